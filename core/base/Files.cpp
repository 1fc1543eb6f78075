#include "core/base/Files.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace taa {

namespace fs = std::filesystem;

std::string readFile(const fs::path& path, std::uintmax_t maxBytes) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw Error("cannot read " + path.string() + ": it is a folder");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error("cannot open " + path.string() + ": " + std::strerror(errno));
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error && size > maxBytes)
    throw Error("cannot read " + path.string() + ": it has " + std::to_string(size) +
                " bytes, more than the " + std::to_string(maxBytes) + " allowed");
  std::ostringstream out;
  out << in.rdbuf();
  if (in.bad()) throw Error("cannot read " + path.string() + ": " + std::strerror(errno));
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
    throw Error("cannot write " + path.string() + ": " + error.message());
  }
}

void writeFile(const fs::path& path, std::string_view bytes) {
  writeAtomically(path, [&](const fs::path& temporary) {
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    if (!out) throw Error("cannot write " + path.string() + ": " + std::strerror(errno));
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.flush();
    if (!out) throw Error("cannot write " + path.string() + ": " + std::strerror(errno));
  });
}

} // namespace taa
