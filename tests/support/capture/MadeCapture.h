// A capture of flat colors, in which every pixel of every frame is known: what verdicts on it have to be
// follows.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace taa::test {

/// What a pixel shows in a frame. Nothing lies between pixels: no edge crosses one.
struct MadePixel {
  glm::vec3 color{0.2f};           ///< scene-linear; of the reference too
  std::optional<glm::vec3> sample; ///< what the frame has there instead
  std::uint32_t object = 1;
  float depth = 10.0f; ///< m, in this frame and in the one before
  glm::vec2 motionPx{0.0f};
  float responsive = 0.0f; ///< of the mask
};

struct MadeCapture {
  glm::ivec2 sizePx{32, 18};
  int frames = 1;
  std::map<std::uint32_t, std::string> objects;
  std::function<MadePixel(int frame, const glm::ivec2& pixel)> pixel;
};

/// Writes it without jitter and cameras; `folder` is a source that can be opened then.
void writeCapture(const std::filesystem::path& folder, const MadeCapture& made);

} // namespace taa::test
