#include "tests/fuzz/Fuzz.h"

#include "core/base/Error.h"
#include "core/base/ShownText.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace taa::fuzz {

namespace fs = std::filesystem;

namespace {

/// A folder that is removed at the end of the process.
struct OwnFolder {
  fs::path path;
  OwnFolder() {
    const char* const memory = "/dev/shm";
    std::string name =
        ((fs::is_directory(memory) ? memory : fs::temp_directory_path()) / "fuzz-XXXXXX").string();
    require(::mkdtemp(name.data()) != nullptr, "no folder for the files can be made");
    path = name;
  }
  ~OwnFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

} // namespace

void require(bool holds, const std::string& sentence) {
  if (holds) return;
  std::fprintf(stderr, "FINDING: %s\n", sentence.c_str());
  std::abort();
}

bool readsOrRefuses(std::string_view place, const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const Error& error) {
    const std::string said = error.what();
    require(said.starts_with(place), "a refusal begins otherwise: " + said);
    require(isPlainText(said), "a refusal is not one plain line: " + said);
  } catch (const std::exception& other) {
    require(false, std::string("something else than an Error is thrown: ") + other.what());
  }
  return false;
}

std::string fileOf(const char* name, const std::uint8_t* bytes, std::size_t count) {
  static const OwnFolder kFolder;
  const fs::path path = kFolder.path / name;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
  out.close();
  require(out.good(), "cannot write " + path.string());
  return path.string();
}

} // namespace taa::fuzz
