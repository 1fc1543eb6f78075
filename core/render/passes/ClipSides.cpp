#include "core/render/passes/ClipSides.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taa {

ClipSides clipSides(const View& view) {
  constexpr float marginPx = 3.0f;
  const glm::vec2 sizePx = view.block.sizePx;
  const gl::Rect part =
      view.part.value_or(gl::Rect{0, 0, static_cast<int>(sizePx.x), static_cast<int>(sizePx.y)});
  const glm::vec2 from = glm::vec2(part.x, part.y) - marginPx;
  const glm::vec2 to = glm::vec2(part.x + part.width, part.y + part.height) + marginPx;
  const glm::vec2 low = 2.0f * from / sizePx - 1.0f, high = 2.0f * to / sizePx - 1.0f;
  return {{low.x, -high.y}, {high.x, -low.y}}; // rows go down, y goes up
}

std::optional<float> farthestPoint(const Bounds& box, const glm::mat4& clipFromModel, const ClipSides& sides,
                                   const glm::vec4& jitter) {
  if (box.isEmpty()) return kBeyondAll;
  std::array<int, 5> outside{};
  float farthest = std::numeric_limits<float>::lowest();
  for (int corner = 0; corner < 8; ++corner) {
    glm::vec4 clip =
        clipFromModel * glm::vec4(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                                  corner & 4 ? box.max.z : box.min.z, 1.0f);
    clip.x += jitter.x * clip.w + jitter.z * clip.z;
    clip.y += jitter.y * clip.w + jitter.w * clip.z;
    outside[0] += clip.x > sides.high.x * clip.w;
    outside[1] += clip.x < sides.low.x * clip.w;
    outside[2] += clip.y > sides.high.y * clip.w;
    outside[3] += clip.y < sides.low.y * clip.w;
    outside[4] += clip.z > clip.w; // before the near plane, which has depth 1
    farthest = std::max(farthest, clip.w - clip.z);
  }
  if (std::ranges::find(outside, 8) != outside.end()) return std::nullopt;
  return farthest;
}

std::array<HalfSpace, 4> beyondSides(const glm::mat4& clipFromModel, const ClipSides& sides,
                                     const glm::vec4& jitter) {
  const glm::vec4 depth = glm::row(clipFromModel, 2), w = glm::row(clipFromModel, 3);
  std::array<HalfSpace, 4> spaces;
  for (int axis = 0; axis < 2; ++axis) {
    const glm::vec4 along = glm::row(clipFromModel, axis);
    const float jitterW = jitter[axis], jitterZ = jitter[2 + axis];
    const glm::vec4 jittered = along + jitterW * w + jitterZ * depth;
    for (const bool isHigh : {false, true}) {
      const float side = isHigh ? sides.high[axis] : sides.low[axis];
      const glm::vec4 above = jittered - side * w;
      spaces[static_cast<std::size_t>(2 * axis + (isHigh ? 1 : 0))] = {
          isHigh ? above : -above, glm::abs(along) + (std::abs(side) + std::abs(jitterW)) * glm::abs(w) +
                                       std::abs(jitterZ) * glm::abs(depth)};
    }
  }
  return spaces;
}

float middleDistance(const Bounds& box, const glm::mat4& clipFromModel) {
  const glm::vec4 clip = clipFromModel * glm::vec4(box.isEmpty() ? glm::vec3(0.0f) : box.center(), 1.0f);
  return clip.w - clip.z;
}

} // namespace taa
