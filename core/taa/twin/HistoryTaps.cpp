#include "core/taa/twin/HistoryTaps.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/SampleStages.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace taa::twin {
namespace {

constexpr float kFarthestPosition = 1e6f; // px

/// Five bilinear taps for sixteen (Jimenez 2016): corners dropped, weights normalized (manual 6.4) unless
/// as printed (6.4b), or each corner given to its two neighbors (6.4c).
template <typename Real>
TapPlacesOf<Real> fiveTaps(const AxisPlaceOf<Real>& x, const AxisPlaceOf<Real>& y,
                           const HistorySettings& settings) {
  const std::array<Real, 4> wx = cubicWeights(settings, x.fraction);
  const std::array<Real, 4> wy = cubicWeights(settings, y.fraction);
  const Real middleX = wx[1] + wx[2];
  const Real middleY = wy[1] + wy[2];
  const AxisPlaceOf<Real> x12{x.texel, wx[2] / middleX}; // taps 1 and 2 in one
  const AxisPlaceOf<Real> y12{y.texel, wy[2] / middleY};
  const bool givesCorners = settings.filter == HistoryFilter::CatmullRom5Corners;
  const Real besideX = givesCorners ? middleX + 0.5f * (wx[0] + wx[3]) : middleX;
  const Real besideY = givesCorners ? middleY + 0.5f * (wy[0] + wy[3]) : middleY;
  // HDRP reads the right tap a row higher (D13).
  const AxisPlaceOf<Real> rightY =
      settings.filter == HistoryFilter::Cubic5AsPrinted ? AxisPlaceOf<Real>{y.texel - 1, 0.0f} : y12;
  return {{{{x12, {y.texel - 1, 0.0f}, besideX * wy[0]},
            {{x.texel - 1, 0.0f}, y12, wx[0] * besideY},
            {x12, y12, middleX * middleY},
            {{x.texel + 2, 0.0f}, rightY, wx[3] * besideY},
            {x12, {y.texel + 2, 0.0f}, besideX * wy[3]}}},
          5,
          2};
}

/// Nine bilinear taps: equal to sixteen texels (manual 6.3).
template <typename Real>
TapPlacesOf<Real> nineTaps(const AxisPlaceOf<Real>& px, const AxisPlaceOf<Real>& py) {
  const auto axis = [](const AxisPlaceOf<Real>& place) {
    const std::array<Real, 4> w = catmullRomWeights(place.fraction);
    const Real both = w[1] + w[2];
    return std::array<std::pair<AxisPlaceOf<Real>, Real>, 3>{{{{place.texel - 1, 0.0f}, w[0]},
                                                              {{place.texel, w[2] / both}, both},
                                                              {{place.texel + 2, 0.0f}, w[3]}}};
  };
  TapPlacesOf<Real> taps;
  taps.middle = 4;
  for (const auto& [y, wy] : axis(py))
    for (const auto& [x, wx] : axis(px)) taps.each[taps.count++] = {x, y, wx * wy};
  return taps;
}

/// Sixteen texels with the kernel's weights (manual 6.2, 6.5 to 6.7).
template <typename Real>
TapPlacesOf<Real> sixteenTexels(const AxisPlaceOf<Real>& x, const AxisPlaceOf<Real>& y,
                                const HistorySettings& settings) {
  const std::array<Real, 4> wx = cubicWeights(settings, x.fraction);
  const std::array<Real, 4> wy = cubicWeights(settings, y.fraction);
  const bool isLanczos = settings.filter == HistoryFilter::Lanczos;
  TapPlacesOf<Real> taps;
  taps.middle = 5;
  for (int k = 0; k < 16; ++k) {
    const int i = k % 4, j = k / 4;
    const bool isNear = (i == 1 || i == 2) && (j == 1 || j == 2);
    taps.each[taps.count++] = {{x.texel + i - 1, 0.0f},
                               {y.texel + j - 1, 0.0f},
                               wx[static_cast<std::size_t>(i)] * wy[static_cast<std::size_t>(j)],
                               true,
                               isNear || !isLanczos};
  }
  return taps;
}

/// The four texels of bilinear interpolation, as weights.
template <typename Real>
TapPlacesOf<Real> fourTexels(const AxisPlaceOf<Real>& x, const AxisPlaceOf<Real>& y) {
  TapPlacesOf<Real> taps;
  for (int k = 0; k < 4; ++k) {
    const int i = k % 2, j = k / 2;
    taps.each[taps.count++] = {{x.texel + i, 0.0f},
                               {y.texel + j, 0.0f},
                               (i == 0 ? 1.0f - x.fraction : x.fraction) *
                                   (j == 0 ? 1.0f - y.fraction : y.fraction),
                               true};
  }
  return taps;
}

/// What the texels around a place weigh: 4×4 of them, the first one before the texel that lies before it.
class TexelSums {
 public:
  explicit TexelSums(const glm::ivec2& first) : first_(first) {}
  void add(const TapPlaces::Tap& tap, float weight) {
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const float share = (i == 0 ? 1.0f - tap.x.fraction : tap.x.fraction) *
                            (j == 0 ? 1.0f - tap.y.fraction : tap.y.fraction);
        if (share == 0.0f) continue;
        const glm::ivec2 at = glm::ivec2(tap.x.texel + i, tap.y.texel + j) - first_;
        weights_[static_cast<std::size_t>(at.y * 4 + at.x)] += share * weight;
      }
  }
  HistoryTexels texels(const glm::ivec2& picturePx, HistoryBorder border) const {
    HistoryTexels result;
    for (int k = 0; k < 16; ++k) {
      const float weight = weights_[static_cast<std::size_t>(k)];
      const glm::ivec2 texel = first_ + glm::ivec2(k % 4, k / 4);
      const glm::ivec2 inside(std::clamp(texel.x, 0, picturePx.x - 1),
                              std::clamp(texel.y, 0, picturePx.y - 1));
      if (weight == 0.0f || (inside != texel && border == HistoryBorder::Black)) continue;
      result.each[result.count++] = {inside, weight};
    }
    return result;
  }

 private:
  glm::ivec2 first_;
  std::array<float, 16> weights_{};
};

} // namespace

template <typename Real>
AxisPlaceOf<Real> axisPlace(Real positionPx) {
  const Real texel = floor(positionPx - 0.5f); // texel 0 is centered at ½
  return {static_cast<int>(texel), named(positionPx - (texel + 0.5f))};
}

template <typename Real>
Vec2<Real> readPosition(const Vec2<Real>& positionPx, const glm::ivec2& pixel) {
  const auto isSane = [](Real value) { return value >= -kFarthestPosition && value <= kFarthestPosition; };
  return isSane(positionPx.x) && isSane(positionPx.y) ? positionPx : Vec2<Real>(pixel) + 0.5f;
}

template <typename Real>
TapPlacesOf<Real> tapPlaces(const HistorySettings& settings, const Vec2<Real>& positionPx) {
  const AxisPlaceOf<Real> x = axisPlace(positionPx.x), y = axisPlace(positionPx.y);
  switch (settings.filter) {
  case HistoryFilter::Point: {
    TapPlacesOf<Real> one;
    one.each[one.count++] = {{whole(positionPx.x), 0.0f}, {whole(positionPx.y), 0.0f}, 1.0f, true};
    return one;
  }
  case HistoryFilter::Bilinear:
    return fourTexels(x, y);
  case HistoryFilter::CatmullRom5:
  case HistoryFilter::CatmullRom5AsPrinted:
  case HistoryFilter::CatmullRom5Corners:
  case HistoryFilter::Cubic5:
  case HistoryFilter::Cubic5AsPrinted:
    return fiveTaps(x, y, settings);
  case HistoryFilter::CatmullRom9:
    return nineTaps(x, y);
  case HistoryFilter::CatmullRom16:
  case HistoryFilter::Cubic:
  case HistoryFilter::Mitchell:
  case HistoryFilter::Lanczos:
    break;
  }
  return sixteenTexels(x, y, settings);
}

HistoryTexels historyTexels(const HistorySettings& settings, const glm::vec2& positionPx,
                            const glm::ivec2& picturePx, bool isEdge) {
  HistorySettings read = settings;
  if (isEdge) read.filter = HistoryFilter::Bilinear;
  const TapPlaces taps = tapPlaces(read, positionPx);
  float sum = 0.0f;
  for (const TapPlaces::Tap& tap : taps.all()) sum += tap.weight;
  const bool givesMiddle = read.filter == HistoryFilter::CatmullRom5Corners;
  const bool isNormalized = !givesMiddle && read.filter != HistoryFilter::CatmullRom5AsPrinted;
  const AxisPlace x = axisPlace(positionPx.x), y = axisPlace(positionPx.y);
  TexelSums sums({x.texel - 1, y.texel - 1});
  for (const TapPlaces::Tap& tap : taps.all()) sums.add(tap, isNormalized ? tap.weight / sum : tap.weight);
  if (givesMiddle) sums.add(taps.each[taps.middle], 1.0f - sum); // the others are differences to it
  return sums.texels(picturePx, read.border);
}

#define TAA_HISTORY_TAPS(Real)                                                                               \
  template AxisPlaceOf<Real> axisPlace(Real positionPx);                                                     \
  template Vec2<Real> readPosition(const Vec2<Real>& positionPx, const glm::ivec2& pixel);                   \
  template TapPlacesOf<Real> tapPlaces(const HistorySettings& settings, const Vec2<Real>& positionPx);
TAA_EACH_NUMBER(TAA_HISTORY_TAPS)
#undef TAA_HISTORY_TAPS

} // namespace taa::twin
