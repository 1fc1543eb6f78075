// Stage 5, neighborhood: moments and extremes of the colors around the pixel, and the box from them.
#include "core/taa/reference/Color.h"
#include "core/taa/reference/Stages.h"

#include <cmath>
#include <cstdlib>

namespace taa::reference {
namespace {

void measureSamples(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel,
                    Neighborhood& result) {
  const glm::vec3 center = toBox(currentColor(inputs, pixel), settings.space);
  const bool isCross = settings.neighborhood.shape == NeighborhoodShape::Cross;
  float count = 0.0f;
  glm::vec3 first(0.0f);
  glm::vec3 second(0.0f);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (isCross && std::abs(dx) + std::abs(dy) > 1) continue;
      const glm::vec3 sample = toBox(currentColor(inputs, pixel + glm::ivec2(dx, dy)), settings.space);
      result.min = count == 0.0f ? sample : smaller(result.min, sample);
      result.max = count == 0.0f ? sample : larger(result.max, sample);
      const glm::vec3 e = sample - center; // about the center: no cancellation in high dynamic range
      first = first + e;
      second = second + e * e;
      count = count + 1.0f;
    }
  }
  const glm::vec3 m1 = first / count;
  const glm::vec3 m2 = second / count;
  result.mean = clamped(center + m1, result.min, result.max);
  const glm::vec3 variance = m2 - m1 * m1;
  for (int i = 0; i < 3; ++i) result.deviation[i] = std::sqrt(variance[i] > 0.0f ? variance[i] : 0.0f);
}

} // namespace

Neighborhood measureNeighborhood(const Inputs& inputs, const Settings& settings,
                                 const glm::vec3& currentFiltered, const glm::ivec2& pixel) {
  Neighborhood result;
  measureSamples(inputs, settings, pixel, result);
  const glm::vec3 reach = settings.neighborhood.gamma * result.deviation;
  const glm::vec3 low = result.mean - reach;
  const glm::vec3 high = result.mean + reach;
  switch (settings.neighborhood.box) {
  case BoxKind::MinMax:
    result.boxMin = result.min;
    result.boxMax = result.max;
    break;
  case BoxKind::Variance:
    result.boxMin = low;
    result.boxMax = high;
    break;
  case BoxKind::Intersection:
    result.boxMin = larger(result.min, low);
    result.boxMax = smaller(result.max, high);
    break;
  }
  if (settings.neighborhood.includeFiltered == Switch::On) {
    const glm::vec3 filtered = toBox(currentFiltered, settings.space);
    result.boxMin = smaller(result.boxMin, filtered);
    result.boxMax = larger(result.boxMax, filtered);
  }
  return result;
}

} // namespace taa::reference
