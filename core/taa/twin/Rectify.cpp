// Stage 7, rectify history: a color outside the box is moved onto it.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Stages.h"

#include <cassert>
#include <cmath>
#include <optional>
#include <vector>

namespace taa::twin {
namespace {

/// Keeps the extent of a flat box from being a zero divisor.
constexpr float kMinExtent = 1e-8f;

template <typename Real>
Real magnitude(const Vec3<Real>& v) {
  return sqrt((v.x * v.x + v.y * v.y) + v.z * v.z);
}

template <typename Real>
bool isInside(const Vec3<Real>& h, const Vec3<Real>& low, const Vec3<Real>& high) {
  for (int i = 0; i < 3; ++i) {
    if (!(h[i] >= low[i] && h[i] <= high[i])) return false;
  }
  return true;
}

/// How far `value` is from h, against the way from h to `target`.
template <typename Real>
Real shareToTarget(const Vec3<Real>& value, const Vec3<Real>& h, const Vec3<Real>& target) {
  const Real whole = magnitude(target - h);
  return whole == 0.0f ? 0.0f : magnitude(value - h) / whole;
}

/// Nearest point of the box (manual 11.1).
template <typename Real>
RectifiedOf<Real> clampToBox(const Vec3<Real>& h, const Vec3<Real>& low, const Vec3<Real>& high) {
  const Vec3<Real> center = 0.5f * (low + high);
  const Vec3<Real> r = named(clamped(h, low, high));
  return {r, shareToTarget(r, h, center)};
}

/// Along the line to the center (manual 11.2).
template <typename Real>
RectifiedOf<Real> clipToCenter(const Vec3<Real>& h, const Vec3<Real>& low, const Vec3<Real>& high) {
  const Vec3<Real> center = 0.5f * (low + high);
  const Vec3<Real> extent = 0.5f * (high - low) + kMinExtent;
  Real m = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const Real u = fabs(h[i] - center[i]) / extent[i];
    m = u > m ? u : m;
  }
  if (!(m > 1.0f)) return {h, 0.0f};
  return {center + (h - center) / m, 1.0f - 1.0f / m};
}

/// Along the line to `aim`, a color of this frame, brought into the box first (manual 11.3).
template <typename Real>
RectifiedOf<Real> clipToFiltered(const Vec3<Real>& h, const Vec3<Real>& aim, const Vec3<Real>& low,
                                 const Vec3<Real>& high) {
  const Vec3<Real> target = named(clamped(aim, low, high));
  const Vec3<Real> d = target - h;
  Real t = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const Real enter = h[i] < low[i]    ? (low[i] - h[i]) / d[i]
                       : h[i] > high[i] ? (high[i] - h[i]) / d[i]
                                        : 0.0f;
    t = enter > t ? enter : t;
  }
  if (t >= 1.0f) return {target, 1.0f};
  return {h + d * t, t};
}

} // namespace

template <typename Real>
RectifiedOf<Real> clip(RectifyMethod method, const Vec3<Real>& value, const Vec3<Real>& target,
                       const Vec3<Real>& boxMin, const Vec3<Real>& boxMax) {
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

/// Towards the mean, made to fit axis by axis (manual 11.5).
template <typename Real>
RectifiedOf<Real> shrinkAxes(const Vec3<Real>& h, const NeighborhoodOf<Real>& n) {
  if (isInside(h, n.boxMin, n.boxMax)) return {h, 0.0f};
  const Vec3<Real> mean = named(clamped(n.mean, n.boxMin, n.boxMax));
  Vec3<Real> r = h - mean;
  for (int i = 0; i < 3; ++i) {
    const Real high = n.boxMax[i] - mean[i];
    const Real low = n.boxMin[i] - mean[i];
    if (r[i] > high) {
      r = r * (high / r[i]);
    } else if (r[i] < low) {
      r = r * (low / r[i]);
    }
  }
  const Vec3<Real> value = named(mean + r);
  return {value, shareToTarget(value, h, mean)};
}

/// One box after the other (manual 10.5).
template <typename Real>
RectifiedOf<Real> clampThenClip(const Vec3<Real>& h, const NeighborhoodOf<Real>& n) {
  const RectifiedOf<Real> second = clipToCenter(named(clamped(h, n.min, n.max)), n.boxMin, n.boxMax);
  const Vec3<Real> value = named(second.value);
  return {value, shareToTarget(value, h, 0.5f * (n.boxMin + n.boxMax))};
}

/// Where the ray to the current color meets the box, if that is not too far (manual 11.4).
template <typename Real>
RectifiedOf<Real> rayToCurrent(const Vec3<Real>& h, const Vec3<Real>& current, const NeighborhoodOf<Real>& n,
                               Real farthest) {
  if (isInside(h, n.boxMin, n.boxMax)) return {h, 0.0f};
  const Vec3<Real> d = current - h;
  const Vec3<Real> b = 0.5f * (n.boxMin + n.boxMax);
  const Vec3<Real> e = 0.5f * (n.boxMax - n.boxMin);
  Real t = 1e9f;
  for (int i = 0; i < 3; ++i) {
    if (d[i] == 0.0f) continue;
    const Real hit = ((b[i] - (d[i] > 0.0f ? e[i] : -e[i])) - h[i]) / d[i];
    if (hit >= 0.0f && hit < t) t = hit;
  }
  if (t > farthest) return {h, 0.0f};
  return {h + d * t, t < 1.0f ? t : 1.0f};
}

/// Towards `target` into what slabs [min d·c, max d·c] of the samples and the target leave
/// (manual 9.7, 10.12).
template <typename Real>
RectifiedOf<Real> clipToSlabs(const Vec3<Real>& h, const Vec3<Real>& target, const NeighborhoodOf<Real>& n,
                              const std::vector<Vec3<Real>>& directions) {
  const Vec3<Real> toTarget = target - h;
  Real t = 0.0f;
  for (const Vec3<Real>& d : directions) {
    const auto across = [&d](const Vec3<Real>& c) { return named((d.x * c.x + d.y * c.y) + d.z * c.z); };
    Real low = across(target), high = low;
    for (const Vec3<Real>& sample : n.samples) {
      low = across(sample) < low ? across(sample) : low;
      high = across(sample) > high ? across(sample) : high;
    }
    const Real from = across(h);
    const Real enter = from < low    ? (low - from) / across(toTarget)
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
template <typename Real>
std::vector<Vec3<Real>> otherAxes(ColorSpace space) {
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

template <typename Real>
RectifiedOf<Real> rectifiedByMethod(const RectifySettings& settings, ColorSpace space, const Vec3<Real>& h,
                                    const Vec3<Real>& current, const NeighborhoodOf<Real>& n) {
  switch (settings.method) {
  case RectifyMethod::ShrinkAxes:
    return shrinkAxes(h, n);
  case RectifyMethod::ClampThenClip:
    return clampThenClip(h, n);
  case RectifyMethod::ClipToHull:
  case RectifyMethod::ClipToBoth:
    return clipToSlabs(h, current, n, slabDirections<Real>(settings.method, space));
  case RectifyMethod::RayToCurrent:
    return rayToCurrent(h, current, n, number<Real>(settings.maxSteps));
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
template <typename Real>
Real rectifyStrength(const RectifySettings& settings, const RectifyInputsOf<Real>& applied) {
  if (settings.method == RectifyMethod::None) return 0.0f;
  const Real ofFlicker = applied.isFlicker ? number<Real>(settings.flickerStrength) : 1.0f;
  if (settings.relaxAtRest == Switch::Off) return ofFlicker;
  const Real q = applied.speed / number<Real>(settings.restSpeed);
  return (number<Real>(settings.minStrength) +
          (1.0f - number<Real>(settings.minStrength)) * saturated(q * q)) *
         ofFlicker;
}

/// A sample in the place of history, inside the box as well, and not taken through its space
/// (manual 11.8).
template <typename Real>
RectifiedOf<Real> selected(const Vec3<Real>& historyRaw, const Vec3<Real>& h, const NeighborhoodOf<Real>& n) {
  const std::size_t nearest = nearestSample(h, n);
  if (n.colors[nearest] == historyRaw) return {historyRaw, 0.0f};
  return {n.colors[nearest], 1.0f, 1.0f, true, n.samples[nearest]};
}

/// Whether history outside the box counts as moved where the method leaves it: a box that is upside down has
/// nothing inside.
bool keepsOnlyInside(RectifyMethod method) {
  return method == RectifyMethod::Clamp || method == RectifyMethod::ClampForget ||
         method == RectifyMethod::ClipToFiltered || method == RectifyMethod::ShrinkAxes;
}

} // namespace

template <typename Real>
RectifiedOf<Real> rectifiedFully(const Settings& settings, const Vec3<Real>& historyRaw,
                                 const Vec3<Real>& currentFiltered, const NeighborhoodOf<Real>& n) {
  const Vec3<Real> h = named(toBox(historyRaw, settings.space));
  if (settings.rectify.method == RectifyMethod::Select) return selected(historyRaw, h, n);
  const RectifiedOf<Real> clipped = rectifiedByMethod(settings.rectify, settings.space.color, h,
                                                      named(toBox(currentFiltered, settings.space)), n);
  // Kept history is kept exactly: no way there and back through the box's space.
  const bool isOutside = keepsOnlyInside(settings.rectify.method) && !isInside(h, n.boxMin, n.boxMax);
  if (clipped.value == h && clipped.amount == 0.0f && !isOutside) return {historyRaw, 0.0f};
  return {named(storable(fromBox(clipped.value, settings.space))), clipped.amount, 1.0f, true, clipped.value};
}

template <typename Real>
std::optional<Vec3<Real>> rectifyTarget(RectifyMethod method, const Vec3<Real>& currentFiltered,
                                        const NeighborhoodOf<Real>& neighborhood) {
  const Vec3<Real>&low = neighborhood.boxMin, &high = neighborhood.boxMax;
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

template <typename Real>
std::vector<Vec3<Real>> slabDirections(RectifyMethod method, ColorSpace space) {
  std::vector<Vec3<Real>> directions;
  if (method == RectifyMethod::ClipToBoth) {
    directions = otherAxes<Real>(space);
    for (int i = 0; i < 3; ++i) {
      Vec3<Real> own(0.0f);
      own[i] = 1.0f;
      directions.push_back(own);
    }
  }
  if (method != RectifyMethod::ClipToHull) return directions;
  for (int code = 14; code < 27; ++code) // components −1, 0 or 1: 26 directions, one of each opposite pair
    directions.emplace_back(glm::ivec3(code / 9 - 1, code / 3 % 3 - 1, code % 3 - 1));
  return directions;
}

template <typename Real>
std::size_t nearestSample(const Vec3<Real>& h, const NeighborhoodOf<Real>& neighborhood) {
  const auto squared = [&](std::size_t k) {
    const Vec3<Real> toTarget = neighborhood.samples[k] - h;
    return (toTarget.x * toTarget.x + toTarget.y * toTarget.y) + toTarget.z * toTarget.z;
  };
  std::size_t nearest = 4; // the pixel's own, unless another is nearer
  for (std::size_t k = 0; k < neighborhood.samples.size(); ++k)
    if (squared(k) < squared(nearest)) nearest = k;
  return nearest;
}

template <typename Real>
RectifiedOf<Real> rectifyHistory(const Inputs& inputs, const Settings& settings, const Vec3<Real>& historyRaw,
                                 const Vec3<Real>& currentFiltered, const NeighborhoodOf<Real>& neighborhood,
                                 const RectifyInputsOf<Real>& applied) {
  const RectifySettings& rectify = settings.rectify;
  searched<Real>();
  const Real strength = rectifyStrength(rectify, applied);
  if (inputs.historyColor.empty()) return {historyRaw, 0.0f, strength};
  RectifiedOf<Real> clipped = rectifiedFully(settings, historyRaw, currentFiltered, neighborhood);
  decided<Real>(IntermediateId::clipAmount);
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

template <typename Real>
Real lengthKept(const Settings& settings, Real historyLength, const RectifiedOf<Real>& clipped,
                Real protection) {
  if (settings.rectify.method != RectifyMethod::ClampForget || !clipped.moved) return historyLength;
  const Real forgotten = minimum(historyLength, 1.6216216f); // 0.1 / (0.74/12)
  return forgotten + protection * (historyLength - forgotten);
}

#define TAA_RECTIFY(Real)                                                                                    \
  template RectifiedOf<Real> clip(RectifyMethod method, const Vec3<Real>& value, const Vec3<Real>& target,   \
                                  const Vec3<Real>& boxMin, const Vec3<Real>& boxMax);                       \
  template std::optional<Vec3<Real>> rectifyTarget(RectifyMethod method, const Vec3<Real>& currentFiltered,  \
                                                   const NeighborhoodOf<Real>& neighborhood);                \
  template std::vector<Vec3<Real>> slabDirections(RectifyMethod method, ColorSpace space);                   \
  template std::size_t nearestSample(const Vec3<Real>& h, const NeighborhoodOf<Real>& neighborhood);         \
  template RectifiedOf<Real> rectifiedFully(const Settings& settings, const Vec3<Real>& historyRaw,          \
                                            const Vec3<Real>& currentFiltered,                               \
                                            const NeighborhoodOf<Real>& neighborhood);                       \
  template Real lengthKept(const Settings& settings, Real historyLength, const RectifiedOf<Real>& clipped,   \
                           Real protection);                                                                 \
  template RectifiedOf<Real> rectifyHistory(const Inputs& inputs, const Settings& settings,                  \
                                            const Vec3<Real>& historyRaw, const Vec3<Real>& currentFiltered, \
                                            const NeighborhoodOf<Real>& neighborhood,                        \
                                            const RectifyInputsOf<Real>& applied);
TAA_EACH_NUMBER(TAA_RECTIFY)
#undef TAA_RECTIFY

} // namespace taa::twin
