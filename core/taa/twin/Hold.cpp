// Stage 7, rectify history: what of the correction is taken back, by locks and by luma that comes and goes.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Stages.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace taa::twin {
namespace {

/// Luma of 3×3, row-major, and its mean.
template <typename Real>
struct LumasOf {
  std::array<Real, 9> each{};
  Real mean = 0.0f;
};

template <typename Real>
LumasOf<Real> lumasOf(const Inputs& inputs, const glm::ivec2& drawn) {
  LumasOf<Real> lumas;
  Real sum = 0.0f;
  for (int k = 0; k < 9; ++k) {
    const Real value = luma(currentColor<Real>(inputs, drawn + glm::ivec2(k % 3 - 1, k / 3 - 1)));
    lumas.each[static_cast<std::size_t>(k)] = value;
    sum = sum + value;
  }
  lumas.mean = sum / 9.0f;
  return lumas;
}

/// The ridge test of FSR2 on luma itself: 1.05⁶.
template <typename Real>
bool isThin(const LumasOf<Real>& lumas) {
  constexpr float kSimilar = 1.340095640625f;
  const Real own = lumas.each[4];
  std::array<bool, 9> similar{};
  Real lowest = 1e30f, highest = 0.0f;
  for (std::size_t k = 0; k < 9; ++k) {
    const Real other = lumas.each[k];
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

template <typename Real>
void updateLock(const Inputs& inputs, Real lockFrames, const LumasOf<Real>& lumas, const Vec2<Real>& stored,
                const Vec2<Real>& next, LockStateOf<Real>& lockState) {
  lockState.storedLock = stored;
  Real life = stored.x;
  Real locked = stored.y == 0.0f ? lumas.mean : stored.y;
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
  decided<Real>(IntermediateId::lockLife);
  lockState.lock = saturated(4.0f * saturated(life - 1.0f));
  const bool stays = next.x >= 0.0f && next.x <= static_cast<float>(inputs.outputWidth()) && next.y >= 0.0f &&
                     next.y <= static_cast<float>(inputs.outputHeight());
  lockState.keptLock = {stays ? maximum(life - 1.0f / lockFrames, 0.0f) : 0.0f, locked};
}

/// L/(1 + L) in 255ths.
template <typename Real>
Real lumaStep(Real luma) {
  return floor((luma / (1.0f + luma)) * 255.0f + 0.5f);
}

template <typename Real>
void updateInstability(const LumasOf<Real>& lumas, const Vec4<Real>& stored, Real deviation,
                       LockStateOf<Real>& lockState) {
  const Real now = lumaStep(lumas.mean);
  lockState.storedLumas = stored;
  lockState.keptLumas = Vec4<Real>(now, stored.x, stored.y, stored.z) / 255.0f;
  const Real last = now - stored.x;
  if (fabs(last) < 1.0f || stored.z == 0.0f) return;
  bool isPeriodic = false;
  for (int k = 1; k < 4; ++k) {
    const Real older = now - stored[k];
    if (!(older * last < 0.0f) && fabs(older) < fabs(last)) isPeriodic = true;
  }
  const Real size = saturated(deviation / 0.1f);
  const Real squared = size * size;
  if (isPeriodic && (squared * squared) * squared > 1.0f / 255.0f) lockState.instability = 1.0f;
}

} // namespace

template <typename Real>
LockStateOf<Real> holdHistory(const Inputs& inputs, const Settings& settings,
                              const ReprojectionOf<Real>& reprojected, const Vec2<Real>& readPosition,
                              const NeighborhoodOf<Real>& neighborhood, bool isValid, const glm::ivec2& pixel,
                              const glm::ivec2& drawn) {
  LockStateOf<Real> lockState;
  const bool locks = settings.rectify.locks == Switch::On;
  const bool findsInstability = settings.rectify.instability == Switch::On;
  if (!locks && !findsInstability) return lockState;
  const LumasOf<Real> lumas = lumasOf<Real>(inputs, drawn);
  lockState.luma = lumas.mean;
  const glm::ivec2 texel = clampedToPicture(texelOf(readPosition), inputs);
  if (locks) {
    const bool has = isValid && !inputs.historyLock.empty();
    const Vec2<Real> center = Vec2<Real>(pixel) + 0.5f;
    updateLock(inputs, number<Real>(settings.rectify.lockFrames), lumas,
               has ? Vec2<Real>(read<Real>(inputs.historyLock, texel)) : Vec2<Real>(0.0f),
               center + (center - reprojected.position), lockState);
  }
  if (findsInstability) {
    Vec4<Real> stored(0.0f);
    if (isValid && !inputs.historyLumas.empty())
      for (int k = 0; k < 4; ++k)
        stored[k] = floor(read<Real>(inputs.historyLumas, texel)[k] * 255.0f + 0.5f);
    updateInstability(lumas, stored, boxLuma(neighborhood.deviation, settings.space), lockState);
    decided<Real>(IntermediateId::instability);
  }
  lockState.protection =
      maximum(lockState.lock, lockState.instability) * (1.0f - sqrt(maskAt<Real>(inputs, drawn).x)); // 11.7
  return lockState;
}

#define TAA_HOLD(Real)                                                                                       \
  template LockStateOf<Real> holdHistory(                                                                    \
      const Inputs& inputs, const Settings& settings, const ReprojectionOf<Real>& reprojected,               \
      const Vec2<Real>& readPosition, const NeighborhoodOf<Real>& neighborhood, bool isValid,                \
      const glm::ivec2& pixel, const glm::ivec2& drawn);
TAA_EACH_NUMBER(TAA_HOLD)
#undef TAA_HOLD

} // namespace taa::twin
