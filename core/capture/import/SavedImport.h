// An import written as a folder with capture.json.
#pragma once

#include "core/base/Progress.h"
#include "core/capture/format/Manifest.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace taa::capture {

struct SavedImport {
  std::filesystem::path manifest;     ///< capture.json
  std::size_t linked = 0, copied = 0; ///< files beside it; linked ones take no room
};

/// What saveImport() writes into `out`.
std::vector<std::filesystem::path> importedFiles(const std::filesystem::path& folder,
                                                 const Manifest& manifest, const std::filesystem::path& out);

/// Writes capture.json into `out`. The planes of `folder` stay where they are if that is below `out`; else
/// they are linked, and copied where links are not possible. Files that are there are an Error but with
/// `replace`, and then nothing was written. Throws Error, Cancelled.
SavedImport saveImport(const std::filesystem::path& folder, const Manifest& manifest,
                       const std::filesystem::path& out, bool replace, const Progress& progress);

} // namespace taa::capture
