#include "core/base/Files.h"

#include "core/base/Say.h"
#include "core/base/ShownText.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

namespace taa {

namespace fs = std::filesystem;

std::string readFile(const fs::path& path, std::uintmax_t maxBytes) {
  return UntrustedFile(path).text(maxBytes);
}

fs::path requireRegularBelow(const fs::path& folder, const fs::path& file) {
  const std::string text = file.string(), name = shownText(text);
  if (text.empty() || text.find('\0') != std::string::npos || file.is_absolute())
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
    if (S_ISDIR(status.st_mode)) throw Error(say<"cannot open %1: it is a folder">(path_.string()));
    throw Error(say<"cannot open %1: it is not a regular file">(path_.string()));
  }
  size_ = static_cast<std::uintmax_t>(status.st_size);
}

UntrustedFile::UntrustedFile(UntrustedFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

UntrustedFile::~UntrustedFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::size_t UntrustedFile::readSome(std::uintmax_t offset, std::span<std::byte> bytes) const {
  for (;;) {
    const ::ssize_t count = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<::off_t>(offset));
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) throw Error(say<"cannot read %1: %2">(path_.string(), std::strerror(errno)));
  }
}

void UntrustedFile::read(std::uintmax_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const std::size_t count = readSome(offset, bytes);
    if (count == 0) throw Error(say<"cannot read %1: it ends after %2 bytes">(path_.string(), offset));
    offset += count;
    bytes = bytes.subspan(count);
  }
}

std::string UntrustedFile::text(std::uintmax_t maxBytes) const {
  constexpr std::size_t kReadStep = std::size_t(1) << 16;
  std::string text;
  for (std::size_t end = 0;;) {
    if (std::max(size_, std::uintmax_t(end)) > maxBytes)
      throw Error(say<"cannot read %1: it has %2 bytes, more than the %3 allowed">(
          path_.string(), std::max(size_, std::uintmax_t(end)), maxBytes));
    // One byte more than it is said to have, so that the end shows.
    if (end == text.size()) text.resize(std::max(static_cast<std::size_t>(size_) + 1, 2 * end + kReadStep));
    const std::size_t count = readSome(end, std::as_writable_bytes(std::span(text)).subspan(end));
    end += count;
    if (count > 0) continue;
    text.resize(end);
    return text;
  }
}

UntrustedFile openUntrusted(const fs::path& folder, const fs::path& file, std::uintmax_t maxBytes) {
  UntrustedFile opened(requireRegularBelow(folder, file));
  if (opened.size() > maxBytes)
    throw Error(
        say<"%1 has %2 bytes, more than the %3 allowed">(shownText(file.string()), opened.size(), maxBytes));
  return opened;
}

namespace {

/// Tells processes of other machines and containers from those that can be asked after here. Machines of one
/// image share names, and all have the same first space: what no two share is the id of the kernel's start.
/// Empty where that is not told: nobody is asked after then.
const std::string& processSpace() {
  static const std::string kSpace = [] {
    std::string start;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> start;
    if (start.empty()) return start;
    std::array<char, 256> space{};
    const bool isKnown = ::readlink("/proc/self/ns/pid", space.data(), space.size() - 1) > 0;
    return std::to_string(std::hash<std::string>()(start + (isKnown ? space.data() : "")));
  }();
  return kSpace;
}

/// The process of this space that a temporary file or folder is of, by its name
/// ".STEM.SPACE-PROCESS.part.EXT".
std::optional<::pid_t> writerOf(const std::string& name) {
  const std::string before = "." + processSpace() + "-";
  const std::size_t end = name.rfind(".part"), start = name.rfind(before, end);
  if (processSpace().empty() || !name.starts_with('.') || end == std::string::npos ||
      start == std::string::npos)
    return {};
  ::pid_t process = 0;
  const char* const last = name.data() + end;
  const auto [rest, error] = std::from_chars(name.data() + start + before.size(), last, process);
  return error == std::errc() && rest == last && process > 0 ? std::optional(process) : std::nullopt;
}

/// What killed processes left; once for each folder, for it may hold many files.
void clearLeftovers(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> cleared;
  const std::lock_guard lock(mutex);
  if (!cleared.insert(folder).second) return;
  std::error_code error;
  std::vector<fs::path> leftovers;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    if (const auto writer = writerOf(entry->path().filename().string());
        writer && ::kill(*writer, 0) != 0 && errno == ESRCH)
      leftovers.push_back(entry->path());
  for (const fs::path& leftover : leftovers) fs::remove_all(leftover, error); // a sequence has a folder
}

} // namespace

fs::path temporaryBeside(const fs::path& path) {
  clearLeftovers(path.has_parent_path() ? path.parent_path() : ".");
  fs::path temporary = path;
  temporary.replace_filename("." + path.stem().string() + "." + processSpace() + "-" +
                             std::to_string(::getpid()) + ".part" + path.extension().string());
  return temporary;
}

void writeAtomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  const fs::path temporary = temporaryBeside(path);
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
