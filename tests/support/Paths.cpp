// The only test file that knows absolute paths, so that ccache can share the others between checkouts.
#include "tests/support/Paths.h"

#include <unistd.h>

namespace taa::test {

namespace {

struct TemporaryFolder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("taa-test-" + std::to_string(::getpid()));
  TemporaryFolder() {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

} // namespace

std::filesystem::path rootFolder() {
  return TAA_ROOT_FOLDER;
}

std::filesystem::path binary(const std::string& name) {
  return std::filesystem::path(TAA_BIN_FOLDER) / name;
}

std::filesystem::path temporaryFolder() {
  static const TemporaryFolder folder;
  return folder.path;
}

} // namespace taa::test
