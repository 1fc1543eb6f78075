// What a writer asks before it takes the place of files that are there already.
#pragma once

#include <filesystem>
#include <vector>

namespace taa {

/// Those of `paths` that something has already, links that lead nowhere included, in their order.
std::vector<std::filesystem::path> existing(const std::vector<std::filesystem::path>& paths);

/// For commands: throws Error where any of `paths` is there, which names the first, says how many they are
/// and that --force replaces them.
void refuseToReplace(const std::vector<std::filesystem::path>& paths);

/// For commands that would have worked for nothing: throws Error unless the folder that `path` would lie in
/// is there.
void requireFolderOf(const std::filesystem::path& path);

} // namespace taa
