// Which of a folder's sequences are the capture: the planes, the frames that have them all, and what a side
// file says of them.
#pragma once

#include "core/base/Progress.h"
#include "core/capture/format/Manifest.h"
#include "core/capture/import/FolderScan.h"
#include "core/capture/import/PlaneNames.h"
#include "core/capture/import/SideFile.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace taa::capture {

struct FolderPlan {
  Manifest manifest; ///< all but conventions
  std::map<PlaneKind, StoredType> types;
  std::vector<PictureSequence> sequences; ///< all that the folder holds
  std::optional<SideFrames> side;
  std::string sideName;                   ///< of its file, to be shown
  double nearPlane = 0.0, farPlane = 0.0; ///< as the side file says; 0: it does not
  std::vector<std::string> found, unsure; ///< sentences
};

/// `planes`: those that are stated, see statePlanes(). Throws Error that says what was looked for where there
/// is no color; Cancelled.
FolderPlan planFolder(const std::filesystem::path& folder, const std::vector<std::string>& planes,
                      const Progress& progress);

} // namespace taa::capture
