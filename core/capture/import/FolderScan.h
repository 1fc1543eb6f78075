// The pictures of a folder as numbered sequences, each with the planes that its files hold.
#pragma once

#include "core/base/Progress.h"
#include "core/capture/import/PlaneNames.h"

#include <filesystem>
#include <string>
#include <vector>

namespace taa::capture {

struct PictureSequence {
  std::string pattern;              ///< "taa/workshop.{frame:4}.exr"; see PlaneSource::file
  std::string folder;               ///< "taa"; empty for the folder itself
  std::vector<int> numbers;         ///< rising; one picture without a number is 0
  std::vector<PictureLayer> layers; ///< of the first file, whatever they are taken for
  NamedPlanes planes;               ///< by their names
};

struct FolderScan {
  std::vector<PictureSequence> sequences;
  std::vector<std::string> sideFiles; ///< *.json but capture.json, those that lie higher first
  std::vector<std::string> failures;  ///< sentences: pictures that cannot be opened
};

/// Folders below `folder` as well, up to three deep. Throws Error where the folder cannot be read or holds
/// too much; Cancelled.
FolderScan scanFolder(const std::filesystem::path& folder, const Progress& progress);

} // namespace taa::capture
