// Whether two images are equal, and where not.
#pragma once

#include "core/base/Image.h"

#include <string>

namespace taa::test {

/// Where two images differ first and how often, or nothing when they agree. `tolerance` is relative to
/// max(1, |expected|); 0 asks for the same bits, any NaN being equal to any other. Up to `allowed` values may
/// differ.
std::string difference(const Image& actual, const Image& expected, float tolerance = 0.0f,
                       std::size_t allowed = 0);

/// The part of `image` at (x, y).
Image crop(const Image& image, int x, int y, int width, int height);

} // namespace taa::test
