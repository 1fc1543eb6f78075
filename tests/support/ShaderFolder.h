// Shaders of a test's own, in place of the embedded ones.
#pragma once

#include <filesystem>
#include <string>

namespace taa::test {

/// A copy of shaders/ that the program reads while this lives (TAA_SHADER_DIR), for a test to add to or
/// change.
class ShaderFolder {
 public:
  ShaderFolder();
  ~ShaderFolder();
  ShaderFolder(const ShaderFolder&) = delete;
  ShaderFolder& operator=(const ShaderFolder&) = delete;

  void write(const std::string& path, const std::string& text) const;
  std::string read(const std::string& path) const;
  /// Expects `from` to be there once.
  void replace(const std::string& path, const std::string& from, const std::string& to) const;

 private:
  std::filesystem::path folder_;
  std::string before_;
};

} // namespace taa::test
