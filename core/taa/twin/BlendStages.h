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
struct WeightInputs {
  bool hasHistory = false;
  float lumaCurrent = 0.0f, lumaHistory = 0.0f; ///< filtered; rectified
  float boxCurrent = 0.0f, boxHistoryRaw = 0.0f, boxHistory = 0.0f, boxLow = 0.0f, boxHigh = 0.0f;
  float compressedCurrent = 0.0f, compressedHistory = 0.0f; ///< Godot's luma of c/(1 + c)
  float maxCurrent = 0.0f, maxHistory = 0.0f;               ///< luma of c/(1 + its largest channel)
  glm::vec3 contrast{0.0f}; ///< range of the nine samples over the filtered color
  float depth = 0.0f;       ///< device
  float speed = 0.0f;       ///< px a frame
  glm::ivec2 picturePx{0};  ///< size of the picture
  glm::vec2 motion{0.0f};   ///< px
  glm::vec2 motionUv{0.0f};
  glm::vec2 mask{0.0f};        ///< reactive, responsive
  float relax = 0.0f;          ///< the larger of them where it relaxes the box
  float velocityChange = 0.0f; ///< px a frame
  float divergence = 0.0f;     ///< 0 to 1
  float confidence = 1.0f;     ///< κ
  bool isFlicker = false;      ///< its depth differs, and it is the same (13.9)
  glm::vec2 jitterPx{0.0f};
  double stepSeconds = 1.0 / 60.0;
  bool isFrozen = false; ///< nothing of the current frame is taken
  bool decays = false;   ///< what is rejected is added to α
};
/// Bevy's confidence after a frame (manual §16).
float confidenceAfter(float before, const glm::vec2& motionPx);
/// Terms of α, the weight of the current frame (manual §13).
struct Weights {
  float base = 0.0f;
  float floor = 0.0f;
  float lumaFlicker = 1.0f, nearClamp = 1.0f, historyContrast = 1.0f, relax = 1.0f, sampleDistance = 1.0f;
  float flicker = 1.0f; ///< after the floor
  float motion = 0.0f, velocityChange = 0.0f, divergence = 0.0f;
  float byFrameRate = 0.0f; ///< all of that, for the time the frame took
  float mask = 0.0f;
  float invalid = 0.0f;
  float alpha = 0.0f;       ///< composed
  glm::vec3 channels{0.0f}; ///< α of red, green and blue
};
Weights blendWeight(const WeightSettings& settings, float historyLength, float invalid,
                    const WeightInputs& weighed = {});
/// α is 1 where TAA is off.
Weights blendWeight(const Settings& settings, float historyLength, float invalid,
                    const WeightInputs& weighed);

/// The output (manual §14–16).
struct Blended {
  float toneWeightCurrent = 1.0f;
  float toneWeightHistory = 1.0f;
  float factor = 1.0f;        ///< share of the current color
  float historyLength = 1.0f; ///< N after this frame
  glm::vec3 resolved{0.0f};
};
/// What is mixed.
struct BlendInputs {
  glm::vec3 current{0.0f};
  glm::vec3 history{0.0f};
  float alpha = 1.0f;
  glm::vec3 channels{1.0f}; ///< α of each channel, where the source has three
  float historyLength = 0.0f;
  float confidence = 1.0f; ///< κ
  glm::vec2 motion{0.0f};  ///< px
  glm::ivec2 pixel{0};     ///< it and the frame's number choose the dither
  int frame = 0;
  bool isFirst = false; ///< there is no history
  bool isNan = false;   ///< a color that is no number is kept
};
Blended blend(const Settings& settings, const BlendInputs& mix);

/// The middle of nine resolved colors sharpened (manual §18), `current`: this frame's; 3×3, row-major.
glm::vec3 sharpen(const OutputSettings& settings, const std::array<glm::vec3, 9>& resolved,
                  const std::array<glm::vec3, 9>& current);
/// What of it formulas are made of: RCAS's lobe, of nine colors with bounded highlights, and the mean that
/// sharpening in the resolve keeps away from.
float rcasLobe(const std::array<glm::vec3, 9>& compressed, float amount);
glm::vec3 meanInResolve(const std::array<glm::vec3, 9>& current);
/// Each color divided by 1 + its largest channel.
std::array<glm::vec3, 9> compressMax(const std::array<glm::vec3, 9>& colors);
/// What is shown of a pixel of `inputs.resolved`, which may be larger than the inputs (manual §18, 14.4).
struct ShownColor {
  float detail = 0.0f; ///< luma that sharpening adds
  float trust = 1.0f;  ///< share of the resolved color
  glm::vec3 color{0.0f};
  glm::vec3 sharp{0.0f}, fast{0.0f}; ///< sharpened; blurred along its motion, where that is
  float noise = 0.0f;                ///< added to square roots
  glm::vec3 smooth{0.0f};            ///< the color before that
};
ShownColor showOutput(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel);

} // namespace taa::twin
