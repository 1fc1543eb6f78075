// Stage 5, neighborhood: moments and extremes of the colors around the pixel, and the box from them.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace taa::twin {
namespace {

/// Samples whose bounds are taken.
enum class Set { Square, Cross, X };

bool belongs(Set set, int dx, int dy) {
  switch (set) {
  case Set::Square:
    return true;
  case Set::Cross:
    return std::abs(dx) + std::abs(dy) <= 1;
  case Set::X:
    return std::abs(dx) == std::abs(dy);
  }
  return false;
}

Set setOf(NeighborhoodShape shape, int frame) {
  switch (shape) {
  case NeighborhoodShape::X:
    return Set::X;
  case NeighborhoodShape::Cross:
    return Set::Cross;
  case NeighborhoodShape::Alternate:
    return frame % 2 == 0 ? Set::Cross : Set::X;
  case NeighborhoodShape::Square3x3:
  case NeighborhoodShape::Rounded: // the bounds of five come later
  case NeighborhoodShape::Varying: // these two have members of their own
  case NeighborhoodShape::Pairs:
    break;
  }
  return Set::Square;
}

/// The sample of a pixel: its color, or what a tap where its center landed finds (manual 8.8).
glm::vec3 sampleAt(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel) {
  if (settings.neighborhood.unjitter == Switch::Off) return currentColor(inputs, pixel);
  return tapAt(inputs, pixel, inputs.jitterPx);
}

std::vector<NeighborhoodSample> membersOf(const Inputs& inputs, const Settings& settings, Set set,
                                          const glm::ivec2& pixel) {
  std::vector<NeighborhoodSample> members;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (belongs(set, dx, dy))
        members.push_back({sampleAt(inputs, settings, pixel + glm::ivec2(dx, dy)),
                           static_cast<std::size_t>(std::abs(dx) + std::abs(dy))});
  return members;
}

/// Seven samples for both of columns 2k and 2k + 1 (manual 8.7): the left one, its diagonals, and the two
/// to the right of it. What is not next to the pixel weighs as a neighbor that is none of them.
std::vector<NeighborhoodSample> pairSamples(const Inputs& inputs, const Settings& settings,
                                            const glm::ivec2& pixel) {
  const bool isLeft = pixel.x % 2 == 0;
  const auto at = [&](int dx, int dy, std::size_t distance) {
    return NeighborhoodSample{sampleAt(inputs, settings, pixel + glm::ivec2(dx, dy)), distance};
  };
  if (isLeft)
    return {at(-1, -1, 2), at(1, -1, 2), at(2, 0, 1), at(0, 0, 0), at(1, 0, 1), at(-1, 1, 2), at(1, 1, 2)};
  return {at(-2, -1, 2), at(0, -1, 1), at(-1, 0, 1), at(0, 0, 0), at(1, 0, 1), at(-2, 1, 2), at(0, 1, 1)};
}

/// κ of manual 8.5, px.
float tapReach(const NeighborhoodInputs& given) {
  if (given.depth == 0.0f) return 0.5f; // the sky is infinitely far
  const float product = given.speed * given.depth;
  return 0.5f + 0.1667f * (product == 0.0f ? 1.0f : saturated(0.5f / product));
}

/// Four taps, which stand for the diagonals: they weigh what those do, since only weights of a table are the
/// same everywhere.
std::vector<NeighborhoodSample> varyingTaps(const Inputs& inputs, const Settings& settings,
                                            const glm::ivec2& pixel, float reach) {
  std::vector<NeighborhoodSample> taps;
  for (const glm::vec2& direction :
       {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(-1, 1), glm::vec2(1, 1)}) {
    glm::vec2 offset = reach * direction;
    if (settings.neighborhood.unjitter == Switch::On) offset = offset + inputs.jitterPx;
    taps.push_back({tapAt(inputs, pixel, offset), 2});
  }
  return taps;
}

/// `center`: the pixel's own color, which need not be a member.
void measure(const std::vector<NeighborhoodSample>& members, const Settings& settings,
             const glm::vec3& center, Neighborhood& result) {
  float total = 0.0f;
  glm::vec3 first(0.0f);
  glm::vec3 second(0.0f);
  result.min = result.max = toBox(members.front().color, settings.space);
  for (const NeighborhoodSample& member : members) {
    const glm::vec3 sample = toBox(member.color, settings.space);
    result.min = minimum(result.min, sample);
    result.max = maximum(result.max, sample);
    const float weight = momentWeight(settings, member);
    const glm::vec3 e = sample - center; // about the center: no cancellation in high dynamic range
    first = first + weight * e;
    second = second + weight * (e * e);
    total = total + weight;
  }
  const glm::vec3 m1 = first / total;
  const glm::vec3 m2 = second / total;
  result.mean = clamped(center + m1, result.min, result.max);
  const glm::vec3 variance = m2 - m1 * m1;
  for (int i = 0; i < 3; ++i) result.deviation[i] = std::sqrt(variance[i] > 0.0f ? variance[i] : 0.0f);
}

std::vector<NeighborhoodSample> membersOfShape(const Inputs& inputs, const Settings& settings,
                                               const glm::ivec2& pixel, float reach) {
  const NeighborhoodShape shape = settings.neighborhood.shape;
  if (shape == NeighborhoodShape::Varying) return varyingTaps(inputs, settings, pixel, reach);
  if (shape == NeighborhoodShape::Pairs) return pairSamples(inputs, settings, pixel);
  return membersOf(inputs, settings, setOf(shape, inputs.frame), pixel);
}

void measureSamples(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel,
                    const NeighborhoodInputs& given, Neighborhood& result) {
  const glm::vec3 center = result.samples[4];
  result.tapReach = tapReach(given);
  result.members = membersOfShape(inputs, settings, pixel, result.tapReach);
  measure(result.members, settings, center, result);
  if (settings.neighborhood.shape != NeighborhoodShape::Rounded) return;
  Neighborhood five;
  measure(membersOf(inputs, settings, Set::Cross, pixel), settings, center, five);
  result.mean = 0.5f * (result.mean + five.mean);
  result.min = 0.5f * (result.min + five.min);
  result.max = 0.5f * (result.max + five.max);
}

/// What contrast between current and history adds to γ (manual 10.11).
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

/// Share of γ that tall pictures keep (manual 10.9).
float shareByResolution(int height) {
  const float share = 1188.0f / static_cast<float>(height); // 1.1 × 1080
  const float atLeast = share > 0.75f ? share : 0.75f;
  return atLeast < 1.0f ? atLeast : 1.0f;
}

float gammaUsed(const Inputs& inputs, const Settings& settings, const Neighborhood& n,
                const glm::vec3& center, const NeighborhoodInputs& given) {
  const NeighborhoodSettings& chosen = settings.neighborhood;
  float gamma = chosen.gamma;
  if (chosen.motionGamma == Switch::On) {
    const glm::ivec2 picturePx(inputs.outputWidth(), inputs.outputHeight());
    const float speed = speedIn(chosen.gammaSpeedIn, given.speed, given.motion, picturePx);
    const float rest = saturated(1.0f - speed / chosen.gammaSpeed);
    gamma = chosen.gammaMoving + (gamma - chosen.gammaMoving) * (rest * rest);
  }
  // Of what is chosen, as Godot multiplies its base; what follows from colors does not know of pixels.
  if (chosen.resolutionGamma == Switch::On) gamma = gamma * shareByResolution(inputs.outputHeight());
  if (chosen.contrastGamma == Switch::On && !inputs.historyColor.empty())
    gamma = gamma + contrastGrowth(settings, n, center, given.history);
  if (chosen.maskRelax == Switch::On) gamma = gamma * (1.0f + 1.5f * given.relax); // manual 10.10
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
    n.boxMin = maximum(n.min, low);
    n.boxMax = minimum(n.max, high);
    break;
  }
}

/// Lowest and highest RGB of nine as they are in box space (fault.boxCorners).
void boxOfCorners(const Settings& settings, Neighborhood& n) {
  glm::vec3 lowest = n.colors[0], highest = n.colors[0];
  for (const glm::vec3& color : n.colors) {
    lowest = minimum(lowest, color);
    highest = maximum(highest, color);
  }
  n.boxMin = toBox(lowest, settings.space);
  n.boxMax = toBox(highest, settings.space);
}

} // namespace

float momentWeight(const Settings& settings, const NeighborhoodSample& member) {
  constexpr std::array kByDistance{1.0f, 0.47236655f, 0.22313016f}; // exp(−¾ r²)
  switch (settings.neighborhood.weights) {
  case MomentWeights::Equal:
    return 1.0f;
  case MomentWeights::Luma:
    return 1.0f / (1.0f + weightLuma(member.color, settings.space.luma));
  case MomentWeights::Distance:
    return kByDistance[member.distance];
  case MomentWeights::BoxLuma:
    return 1.0f / (1.0f + boxLuma(toBox(member.color, settings.space), settings.space));
  }
  return 1.0f;
}

Neighborhood measureNeighborhood(const Inputs& inputs, const Settings& settings,
                                 const glm::vec3& currentFiltered, const glm::ivec2& pixel,
                                 const NeighborhoodInputs& given) {
  Neighborhood result;
  for (int k = 0; k < 9; ++k) {
    const auto place = static_cast<std::size_t>(k);
    result.colors[place] = sampleAt(inputs, settings, pixel + glm::ivec2(k % 3 - 1, k / 3 - 1));
    result.samples[place] = toBox(result.colors[place], settings.space);
  }
  measureSamples(inputs, settings, pixel, given, result);
  const glm::vec3 center = result.samples[4];
  result.gamma = gammaUsed(inputs, settings, result, center, given);
  boundByMoments(settings.neighborhood.box, result);
  if (settings.neighborhood.chromaShrink == Switch::On && settings.space.color != ColorSpace::Rgb) {
    const float half = 0.125f * (result.max.x - result.min.x); // manual 10.6
    for (int i = 1; i < 3; ++i) {
      result.boxMin[i] = center[i] - half;
      result.boxMax[i] = center[i] + half;
    }
  }
  if (isOn(settings.fault.boxCorners)) boxOfCorners(settings, result);
  if (settings.neighborhood.includeFiltered == Switch::On) {
    const glm::vec3 filtered = toBox(currentFiltered, settings.space);
    result.boxMin = minimum(result.boxMin, filtered);
    result.boxMax = maximum(result.boxMax, filtered);
  }
  return result;
}

} // namespace taa::twin
