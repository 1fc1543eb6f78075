// Stage 7, rectify history: what of the correction is taken back, by locks and by luma that comes and goes.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace taa::twin {
namespace {

/// Luma of 3×3, row-major, and its mean.
struct Lumas {
  std::array<float, 9> each{};
  float mean = 0.0f;
};

Lumas lumasOf(const Inputs& inputs, const glm::ivec2& drawn) {
  Lumas lumas;
  float sum = 0.0f;
  for (int k = 0; k < 9; ++k) {
    const float value = luma(currentColor(inputs, drawn + glm::ivec2(k % 3 - 1, k / 3 - 1)));
    lumas.each[static_cast<std::size_t>(k)] = value;
    sum = sum + value;
  }
  lumas.mean = sum / 9.0f;
  return lumas;
}

/// The ridge test of FSR2 on luma itself: 1.05⁶.
bool isThin(const Lumas& lumas) {
  constexpr float kSimilar = 1.340095640625f;
  const float own = lumas.each[4];
  std::array<bool, 9> similar{};
  float lowest = 1e30f, highest = 0.0f;
  for (std::size_t k = 0; k < 9; ++k) {
    const float other = lumas.each[k];
    similar[k] = k == 4 || maximum(own, other) < kSimilar * minimum(own, other);
    if (similar[k]) continue;
    lowest = minimum(other, lowest);
    highest = maximum(other, highest);
  }
  if (!(own > highest || own < lowest)) return false;
  for (const std::size_t corner : {0u, 1u, 3u, 4u}) // of the four 2×2 that hold the pixel
    if (similar[corner] && similar[corner + 1] && similar[corner + 3] && similar[corner + 4]) return false;
  return true;
}

void updateLock(const Inputs& inputs, float lockFrames, const Lumas& lumas, const glm::vec2& stored,
                const glm::vec2& next, LockState& lockState) {
  lockState.storedLock = stored;
  float life = stored.x;
  float locked = stored.y == 0.0f ? lumas.mean : stored.y;
  const bool isChanged = minimum(locked, lumas.mean) < 0.531441f * maximum(locked, lumas.mean); // 0.9⁶
  lockState.isThin = isThin(lumas);
  lockState.isChanged = isChanged;
  if (lockState.isThin) {
    locked = lumas.mean;
    life = life == 0.0f ? 1.0f : 2.0f;
  } else if (life <= 1.0f) {
    locked = locked + 0.5f * (lumas.mean - locked);
  }
  if (isChanged) life = 0.0f;
  lockState.lockLife = life;
  lockState.lock = saturated(4.0f * saturated(life - 1.0f));
  const bool stays = next.x >= 0.0f && next.x <= static_cast<float>(inputs.outputWidth()) && next.y >= 0.0f &&
                     next.y <= static_cast<float>(inputs.outputHeight());
  lockState.keptLock = {stays ? maximum(life - 1.0f / lockFrames, 0.0f) : 0.0f, locked};
}

/// L/(1 + L) in 255ths.
float lumaStep(float luma) {
  return std::floor((luma / (1.0f + luma)) * 255.0f + 0.5f);
}

void updateInstability(const Lumas& lumas, const glm::vec4& stored, float deviation, LockState& lockState) {
  const float now = lumaStep(lumas.mean);
  lockState.storedLumas = stored;
  lockState.keptLumas = glm::vec4(now, stored.x, stored.y, stored.z) / 255.0f;
  const float last = now - stored.x;
  if (std::fabs(last) < 1.0f || stored.z == 0.0f) return;
  bool isPeriodic = false;
  for (int k = 1; k < 4; ++k) {
    const float older = now - stored[k];
    if (!(older * last < 0.0f) && std::fabs(older) < std::fabs(last)) isPeriodic = true;
  }
  const float size = saturated(deviation / 0.1f);
  const float squared = size * size;
  if (isPeriodic && (squared * squared) * squared > 1.0f / 255.0f) lockState.instability = 1.0f;
}

} // namespace

LockState holdHistory(const Inputs& inputs, const Settings& settings, const Reprojection& reprojected,
                      const glm::vec2& readPosition, const Neighborhood& neighborhood, bool isValid,
                      const glm::ivec2& pixel, const glm::ivec2& drawn) {
  LockState lockState;
  const bool locks = settings.rectify.locks == Switch::On;
  const bool findsInstability = settings.rectify.instability == Switch::On;
  if (!locks && !findsInstability) return lockState;
  const Lumas lumas = lumasOf(inputs, drawn);
  lockState.luma = lumas.mean;
  const glm::ivec2 texel = clampedToPicture(
      {static_cast<int>(std::floor(readPosition.x)), static_cast<int>(std::floor(readPosition.y))}, inputs);
  if (locks) {
    const bool has = isValid && !inputs.historyLock.empty();
    const glm::vec2 center = glm::vec2(pixel) + 0.5f;
    updateLock(inputs, settings.rectify.lockFrames, lumas,
               has ? glm::vec2(inputs.historyLock.texel(texel.x, texel.y)) : glm::vec2(0.0f),
               center + (center - reprojected.position), lockState);
  }
  if (findsInstability) {
    glm::vec4 stored(0.0f);
    if (isValid && !inputs.historyLumas.empty())
      for (int k = 0; k < 4; ++k)
        stored[k] = std::floor(inputs.historyLumas.texel(texel.x, texel.y)[k] * 255.0f + 0.5f);
    updateInstability(lumas, stored, boxLuma(neighborhood.deviation, settings.space), lockState);
  }
  lockState.protection =
      maximum(lockState.lock, lockState.instability) * (1.0f - std::sqrt(maskAt(inputs, drawn).x)); // 11.7
  return lockState;
}

} // namespace taa::twin
