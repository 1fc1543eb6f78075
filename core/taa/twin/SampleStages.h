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
glm::vec2 maskAt(const Inputs& inputs, const glm::ivec2& texel);
/// Both components of the motion of a point behind the previous camera, px; as in render/FrameInputs.h.
inline constexpr float kNoPreviousPosition = 65504.0f;

/// View depth (m) of a device depth; 0 stands for the sky.
float viewDepth(float depth, const glm::vec4& depthTerms);

/// Whose motion the pixel follows (manual §4).
struct DilatedMotion {
  glm::ivec2 offset{0};   ///< px
  float depth = 0.0f;     ///< device
  glm::vec2 motion{0.0f}; ///< px of the picture
};
DilatedMotion dilateMotion(const Inputs& inputs, const DilateSettings& settings, const glm::ivec2& texel);

/// Where that surface was (manual §5).
struct Reprojection {
  glm::vec2 position{0.0f}; ///< px in the previous frame
  bool onScreen = false;
  bool noPrevious = false; ///< it was behind the previous camera
  float speed = 0.0f;      ///< px a frame
};
/// `readOff`: px that history is read off its place (fault.historyJitter).
Reprojection reproject(const Inputs& inputs, const ReprojectSettings& settings, const glm::vec2& motionPx,
                       const glm::ivec2& pixel, const glm::vec2& readOff = glm::vec2(0.0f));

/// A speed in another unit than px, of its motion, px, and the picture's size.
float speedIn(SpeedUnit unit, float speed, const glm::vec2& motionPx, const glm::ivec2& picturePx);

/// A weighted set of colors, whose mean a filter is.
struct Taps {
  struct Tap {
    glm::vec3 color{0.0f};
    float weight = 0.0f;
    bool bounds = true; ///< the result stays within such ones when deringed
  };
  std::array<Tap, 16> each{};
  std::size_t count = 0;
  std::size_t middle = 0; ///< the one that others are differences to
  void add(const glm::vec3& color, float weight, bool bounds = true) {
    each[count++] = {color, weight, bounds};
  }
  std::span<const Tap> all() const { return std::span(each).first(count); }
};

/// Weights of a cubic's four taps at fraction f of a texel (manual 6.2, Catmull-Rom).
std::array<float, 4> catmullRomWeights(float fraction);
/// Weights of the four texels of an axis for the filters of sixteen texels (manual 6.2, 6.5 to 6.7).
std::array<float, 4> cubicWeights(const HistorySettings& settings, float fraction);
/// The stored color at `positionPx` by bilinear interpolation, clamped to the edge.
glm::vec3 bilinearHistory(const Inputs& inputs, const glm::vec2& positionPx,
                          HistoryBorder border = HistoryBorder::Edge);
/// The taps that a filter of history takes around a place, which are one for Point and four for Bilinear.
Taps historyTaps(const Inputs& inputs, const HistorySettings& settings, const glm::vec2& positionPx);
/// What was accumulated there (manual §6).
struct HistorySample {
  glm::vec3 color{0.0f};
  float historyLength = 0.0f; ///< N, frames; 0 without history
  glm::vec2 position{0.0f};   ///< px, where it was read: the history position when that is sane
  bool isEdge = false;        ///< read by one bilinear tap because depth has an edge (6.8)
};
HistorySample sampleHistory(const Inputs& inputs, const HistorySettings& settings,
                            const glm::vec2& positionPx, const glm::ivec2& pixel, const glm::ivec2& drawn);
/// At full size, where a pixel is its own render texel.
inline HistorySample sampleHistory(const Inputs& inputs, const HistorySettings& settings,
                                   const glm::vec2& positionPx, const glm::ivec2& pixel) {
  return sampleHistory(inputs, settings, positionPx, pixel, pixel);
}

/// The fault that a color that is no number is kept (fault.nan): whether the sample of the render texel is
/// none, or one of nine texels of the history around its position.
bool holdsNan(const Inputs& inputs, const glm::ivec2& drawn, const Reprojection& reprojection);

/// Weights of the Gaussian around the displaced sample, row-major over 3×3, not normalized (manual 7.4).
std::array<float, 9> gaussianWeights(float variance, const glm::vec2& jitterPx);
/// Weights of the chosen filter, likewise (manual §7).
std::array<float, 9> currentWeights(const CurrentSettings& settings, const glm::vec2& jitterPx);
/// Mean of the pixel and its diagonals (manual 5.6).
glm::vec3 blurredRestart(const Inputs& inputs, const glm::ivec2& pixel);
/// Least and greatest of the nine colors around a texel, channel by channel.
struct SampleRange {
  glm::vec3 low{0.0f}, high{0.0f};
};
SampleRange sampleRange(const Inputs& inputs, const glm::ivec2& texel);
/// Within the nine samples around a texel.
glm::vec3 boundedBySamples(const Inputs& inputs, const glm::ivec2& texel, const glm::vec3& color);
/// `color`, filtered around a texel, sharpened (manual 18.2); itself where that is off.
glm::vec3 sharpenCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& texel,
                         const glm::vec3& color);
/// This frame's color by a bilinear tap at `offset` px from the center of a render texel.
glm::vec3 tapAt(const Inputs& inputs, const glm::ivec2& texel, const glm::vec2& offset);
/// This frame's color at the pixel's center (manual §7), before it is sharpened; `chosen`: the luma that
/// samples are weighed by where the settings weigh them so.
glm::vec3 unsharpenedCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel,
                             WeightLuma chosen = WeightLuma::Rec709);
/// And after that.
glm::vec3 filterCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel,
                        WeightLuma chosen = WeightLuma::Rec709);

} // namespace taa::twin
