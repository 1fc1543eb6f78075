// Stage 6, rectify history: a color outside the box is moved onto it.
#include "core/taa/reference/Color.h"
#include "core/taa/reference/Stages.h"

#include <cassert>
#include <cmath>

namespace taa::reference {
namespace {

/// Keeps the extent of a flat box from being a zero divisor.
constexpr float kLeastExtent = 1e-8f;

float magnitude(const glm::vec3& v) {
  return std::sqrt((v.x * v.x + v.y * v.y) + v.z * v.z);
}

bool isInside(const glm::vec3& h, const glm::vec3& low, const glm::vec3& high) {
  for (int i = 0; i < 3; ++i) {
    if (!(h[i] >= low[i] && h[i] <= high[i])) return false;
  }
  return true;
}

/// Nearest point of the box (catalogue 11.1).
Clipped clampToBox(const glm::vec3& h, const glm::vec3& low, const glm::vec3& high) {
  const glm::vec3 center = 0.5f * (low + high);
  const glm::vec3 r = clamped(h, low, high);
  const float whole = magnitude(center - h);
  return {r, whole == 0.0f ? 0.0f : magnitude(r - h) / whole};
}

/// Along the line to the center (catalogue 11.2).
Clipped clipToCenter(const glm::vec3& h, const glm::vec3& low, const glm::vec3& high) {
  const glm::vec3 center = 0.5f * (low + high);
  const glm::vec3 extent = 0.5f * (high - low) + kLeastExtent;
  float m = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const float u = std::fabs(h[i] - center[i]) / extent[i];
    m = u > m ? u : m;
  }
  if (!(m > 1.0f)) return {h, 0.0f};
  return {center + (h - center) / m, 1.0f - 1.0f / m};
}

/// Along the line to `aim`, a color of this frame, brought into the box first (catalogue 11.3).
Clipped clipToColor(const glm::vec3& h, const glm::vec3& aim, const glm::vec3& low, const glm::vec3& high) {
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

Clipped clip(RectifyMethod method, const glm::vec3& value, const glm::vec3& target, const glm::vec3& boxMin,
             const glm::vec3& boxMax) {
  if (method == RectifyMethod::None || isInside(value, boxMin, boxMax)) return {value, 0.0f};
  switch (method) {
  case RectifyMethod::Clamp:
    return clampToBox(value, boxMin, boxMax);
  case RectifyMethod::ClipToCenter:
    return clipToCenter(value, boxMin, boxMax);
  case RectifyMethod::ClipToFiltered:
    return clipToColor(value, target, boxMin, boxMax);
  case RectifyMethod::None:
    break;
  }
  assert(false);
  return {value, 0.0f};
}

Clipped rectifyHistory(const Inputs& inputs, const Settings& settings, const glm::vec3& historyRaw,
                       const glm::vec3& currentFiltered, const Neighborhood& neighborhood) {
  if (inputs.historyColor.empty()) return {historyRaw, 0.0f};
  const glm::vec3 h = toBox(historyRaw, settings.space);
  const Clipped clipped = clip(settings.rectify.method, h, toBox(currentFiltered, settings.space),
                               neighborhood.boxMin, neighborhood.boxMax);
  // Kept history is kept exactly: no way there and back through the box's space.
  const bool isKept = clipped.value == h && clipped.amount == 0.0f;
  return {isKept ? historyRaw : sanitized(fromBox(clipped.value, settings.space)), clipped.amount};
}

} // namespace taa::reference
