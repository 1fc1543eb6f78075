// Stage 3, sample history: the accumulated color at a place between texels.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/HistoryTaps.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Stages.h"

#include <glm/common.hpp>

#include <array>
#include <cassert>
#include <cmath>

namespace taa::twin {
namespace {

template <typename Real>
Vec3<Real> lerp(const Vec3<Real>& a, const Vec3<Real>& b, Real fraction) {
  return a + fraction * (b - a);
}

/// A texel of the history; beyond the border that of the edge, or black (manual 5.4).
template <typename Real>
Vec3<Real> storedColor(const Inputs& inputs, HistoryBorder border, const glm::ivec2& texel) {
  const glm::ivec2 inside = clampedToPicture(texel, inputs);
  if (border == HistoryBorder::Black && inside != texel) return Vec3<Real>(0.0f);
  return Vec3<Real>(read<Real>(inputs.historyColor, inside));
}

template <typename Real>
Vec3<Real> bilinear(const Inputs& inputs, HistoryBorder border, const AxisPlaceOf<Real>& x,
                    const AxisPlaceOf<Real>& y) {
  const auto stored = [&](int column, int row) { return storedColor<Real>(inputs, border, {column, row}); };
  const Vec3<Real> upper = lerp(stored(x.texel, y.texel), stored(x.texel + 1, y.texel), x.fraction);
  const Vec3<Real> lower = lerp(stored(x.texel, y.texel + 1), stored(x.texel + 1, y.texel + 1), x.fraction);
  return lerp(upper, lower, y.fraction);
}

/// Σwc/Σw about the middle one, within the colors that bound it when deringed; or Σwc, as some are printed or
/// meant.
template <typename Real>
Vec3<Real> meanOf(const TapsOf<Real>& taps, const HistorySettings& settings) {
  const Vec3<Real>& middle = taps.each[taps.middle].color;
  Real sum = 0.0f;
  Vec3<Real> difference(0.0f);
  Vec3<Real> low = middle;
  Vec3<Real> high = middle;
  for (const auto& tap : taps.all()) {
    sum = sum + tap.weight;
    difference = difference + (tap.color - middle) * tap.weight;
    if (!tap.bounds) continue;
    low = minimum(low, tap.color);
    high = maximum(high, tap.color);
  }
  Vec3<Real> result = middle + difference / sum;
  if (settings.filter == HistoryFilter::CatmullRom5AsPrinted) result = middle * sum + difference;
  if (settings.filter == HistoryFilter::CatmullRom5Corners) result = middle + difference;
  return settings.dering == Switch::On ? clamped(result, low, high) : result;
}

template <typename Real>
Vec3<Real> filteredHistory(const Inputs& inputs, const HistorySettings& settings, const Vec2<Real>& q) {
  if (settings.filter == HistoryFilter::Bilinear) return bilinearHistory(inputs, q, settings.border);
  const TapsOf<Real> taps = historyTaps(inputs, settings, q);
  return settings.filter == HistoryFilter::Point ? taps.each[0].color : meanOf(taps, settings);
}

/// N of the four texels around, mixed by their distance, as Godot reads it.
template <typename Real>
Real bilinearLength(const Inputs& inputs, const Vec2<Real>& position) {
  const AxisPlaceOf<Real> x = axisPlace(position.x), y = axisPlace(position.y);
  const auto at = [&](int i, int j) {
    const glm::ivec2 texel = clampedToPicture({x.texel + i, y.texel + j}, inputs);
    return read<Real>(inputs.historySurface, texel).x;
  };
  const Real top = at(0, 0) + x.fraction * (at(1, 0) - at(0, 0));
  const Real bottom = at(0, 1) + x.fraction * (at(1, 1) - at(0, 1));
  return top + y.fraction * (bottom - top);
}

/// Whether view depth spans more than a share of the farthest among the nine pixels (manual 6.8).
template <typename Real>
bool hasDepthEdge(const Inputs& inputs, const glm::ivec2& pixel, Real share) {
  constexpr float kSky = 1e30f; // m
  Real nearest = kSky, farthest = 0.0f;
  for (int k = 0; k < 9; ++k) {
    const glm::ivec2 p = clampedToDrawn(pixel + glm::ivec2(k % 3 - 1, k / 3 - 1), inputs);
    const Real device = read<Real>(inputs.depth, p).x;
    const Real depth = device == 0.0f ? Real(kSky) : viewDepth(device, inputs.depthTerms);
    nearest = depth < nearest ? depth : nearest;
    farthest = depth > farthest ? depth : farthest;
  }
  return farthest - nearest > share * farthest;
}

/// A cubic of sharpness c (manual 6.5).
template <typename Real>
std::array<Real, 4> sharpnessWeights(Real c, Real f) {
  return {((-c * f + 2.0f * c) * f - c) * f, ((2.0f - c) * f - (3.0f - c)) * (f * f) + 1.0f,
          ((-(2.0f - c) * f + (3.0f - 2.0f * c)) * f + c) * f, (c * f - c) * (f * f)};
}

/// Manual 6.6.
template <typename Real>
std::array<Real, 4> mitchellWeights(Real f) {
  const auto mitchellNear = [](Real x) { return ((7.0f * x - 12.0f) * (x * x) + 16.0f / 3.0f) / 6.0f; };
  const auto mitchellFar = [](Real x) {
    return ((((-7.0f / 3.0f) * x + 12.0f) * x - 20.0f) * x + 32.0f / 3.0f) / 6.0f;
  };
  return {mitchellFar(1.0f + f), mitchellNear(f), mitchellNear(1.0f - f), mitchellFar(2.0f - f)};
}

/// Manual 6.7.
template <typename Real>
std::array<Real, 4> lanczosWeights(Real f) {
  const auto lanczos = [](Real x) {
    const Real x2 = x * x < 4.0f ? x * x : 4.0f;
    const Real a = x2 - 1.0f, b = x2 - 4.0f;
    return ((a * b) * (b * b)) / 64.0f;
  };
  return {lanczos(1.0f + f), lanczos(f), lanczos(1.0f - f), lanczos(2.0f - f)};
}

} // namespace

template <typename Real>
std::array<Real, 4> catmullRomWeights(Real f) {
  return {f * (-0.5f + f * (1.0f - 0.5f * f)), 1.0f + (f * f) * (-2.5f + 1.5f * f),
          f * (0.5f + f * (2.0f - 1.5f * f)), (f * f) * (-0.5f + 0.5f * f)};
}

template <typename Real>
std::array<Real, 4> cubicWeights(const HistorySettings& settings, Real f) {
  switch (settings.filter) {
  case HistoryFilter::Cubic:
  case HistoryFilter::Cubic5:
  case HistoryFilter::Cubic5AsPrinted:
    return sharpnessWeights(number<Real>(settings.sharpness), f);
  case HistoryFilter::Mitchell:
    return mitchellWeights(f);
  case HistoryFilter::Lanczos:
    return lanczosWeights(f);
  case HistoryFilter::CatmullRom5:
  case HistoryFilter::CatmullRom9:
  case HistoryFilter::CatmullRom16:
  case HistoryFilter::CatmullRom5AsPrinted:
  case HistoryFilter::CatmullRom5Corners:
    return catmullRomWeights(f);
  case HistoryFilter::Point: // neither of these two has a cubic
  case HistoryFilter::Bilinear:
    break;
  }
  assert(false);
  return {};
}

template <typename Real>
TapsOf<Real> historyTaps(const Inputs& inputs, const HistorySettings& settings,
                         const Vec2<Real>& positionPx) {
  const TapPlacesOf<Real> places = tapPlaces(settings, positionPx);
  const bool isAsStored =
      settings.filter == HistoryFilter::Point || settings.filter == HistoryFilter::Bilinear;
  TapsOf<Real> taps;
  taps.middle = places.middle;
  for (const auto& tap : places.all()) {
    const Vec3<Real> color = tap.isTexel
                                 ? storedColor<Real>(inputs, settings.border, {tap.x.texel, tap.y.texel})
                                 : bilinear(inputs, settings.border, tap.x, tap.y);
    taps.add(named(isAsStored ? color : sanitized(color)), named(tap.weight), tap.bounds);
  }
  return taps;
}

template <typename Real>
Vec3<Real> bilinearHistory(const Inputs& inputs, const Vec2<Real>& positionPx, HistoryBorder border) {
  return bilinear(inputs, border, axisPlace(positionPx.x), axisPlace(positionPx.y));
}

template <typename Real>
HistorySampleOf<Real> sampleHistory(const Inputs& inputs, const HistorySettings& settings,
                                    const Vec2<Real>& positionPx, const glm::ivec2& pixel,
                                    const glm::ivec2& drawn) {
  HistorySampleOf<Real> result;
  result.position = readPosition(positionPx, pixel);
  const bool mayBeEdge = settings.bilinearAtEdges == Switch::On && settings.filter != HistoryFilter::Point &&
                         settings.filter != HistoryFilter::Bilinear;
  result.isEdge = mayBeEdge && hasDepthEdge(inputs, drawn, number<Real>(settings.edgeDepth));
  decided<Real>(IntermediateId::depthEdge);
  if (inputs.historyColor.empty()) return result;
  const Vec2<Real>& q = result.position;
  result.color =
      storable(result.isEdge ? bilinearHistory(inputs, q, settings.border)
                             : filteredHistory(inputs, settings, q));   // negative lobes overshoot both ways
  const bool isOfPixel = settings.length == LengthFrom::PixelAsPrinted; // D15
  const glm::ivec2 nearest = clampedToPicture(isOfPixel ? pixel : texelOf(q), inputs);
  result.historyLength = settings.length == LengthFrom::Bilinear
                             ? bilinearLength(inputs, q)
                             : read<Real>(inputs.historySurface, nearest).x;
  return result;
}

template <typename Real>
bool holdsNan(const Inputs& inputs, const glm::ivec2& drawn, const ReprojectionOf<Real>& reprojection) {
  const auto isNan = [](const Vec4<Real>& c) { return isnan(c.x) || isnan(c.y) || isnan(c.z); };
  if (isNan(read<Real>(inputs.color, drawn))) return true;
  if (inputs.historyColor.empty() || !reprojection.onScreen) return false;
  const glm::ivec2 from = texelOf(reprojection.position);
  for (int k = 0; k < 9; ++k) {
    const glm::ivec2 at = clampedToPicture(from + glm::ivec2(k % 3 - 1, k / 3 - 1), inputs);
    if (isNan(read<Real>(inputs.historyColor, at))) return true;
  }
  return false;
}

#define TAA_HISTORY(Real)                                                                                    \
  template std::array<Real, 4> catmullRomWeights(Real fraction);                                             \
  template std::array<Real, 4> cubicWeights(const HistorySettings& settings, Real fraction);                 \
  template Vec3<Real> bilinearHistory(const Inputs& inputs, const Vec2<Real>& positionPx,                    \
                                      HistoryBorder border);                                                 \
  template TapsOf<Real> historyTaps(const Inputs& inputs, const HistorySettings& settings,                   \
                                    const Vec2<Real>& positionPx);                                           \
  template HistorySampleOf<Real> sampleHistory(const Inputs& inputs, const HistorySettings& settings,        \
                                               const Vec2<Real>& positionPx, const glm::ivec2& pixel,        \
                                               const glm::ivec2& drawn);                                     \
  template bool holdsNan(const Inputs& inputs, const glm::ivec2& drawn,                                      \
                         const ReprojectionOf<Real>& reprojection);
TAA_EACH_NUMBER(TAA_HISTORY)
#undef TAA_HISTORY

} // namespace taa::twin
