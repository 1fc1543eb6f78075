#include "core/base/EmbeddedFiles.h"

#include "core/base/Files.h"

#include <algorithm>
#include <cstdlib>

namespace taa {

std::string embeddedText(std::string_view path) {
  constexpr std::string_view kShaders = "shaders/";
  const char* folder = std::getenv("TAA_SHADER_DIR");
  if (folder && path.starts_with(kShaders))
    return readFile(std::string(folder) + "/" + std::string(path.substr(kShaders.size())));
  for (const EmbeddedFile& file : detail::embeddedFiles())
    if (file.path == path) return std::string(file.bytes);
  throw Error("there is no built-in file \"" + std::string(path) + "\"");
}

std::vector<std::string> embeddedPaths(std::string_view prefix) {
  std::vector<std::string> paths;
  for (const EmbeddedFile& file : detail::embeddedFiles())
    if (file.path.starts_with(prefix)) paths.emplace_back(file.path);
  std::ranges::sort(paths);
  return paths;
}

} // namespace taa
