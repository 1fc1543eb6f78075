// Stage 6, validate history: how deep the surface was, and how deep history is there.
#include "core/taa/twin/CompareDepth.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Upsample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace taa::twin {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// The sky lies infinitely far.
template <typename Real>
Real distance(Real depth) {
  return depth == 0.0f ? kInfinity : depth;
}

/// |z − z′| / z; the sky differs from everything by 1, but not from itself.
template <typename Real>
Real depthMismatch(const ValidateSettings& settings, Real expected, Real stored) {
  if (settings.depthDirection == DepthDirection::Nearer && !(distance(stored) < distance(expected)))
    return 0.0f;
  if (expected == 0.0f || stored == 0.0f) return expected == stored ? 0.0f : 1.0f;
  return fabs(expected - stored) / expected;
}

template <typename Real>
Real storedDepth(const Inputs& inputs, const glm::ivec2& place) {
  const glm::ivec2 texel = clampedToPicture(place, inputs);
  return read<Real>(inputs.historySurface, texel).y;
}

/// 3×3 in reading order.
std::vector<glm::ivec2> square(const glm::ivec2& middle) {
  std::vector<glm::ivec2> texels;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) texels.push_back(middle + glm::ivec2(x, y));
  return texels;
}

/// Texels of the square whose center is less than a pixel away along both axes: those with a bilinear weight.
template <typename Real>
std::vector<glm::ivec2> readTexels(const Vec2<Real>& position) {
  std::vector<glm::ivec2> texels = square(texelOf(position));
  std::erase_if(texels, [&](const glm::ivec2& texel) {
    const Vec2<Real> center = Vec2<Real>(texel) + 0.5f;
    return !(fabs(center.x - position.x) < 1.0f && fabs(center.y - position.y) < 1.0f);
  });
  return texels;
}

template <typename Real>
void takeBest(const Inputs& inputs, const ValidateSettings& settings, const std::vector<glm::ivec2>& texels,
              DepthTestOf<Real>& result) {
  std::optional<Real> least;
  for (const glm::ivec2& texel : texels) {
    const Real stored = storedDepth<Real>(inputs, texel);
    const Real mismatch = depthMismatch(settings, result.expected, stored);
    if (least && !(mismatch < *least)) continue;
    least = mismatch;
    result.stored = stored;
    result.mismatch = mismatch;
  }
}

/// The smaller step to two opposite neighbors where the surface goes on from one to the other; the step of a
/// ridge or of a groove leads to something else.
template <typename Real>
Real slopeBetween(const Inputs& inputs, const glm::ivec2& drawn, const glm::ivec2& direction) {
  const auto depthAt = [&](const glm::ivec2& place) {
    const glm::ivec2 texel = clampedToDrawn(place, inputs);
    return distance(viewDepth(read<Real>(inputs.depth, texel).x, inputs.depthTerms));
  };
  const Real before = depthAt(drawn - direction), own = depthAt(drawn), after = depthAt(drawn + direction);
  const bool isBetween = (before <= own && own <= after) || (after <= own && own <= before);
  return isBetween ? minimum(fabs(after - own), fabs(own - before)) : 0.0f;
}

/// τ and the share of the surface's slope (manual 12.1: grazing surfaces need a slope term).
template <typename Real>
Real allowedMismatch(const Inputs& inputs, const ValidateSettings& settings, const glm::ivec2& chosen,
                     Real expected) {
  if (expected == 0.0f || read<Real>(inputs.depth, chosen).x == 0.0f)
    return number<Real>(settings.depthTolerance);
  return number<Real>(settings.depthTolerance) +
         (number<Real>(settings.slopeAllowance) * named(depthSlope<Real>(inputs, chosen))) / expected;
}

/// Nothing that history shows there moved otherwise a frame ago, but for the limit. NaN moves.
template <typename Real>
bool isAtRest(const Inputs& inputs, const ValidateSettings& settings, const Vec2<Real>& motion,
              const Vec2<Real>& position) {
  if (inputs.historyMotion.empty()) return false;
  return std::ranges::all_of(readTexels(position), [&](const glm::ivec2& place) {
    const glm::ivec2 texel = clampedToPicture(place, inputs);
    const Vec2<Real> change = motion - Vec2<Real>(read<Real>(inputs.historyMotion, texel));
    const Real length = sqrt(change.x * change.x + change.y * change.y);
    return minimum(length, kNoPreviousPosition) <= number<Real>(settings.restLimit);
  });
}

/// Of the nearer of the two surfaces, in its own frame: seen past on opposite sides, in history, which is
/// dilated by a texel to all sides, a texel farther out. Now the pixel's own sample may see past it too.
template <typename Real>
bool isNearerThin(const Inputs& inputs, const DepthTestOf<Real>& depth, const glm::ivec2& drawn,
                  const glm::ivec2& middle) {
  const bool wasNearer = distance(depth.stored) < distance(depth.expected);
  const Real farther = wasNearer ? depth.expected : depth.stored;
  const auto isSeenPast = [&](const glm::ivec2& step) {
    const glm::ivec2 now = clampedToDrawn(drawn + step, inputs);
    const Real seen =
        wasNearer ? storedDepth<Real>(inputs, middle + 2 * step) : read<Real>(inputs.previousDepth, now).x;
    return seen == 0.0f || (farther != 0.0f && seen >= farther * (1.0f - depth.allowed));
  };
  if (!wasNearer && isSeenPast({0, 0})) return true;
  constexpr std::array<glm::ivec2, 4> kAxes{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  return std::ranges::any_of(kAxes,
                             [&](const glm::ivec2& axis) { return isSeenPast(axis) && isSeenPast(-axis); });
}

} // namespace

template <typename Real>
Real depthSlope(const Inputs& inputs, const glm::ivec2& drawn) {
  if (read<Real>(inputs.depth, drawn).x == 0.0f) return 0.0f;
  return slopeBetween<Real>(inputs, drawn, {1, 0}) + slopeBetween<Real>(inputs, drawn, {0, 1});
}

template <typename Real>
DepthTestOf<Real> compareDepth(const Inputs& inputs, const ValidateSettings& settings,
                               const DilatedMotionOf<Real>& dilated, const glm::ivec2& drawn,
                               const Vec2<Real>& position) {
  const glm::ivec2 chosen = drawn + dilated.offset, middle = texelOf(position);
  DepthTestOf<Real> result;
  result.expected = read<Real>(inputs.previousDepth, chosen).x;
  searched<Real>();
  result.allowed = allowedMismatch(inputs, settings, chosen, result.expected);
  decided<Real>(IntermediateId::depthAllowed);
  if (inputs.historyColor.empty()) return result;
  const bool isOn = settings.depth == Switch::On, findsFlicker = isOn && settings.flicker == Switch::On;
  const bool widens = settings.depthFootprint == DepthFootprint::ReadInMotion;
  takeBest(inputs, settings, widens ? readTexels(position) : square(middle), result);
  searched<Real>();
  result.isOther = result.mismatch > result.allowed;
  if (!result.isOther || !(findsFlicker || (isOn && widens))) return result;
  if (!isAtRest(inputs, settings, dilated.motion, position)) return result;
  takeBest(inputs, settings, square(middle), result);
  searched<Real>();
  result.isOther = result.mismatch > result.allowed;
  result.isFlicker = result.isOther && findsFlicker && isNearerThin(inputs, result, drawn, middle);
  result.isOther = result.isOther && !result.isFlicker;
  return result;
}

#define TAA_COMPARE_DEPTH(Real)                                                                              \
  template Real depthSlope(const Inputs& inputs, const glm::ivec2& drawn);                                   \
  template DepthTestOf<Real> compareDepth(const Inputs& inputs, const ValidateSettings& settings,            \
                                          const DilatedMotionOf<Real>& dilated, const glm::ivec2& drawn,     \
                                          const Vec2<Real>& position);
TAA_EACH_NUMBER(TAA_COMPARE_DEPTH)
#undef TAA_COMPARE_DEPTH

} // namespace taa::twin
