// Stage 7, rectify history: a color outside the box is moved onto it.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"

#include <cassert>
#include <cmath>
#include <optional>
#include <vector>

namespace taa::twin {
namespace {

/// Keeps the extent of a flat box from being a zero divisor.
constexpr float kMinExtent = 1e-8f;

float magnitude(const glm::vec3& v) {
  return std::sqrt((v.x * v.x + v.y * v.y) + v.z * v.z);
}

bool isInside(const glm::vec3& h, const glm::vec3& low, const glm::vec3& high) {
  for (int i = 0; i < 3; ++i) {
    if (!(h[i] >= low[i] && h[i] <= high[i])) return false;
  }
  return true;
}

/// Nearest point of the box (manual 11.1).
Rectified clampToBox(const glm::vec3& h, const glm::vec3& low, const glm::vec3& high) {
  const glm::vec3 center = 0.5f * (low + high);
  const glm::vec3 r = clamped(h, low, high);
  const float whole = magnitude(center - h);
  return {r, whole == 0.0f ? 0.0f : magnitude(r - h) / whole};
}

/// Along the line to the center (manual 11.2).
Rectified clipToCenter(const glm::vec3& h, const glm::vec3& low, const glm::vec3& high) {
  const glm::vec3 center = 0.5f * (low + high);
  const glm::vec3 extent = 0.5f * (high - low) + kMinExtent;
  float m = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const float u = std::fabs(h[i] - center[i]) / extent[i];
    m = u > m ? u : m;
  }
  if (!(m > 1.0f)) return {h, 0.0f};
  return {center + (h - center) / m, 1.0f - 1.0f / m};
}

/// Along the line to `aim`, a color of this frame, brought into the box first (manual 11.3).
Rectified clipToFiltered(const glm::vec3& h, const glm::vec3& aim, const glm::vec3& low,
                         const glm::vec3& high) {
  const glm::vec3 target = clamped(aim, low, high);
  const glm::vec3 d = target - h;
  float t = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const float enter = h[i] < low[i]    ? (low[i] - h[i]) / d[i]
                        : h[i] > high[i] ? (high[i] - h[i]) / d[i]
                                         : 0.0f;
    t = enter > t ? enter : t;
  }
  if (t >= 1.0f) return {target, 1.0f};
  return {h + d * t, t};
}

} // namespace

Rectified clip(RectifyMethod method, const glm::vec3& value, const glm::vec3& target, const glm::vec3& boxMin,
               const glm::vec3& boxMax) {
  if (method == RectifyMethod::None || isInside(value, boxMin, boxMax)) return {value, 0.0f};
  switch (method) {
  case RectifyMethod::Clamp:
    return clampToBox(value, boxMin, boxMax);
  case RectifyMethod::ClipToCenter:
    return clipToCenter(value, boxMin, boxMax);
  case RectifyMethod::ClipToFiltered:
    return clipToFiltered(value, target, boxMin, boxMax);
  case RectifyMethod::None:
  case RectifyMethod::ShrinkAxes:
  case RectifyMethod::ClampThenClip:
  case RectifyMethod::RayToCurrent:
  case RectifyMethod::ClipToHull:
  case RectifyMethod::ClipToBoth:
  case RectifyMethod::ClampForget:
  case RectifyMethod::Select:
    break;
  }
  assert(false);
  return {value, 0.0f};
}

namespace {

/// How far `value` is from h, against the way from h to `target`.
float shareToTarget(const glm::vec3& value, const glm::vec3& h, const glm::vec3& target) {
  const float whole = magnitude(target - h);
  return whole == 0.0f ? 0.0f : magnitude(value - h) / whole;
}

/// Towards the mean, made to fit axis by axis (manual 11.5).
Rectified shrinkAxes(const glm::vec3& h, const Neighborhood& n) {
  if (isInside(h, n.boxMin, n.boxMax)) return {h, 0.0f};
  const glm::vec3 mean = clamped(n.mean, n.boxMin, n.boxMax);
  glm::vec3 r = h - mean;
  for (int i = 0; i < 3; ++i) {
    const float high = n.boxMax[i] - mean[i];
    const float low = n.boxMin[i] - mean[i];
    if (r[i] > high) {
      r = r * (high / r[i]);
    } else if (r[i] < low) {
      r = r * (low / r[i]);
    }
  }
  const glm::vec3 value = mean + r;
  return {value, shareToTarget(value, h, mean)};
}

/// One box after the other (manual 10.5).
Rectified clampThenClip(const glm::vec3& h, const Neighborhood& n) {
  const Rectified second = clipToCenter(clamped(h, n.min, n.max), n.boxMin, n.boxMax);
  return {second.value, shareToTarget(second.value, h, 0.5f * (n.boxMin + n.boxMax))};
}

/// Where the ray to the current color meets the box, if that is not too far (manual 11.4).
Rectified rayToCurrent(const glm::vec3& h, const glm::vec3& current, const Neighborhood& n, float farthest) {
  if (isInside(h, n.boxMin, n.boxMax)) return {h, 0.0f};
  const glm::vec3 d = current - h;
  const glm::vec3 b = 0.5f * (n.boxMin + n.boxMax);
  const glm::vec3 e = 0.5f * (n.boxMax - n.boxMin);
  float t = 1e9f;
  for (int i = 0; i < 3; ++i) {
    if (d[i] == 0.0f) continue;
    const float hit = ((b[i] - (d[i] > 0.0f ? e[i] : -e[i])) - h[i]) / d[i];
    if (hit >= 0.0f && hit < t) t = hit;
  }
  if (t > farthest) return {h, 0.0f};
  return {h + d * t, t < 1.0f ? t : 1.0f};
}

/// Towards `target` into what slabs [min d·c, max d·c] of the samples and the target leave
/// (manual 9.7, 10.12).
Rectified clipToSlabs(const glm::vec3& h, const glm::vec3& target, const Neighborhood& n,
                      const std::vector<glm::vec3>& directions) {
  const glm::vec3 toTarget = target - h;
  float t = 0.0f;
  for (const glm::vec3& d : directions) {
    const auto across = [&d](const glm::vec3& c) { return (d.x * c.x + d.y * c.y) + d.z * c.z; };
    float low = across(target), high = low;
    for (const glm::vec3& sample : n.samples) {
      low = across(sample) < low ? across(sample) : low;
      high = across(sample) > high ? across(sample) : high;
    }
    const float from = across(h);
    const float enter = from < low    ? (low - from) / across(toTarget)
                        : from > high ? (high - from) / across(toTarget)
                                      : 0.0f;
    t = enter > t ? enter : t;
  }
  if (!(t > 0.0f)) return {h, 0.0f};
  if (t >= 1.0f) return {target, 1.0f};
  return {h + toTarget * t, t};
}

/// Axes of the space that is looked at besides the box's: Y, Co and Cg by R, G and B, or those by the box's
/// axes. How long they are does not matter.
std::vector<glm::vec3> otherAxes(ColorSpace space) {
  switch (space) {
  case ColorSpace::Rgb:
    return {{1, 2, 1}, {1, 0, -1}, {-1, 2, -1}};
  case ColorSpace::YCoCg:
  case ColorSpace::YCoCgAsPrinted:
    return {{1, 1, -1}, {1, 0, 1}, {1, -1, -1}};
  case ColorSpace::YCoCgLifting:
    return {{2, 1, -1}, {2, 0, 1}, {2, -1, -1}};
  case ColorSpace::YCbCr: // green: Y less 0.0722 × 1.8556 / 0.7152 Cb and 0.2126 × 1.5748 / 0.7152 Cr
    return {{1, 0, 1.5748f}, {1, -0.18732427f, -0.46812427f}, {1, 1.8556f, 0}};
  }
  return {};
}

Rectified rectifiedByMethod(const RectifySettings& settings, ColorSpace space, const glm::vec3& h,
                            const glm::vec3& current, const Neighborhood& n) {
  switch (settings.method) {
  case RectifyMethod::ShrinkAxes:
    return shrinkAxes(h, n);
  case RectifyMethod::ClampThenClip:
    return clampThenClip(h, n);
  case RectifyMethod::ClipToHull:
  case RectifyMethod::ClipToBoth:
    return clipToSlabs(h, current, n, slabDirections(settings.method, space));
  case RectifyMethod::RayToCurrent:
    return rayToCurrent(h, current, n, settings.maxSteps);
  case RectifyMethod::ClampForget:
    return clip(RectifyMethod::Clamp, h, current, n.boxMin, n.boxMax);
  case RectifyMethod::None:
  case RectifyMethod::Clamp:
  case RectifyMethod::ClipToCenter:
  case RectifyMethod::ClipToFiltered:
  case RectifyMethod::Select: // does not come here
    break;
  }
  return clip(settings.method, h, current, n.boxMin, n.boxMax);
}

/// Part of the correction that is applied (manual 11.6, 13.9).
float rectifyStrength(const RectifySettings& settings, const RectifyInputs& applied) {
  if (settings.method == RectifyMethod::None) return 0.0f;
  const float ofFlicker = applied.isFlicker ? settings.flickerStrength : 1.0f;
  if (settings.relaxAtRest == Switch::Off) return ofFlicker;
  const float q = applied.speed / settings.restSpeed;
  return (settings.minStrength + (1.0f - settings.minStrength) * saturated(q * q)) * ofFlicker;
}

/// A sample in the place of history, inside the box as well, and not taken through its space
/// (manual 11.8).
Rectified selected(const glm::vec3& historyRaw, const glm::vec3& h, const Neighborhood& n) {
  const glm::vec3 color = n.colors[nearestSample(h, n)];
  if (color == historyRaw) return {historyRaw, 0.0f};
  return {color, 1.0f, 1.0f, true};
}

/// Whether history outside the box counts as moved where the method leaves it: a box that is upside down has
/// nothing inside.
bool keepsOnlyInside(RectifyMethod method) {
  return method == RectifyMethod::Clamp || method == RectifyMethod::ClampForget ||
         method == RectifyMethod::ClipToFiltered || method == RectifyMethod::ShrinkAxes;
}

} // namespace

Rectified rectifiedFully(const Settings& settings, const glm::vec3& historyRaw,
                         const glm::vec3& currentFiltered, const Neighborhood& n) {
  const glm::vec3 h = toBox(historyRaw, settings.space);
  if (settings.rectify.method == RectifyMethod::Select) return selected(historyRaw, h, n);
  const Rectified clipped =
      rectifiedByMethod(settings.rectify, settings.space.color, h, toBox(currentFiltered, settings.space), n);
  // Kept history is kept exactly: no way there and back through the box's space.
  const bool isOutside = keepsOnlyInside(settings.rectify.method) && !isInside(h, n.boxMin, n.boxMax);
  if (clipped.value == h && clipped.amount == 0.0f && !isOutside) return {historyRaw, 0.0f};
  return {storable(fromBox(clipped.value, settings.space)), clipped.amount, 1.0f, true};
}

std::optional<glm::vec3> rectifyTarget(RectifyMethod method, const glm::vec3& currentFiltered,
                                       const Neighborhood& neighborhood) {
  const glm::vec3 &low = neighborhood.boxMin, &high = neighborhood.boxMax;
  switch (method) {
  case RectifyMethod::ClipToCenter:
  case RectifyMethod::ClampThenClip:
    return 0.5f * (low + high);
  case RectifyMethod::ClipToFiltered:
    return clamped(currentFiltered, low, high);
  case RectifyMethod::RayToCurrent:
  case RectifyMethod::ClipToHull:
  case RectifyMethod::ClipToBoth:
    return currentFiltered;
  case RectifyMethod::ShrinkAxes:
    return clamped(neighborhood.mean, low, high);
  case RectifyMethod::None:
  case RectifyMethod::Clamp:
  case RectifyMethod::ClampForget:
  case RectifyMethod::Select:
    break;
  }
  return {};
}

std::vector<glm::vec3> slabDirections(RectifyMethod method, ColorSpace space) {
  std::vector<glm::vec3> directions;
  if (method == RectifyMethod::ClipToBoth) {
    directions = otherAxes(space);
    for (int i = 0; i < 3; ++i) {
      glm::vec3 own(0.0f);
      own[i] = 1.0f;
      directions.push_back(own);
    }
  }
  if (method != RectifyMethod::ClipToHull) return directions;
  for (int code = 14; code < 27; ++code) // components −1, 0 or 1: 26 directions, one of each opposite pair
    directions.emplace_back(glm::ivec3(code / 9 - 1, code / 3 % 3 - 1, code % 3 - 1));
  return directions;
}

std::size_t nearestSample(const glm::vec3& h, const Neighborhood& neighborhood) {
  const auto squared = [&](std::size_t k) {
    const glm::vec3 toTarget = neighborhood.samples[k] - h;
    return (toTarget.x * toTarget.x + toTarget.y * toTarget.y) + toTarget.z * toTarget.z;
  };
  std::size_t nearest = 4; // the pixel's own, unless another is nearer
  for (std::size_t k = 0; k < neighborhood.samples.size(); ++k)
    if (squared(k) < squared(nearest)) nearest = k;
  return nearest;
}

Rectified rectifyHistory(const Inputs& inputs, const Settings& settings, const glm::vec3& historyRaw,
                         const glm::vec3& currentFiltered, const Neighborhood& neighborhood,
                         const RectifyInputs& applied) {
  const RectifySettings& rectify = settings.rectify;
  const float strength = rectifyStrength(rectify, applied);
  if (inputs.historyColor.empty()) return {historyRaw, 0.0f, strength};
  Rectified clipped = rectifiedFully(settings, historyRaw, currentFiltered, neighborhood);
  clipped.strength = strength;
  if (!clipped.moved) return clipped;
  if (rectify.relaxAtRest == Switch::On || strength < 1.0f) {
    clipped.value = historyRaw + strength * (clipped.value - historyRaw);
    clipped.amount = clipped.amount * strength;
  }
  if (rectify.locks == Switch::On || rectify.instability == Switch::On) {
    clipped.value = clipped.value + applied.protection * (historyRaw - clipped.value);
    clipped.amount = clipped.amount * (1.0f - applied.protection);
  }
  return clipped;
}

float lengthKept(const Settings& settings, float historyLength, const Rectified& clipped, float protection) {
  if (settings.rectify.method != RectifyMethod::ClampForget || !clipped.moved) return historyLength;
  const float forgotten = historyLength < 1.6216216f ? historyLength : 1.6216216f; // 0.1 / (0.74/12)
  return forgotten + protection * (historyLength - forgotten);
}

} // namespace taa::twin
