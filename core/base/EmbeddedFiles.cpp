#include "core/base/EmbeddedFiles.h"

#include "core/base/Files.h"
#include "core/base/Say.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace taa {

namespace {

constexpr std::string_view kShaders = "shaders/";
thread_local std::shared_ptr<const ShaderTexts> usedShaders;

} // namespace

std::string embeddedText(std::string_view path) {
  const bool isShader = path.starts_with(kShaders);
  if (isShader && usedShaders)
    if (const auto found = usedShaders->find(path); found != usedShaders->end()) return found->second;
  const char* folder = std::getenv("TAA_SHADER_DIR");
  if (folder && isShader)
    return readFile(std::string(folder) + "/" + std::string(path.substr(kShaders.size())));
  for (const EmbeddedFile& file : detail::embeddedFiles())
    if (file.path == path) return std::string(file.bytes);
  throw Error(say<"there is no built-in file \"%1\"">(path));
}

std::shared_ptr<const ShaderTexts> readShaders() {
  const char* folder = std::getenv("TAA_SHADER_DIR");
  if (!folder) return nullptr;
  auto texts = std::make_shared<ShaderTexts>();
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator file(folder, error), end; !error && file != end;
       file.increment(error)) {
    if (!file->is_regular_file(error)) continue;
    const std::filesystem::path below = file->path().lexically_relative(folder);
    (*texts)[std::string(kShaders) + below.generic_string()] = readFile(file->path());
  }
  if (error) throw Error(say<"cannot read the shaders in %1: %2">(folder, error.message()));
  return texts;
}

std::shared_ptr<const ShaderTexts> useShaders(std::shared_ptr<const ShaderTexts> texts) {
  return std::exchange(usedShaders, std::move(texts));
}

std::shared_ptr<const ShaderTexts> shadersInUse() {
  return usedShaders;
}

std::vector<std::string> embeddedPaths(std::string_view prefix) {
  std::vector<std::string> paths;
  for (const EmbeddedFile& file : detail::embeddedFiles())
    if (file.path.starts_with(prefix)) paths.emplace_back(file.path);
  std::ranges::sort(paths);
  return paths;
}

} // namespace taa
