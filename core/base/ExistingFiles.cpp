#include "core/base/ExistingFiles.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <system_error>

namespace taa {

namespace fs = std::filesystem;

std::vector<fs::path> existing(const std::vector<fs::path>& paths) {
  std::vector<fs::path> found;
  std::ranges::copy_if(paths, std::back_inserter(found), [](const fs::path& path) {
    std::error_code ignored; // what cannot be reached cannot be replaced either: the writer says why
    return fs::exists(fs::symlink_status(path, ignored));
  });
  return found;
}

void refuseToReplace(const std::vector<fs::path>& paths) {
  const std::vector<fs::path> there = existing(paths);
  if (there.empty()) return;
  const std::string first = there.front().string();
  if (paths.size() == 1) throw Error(say<"%1 is there already; --force replaces it">(first));
  throw Error(say<"files that are there already: %1 of %2, the first is %3; --force replaces them">(
      there.size(), paths.size(), first));
}

void requireFolderOf(const fs::path& path) {
  const fs::path folder = path.parent_path();
  std::error_code ignored; // a folder that cannot be seen is none to write into
  if (!folder.empty() && !fs::is_directory(folder, ignored))
    throw Error(say<"cannot write %1: there is no folder %2">(path.string(), folder.string()));
}

} // namespace taa
