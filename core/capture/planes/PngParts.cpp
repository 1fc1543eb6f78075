#include "core/capture/planes/PngParts.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace taa::capture {

namespace {

constexpr std::uintmax_t kSignature = 8; ///< bytes before the first part
constexpr std::uintmax_t kAround = 12;   ///< bytes of a part that are not its data: length, name, checksum
constexpr std::size_t kSummedBytes = std::size_t(1) << 20;

std::uint32_t bigEndian(std::span<const std::byte> bytes) {
  std::uint32_t value = 0;
  for (const std::byte each : bytes.first(4)) value = value << 8 | static_cast<std::uint32_t>(each);
  return value;
}

std::uint32_t checksumOf(const UntrustedFile& file, std::uintmax_t at, std::uintmax_t count) {
  std::vector<std::byte> block(static_cast<std::size_t>(std::min<std::uintmax_t>(count, kSummedBytes)));
  uLong sum = crc32(0, nullptr, 0);
  while (count > 0) {
    const std::span<std::byte> now =
        std::span(block).first(static_cast<std::size_t>(std::min<std::uintmax_t>(count, kSummedBytes)));
    file.read(at, now);
    sum = crc32(sum, reinterpret_cast<const Bytef*>(now.data()), static_cast<uInt>(now.size()));
    at += now.size();
    count -= now.size();
  }
  return static_cast<std::uint32_t>(sum);
}

} // namespace

void checkPngParts(const UntrustedFile& file, const std::string& name) {
  std::uintmax_t at = kSignature;
  while (at + kAround <= file.size()) {
    std::array<std::byte, 8> head{};
    file.read(at, head);
    const std::uint32_t length = bigEndian(head);
    const std::string part(reinterpret_cast<const char*>(head.data()) + 4, 4);
    if (length > file.size() - at - kAround)
      throw Error(say<"%1 is damaged: its part %2 at byte %3 ends behind its end; write it again">(
          name, shownText(part), at));
    std::array<std::byte, 4> stored{};
    file.read(at + 8 + length, stored);
    if (bigEndian(stored) != checksumOf(file, at + 4, 4 + std::uintmax_t{length}))
      throw Error(say<"%1 is damaged: its part %2 at byte %3 does not fit its checksum; write it again">(
          name, shownText(part), at));
    if (part == "IEND") return;
    at += kAround + length;
  }
  throw Error(say<"%1 is damaged: it ends before its last part; write it again">(name));
}

} // namespace taa::capture
