#include "core/report/doctor/ShownPng.h"

#include "core/io/PictureFile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace taa {

std::string pngOfShown(const Image& picture) {
  std::vector<std::uint8_t> rgba;
  rgba.reserve(static_cast<std::size_t>(picture.width) * picture.height * 4);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        const float value = picture.at(x, y)[channel];
        // Comparisons are written so that NaN is black.
        const float shown = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
        rgba.push_back(static_cast<std::uint8_t>(std::lround(255.0f * shown)));
      }
      rgba.push_back(255);
    }
  return packedPng(picture.width, picture.height, rgba);
}

std::string base64Of(std::string_view bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t byte = 0; byte < 3; ++byte)
      bits = bits << 8 | (byte < count ? static_cast<std::uint8_t>(bytes[i + byte]) : 0u);
    for (std::size_t letter = 0; letter < 4; ++letter)
      out += letter <= count ? kLetters[bits >> (18 - 6 * letter) & 63u] : '=';
  }
  return out;
}

} // namespace taa
