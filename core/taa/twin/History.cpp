// Stage 3, sample history: the accumulated color at a place between texels.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/HistoryTaps.h"
#include "core/taa/twin/Stages.h"

#include <glm/common.hpp>

#include <array>
#include <cassert>
#include <cmath>

namespace taa::twin {
namespace {

glm::vec3 lerp(const glm::vec3& a, const glm::vec3& b, float fraction) {
  return a + fraction * (b - a);
}

/// A texel of the history; beyond the border that of the edge, or black (manual 5.4).
glm::vec3 storedColor(const Inputs& inputs, HistoryBorder border, const glm::ivec2& texel) {
  const glm::ivec2 inside = clampedToPicture(texel, inputs);
  if (border == HistoryBorder::Black && inside != texel) return glm::vec3(0.0f);
  return glm::vec3(inputs.historyColor.texel(inside.x, inside.y));
}

glm::vec3 bilinear(const Inputs& inputs, HistoryBorder border, const AxisPlace& x, const AxisPlace& y) {
  const auto stored = [&](int column, int row) { return storedColor(inputs, border, {column, row}); };
  const glm::vec3 upper = lerp(stored(x.texel, y.texel), stored(x.texel + 1, y.texel), x.fraction);
  const glm::vec3 lower = lerp(stored(x.texel, y.texel + 1), stored(x.texel + 1, y.texel + 1), x.fraction);
  return lerp(upper, lower, y.fraction);
}

/// Σwc/Σw about the middle one, within the colors that bound it when deringed; or Σwc, as some are printed or
/// meant.
glm::vec3 meanOf(const Taps& taps, const HistorySettings& settings) {
  const glm::vec3& middle = taps.each[taps.middle].color;
  float sum = 0.0f;
  glm::vec3 difference(0.0f);
  glm::vec3 low = middle;
  glm::vec3 high = middle;
  for (const Taps::Tap& tap : taps.all()) {
    sum = sum + tap.weight;
    difference = difference + (tap.color - middle) * tap.weight;
    if (!tap.bounds) continue;
    low = minimum(low, tap.color);
    high = maximum(high, tap.color);
  }
  glm::vec3 result = middle + difference / sum;
  if (settings.filter == HistoryFilter::CatmullRom5AsPrinted) result = middle * sum + difference;
  if (settings.filter == HistoryFilter::CatmullRom5Corners) result = middle + difference;
  return settings.dering == Switch::On ? clamped(result, low, high) : result;
}

glm::vec3 filteredHistory(const Inputs& inputs, const HistorySettings& settings, const glm::vec2& q) {
  if (settings.filter == HistoryFilter::Bilinear) return bilinearHistory(inputs, q, settings.border);
  const Taps taps = historyTaps(inputs, settings, q);
  return settings.filter == HistoryFilter::Point ? taps.each[0].color : meanOf(taps, settings);
}

/// N of the four texels around, mixed by their distance, as Godot reads it.
float bilinearLength(const Inputs& inputs, const glm::vec2& position) {
  const AxisPlace x = axisPlace(position.x), y = axisPlace(position.y);
  const auto at = [&](int i, int j) {
    const glm::ivec2 texel = clampedToPicture({x.texel + i, y.texel + j}, inputs);
    return inputs.historySurface.texel(texel.x, texel.y).x;
  };
  const float top = at(0, 0) + x.fraction * (at(1, 0) - at(0, 0));
  const float bottom = at(0, 1) + x.fraction * (at(1, 1) - at(0, 1));
  return top + y.fraction * (bottom - top);
}

/// Whether view depth spans more than a share of the farthest among the nine pixels (manual 6.8).
bool hasDepthEdge(const Inputs& inputs, const glm::ivec2& pixel, float share) {
  constexpr float kSky = 1e30f; // m
  float nearest = kSky, farthest = 0.0f;
  for (int k = 0; k < 9; ++k) {
    const glm::ivec2 p = clampedToDrawn(pixel + glm::ivec2(k % 3 - 1, k / 3 - 1), inputs);
    const float device = inputs.depth.texel(p.x, p.y).x;
    const float depth = device == 0.0f ? kSky : viewDepth(device, inputs.depthTerms);
    nearest = depth < nearest ? depth : nearest;
    farthest = depth > farthest ? depth : farthest;
  }
  return farthest - nearest > share * farthest;
}

/// A cubic of sharpness c (manual 6.5).
std::array<float, 4> sharpnessWeights(float c, float f) {
  return {((-c * f + 2.0f * c) * f - c) * f, ((2.0f - c) * f - (3.0f - c)) * (f * f) + 1.0f,
          ((-(2.0f - c) * f + (3.0f - 2.0f * c)) * f + c) * f, (c * f - c) * (f * f)};
}

/// Manual 6.6.
std::array<float, 4> mitchellWeights(float f) {
  const auto mitchellNear = [](float x) { return ((7.0f * x - 12.0f) * (x * x) + 16.0f / 3.0f) / 6.0f; };
  const auto mitchellFar = [](float x) {
    return ((((-7.0f / 3.0f) * x + 12.0f) * x - 20.0f) * x + 32.0f / 3.0f) / 6.0f;
  };
  return {mitchellFar(1.0f + f), mitchellNear(f), mitchellNear(1.0f - f), mitchellFar(2.0f - f)};
}

/// Manual 6.7.
std::array<float, 4> lanczosWeights(float f) {
  const auto lanczos = [](float x) {
    const float x2 = x * x < 4.0f ? x * x : 4.0f;
    const float a = x2 - 1.0f, b = x2 - 4.0f;
    return ((a * b) * (b * b)) / 64.0f;
  };
  return {lanczos(1.0f + f), lanczos(f), lanczos(1.0f - f), lanczos(2.0f - f)};
}

} // namespace

std::array<float, 4> catmullRomWeights(float f) {
  return {f * (-0.5f + f * (1.0f - 0.5f * f)), 1.0f + (f * f) * (-2.5f + 1.5f * f),
          f * (0.5f + f * (2.0f - 1.5f * f)), (f * f) * (-0.5f + 0.5f * f)};
}

std::array<float, 4> cubicWeights(const HistorySettings& settings, float f) {
  switch (settings.filter) {
  case HistoryFilter::Cubic:
  case HistoryFilter::Cubic5:
  case HistoryFilter::Cubic5AsPrinted:
    return sharpnessWeights(settings.sharpness, f);
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

Taps historyTaps(const Inputs& inputs, const HistorySettings& settings, const glm::vec2& positionPx) {
  const TapPlaces places = tapPlaces(settings, positionPx);
  const bool isAsStored =
      settings.filter == HistoryFilter::Point || settings.filter == HistoryFilter::Bilinear;
  Taps taps;
  taps.middle = places.middle;
  for (const TapPlaces::Tap& tap : places.all()) {
    const glm::vec3 color = tap.isTexel ? storedColor(inputs, settings.border, {tap.x.texel, tap.y.texel})
                                        : bilinear(inputs, settings.border, tap.x, tap.y);
    taps.add(isAsStored ? color : sanitized(color), tap.weight, tap.bounds);
  }
  return taps;
}

glm::vec3 bilinearHistory(const Inputs& inputs, const glm::vec2& positionPx, HistoryBorder border) {
  return bilinear(inputs, border, axisPlace(positionPx.x), axisPlace(positionPx.y));
}

HistorySample sampleHistory(const Inputs& inputs, const HistorySettings& settings,
                            const glm::vec2& positionPx, const glm::ivec2& pixel, const glm::ivec2& drawn) {
  HistorySample result;
  result.position = readPosition(positionPx, pixel);
  const bool mayBeEdge = settings.bilinearAtEdges == Switch::On && settings.filter != HistoryFilter::Point &&
                         settings.filter != HistoryFilter::Bilinear;
  result.isEdge = mayBeEdge && hasDepthEdge(inputs, drawn, settings.edgeDepth);
  if (inputs.historyColor.empty()) return result;
  const glm::vec2& q = result.position;
  result.color =
      storable(result.isEdge ? bilinearHistory(inputs, q, settings.border)
                             : filteredHistory(inputs, settings, q));   // negative lobes overshoot both ways
  const bool isOfPixel = settings.length == LengthFrom::PixelAsPrinted; // D15
  const glm::ivec2 nearest = clampedToPicture(isOfPixel ? pixel : texelOf(q), inputs);
  result.historyLength = settings.length == LengthFrom::Bilinear
                             ? bilinearLength(inputs, q)
                             : inputs.historySurface.texel(nearest.x, nearest.y).x;
  return result;
}

bool holdsNan(const Inputs& inputs, const glm::ivec2& drawn, const Reprojection& reprojection) {
  const auto isNan = [](const glm::vec4& c) { return std::isnan(c.x) || std::isnan(c.y) || std::isnan(c.z); };
  if (isNan(inputs.color.texel(drawn.x, drawn.y))) return true;
  if (inputs.historyColor.empty() || !reprojection.onScreen) return false;
  const glm::ivec2 from(glm::floor(reprojection.position));
  for (int k = 0; k < 9; ++k) {
    const glm::ivec2 at = clampedToPicture(from + glm::ivec2(k % 3 - 1, k / 3 - 1), inputs);
    if (isNan(inputs.historyColor.texel(at.x, at.y))) return true;
  }
  return false;
}

} // namespace taa::twin
