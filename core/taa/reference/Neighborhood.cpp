// Stage 5, neighborhood: moments and extremes of the colors around the pixel, and the box from them.
#include "core/taa/reference/Color.h"
#include "core/taa/reference/Stages.h"

#include <cmath>
#include <cstdlib>

namespace taa::reference {
namespace {

/// Samples whose bounds are taken.
enum class Set { Square, Cross, X };

bool belongs(Set set, int dx, int dy) {
  if (set == Set::Cross) return std::abs(dx) + std::abs(dy) <= 1;
  return set == Set::Square || std::abs(dx) == std::abs(dy);
}

Set setOf(NeighborhoodShape shape, int frame) {
  if (shape == NeighborhoodShape::X) return Set::X;
  if (shape == NeighborhoodShape::Cross) return Set::Cross;
  if (shape == NeighborhoodShape::Alternate) return frame % 2 == 0 ? Set::Cross : Set::X;
  return Set::Square;
}

/// The sample of a pixel: its color, or what a tap where its center landed finds (catalogue 8.8).
glm::vec3 sampleOf(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel) {
  if (settings.neighborhood.unjitter == Switch::Off) return currentColor(inputs, pixel);
  return storable(unjitteredColor(inputs, pixel));
}

/// What the sample at a step counts (catalogue 10.7).
float momentWeight(MomentWeights weights, const glm::vec3& color, int dx, int dy) {
  constexpr float kByDistance[] = {1.0f, 0.47236655f, 0.22313016f}; // exp(−¾ r²)
  if (weights == MomentWeights::Luma) return 1.0f / (1.0f + luma(color));
  return weights == MomentWeights::Distance ? kByDistance[std::abs(dx) + std::abs(dy)] : 1.0f;
}

void measureSet(const Inputs& inputs, const Settings& settings, Set set, const glm::ivec2& pixel,
                Neighborhood& result) {
  const glm::vec3 center = toBox(sampleOf(inputs, settings, pixel), settings.space);
  float total = 0.0f;
  glm::vec3 first(0.0f);
  glm::vec3 second(0.0f);
  result.min = result.max = center;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (!belongs(set, dx, dy)) continue;
      const glm::vec3 color = sampleOf(inputs, settings, pixel + glm::ivec2(dx, dy));
      const glm::vec3 sample = toBox(color, settings.space);
      result.min = smaller(result.min, sample);
      result.max = larger(result.max, sample);
      const float weight = momentWeight(settings.neighborhood.weights, color, dx, dy);
      const glm::vec3 e = sample - center; // about the center: no cancellation in high dynamic range
      first = first + weight * e;
      second = second + weight * (e * e);
      total = total + weight;
    }
  }
  const glm::vec3 m1 = first / total;
  const glm::vec3 m2 = second / total;
  result.mean = clamped(center + m1, result.min, result.max);
  const glm::vec3 variance = m2 - m1 * m1;
  for (int i = 0; i < 3; ++i) result.deviation[i] = std::sqrt(variance[i] > 0.0f ? variance[i] : 0.0f);
}

void measureSamples(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel,
                    Neighborhood& result) {
  measureSet(inputs, settings, setOf(settings.neighborhood.shape, inputs.frame), pixel, result);
  if (settings.neighborhood.shape != NeighborhoodShape::Rounded) return;
  Neighborhood five;
  measureSet(inputs, settings, Set::Cross, pixel, five);
  result.mean = 0.5f * (result.mean + five.mean);
  result.min = 0.5f * (result.min + five.min);
  result.max = 0.5f * (result.max + five.max);
}

/// What contrast between current and history adds to γ (catalogue 10.11).
float contrastGrowth(const Settings& settings, const Neighborhood& n, const glm::vec3& center,
                     const glm::vec3& history) {
  const SpaceSettings& space = settings.space;
  const float half = 0.5f * boxLuma(n.deviation, space);
  const float mean = boxLuma(n.mean, space);
  const float current = boxLuma(center, space);
  float past = boxLuma(toBox(history, space), space);
  past = past > mean - half ? past : mean - half;
  past = past < mean + half ? past : mean + half;
  float divisor = current > past ? current : past;
  divisor = divisor > 0.15f ? divisor : 0.15f;
  const float x = saturated((std::fabs(current - past) / divisor - 0.05f) / 0.5f);
  return settings.neighborhood.contrastGrowth * ((x * x) * (3.0f - 2.0f * x));
}

float gammaUsed(const Inputs& inputs, const Settings& settings, const Neighborhood& n,
                const glm::vec3& center, const Moved& moved) {
  const NeighborhoodSettings& chosen = settings.neighborhood;
  float gamma = chosen.gamma;
  if (chosen.motionGamma == Switch::On) {
    const float rest = saturated(1.0f - moved.speed / chosen.gammaSpeed);
    gamma = chosen.gammaMoving + (gamma - chosen.gammaMoving) * (rest * rest);
  }
  if (chosen.contrastGamma == Switch::On && !inputs.historyColor.empty())
    gamma = gamma + contrastGrowth(settings, n, center, moved.history);
  if (chosen.maskRelax == Switch::On) gamma = gamma * (1.0f + 1.5f * moved.relax); // catalogue 10.10
  return gamma;
}

void boundByMoments(BoxKind kind, Neighborhood& n) {
  const glm::vec3 reach = n.gamma * n.deviation;
  const glm::vec3 low = n.mean - reach;
  const glm::vec3 high = n.mean + reach;
  switch (kind) {
  case BoxKind::MinMax:
    n.boxMin = n.min;
    n.boxMax = n.max;
    break;
  case BoxKind::Variance:
    n.boxMin = low;
    n.boxMax = high;
    break;
  case BoxKind::Intersection:
    n.boxMin = larger(n.min, low);
    n.boxMax = smaller(n.max, high);
    break;
  }
}

} // namespace

Neighborhood measureNeighborhood(const Inputs& inputs, const Settings& settings,
                                 const glm::vec3& currentFiltered, const glm::ivec2& pixel,
                                 const Moved& moved) {
  Neighborhood result;
  measureSamples(inputs, settings, pixel, result);
  for (int k = 0; k < 9; ++k)
    result.samples[static_cast<std::size_t>(k)] =
        toBox(sampleOf(inputs, settings, pixel + glm::ivec2(k % 3 - 1, k / 3 - 1)), settings.space);
  const glm::vec3 center = result.samples[4];
  result.gamma = gammaUsed(inputs, settings, result, center, moved);
  boundByMoments(settings.neighborhood.box, result);
  if (settings.neighborhood.chromaShrink == Switch::On && settings.space.color != ColorSpace::Rgb) {
    const float half = 0.125f * (result.max.x - result.min.x); // catalogue 10.6
    for (int i = 1; i < 3; ++i) {
      result.boxMin[i] = center[i] - half;
      result.boxMax[i] = center[i] + half;
    }
  }
  if (settings.neighborhood.includeFiltered == Switch::On) {
    const glm::vec3 filtered = toBox(currentFiltered, settings.space);
    result.boxMin = smaller(result.boxMin, filtered);
    result.boxMax = larger(result.boxMax, filtered);
  }
  return result;
}

} // namespace taa::reference
