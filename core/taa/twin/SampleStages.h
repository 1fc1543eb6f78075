// Stages 1 to 4 of the resolve on the CPU: whose motion a pixel follows, where that was, what history holds
// there, and this frame's color.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/twin/Twin.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace taa::twin {

/// A render texel's masks: reactive, responsive; 0 where there is no mask.
template <typename Real = float>
Vec2<Real> maskAt(const Inputs& inputs, const glm::ivec2& texel);
/// Both components of the motion of a point behind the previous camera, px; as in render/FrameInputs.h.
inline constexpr float kNoPreviousPosition = 65504.0f;

/// View depth (m) of a device depth; 0 stands for the sky.
template <typename Real = float>
Real viewDepth(Real depth, const glm::vec4& depthTerms);

/// Whose motion the pixel follows (manual §4).
template <typename Real>
struct DilatedMotionOf {
  glm::ivec2 offset{0};    ///< px
  Real depth = 0.0f;       ///< device
  Vec2<Real> motion{0.0f}; ///< px of the picture
};
using DilatedMotion = DilatedMotionOf<float>;
template <typename Real = float>
DilatedMotionOf<Real> dilateMotion(const Inputs& inputs, const DilateSettings& settings,
                                   const glm::ivec2& texel);

/// Where that surface was (manual §5).
template <typename Real>
struct ReprojectionOf {
  Vec2<Real> position{0.0f}; ///< px in the previous frame
  bool onScreen = false;
  bool noPrevious = false; ///< it was behind the previous camera
  Real speed = 0.0f;       ///< px a frame
};
using Reprojection = ReprojectionOf<float>;
/// `readOff`: px that history is read off its place (fault.historyJitter).
template <typename Real = float>
ReprojectionOf<Real> reproject(const Inputs& inputs, const ReprojectSettings& settings,
                               const Vec2<Real>& motionPx, const glm::ivec2& pixel,
                               const Vec2<Real>& readOff = Vec2<Real>(0.0f));

/// A speed in another unit than px, of its motion, px, and the picture's size.
template <typename Real = float>
Real speedIn(SpeedUnit unit, Real speed, const Vec2<Real>& motionPx, const glm::ivec2& picturePx);

/// A weighted set of colors, whose mean a filter is.
template <typename Real>
struct TapsOf {
  struct Tap {
    Vec3<Real> color{0.0f};
    Real weight = 0.0f;
    bool bounds = true; ///< the result stays within such ones when deringed
  };
  std::array<Tap, 16> each{};
  std::size_t count = 0;
  std::size_t middle = 0; ///< the one that others are differences to
  void add(const Vec3<Real>& color, Real weight, bool bounds = true) {
    each[count++] = {color, weight, bounds};
  }
  std::span<const Tap> all() const { return std::span(each).first(count); }
};
using Taps = TapsOf<float>;

/// Weights of a cubic's four taps at fraction f of a texel (manual 6.2, Catmull-Rom).
template <typename Real = float>
std::array<Real, 4> catmullRomWeights(Real fraction);
/// Weights of the four texels of an axis for the filters of sixteen texels (manual 6.2, 6.5 to 6.7).
template <typename Real = float>
std::array<Real, 4> cubicWeights(const HistorySettings& settings, Real fraction);
/// The stored color at `positionPx` by bilinear interpolation, clamped to the edge.
template <typename Real = float>
Vec3<Real> bilinearHistory(const Inputs& inputs, const Vec2<Real>& positionPx,
                           HistoryBorder border = HistoryBorder::Edge);
/// The taps that a filter of history takes around a place, which are one for Point and four for Bilinear.
template <typename Real = float>
TapsOf<Real> historyTaps(const Inputs& inputs, const HistorySettings& settings, const Vec2<Real>& positionPx);
/// What was accumulated there (manual §6).
template <typename Real>
struct HistorySampleOf {
  Vec3<Real> color{0.0f};
  Real historyLength = 0.0f; ///< N, frames; 0 without history
  Vec2<Real> position{0.0f}; ///< px, where it was read: the history position when that is sane
  bool isEdge = false;       ///< read by one bilinear tap because depth has an edge (6.8)
};
using HistorySample = HistorySampleOf<float>;
template <typename Real = float>
HistorySampleOf<Real> sampleHistory(const Inputs& inputs, const HistorySettings& settings,
                                    const Vec2<Real>& positionPx, const glm::ivec2& pixel,
                                    const glm::ivec2& drawn);
/// At full size, where a pixel is its own render texel.
template <typename Real = float>
inline HistorySampleOf<Real> sampleHistory(const Inputs& inputs, const HistorySettings& settings,
                                           const Vec2<Real>& positionPx, const glm::ivec2& pixel) {
  return sampleHistory(inputs, settings, positionPx, pixel, pixel);
}

/// The fault that a color that is no number is kept (fault.nan): whether the sample of the render texel is
/// none, or one of nine texels of the history around its position.
template <typename Real = float>
bool holdsNan(const Inputs& inputs, const glm::ivec2& drawn, const ReprojectionOf<Real>& reprojection);

/// Weights of the Gaussian around the displaced sample, row-major over 3×3, not normalized (manual 7.4).
template <typename Real = float>
std::array<Real, 9> gaussianWeights(Real variance, const Vec2<Real>& jitterPx);
/// Weights of the chosen filter, likewise (manual §7).
template <typename Real = float>
std::array<Real, 9> currentWeights(const CurrentSettings& settings, const Vec2<Real>& jitterPx);
/// Mean of the pixel and its diagonals (manual 5.6).
template <typename Real = float>
Vec3<Real> blurredRestart(const Inputs& inputs, const glm::ivec2& pixel);
/// Least and greatest of the nine colors around a texel, channel by channel.
template <typename Real>
struct SampleRangeOf {
  Vec3<Real> low{0.0f}, high{0.0f};
};
using SampleRange = SampleRangeOf<float>;
template <typename Real = float>
SampleRangeOf<Real> sampleRange(const Inputs& inputs, const glm::ivec2& texel);
/// Within the nine samples around a texel.
template <typename Real = float>
Vec3<Real> boundedBySamples(const Inputs& inputs, const glm::ivec2& texel, const Vec3<Real>& color);
/// `color`, filtered around a texel, sharpened (manual 18.2); itself where that is off.
template <typename Real = float>
Vec3<Real> sharpenCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& texel,
                          const Vec3<Real>& color);
/// This frame's color by a bilinear tap at `offset` px from the center of a render texel.
template <typename Real = float>
Vec3<Real> tapAt(const Inputs& inputs, const glm::ivec2& texel, const Vec2<Real>& offset);
/// This frame's color at the pixel's center (manual §7); `chosen`: the luma that samples are weighed by where
/// the settings weigh them so.
template <typename Real = float>
Vec3<Real> filterCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel,
                         WeightLuma chosen = WeightLuma::Rec709);

} // namespace taa::twin
