// Stage 6, validate history: how deep the surface was, and how deep history is there.
#include "core/taa/twin/CompareDepth.h"

#include "core/taa/twin/Color.h"
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
float distance(float depth) {
  return depth == 0.0f ? kInfinity : depth;
}

/// |z − z′| / z; the sky differs from everything by 1, but not from itself.
float depthMismatch(const ValidateSettings& settings, float expected, float stored) {
  if (settings.depthDirection == DepthDirection::Nearer && !(distance(stored) < distance(expected)))
    return 0.0f;
  if (expected == 0.0f || stored == 0.0f) return expected == stored ? 0.0f : 1.0f;
  return std::fabs(expected - stored) / expected;
}

float storedDepth(const Inputs& inputs, const glm::ivec2& place) {
  const glm::ivec2 texel = clampedToPicture(place, inputs);
  return inputs.historySurface.texel(texel.x, texel.y).y;
}

/// 3×3 in reading order.
std::vector<glm::ivec2> square(const glm::ivec2& middle) {
  std::vector<glm::ivec2> texels;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) texels.push_back(middle + glm::ivec2(x, y));
  return texels;
}

/// Texels of the square whose center is less than a pixel away along both axes: those with a bilinear weight.
std::vector<glm::ivec2> readTexels(const glm::vec2& position) {
  std::vector<glm::ivec2> texels = square(texelOf(position));
  std::erase_if(texels, [&](const glm::ivec2& texel) {
    const glm::vec2 center(static_cast<float>(texel.x) + 0.5f, static_cast<float>(texel.y) + 0.5f);
    return !(std::fabs(center.x - position.x) < 1.0f && std::fabs(center.y - position.y) < 1.0f);
  });
  return texels;
}

void takeBest(const Inputs& inputs, const ValidateSettings& settings, const std::vector<glm::ivec2>& texels,
              DepthTest& result) {
  std::optional<float> least;
  for (const glm::ivec2& texel : texels) {
    const float stored = storedDepth(inputs, texel);
    const float mismatch = depthMismatch(settings, result.expected, stored);
    if (least && !(mismatch < *least)) continue;
    least = mismatch;
    result.stored = stored;
    result.mismatch = mismatch;
  }
}

/// The smaller step to two opposite neighbors where the surface goes on from one to the other; the step of a
/// ridge or of a groove leads to something else.
float slopeBetween(const Inputs& inputs, const glm::ivec2& drawn, const glm::ivec2& direction) {
  const auto depthAt = [&](const glm::ivec2& place) {
    const glm::ivec2 texel = clampedToDrawn(place, inputs);
    return distance(viewDepth(inputs.depth.texel(texel.x, texel.y).x, inputs.depthTerms));
  };
  const float before = depthAt(drawn - direction), own = depthAt(drawn), after = depthAt(drawn + direction);
  const bool isBetween = (before <= own && own <= after) || (after <= own && own <= before);
  return isBetween ? std::min(std::fabs(own - before), std::fabs(after - own)) : 0.0f;
}

/// τ and the share of the surface's slope (manual 12.1: grazing surfaces need a slope term).
float allowedMismatch(const Inputs& inputs, const ValidateSettings& settings, const glm::ivec2& chosen,
                      float expected) {
  if (expected == 0.0f || inputs.depth.texel(chosen.x, chosen.y).x == 0.0f) return settings.depthTolerance;
  return settings.depthTolerance + (settings.slopeAllowance * depthSlope(inputs, chosen)) / expected;
}

/// Nothing that history shows there moved otherwise a frame ago, but for the limit. NaN moves.
bool isAtRest(const Inputs& inputs, const ValidateSettings& settings, const glm::vec2& motion,
              const glm::vec2& position) {
  if (inputs.historyMotion.empty()) return false;
  return std::ranges::all_of(readTexels(position), [&](const glm::ivec2& place) {
    const glm::ivec2 texel = clampedToPicture(place, inputs);
    const glm::vec2 change = motion - glm::vec2(inputs.historyMotion.texel(texel.x, texel.y));
    const float length = std::sqrt(change.x * change.x + change.y * change.y);
    return std::min(length, kNoPreviousPosition) <= settings.restLimit;
  });
}

/// Of the nearer of the two surfaces, in its own frame: seen past on opposite sides, in history, which is
/// dilated by a texel to all sides, a texel farther out. Now the pixel's own sample may see past it too.
bool isNearerThin(const Inputs& inputs, const DepthTest& depth, const glm::ivec2& drawn,
                  const glm::ivec2& middle) {
  const bool wasNearer = distance(depth.stored) < distance(depth.expected);
  const float farther = wasNearer ? depth.expected : depth.stored;
  const auto isSeenPast = [&](const glm::ivec2& step) {
    const glm::ivec2 now = clampedToDrawn(drawn + step, inputs);
    const float seen =
        wasNearer ? storedDepth(inputs, middle + 2 * step) : inputs.previousDepth.texel(now.x, now.y).x;
    return seen == 0.0f || (farther != 0.0f && seen >= farther * (1.0f - depth.allowed));
  };
  if (!wasNearer && isSeenPast({0, 0})) return true;
  constexpr std::array<glm::ivec2, 4> kAxes{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  return std::ranges::any_of(kAxes,
                             [&](const glm::ivec2& axis) { return isSeenPast(axis) && isSeenPast(-axis); });
}

} // namespace

float depthSlope(const Inputs& inputs, const glm::ivec2& drawn) {
  if (inputs.depth.texel(drawn.x, drawn.y).x == 0.0f) return 0.0f;
  return slopeBetween(inputs, drawn, {1, 0}) + slopeBetween(inputs, drawn, {0, 1});
}

DepthTest compareDepth(const Inputs& inputs, const ValidateSettings& settings, const DilatedMotion& dilated,
                       const glm::ivec2& drawn, const glm::vec2& position) {
  const glm::ivec2 chosen = drawn + dilated.offset, middle = texelOf(position);
  DepthTest result;
  result.expected = inputs.previousDepth.texel(chosen.x, chosen.y).x;
  result.allowed = allowedMismatch(inputs, settings, chosen, result.expected);
  if (inputs.historyColor.empty()) return result;
  const bool isOn = settings.depth == Switch::On, findsFlicker = isOn && settings.flicker == Switch::On;
  const bool widens = settings.depthFootprint == DepthFootprint::ReadInMotion;
  takeBest(inputs, settings, widens ? readTexels(position) : square(middle), result);
  result.isOther = result.mismatch > result.allowed;
  if (!result.isOther || !(findsFlicker || (isOn && widens))) return result;
  if (!isAtRest(inputs, settings, dilated.motion, position)) return result;
  takeBest(inputs, settings, square(middle), result);
  result.isOther = result.mismatch > result.allowed;
  result.isFlicker = result.isOther && findsFlicker && isNearerThin(inputs, result, drawn, middle);
  result.isOther = result.isOther && !result.isFlicker;
  return result;
}

} // namespace taa::twin
