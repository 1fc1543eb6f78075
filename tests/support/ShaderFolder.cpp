// Shaders of a test's own, in place of the embedded ones.
#include "tests/support/ShaderFolder.h"

#include "core/base/Files.h"
#include "tests/support/Paths.h"

#include <cassert>
#include <cstdlib>

namespace taa::test {

namespace {

constexpr const char* kVariable = "TAA_SHADER_DIR";

} // namespace

ShaderFolder::ShaderFolder() : folder_(temporaryFolder() / "shaders") {
  std::filesystem::remove_all(folder_);
  std::filesystem::copy(rootFolder() / "shaders", folder_, std::filesystem::copy_options::recursive);
  if (const char* before = std::getenv(kVariable)) before_ = before;
  setenv(kVariable, folder_.c_str(), 1);
}

ShaderFolder::~ShaderFolder() {
  if (before_.empty())
    unsetenv(kVariable);
  else
    setenv(kVariable, before_.c_str(), 1);
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void ShaderFolder::write(const std::string& path, const std::string& text) const {
  writeFile(folder_ / path, text);
}

std::string ShaderFolder::read(const std::string& path) const {
  return readFile(folder_ / path);
}

void ShaderFolder::replace(const std::string& path, const std::string& from, const std::string& to) const {
  std::string text = read(path);
  const std::size_t at = text.find(from);
  assert(at != std::string::npos && text.find(from, at + 1) == std::string::npos);
  write(path, text.replace(at, from.size(), to));
}

} // namespace taa::test
