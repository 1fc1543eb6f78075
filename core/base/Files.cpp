#include "core/base/Files.h"

#include "core/base/Say.h"

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

namespace taa {

namespace fs = std::filesystem;

std::string readFile(const fs::path& path, std::uintmax_t maxBytes) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw Error(say<"cannot read %1: it is a folder">(path.string()));
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(say<"cannot open %1: %2">(path.string(), std::strerror(errno)));
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > maxBytes)
    throw Error(
        say<"cannot read %1: it has %2 bytes, more than the %3 allowed">(path.string(), size, maxBytes));
  std::ostringstream out;
  out << in.rdbuf();
  if (in.bad()) throw Error(say<"cannot read %1: %2">(path.string(), std::strerror(errno)));
  return std::move(out).str();
}

void writeAtomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  fs::path temporary = path;
  temporary.replace_filename("." + path.stem().string() + "." + std::to_string(::getpid()) + ".part" +
                             path.extension().string());
  std::error_code error;
  try {
    write(temporary);
    fs::rename(temporary, path, error);
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
  if (error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw Error(say<"cannot write %1: %2">(path.string(), error.message()));
  }
}

void writeFile(const fs::path& path, std::string_view bytes) {
  writeAtomically(path, [&](const fs::path& temporary) {
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    const auto fail = [&] { throw Error(say<"cannot write %1: %2">(path.string(), std::strerror(errno))); };
    if (!out) fail();
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.flush();
    if (!out) fail();
  });
}

} // namespace taa
