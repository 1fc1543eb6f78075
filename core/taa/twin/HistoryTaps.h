// Where the filters of history read, and what each place weighs: without the colors that are there, so that
// whatever history is made of can be filtered likewise.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/twin/Numbers.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace taa::twin {

/// A place between texels along one axis: the texel before it, and how far it is to the next. Apart, because
/// their sum would round the fraction by as much as the texel's number is large.
template <typename Real>
struct AxisPlaceOf {
  int texel = 0;
  Real fraction = 0.0f; ///< 0 to 1
};
using AxisPlace = AxisPlaceOf<float>;
template <typename Real = float>
AxisPlaceOf<Real> axisPlace(Real positionPx);

/// Where history is read: the pixel itself where the position is no number or so far out that history is
/// rejected later anyway.
template <typename Real = float>
Vec2<Real> readPosition(const Vec2<Real>& positionPx, const glm::ivec2& pixel);

/// The places that a filter of history takes around another (manual §6).
template <typename Real>
struct TapPlacesOf {
  struct Tap {
    AxisPlaceOf<Real> x, y;
    Real weight = 0.0f;
    bool isTexel = false; ///< read as it is stored; else by bilinear interpolation
    bool bounds = true;   ///< the result stays within such ones when deringed
  };
  std::array<Tap, 16> each{};
  std::size_t count = 0;
  std::size_t middle = 0; ///< the one that others are differences to
  std::span<const Tap> all() const { return std::span(each).first(count); }
};
using TapPlaces = TapPlacesOf<float>;
template <typename Real = float>
TapPlacesOf<Real> tapPlaces(const HistorySettings& settings, const Vec2<Real>& positionPx);

/// Texels of the history and what each is multiplied by.
struct HistoryTexels {
  struct Texel {
    glm::ivec2 at{0};
    float weight = 0.0f;
  };
  std::array<Texel, 16> each{};
  std::size_t count = 0;
  std::span<const Texel> all() const { return std::span(each).first(count); }
};
/// All that a filter is but for deringing, which is no sum: of texels inside the picture, beyond the border
/// those of the edge, or none where it is black. They sum up to 1 but for that and for filters that are as
/// printed. `isEdge`: read by one bilinear tap (6.8).
HistoryTexels historyTexels(const HistorySettings& settings, const glm::vec2& positionPx,
                            const glm::ivec2& picturePx, bool isEdge = false);

} // namespace taa::twin
