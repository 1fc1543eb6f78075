#include "core/render/Jitter.h"

#include <cassert>
#include <cstdint>

namespace taa {

float radicalInverse(int index, int base) {
  assert(index >= 0 && base >= 2);
  // Numerator and denominator are exact integers. While the denominator is below 2^27 (indices to 10^7) no
  // quotient comes near enough to the middle of two floats for the double in between to round twice.
  std::int64_t numerator = 0, denominator = 1;
  for (int rest = index; rest > 0; rest /= base) {
    numerator = numerator * base + rest % base;
    denominator *= base;
  }
  return static_cast<float>(static_cast<double>(numerator) / static_cast<double>(denominator));
}

int jitterIndex(const JitterSettings& settings, int frame) {
  assert(frame >= 0 && settings.period > 0);
  return settings.sequence == JitterSequence::None ? 0 : frame % settings.period;
}

glm::vec2 jitterPx(const JitterSettings& settings, int frame) {
  if (settings.sequence == JitterSequence::None) return glm::vec2(0.0f);
  const int index = settings.firstIndex + jitterIndex(settings, frame);
  return settings.scale * (glm::vec2(radicalInverse(index, 2), radicalInverse(index, 3)) - 0.5f);
}

glm::mat4 jittered(const glm::mat4& clipFromView, glm::vec2 jitterPx, glm::vec2 sizePx) {
  const glm::vec2 offset = glm::vec2(2.0f, -2.0f) * (jitterPx / sizePx); // NDC, y up
  glm::mat4 result = clipFromView;
  for (int column = 0; column < 4; ++column) {
    result[column][0] += offset.x * clipFromView[column][3];
    result[column][1] += offset.y * clipFromView[column][3];
  }
  return result;
}

} // namespace taa
