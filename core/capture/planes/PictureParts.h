// What a picture file consists of, before anything of it is read.
#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace taa::capture {

/// What a channel is stored as; Normalized: integers that stand for 0 to 1.
enum class StoredType : std::uint8_t { Half, Float, Normalized8, Normalized16, Integer };

struct PictureChannel {
  std::string name;
  StoredType type = StoredType::Float;
};

struct PicturePart {
  std::string name; ///< of a multi-part EXR; else empty
  glm::ivec2 sizePx{0};
  std::vector<PictureChannel> channels;
};

/// Of an EXR, PNG, HDR, TIFF or DDS `file` below `folder`. Throws Error that names it.
std::vector<PicturePart> picturePartsOf(const std::filesystem::path& folder, const std::string& file);

} // namespace taa::capture
