// Reading and writing whole files, with sentences for errors.
#pragma once

#include "core/base/Error.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace taa {

/// The bytes of a file. It comes from anywhere: never waits for a writer, and follows links. Throws Error
/// when it cannot be read, is no regular file or has more than `maxBytes`.
std::string readFile(const std::filesystem::path& path, std::uintmax_t maxBytes = std::uintmax_t(2) << 30);

// Files of somebody else's, which a file of somebody else's names.

/// Where `file`, a path relative to `folder`, leads once links are resolved. Throws Error that begins with
/// `file` unless that is a regular file below `folder`: no folder, device, pipe or socket.
std::filesystem::path requireRegularBelow(const std::filesystem::path& folder,
                                          const std::filesystem::path& file);

/// An open file that was regular when it was opened; opening and reading it never wait for a writer.
class UntrustedFile {
 public:
  /// Throws Error.
  explicit UntrustedFile(std::filesystem::path path);
  UntrustedFile(UntrustedFile&& other) noexcept;
  UntrustedFile& operator=(UntrustedFile&&) = delete;
  ~UntrustedFile();

  const std::filesystem::path& path() const { return path_; }
  std::uintmax_t size() const { return size_; }
  /// Fills `bytes` with what stands at `offset`. Throws Error where the file ends before.
  void read(std::uintmax_t offset, std::span<std::byte> bytes) const;
  /// All of it, also where the system tells no size, as of what stands in /proc. Throws Error where that is
  /// more than `maxBytes`.
  std::string text(std::uintmax_t maxBytes) const;

 private:
  /// As pread() returns it: 0 where the file ends.
  std::size_t readSome(std::uintmax_t offset, std::span<std::byte> bytes) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uintmax_t size_ = 0;
};

/// `file` below `folder`, as requireRegularBelow() says. Throws Error, also when it has more than `maxBytes`.
UntrustedFile openUntrusted(const std::filesystem::path& folder, const std::filesystem::path& file,
                            std::uintmax_t maxBytes);

/// Where this process writes what becomes `path` when it is whole, a file or a folder; keeps the extension.
/// Removes what processes that have ended left so in this folder.
std::filesystem::path temporaryBeside(const std::filesystem::path& path);

/// Writes beside the target and renames, so that a reader sees the old file or the new one, never half of
/// one. `write` gets the temporary path, which keeps the extension of `path`. Whatever it throws goes on, and
/// the temporary file is removed.
void writeAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path&)>& write);

/// As above, for bytes at hand.
void writeFile(const std::filesystem::path& path, std::string_view bytes);

} // namespace taa
