// Stages 8 to 10 of the resolve on the CPU: the weight of the current frame, the mix, and what is shown of
// it.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/twin/Twin.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace taa::twin {

/// What the terms of α look at: luma of scene-linear colors, luma of box space, and motion.
template <typename Real>
struct WeightInputsOf {
  bool hasHistory = false;
  Real lumaCurrent = 0.0f, lumaHistory = 0.0f; ///< filtered; rectified
  Real boxCurrent = 0.0f, boxHistoryRaw = 0.0f, boxHistory = 0.0f, boxLow = 0.0f, boxHigh = 0.0f;
  Real compressedCurrent = 0.0f, compressedHistory = 0.0f; ///< Godot's luma of c/(1 + c)
  Real maxCurrent = 0.0f, maxHistory = 0.0f;               ///< luma of c/(1 + its largest channel)
  Vec3<Real> contrast{0.0f}; ///< range of the nine samples over the filtered color
  Real depth = 0.0f;         ///< device
  Real speed = 0.0f;         ///< px a frame
  glm::ivec2 picturePx{0};   ///< size of the picture
  Vec2<Real> motion{0.0f};   ///< px
  Vec2<Real> motionUv{0.0f};
  Vec2<Real> mask{0.0f};      ///< reactive, responsive
  Real relax = 0.0f;          ///< the larger of them where it relaxes the box
  Real velocityChange = 0.0f; ///< px a frame
  Real divergence = 0.0f;     ///< 0 to 1
  Real confidence = 1.0f;     ///< κ
  bool isFlicker = false;     ///< its depth differs, and it is the same (13.9)
  Vec2<Real> jitterPx{0.0f};
  double stepSeconds = 1.0 / 60.0;
  bool isFrozen = false; ///< nothing of the current frame is taken
  bool decays = false;   ///< what is rejected is added to α
};
using WeightInputs = WeightInputsOf<float>;
/// Bevy's confidence after a frame (manual §16).
template <typename Real = float>
Real confidenceAfter(Real before, const Vec2<Real>& motionPx);
/// Terms of α, the weight of the current frame (manual §13).
template <typename Real>
struct WeightsOf {
  Real base = 0.0f;
  Real floor = 0.0f;
  Real lumaFlicker = 1.0f, nearClamp = 1.0f, historyContrast = 1.0f, relax = 1.0f, sampleDistance = 1.0f;
  Real flicker = 1.0f; ///< after the floor
  Real motion = 0.0f, velocityChange = 0.0f, divergence = 0.0f;
  Real byFrameRate = 0.0f; ///< all of that, for the time the frame took
  Real mask = 0.0f;
  Real invalid = 0.0f;
  Real alpha = 0.0f;         ///< composed
  Vec3<Real> channels{0.0f}; ///< α of red, green and blue
};
using Weights = WeightsOf<float>;
template <typename Real = float>
WeightsOf<Real> blendWeight(const WeightSettings& settings, Real historyLength, Real invalid,
                            const WeightInputsOf<Real>& weighed = {});
/// α is 1 where TAA is off.
template <typename Real = float>
WeightsOf<Real> blendWeight(const Settings& settings, Real historyLength, Real invalid,
                            const WeightInputsOf<Real>& weighed);

/// The output (manual §14–16).
template <typename Real>
struct BlendedOf {
  Real toneWeightCurrent = 1.0f;
  Real toneWeightHistory = 1.0f;
  Real factor = 1.0f;        ///< share of the current color
  Real historyLength = 1.0f; ///< N after this frame
  Vec3<Real> resolved{0.0f};
};
using Blended = BlendedOf<float>;
/// What is mixed.
template <typename Real>
struct BlendInputsOf {
  Vec3<Real> current{0.0f};
  Vec3<Real> history{0.0f};
  Real alpha = 1.0f;
  Vec3<Real> channels{1.0f}; ///< α of each channel, where the source has three
  Real historyLength = 0.0f;
  Real confidence = 1.0f;  ///< κ
  Vec2<Real> motion{0.0f}; ///< px
  glm::ivec2 pixel{0};     ///< it and the frame's number choose the dither
  int frame = 0;
  bool isFirst = false; ///< there is no history
  bool isNan = false;   ///< a color that is no number is kept
};
using BlendInputs = BlendInputsOf<float>;
template <typename Real = float>
BlendedOf<Real> blend(const Settings& settings, const BlendInputsOf<Real>& mix);

/// The middle of nine resolved colors sharpened (manual §18), `current`: this frame's; 3×3, row-major.
template <typename Real = float>
Vec3<Real> sharpen(const OutputSettings& settings, const std::array<Vec3<Real>, 9>& resolved,
                   const std::array<Vec3<Real>, 9>& current);
/// What is shown of a pixel of `inputs.resolved`, which may be larger than the inputs (manual §18, 14.4).
template <typename Real>
struct ShownColorOf {
  Real detail = 0.0f; ///< luma that sharpening adds
  Real trust = 1.0f;  ///< share of the resolved color
  Vec3<Real> color{0.0f};
};
using ShownColor = ShownColorOf<float>;
template <typename Real = float>
ShownColorOf<Real> showOutput(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel);

} // namespace taa::twin
