// Golden pictures: what a picture looked like when somebody last looked at it.
#pragma once

#include "tests/support/CompareImages.h"

#include <filesystem>
#include <set>
#include <string>

namespace taa::test {

/// tests/image/golden of the repository.
std::filesystem::path goldenFolder();

/// What difference() says of a picture, whose values are within 0 and 1, and NAME.png in `folder`. Where
/// there is no such file it says so. Where TAA_UPDATE_GOLDEN is set (tests/golden does) it writes the file
/// unless the two agree, and says nothing.
std::string differenceFromGolden(const std::string& name, const Image& actual, const Limits& limits,
                                 const std::filesystem::path& folder = goldenFolder());

/// NAME of each NAME.png there that begins with `prefix`.
std::set<std::string> goldenNames(const std::string& prefix,
                                  const std::filesystem::path& folder = goldenFolder());

/// The means of squares of side × side pixels; what is left over at the right and below is left out.
Image averaged(const Image& image, int side);

} // namespace taa::test
