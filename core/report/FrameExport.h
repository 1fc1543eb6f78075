// The frame on show into a file, however large it and the choice of intermediates are.
#pragma once

#include "core/base/Progress.h"
#include "core/inspect/ShownPicture.h"
#include "core/io/FrameFile.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace taa {

class Inspector;

/// Bytes of exposed values that an export holds at once, on the GPU and once more in memory.
inline constexpr std::size_t kExportBytes = std::size_t(256) << 20;

/// Writes `ids` of every lane of the inspector's frame; `frame` says the rest and has a lane for each, but no
/// parts. Exposes as many at a time as `bytes` hold, at least one. Throws Error.
void exportFrame(Inspector& inspector, FrameFile frame, const std::vector<IntermediateId>& ids,
                 const std::filesystem::path& path, std::size_t bytes = kExportBytes);

/// What `ids` of the lane of `sides` are more than on its other side, one after the other: where that has the
/// row of `sides`, each is compared with itself. `with`: what they are compared with, in words; `frame` as
/// above. Throws Error, Cancelled.
void exportDifferences(Inspector& inspector, FrameFile frame, const std::vector<IntermediateId>& ids,
                       const PictureRequest& sides, const std::string& with,
                       const std::filesystem::path& path, const Progress& progress = {});

} // namespace taa
