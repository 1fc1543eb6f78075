// Stage 3, sample history: the accumulated color at a place between texels.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/stages/Stages.h"

#include <array>
#include <cmath>
#include <utility>

namespace taa::twin {
namespace {

/// Positions further out than this, px, are read at the pixel itself: they are rejected later anyway.
constexpr float kFarthestPosition = 1e6f;

/// A place between texels along one axis: the texel before it, and how far it is to the next. Apart, because
/// their sum would round the fraction by as much as the texel's number is large.
struct AxisPlace {
  int texel;
  float fraction; ///< 0 to 1
};

AxisPlace placeAt(float positionPx) {
  const float texel = std::floor(positionPx - 0.5f); // texel 0 is centered at ½
  return {static_cast<int>(texel), positionPx - (texel + 0.5f)};
}

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

/// Five bilinear taps for sixteen (Jimenez 2016): corners dropped, weights normalized (manual 6.4) unless
/// as printed (6.4b), or each corner given to its two neighbors (6.4c).
Taps fiveTaps(const Inputs& inputs, const glm::vec2& position, const HistorySettings& settings) {
  const AxisPlace x = placeAt(position.x);
  const AxisPlace y = placeAt(position.y);
  const std::array<float, 4> wx = cubicWeights(settings, x.fraction);
  const std::array<float, 4> wy = cubicWeights(settings, y.fraction);
  const float middleX = wx[1] + wx[2];
  const float middleY = wy[1] + wy[2];
  const AxisPlace x12{x.texel, wx[2] / middleX}; // taps 1 and 2 in one
  const AxisPlace y12{y.texel, wy[2] / middleY};
  const bool givesCorners = settings.filter == HistoryFilter::CatmullRom5Corners;
  const float besideX = givesCorners ? middleX + 0.5f * (wx[0] + wx[3]) : middleX;
  const float besideY = givesCorners ? middleY + 0.5f * (wy[0] + wy[3]) : middleY;
  // HDRP reads the right tap a row higher (D13).
  const AxisPlace rightY =
      settings.filter == HistoryFilter::Cubic5AsPrinted ? AxisPlace{y.texel - 1, 0.0f} : y12;
  Taps taps;
  taps.middle = 2;
  const auto tap = [&](const AxisPlace& column, const AxisPlace& row, float weight) {
    taps.add(sanitized(bilinear(inputs, settings.border, column, row)), weight);
  };
  tap(x12, {y.texel - 1, 0.0f}, besideX * wy[0]);
  tap({x.texel - 1, 0.0f}, y12, wx[0] * besideY);
  tap(x12, y12, middleX * middleY);
  tap({x.texel + 2, 0.0f}, rightY, wx[3] * besideY);
  tap(x12, {y.texel + 2, 0.0f}, besideX * wy[3]);
  return taps;
}

/// Nine bilinear taps: equal to sixteen texels (manual 6.3).
Taps catmullRom9(const Inputs& inputs, const glm::vec2& position, HistoryBorder border) {
  const AxisPlace px = placeAt(position.x);
  const AxisPlace py = placeAt(position.y);
  const auto axis = [](const AxisPlace& place) {
    const std::array<float, 4> w = catmullRomWeights(place.fraction);
    const float both = w[1] + w[2];
    return std::array<std::pair<AxisPlace, float>, 3>{{{{place.texel - 1, 0.0f}, w[0]},
                                                       {{place.texel, w[2] / both}, both},
                                                       {{place.texel + 2, 0.0f}, w[3]}}};
  };
  Taps taps;
  taps.middle = 4;
  for (const auto& [y, wy] : axis(py))
    for (const auto& [x, wx] : axis(px)) taps.add(sanitized(bilinear(inputs, border, x, y)), wx * wy);
  return taps;
}

/// Sixteen texels with the kernel's weights (manual 6.2, 6.5 to 6.7).
Taps sixteenTexels(const Inputs& inputs, const glm::vec2& position, const HistorySettings& settings) {
  const AxisPlace x = placeAt(position.x);
  const AxisPlace y = placeAt(position.y);
  const std::array<float, 4> wx = cubicWeights(settings, x.fraction);
  const std::array<float, 4> wy = cubicWeights(settings, y.fraction);
  const bool isLanczos = settings.filter == HistoryFilter::Lanczos;
  Taps taps;
  taps.middle = 5;
  for (int k = 0; k < 16; ++k) {
    const int i = k % 4, j = k / 4;
    const bool isNear = (i == 1 || i == 2) && (j == 1 || j == 2);
    taps.add(sanitized(storedColor(inputs, settings.border, {x.texel + i - 1, y.texel + j - 1})),
             wx[static_cast<std::size_t>(i)] * wy[static_cast<std::size_t>(j)], isNear || !isLanczos);
  }
  return taps;
}

/// The four texels of bilinear interpolation, as weights.
Taps four(const Inputs& inputs, const glm::vec2& position, HistoryBorder border) {
  const AxisPlace x = placeAt(position.x), y = placeAt(position.y);
  Taps taps;
  for (int k = 0; k < 4; ++k) {
    const int i = k % 2, j = k / 2;
    taps.add(storedColor(inputs, border, {x.texel + i, y.texel + j}),
             (i == 0 ? 1.0f - x.fraction : x.fraction) * (j == 0 ? 1.0f - y.fraction : y.fraction));
  }
  return taps;
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
  const AxisPlace x = placeAt(position.x), y = placeAt(position.y);
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

} // namespace

std::array<float, 4> catmullRomWeights(float f) {
  return {f * (-0.5f + f * (1.0f - 0.5f * f)), 1.0f + (f * f) * (-2.5f + 1.5f * f),
          f * (0.5f + f * (2.0f - 1.5f * f)), (f * f) * (-0.5f + 0.5f * f)};
}

std::array<float, 4> cubicWeights(const HistorySettings& settings, float f) {
  const float c = settings.sharpness;
  const auto mitchellNear = [](float x) { return ((7.0f * x - 12.0f) * (x * x) + 16.0f / 3.0f) / 6.0f; };
  const auto mitchellFar = [](float x) {
    return ((((-7.0f / 3.0f) * x + 12.0f) * x - 20.0f) * x + 32.0f / 3.0f) / 6.0f;
  };
  const auto lanczos = [](float x) {
    const float x2 = x * x < 4.0f ? x * x : 4.0f;
    const float a = x2 - 1.0f, b = x2 - 4.0f;
    return ((a * b) * (b * b)) / 64.0f;
  };
  switch (settings.filter) {
  case HistoryFilter::Cubic:
  case HistoryFilter::Cubic5:
  case HistoryFilter::Cubic5AsPrinted:
    return {((-c * f + 2.0f * c) * f - c) * f, ((2.0f - c) * f - (3.0f - c)) * (f * f) + 1.0f,
            ((-(2.0f - c) * f + (3.0f - 2.0f * c)) * f + c) * f, (c * f - c) * (f * f)};
  case HistoryFilter::Mitchell:
    return {mitchellFar(1.0f + f), mitchellNear(f), mitchellNear(1.0f - f), mitchellFar(2.0f - f)};
  case HistoryFilter::Lanczos:
    return {lanczos(1.0f + f), lanczos(f), lanczos(1.0f - f), lanczos(2.0f - f)};
  case HistoryFilter::Point:
  case HistoryFilter::Bilinear:
  case HistoryFilter::CatmullRom5:
  case HistoryFilter::CatmullRom9:
  case HistoryFilter::CatmullRom16:
  case HistoryFilter::CatmullRom5AsPrinted:
  case HistoryFilter::CatmullRom5Corners:
    break;
  }
  return catmullRomWeights(f);
}

Taps historyTaps(const Inputs& inputs, const HistorySettings& settings, const glm::vec2& positionPx) {
  switch (settings.filter) {
  case HistoryFilter::Point: {
    Taps one;
    one.add(storedColor(inputs, settings.border, texelOf(positionPx)), 1.0f);
    return one;
  }
  case HistoryFilter::Bilinear:
    return four(inputs, positionPx, settings.border);
  case HistoryFilter::CatmullRom5:
  case HistoryFilter::CatmullRom5AsPrinted:
  case HistoryFilter::CatmullRom5Corners:
  case HistoryFilter::Cubic5:
  case HistoryFilter::Cubic5AsPrinted:
    return fiveTaps(inputs, positionPx, settings);
  case HistoryFilter::CatmullRom9:
    return catmullRom9(inputs, positionPx, settings.border);
  case HistoryFilter::CatmullRom16:
  case HistoryFilter::Cubic:
  case HistoryFilter::Mitchell:
  case HistoryFilter::Lanczos:
    break;
  }
  return sixteenTexels(inputs, positionPx, settings);
}

glm::vec3 bilinearHistory(const Inputs& inputs, const glm::vec2& positionPx, HistoryBorder border) {
  return bilinear(inputs, border, placeAt(positionPx.x), placeAt(positionPx.y));
}

HistorySample sampleHistory(const Inputs& inputs, const HistorySettings& settings,
                            const glm::vec2& positionPx, const glm::ivec2& pixel, const glm::ivec2& drawn) {
  const auto isSane = [](float value) { return value >= -kFarthestPosition && value <= kFarthestPosition; };
  HistorySample result;
  result.position = isSane(positionPx.x) && isSane(positionPx.y) ? positionPx : glm::vec2(pixel) + 0.5f;
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

} // namespace taa::twin
