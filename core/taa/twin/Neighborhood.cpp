// Stage 5, neighborhood: moments and extremes of the colors around the pixel, and the box from them.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
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
template <typename Real>
Vec3<Real> sampleAt(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel) {
  if (settings.neighborhood.unjitter == Switch::Off) return currentColor<Real>(inputs, pixel);
  return tapAt(inputs, pixel, Vec2<Real>(inputs.jitterPx));
}

template <typename Real>
std::vector<NeighborhoodSampleOf<Real>> membersOf(const Inputs& inputs, const Settings& settings, Set set,
                                                  const glm::ivec2& pixel) {
  std::vector<NeighborhoodSampleOf<Real>> members;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (belongs(set, dx, dy))
        members.push_back({sampleAt<Real>(inputs, settings, pixel + glm::ivec2(dx, dy)),
                           static_cast<std::size_t>(std::abs(dx) + std::abs(dy))});
  return members;
}

/// Seven samples for both of columns 2k and 2k + 1 (manual 8.7): the left one, its diagonals, and the two
/// to the right of it. What is not next to the pixel weighs as a neighbor that is none of them.
template <typename Real>
std::vector<NeighborhoodSampleOf<Real>> pairSamples(const Inputs& inputs, const Settings& settings,
                                                    const glm::ivec2& pixel) {
  const bool isLeft = pixel.x % 2 == 0;
  const auto at = [&](int dx, int dy, std::size_t distance) {
    return NeighborhoodSampleOf<Real>{sampleAt<Real>(inputs, settings, pixel + glm::ivec2(dx, dy)), distance};
  };
  if (isLeft)
    return {at(-1, -1, 2), at(1, -1, 2), at(2, 0, 1), at(0, 0, 0), at(1, 0, 1), at(-1, 1, 2), at(1, 1, 2)};
  return {at(-2, -1, 2), at(0, -1, 1), at(-1, 0, 1), at(0, 0, 0), at(1, 0, 1), at(-2, 1, 2), at(0, 1, 1)};
}

/// κ of manual 8.5, px.
template <typename Real>
Real tapReach(const NeighborhoodInputsOf<Real>& given) {
  if (given.depth == 0.0f) return 0.5f; // the sky is infinitely far
  const Real product = given.speed * given.depth;
  return 0.5f + 0.1667f * (product == 0.0f ? 1.0f : saturated(0.5f / product));
}

/// Four taps, which stand for the diagonals: they weigh what those do, since only weights of a table are the
/// same everywhere.
template <typename Real>
std::vector<NeighborhoodSampleOf<Real>> varyingTaps(const Inputs& inputs, const Settings& settings,
                                                    const glm::ivec2& pixel, Real reach) {
  std::vector<NeighborhoodSampleOf<Real>> taps;
  for (const Vec2<Real>& direction :
       {Vec2<Real>(-1, -1), Vec2<Real>(1, -1), Vec2<Real>(-1, 1), Vec2<Real>(1, 1)}) {
    Vec2<Real> offset = reach * direction;
    if (settings.neighborhood.unjitter == Switch::On) offset = offset + Vec2<Real>(inputs.jitterPx);
    taps.push_back({tapAt(inputs, pixel, offset), 2});
  }
  return taps;
}

/// What it counts for mean and deviation (manual 10.7).
template <typename Real>
Real momentWeight(const Settings& settings, const NeighborhoodSampleOf<Real>& member) {
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

/// `center`: the pixel's own color, which need not be a member.
template <typename Real>
void measure(const std::vector<NeighborhoodSampleOf<Real>>& members, const Settings& settings,
             const Vec3<Real>& center, NeighborhoodOf<Real>& result) {
  Real total = 0.0f;
  Vec3<Real> first(0.0f);
  Vec3<Real> second(0.0f);
  result.min = result.max = named(toBox(members.front().color, settings.space));
  for (const NeighborhoodSampleOf<Real>& member : members) {
    const Vec3<Real> sample = named(toBox(member.color, settings.space));
    result.min = minimum(result.min, sample);
    result.max = maximum(result.max, sample);
    const Real weight = named(momentWeight(settings, member));
    const Vec3<Real> e = sample - center; // about the center: no cancellation in high dynamic range
    first = first + weight * e;
    second = second + weight * (e * e);
    total = total + weight;
  }
  const Vec3<Real> m1 = first / total;
  const Vec3<Real> m2 = second / total;
  result.mean = clamped(center + m1, result.min, result.max);
  const Vec3<Real> variance = m2 - m1 * m1;
  for (int i = 0; i < 3; ++i) result.deviation[i] = sqrt(variance[i] > 0.0f ? variance[i] : 0.0f);
}

template <typename Real>
std::vector<NeighborhoodSampleOf<Real>> membersOfShape(const Inputs& inputs, const Settings& settings,
                                                       const glm::ivec2& pixel, Real reach) {
  const NeighborhoodShape shape = settings.neighborhood.shape;
  if (shape == NeighborhoodShape::Varying) return varyingTaps(inputs, settings, pixel, reach);
  if (shape == NeighborhoodShape::Pairs) return pairSamples<Real>(inputs, settings, pixel);
  return membersOf<Real>(inputs, settings, setOf(shape, inputs.frame), pixel);
}

template <typename Real>
void measureSamples(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel,
                    const NeighborhoodInputsOf<Real>& given, NeighborhoodOf<Real>& result) {
  const Vec3<Real> center = result.samples[4];
  result.tapReach = tapReach(given);
  result.members = membersOfShape(inputs, settings, pixel, result.tapReach);
  measure(result.members, settings, center, result);
  if (settings.neighborhood.shape != NeighborhoodShape::Rounded) return;
  NeighborhoodOf<Real> five;
  measure(membersOf<Real>(inputs, settings, Set::Cross, pixel), settings, center, five);
  result.mean = 0.5f * (result.mean + five.mean);
  result.min = 0.5f * (result.min + five.min);
  result.max = 0.5f * (result.max + five.max);
}

/// What contrast between current and history adds to γ (manual 10.11).
template <typename Real>
Real contrastGrowth(const Settings& settings, const NeighborhoodOf<Real>& n, const Vec3<Real>& center,
                    const Vec3<Real>& history) {
  const SpaceSettings& space = settings.space;
  const Real half = named(0.5f * boxLuma(n.deviation, space));
  const Real mean = named(boxLuma(n.mean, space));
  const Real current = named(boxLuma(center, space));
  const Real past = minimum(maximum(named(boxLuma(toBox(history, space), space)), mean - half), mean + half);
  const Real divisor = maximum(maximum(current, past), 0.15f);
  const Real x = (fabs(current - past) / divisor - 0.05f) / 0.5f;
  return number<Real>(settings.neighborhood.contrastGrowth) * smooth(x);
}

/// Share of γ that tall pictures keep (manual 10.9).
template <typename Real>
Real shareByResolution(int height) {
  const Real share = 1188.0f / static_cast<Real>(height); // 1.1 × 1080
  return minimum(maximum(share, 0.75f), 1.0f);
}

template <typename Real>
Real gammaUsed(const Inputs& inputs, const Settings& settings, const NeighborhoodOf<Real>& n,
               const Vec3<Real>& center, const NeighborhoodInputsOf<Real>& given) {
  const NeighborhoodSettings& chosen = settings.neighborhood;
  Real gamma = number<Real>(chosen.gamma);
  if (chosen.motionGamma == Switch::On) {
    const glm::ivec2 picturePx(inputs.outputWidth(), inputs.outputHeight());
    const Real speed = speedIn(chosen.gammaSpeedIn, given.speed, given.motion, picturePx);
    const Real rest = saturated(1.0f - speed / number<Real>(chosen.gammaSpeed));
    gamma = number<Real>(chosen.gammaMoving) + (gamma - number<Real>(chosen.gammaMoving)) * (rest * rest);
  }
  // Of what is chosen, as Godot multiplies its base; what follows from colors does not know of pixels.
  if (chosen.resolutionGamma == Switch::On) gamma = gamma * shareByResolution<Real>(inputs.outputHeight());
  if (chosen.contrastGamma == Switch::On && !inputs.historyColor.empty())
    gamma = gamma + contrastGrowth(settings, n, center, given.history);
  if (chosen.maskRelax == Switch::On) gamma = gamma * (1.0f + 1.5f * given.relax); // manual 10.10
  return gamma;
}

template <typename Real>
void boundByMoments(BoxKind kind, NeighborhoodOf<Real>& n) {
  const Vec3<Real> reach = n.gamma * n.deviation;
  const Vec3<Real> low = n.mean - reach;
  const Vec3<Real> high = n.mean + reach;
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
template <typename Real>
void boxOfCorners(const Settings& settings, NeighborhoodOf<Real>& n) {
  Vec3<Real> lowest = n.colors[0], highest = n.colors[0];
  for (const Vec3<Real>& color : n.colors) {
    lowest = minimum(lowest, color);
    highest = maximum(highest, color);
  }
  n.boxMin = toBox(lowest, settings.space);
  n.boxMax = toBox(highest, settings.space);
}

} // namespace

template <typename Real>
NeighborhoodOf<Real> measureNeighborhood(const Inputs& inputs, const Settings& settings,
                                         const Vec3<Real>& currentFiltered, const glm::ivec2& pixel,
                                         const NeighborhoodInputsOf<Real>& given) {
  NeighborhoodOf<Real> result;
  for (int k = 0; k < 9; ++k) {
    const auto place = static_cast<std::size_t>(k);
    result.colors[place] = sampleAt<Real>(inputs, settings, pixel + glm::ivec2(k % 3 - 1, k / 3 - 1));
    result.samples[place] = named(toBox(result.colors[place], settings.space));
  }
  measureSamples(inputs, settings, pixel, given, result);
  const Vec3<Real> center = result.samples[4];
  observe(IntermediateId::neighborhoodMean, result.mean);
  observe(IntermediateId::neighborhoodDeviation, result.deviation);
  observe(IntermediateId::neighborhoodMin, result.min);
  observe(IntermediateId::neighborhoodMax, result.max);
  searched<Real>();
  result.gamma = gammaUsed(inputs, settings, result, center, given);
  decided<Real>(IntermediateId::boxGamma);
  observe(IntermediateId::boxGamma, result.gamma);
  boundByMoments(settings.neighborhood.box, result);
  if (settings.neighborhood.chromaShrink == Switch::On && settings.space.color != ColorSpace::Rgb) {
    const Real half = 0.125f * (result.max.x - result.min.x); // manual 10.6
    for (int i = 1; i < 3; ++i) {
      result.boxMin[i] = center[i] - half;
      result.boxMax[i] = center[i] + half;
    }
  }
  if (isOn(settings.fault.boxCorners)) boxOfCorners(settings, result);
  if (settings.neighborhood.includeFiltered == Switch::On) {
    const Vec3<Real> filtered = named(toBox(currentFiltered, settings.space));
    result.boxMin = minimum(result.boxMin, filtered);
    result.boxMax = maximum(result.boxMax, filtered);
  }
  return result;
}

#define TAA_NEIGHBORHOOD(Real)                                                                               \
  template NeighborhoodOf<Real> measureNeighborhood(                                                         \
      const Inputs& inputs, const Settings& settings, const Vec3<Real>& currentFiltered,                     \
      const glm::ivec2& pixel, const NeighborhoodInputsOf<Real>& given);
TAA_EACH_NUMBER(TAA_NEIGHBORHOOD)
#undef TAA_NEIGHBORHOOD

} // namespace taa::twin
