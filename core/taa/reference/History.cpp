// Stage 3, sample history: the accumulated color at a place between texels.
#include "core/taa/reference/Color.h"
#include "core/taa/reference/Stages.h"

#include <cmath>

namespace taa::reference {
namespace {

/// Positions further out than this, px, are read at the pixel itself: they are rejected later anyway.
constexpr float kFarthestPosition = 1e6f;

/// A place between texels along one axis: the texel before it, and how far it is to the next. Apart, because
/// their sum would round the fraction by as much as the texel's number is large.
struct Place {
  int texel;
  float fraction; ///< 0 to 1
};

Place placeAt(float positionPx) {
  const float texel = std::floor(positionPx - 0.5f); // texel 0 is centered at ½
  return {static_cast<int>(texel), positionPx - (texel + 0.5f)};
}

glm::vec3 lerp(const glm::vec3& a, const glm::vec3& b, float fraction) {
  return a + fraction * (b - a);
}

glm::vec3 bilinear(const Inputs& inputs, const Place& x, const Place& y) {
  const auto stored = [&inputs](int column, int row) {
    const glm::ivec2 texel = clampedToPicture({column, row}, inputs);
    return glm::vec3(inputs.historyColor.texel(texel.x, texel.y));
  };
  const glm::vec3 upper = lerp(stored(x.texel, y.texel), stored(x.texel + 1, y.texel), x.fraction);
  const glm::vec3 lower = lerp(stored(x.texel, y.texel + 1), stored(x.texel + 1, y.texel + 1), x.fraction);
  return lerp(upper, lower, y.fraction);
}

/// Five bilinear taps for sixteen (Jimenez 2016): corners dropped, weights normalized (catalogue 6.4).
glm::vec3 catmullRom5(const Inputs& inputs, const glm::vec2& position, Switch dering) {
  const Place x = placeAt(position.x);
  const Place y = placeAt(position.y);
  const std::array<float, 4> wx = catmullRomWeights(x.fraction);
  const std::array<float, 4> wy = catmullRomWeights(y.fraction);
  const float middleX = wx[1] + wx[2];
  const float middleY = wy[1] + wy[2];
  const Place x12{x.texel, wx[2] / middleX}; // taps 1 and 2 in one
  const Place y12{y.texel, wy[2] / middleY};
  struct Tap {
    Place x, y;
    float weight;
  };
  constexpr std::size_t kMiddle = 2;
  const std::array<Tap, 5> taps{{{x12, {y.texel - 1, 0.0f}, middleX * wy[0]},
                                 {{x.texel - 1, 0.0f}, y12, wx[0] * middleY},
                                 {x12, y12, middleX * middleY},
                                 {{x.texel + 2, 0.0f}, y12, wx[3] * middleY},
                                 {x12, {y.texel + 2, 0.0f}, middleX * wy[3]}}};
  std::array<glm::vec3, 5> colors;
  for (std::size_t i = 0; i < 5; ++i) colors[i] = sanitized(bilinear(inputs, taps[i].x, taps[i].y));

  const glm::vec3& c = colors[kMiddle];
  float sum = 0.0f;
  glm::vec3 difference(0.0f);
  glm::vec3 low = c;
  glm::vec3 high = c;
  for (std::size_t i = 0; i < 5; ++i) {
    sum = sum + taps[i].weight;
    if (i == kMiddle) continue;
    difference = difference + (colors[i] - c) * taps[i].weight;
    low = smaller(low, colors[i]);
    high = larger(high, colors[i]);
  }
  const glm::vec3 result = c + difference / sum;
  return dering == Switch::On ? clamped(result, low, high) : result;
}

} // namespace

std::array<float, 4> catmullRomWeights(float f) {
  return {f * (-0.5f + f * (1.0f - 0.5f * f)), 1.0f + (f * f) * (-2.5f + 1.5f * f),
          f * (0.5f + f * (2.0f - 1.5f * f)), (f * f) * (-0.5f + 0.5f * f)};
}

glm::vec3 bilinearHistory(const Inputs& inputs, const glm::vec2& positionPx) {
  return bilinear(inputs, placeAt(positionPx.x), placeAt(positionPx.y));
}

HistorySample sampleHistory(const Inputs& inputs, const HistorySettings& settings,
                            const glm::vec2& positionPx, const glm::ivec2& pixel) {
  const auto isSane = [](float value) { return value >= -kFarthestPosition && value <= kFarthestPosition; };
  HistorySample result;
  result.position = isSane(positionPx.x) && isSane(positionPx.y) ? positionPx : glm::vec2(pixel) + 0.5f;
  if (inputs.historyColor.empty()) return result;
  const glm::vec2& q = result.position;
  const glm::vec3 color = settings.filter == HistoryFilter::CatmullRom5
                              ? catmullRom5(inputs, q, settings.dering)
                              : bilinearHistory(inputs, q);
  result.color = sanitized(color); // a filter with negative lobes can go below 0
  const glm::ivec2 nearest =
      clampedToPicture({static_cast<int>(std::floor(q.x)), static_cast<int>(std::floor(q.y))}, inputs);
  result.length = inputs.historySurface.texel(nearest.x, nearest.y).x;
  return result;
}

} // namespace taa::reference
