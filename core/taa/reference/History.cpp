// Stage 3, sample history: the accumulated color at a place between texels.
#include "core/taa/reference/Color.h"
#include "core/taa/reference/Stages.h"

#include <cmath>

namespace taa::reference {
namespace {

/// Positions further out than this, px, are read at the pixel itself: they are rejected later anyway.
constexpr float kFarthestPosition = 1e6f;

/// The two texels a position lies between along one axis, and how far from the first.
struct Span {
  int first;
  int second;
  float fraction;
};

Span span(float positionPx, int count) {
  const auto size = static_cast<float>(count);
  float u = (positionPx / size) * size; // as a sampler gets it: normalized, then scaled again
  u = u < size ? u : size;
  u = u - 0.5f;
  u = u > 0.0f ? u : 0.0f;
  const float whole = std::floor(u);
  const int first = static_cast<int>(whole);
  return {first, first + 1 < count - 1 ? first + 1 : count - 1, u - whole};
}

glm::vec3 lerp(const glm::vec3& a, const glm::vec3& b, float fraction) {
  return a + fraction * (b - a);
}

glm::vec3 storedColor(const Inputs& inputs, int x, int y) {
  return glm::vec3(inputs.historyColor.texel(x, y));
}

/// Five bilinear taps for sixteen (Jimenez 2016): corners dropped, weights normalized (catalogue 6.4).
glm::vec3 catmullRom5(const Inputs& inputs, const glm::vec2& position, Switch dering) {
  const glm::vec2 center(std::floor(position.x - 0.5f) + 0.5f, std::floor(position.y - 0.5f) + 0.5f);
  const std::array<float, 4> wx = catmullRomWeights(position.x - center.x);
  const std::array<float, 4> wy = catmullRomWeights(position.y - center.y);
  const float middleX = wx[1] + wx[2];
  const float middleY = wy[1] + wy[2];
  const float x12 = center.x + wx[2] / middleX;
  const float y12 = center.y + wy[2] / middleY;
  struct Tap {
    glm::vec2 position;
    float weight;
  };
  constexpr std::size_t kMiddle = 2;
  const std::array<Tap, 5> taps{{{{x12, center.y - 1.0f}, middleX * wy[0]},
                                 {{center.x - 1.0f, y12}, wx[0] * middleY},
                                 {{x12, y12}, middleX * middleY},
                                 {{center.x + 2.0f, y12}, wx[3] * middleY},
                                 {{x12, center.y + 2.0f}, middleX * wy[3]}}};
  std::array<glm::vec3, 5> colors;
  for (std::size_t i = 0; i < 5; ++i) colors[i] = sanitized(bilinearHistory(inputs, taps[i].position));

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
  const Span x = span(positionPx.x, inputs.width());
  const Span y = span(positionPx.y, inputs.height());
  const glm::vec3 upper =
      lerp(storedColor(inputs, x.first, y.first), storedColor(inputs, x.second, y.first), x.fraction);
  const glm::vec3 lower =
      lerp(storedColor(inputs, x.first, y.second), storedColor(inputs, x.second, y.second), x.fraction);
  return lerp(upper, lower, y.fraction);
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
