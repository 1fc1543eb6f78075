// Linked programs kept on disk. A file: magic, source of the driver and of the program, format, bytes,
// checksum; texts and bytes after their length; numbers as this machine has them, because binaries are of
// this machine.
#include "core/gl/ProgramBinaries.h"

#include "core/base/Files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

namespace taa::gl {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMagic = "taa program 1\n", kExtension = ".program";

// FNV-1a, 64 bits: against accidents, not against malice.
std::uint64_t hashOf(std::string_view text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

void appendNumber(std::string& text, std::uint64_t number) {
  std::array<char, 8> bytes;
  std::memcpy(bytes.data(), &number, bytes.size());
  text.append(bytes.data(), bytes.size());
}

void appendText(std::string& text, std::string_view part) {
  appendNumber(text, part.size());
  text += part;
}

/// Takes a file apart from its front; `isWhole` turns false where it ends too early.
struct Reader {
  std::string_view rest;
  bool isWhole = true;

  std::string_view take(std::uint64_t length) {
    isWhole = isWhole && length <= rest.size();
    if (!isWhole) return {};
    const std::string_view part = rest.substr(0, length);
    rest.remove_prefix(length);
    return part;
  }
  std::uint64_t number() {
    std::uint64_t number = 0;
    const std::string_view bytes = take(sizeof(number));
    if (isWhole) std::memcpy(&number, bytes.data(), sizeof(number));
    return number;
  }
  std::string_view text() { return take(number()); }
};

std::string contents(const std::string& driver, const std::string& source, const ProgramBinary& binary) {
  std::string text(kMagic);
  appendText(text, driver);
  appendText(text, source);
  appendNumber(text, binary.format);
  appendText(text, binary.bytes);
  appendNumber(text, hashOf(text));
  return text;
}

} // namespace

ProgramBinaries::ProgramBinaries(fs::path folder, std::string driver, std::uintmax_t maxBytes)
    : folder_(std::move(folder)), driver_(std::move(driver)), maxBytes_(maxBytes) {}

fs::path ProgramBinaries::fileOf(const std::string& source) const {
  std::array<char, 16> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), hashOf(driver_ + "\n" + source), 16);
  return folder_ / (std::string(digits.data(), end.ptr) + std::string(kExtension));
}

std::optional<ProgramBinary> ProgramBinaries::find(const std::string& source) const {
  const fs::path file = fileOf(source);
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return std::nullopt;
  std::string text;
  try {
    text = readFile(file, maxBytes_);
  } catch (const Error&) {
    return std::nullopt;
  }
  Reader reader{text};
  const bool isOurs = reader.take(kMagic.size()) == kMagic;
  const bool isFitting = reader.text() == driver_ && reader.text() == source;
  ProgramBinary binary{static_cast<std::uint32_t>(reader.number()), std::string(reader.text())};
  const std::uint64_t expected = hashOf(std::string_view(text).substr(0, text.size() - reader.rest.size()));
  if (!isOurs || !isFitting || reader.number() != expected || !reader.isWhole) return std::nullopt;
  fs::last_write_time(file, fs::file_time_type::clock::now(), error); // used lately
  return binary;
}

void ProgramBinaries::keep(const std::string& source, const ProgramBinary& binary) const {
  std::error_code error;
  fs::create_directories(folder_, error);
  try {
    writeFile(fileOf(source), contents(driver_, source, binary));
  } catch (const Error&) {
    return;
  }
  dropOldest();
}

void ProgramBinaries::dropOldest() const {
  struct File {
    fs::file_time_type time;
    std::uintmax_t bytes;
    fs::path path;
  };
  std::vector<File> files;
  std::uintmax_t total = 0;
  std::error_code error;
  for (fs::directory_iterator entry(folder_, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() != kExtension) continue;
    std::error_code gone; // another process may have dropped it
    const File file{entry->last_write_time(gone), gone ? 0 : entry->file_size(gone), entry->path()};
    if (gone) continue;
    files.push_back(file);
    total += file.bytes;
  }
  std::ranges::sort(files, {}, &File::time);
  for (const File& file : files) {
    if (total <= maxBytes_) return;
    total -= file.bytes;
    fs::remove(file.path, error);
  }
}

fs::path programFolder() {
  if (const char* folder = std::getenv("TAA_PROGRAM_CACHE")) return folder;
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  const fs::path base = cache && *cache ? fs::path(cache)
                        : home && *home ? fs::path(home) / ".cache"
                                        : fs::path();
  return base.empty() ? base : base / "taa-inspector" / "programs";
}

} // namespace taa::gl
