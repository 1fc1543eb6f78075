#include "core/base/Files.h"

#include "core/base/Say.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
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

fs::path requireRegularBelow(const fs::path& folder, const fs::path& file) {
  const std::string name = file.string();
  if (name.empty() || name.find('\0') != std::string::npos || file.is_absolute())
    throw Error(say<"%1 is not a path below the folder; only files below it are opened">(name));
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error) throw Error(say<"cannot open the folder %1: %2">(folder.string(), error.message()));
  const fs::path path = fs::canonical(root / file, error);
  if (error) throw Error(say<"%1 cannot be opened: %2">(name, error.message()));
  if (std::ranges::mismatch(root, path).in1 != root.end())
    throw Error(say<"%1 leads out of the folder; only files below it are opened">(name));
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) throw Error(say<"%1 is a folder, not a file">(name));
  if (!fs::is_regular_file(status)) throw Error(say<"%1 is not a regular file">(name));
  return path;
}

// O_NONBLOCK: a pipe without a writer would be waited for for ever.
UntrustedFile::UntrustedFile(fs::path path)
    : path_(std::move(path)), descriptor_(::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
  if (descriptor_ < 0) throw Error(say<"cannot open %1: %2">(path_.string(), std::strerror(errno)));
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor_);
    throw Error(say<"cannot open %1: it is not a regular file">(path_.string()));
  }
  size_ = static_cast<std::uintmax_t>(status.st_size);
}

UntrustedFile::UntrustedFile(UntrustedFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

UntrustedFile::~UntrustedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void UntrustedFile::read(std::uintmax_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ::ssize_t count = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<::off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw Error(say<"cannot read %1: %2">(path_.string(), std::strerror(errno)));
    if (count == 0) throw Error(say<"cannot read %1: it ends after %2 bytes">(path_.string(), offset));
    offset += static_cast<std::uintmax_t>(count);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

UntrustedFile openUntrusted(const fs::path& folder, const fs::path& file, std::uintmax_t maxBytes) {
  UntrustedFile opened(requireRegularBelow(folder, file));
  if (opened.size() > maxBytes)
    throw Error(say<"%1 has %2 bytes, more than the %3 allowed">(file.string(), opened.size(), maxBytes));
  return opened;
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
