// A .glb file. Of what libFuzzer changes most is put into chunks whose lengths are right: a wrong length is
// refused before anything else is looked at.
#include "tests/fuzz/OpenGltf.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* bytes, std::size_t count, std::size_t most);

namespace {

constexpr std::size_t kGlbHeader = 12, kGlbChunkHeader = 8;

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::string wordText(std::size_t value) {
  const auto narrow = static_cast<std::uint32_t>(value);
  return {reinterpret_cast<const char*>(&narrow), sizeof narrow};
}

struct GlbChunks {
  std::string json, binary;
};

/// As far as the lengths that are said go.
GlbChunks chunksOf(std::string_view bytes) {
  const auto chunkAt = [&](std::size_t at) {
    if (at + kGlbChunkHeader > bytes.size()) return std::string_view();
    return bytes.substr(at + kGlbChunkHeader, wordAt(bytes, at));
  };
  const std::string_view json = chunkAt(kGlbHeader);
  return {std::string(json), std::string(chunkAt(kGlbHeader + kGlbChunkHeader + json.size()))};
}

std::string joined(GlbChunks chunks) {
  chunks.json.resize((chunks.json.size() + 3) / 4 * 4, ' ');
  chunks.binary.resize((chunks.binary.size() + 3) / 4 * 4, '\0');
  const std::size_t length = kGlbHeader + 2 * kGlbChunkHeader + chunks.json.size() + chunks.binary.size();
  return "glTF" + wordText(2) + wordText(length) + wordText(chunks.json.size()) + "JSON" + chunks.json +
         wordText(chunks.binary.size()) + std::string("BIN\0", 4) + chunks.binary;
}

void mutateText(std::string& text, std::size_t most) {
  const std::size_t count = text.size();
  text.resize(std::max(most, count));
  text.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(text.data()), count, text.size()));
}

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* bytes, std::size_t count, std::size_t most,
                                               unsigned seed) {
  GlbChunks chunks = chunksOf({reinterpret_cast<const char*>(bytes), count});
  const std::size_t around = kGlbHeader + 2 * kGlbChunkHeader + 6; // six bytes may be added to fill up
  const std::size_t kept = around + chunks.json.size() + chunks.binary.size();
  if (seed % 16 == 0 || chunks.json.empty() || kept >= most) return LLVMFuzzerMutate(bytes, count, most);
  mutateText(seed % 4 == 1 ? chunks.binary : chunks.json,
             (seed % 4 == 1 ? chunks.binary : chunks.json).size() + most - kept);
  const std::string file = joined(std::move(chunks));
  if (file.size() > most) return LLVMFuzzerMutate(bytes, count, most);
  std::memcpy(bytes, file.data(), file.size());
  return file.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  taa::fuzz::openGltf("scene.glb", bytes, count);
  return 0;
}
