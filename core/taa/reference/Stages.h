// The nine stages of the resolve and what is shown of it on the CPU, in order, one file each: values in,
// values out.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/reference/Reference.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>

namespace taa::reference {

/// A render texel's masks: reactive, responsive; 0 where there is no mask.
glm::vec2 maskAt(const Inputs& inputs, const glm::ivec2& texel);
/// Both components of the motion of a point behind the previous camera, px; as in render/FrameInputs.h.
inline constexpr float kNoPreviousPosition = 65504.0f;

/// View depth (m) of a device depth; 0 stands for the sky.
float viewDepth(float depth, const glm::vec4& depthTerms);

/// Whose motion the pixel follows (catalogue §4).
struct Dilated {
  glm::ivec2 offset{0};   ///< px
  float depth = 0.0f;     ///< device
  glm::vec2 motion{0.0f}; ///< px of the picture
};
Dilated dilateMotion(const Inputs& inputs, const DilateSettings& settings, const glm::ivec2& texel);

/// Where that surface was (catalogue §5).
struct Reprojected {
  glm::vec2 position{0.0f}; ///< px in the previous frame
  bool onScreen = false;
  bool noPrevious = false; ///< it was behind the previous camera
  float speed = 0.0f;      ///< px a frame
};
Reprojected reproject(const Inputs& inputs, const glm::vec2& motionPx, const glm::ivec2& pixel);

/// Weights of a cubic's four taps at fraction f of a texel (catalogue 6.2, Catmull-Rom).
std::array<float, 4> catmullRomWeights(float fraction);
/// Weights of the four texels of an axis for the filters of sixteen texels (catalogue 6.2, 6.5 to 6.7).
std::array<float, 4> cubicWeights(const HistorySettings& settings, float fraction);
/// The stored color at `positionPx` by bilinear interpolation, clamped to the edge.
glm::vec3 bilinearHistory(const Inputs& inputs, const glm::vec2& positionPx);
/// What was accumulated there (catalogue §6).
struct HistorySample {
  glm::vec3 color{0.0f};
  float length = 0.0f;      ///< N, frames; 0 without history
  glm::vec2 position{0.0f}; ///< px, where it was read: the history position when that is sane
  bool isEdge = false;      ///< read by one bilinear tap because depth has an edge (6.8)
};
HistorySample sampleHistory(const Inputs& inputs, const HistorySettings& settings,
                            const glm::vec2& positionPx, const glm::ivec2& pixel, const glm::ivec2& drawn);
/// At full size, where a pixel is its own render texel.
inline HistorySample sampleHistory(const Inputs& inputs, const HistorySettings& settings,
                                   const glm::vec2& positionPx, const glm::ivec2& pixel) {
  return sampleHistory(inputs, settings, positionPx, pixel, pixel);
}

/// Weights of the Gaussian around the displaced sample, row-major over 3×3, not normalized (catalogue 7.4).
std::array<float, 9> gaussianWeights(float variance, const glm::vec2& jitterPx);
/// Weights of the chosen filter, likewise (catalogue §7).
std::array<float, 9> currentWeights(const CurrentSettings& settings, const glm::vec2& jitterPx);
/// Mean of the pixel and its diagonals (catalogue 5.6).
glm::vec3 blurredRestart(const Inputs& inputs, const glm::ivec2& pixel);
/// Within the nine samples around a texel.
glm::vec3 boundedBySamples(const Inputs& inputs, const glm::ivec2& texel, const glm::vec3& color);
/// `color`, filtered around a texel, sharpened (catalogue 18.2); itself where that is off.
glm::vec3 sharpenCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& texel,
                         const glm::vec3& color);
/// A bilinear tap where the center of `pixel` landed (catalogue 7.1, 8.8).
glm::vec3 unjitteredColor(const Inputs& inputs, const glm::ivec2& pixel);
/// This frame's color at the pixel's center (catalogue §7).
glm::vec3 filterCurrent(const Inputs& inputs, const CurrentSettings& settings, const glm::ivec2& pixel);

/// The colors around the pixel and the box that bounds them, box space (catalogue §8–10).
struct Neighborhood {
  glm::vec3 mean{0.0f};
  glm::vec3 deviation{0.0f};
  glm::vec3 min{0.0f};
  glm::vec3 max{0.0f};
  float gamma = 0.0f; ///< the one used
  glm::vec3 boxMin{0.0f};
  glm::vec3 boxMax{0.0f};
  std::array<glm::vec3, 9> samples{}; ///< in box space, row-major
};
/// What γ may depend on.
struct Moved {
  glm::vec3 history{0.0f}; ///< scene-linear, as it was read
  float speed = 0.0f;      ///< px a frame
  float relax = 0.0f;      ///< the larger mask
};
Neighborhood measureNeighborhood(const Inputs& inputs, const Settings& settings,
                                 const glm::vec3& currentFiltered, const glm::ivec2& pixel,
                                 const Moved& moved = {});

/// A point moved into a box, box space, how far on its way (0 kept, 1 all the way), and which part of that is
/// applied.
struct Clipped {
  glm::vec3 value{0.0f};
  float amount = 0.0f;
  float strength = 1.0f;
  bool moved = false; ///< it was outside
};
/// Of the methods that need no more than the box (11.1 to 11.3).
Clipped clip(RectifyMethod method, const glm::vec3& value, const glm::vec3& target, const glm::vec3& boxMin,
             const glm::vec3& boxMax);
/// What rectification may depend on besides colors.
struct Applied {
  float speed = 0.0f; ///< px a frame
  float held = 0.0f;  ///< share of the correction that is taken back
};
/// History pulled into the box, scene-linear (catalogue §11).
Clipped rectifyHistory(const Inputs& inputs, const Settings& settings, const glm::vec3& historyRaw,
                       const glm::vec3& currentFiltered, const Neighborhood& neighborhood,
                       const Applied& applied = {});
/// N of history after it was rectified (catalogue 11.7).
float lengthKept(const Settings& settings, float length, const Clipped& clipped, float held);

/// What of the correction is taken back (catalogue 17.3, 17.4).
struct Held {
  float lock = 0.0f, lockLife = 0.0f, instability = 0.0f;
  float share = 0.0f; ///< of the correction
  glm::vec2 keptLock{0.0f};
  glm::vec4 keptLumas{0.0f};
};
Held holdHistory(const Inputs& inputs, const Settings& settings, const Reprojected& reprojected,
                 const glm::vec2& readPosition, const Neighborhood& neighborhood, bool isValid,
                 const glm::ivec2& pixel, const glm::ivec2& drawn);

/// What the dilated sample belongs to.
struct Geometry {
  float object = 0.0f, objectClass = 0.0f;
  glm::vec3 normal{0.0f};
  glm::vec2 motion{0.0f};
};
Geometry geometryOf(const Inputs& inputs, const Dilated& dilated, const glm::ivec2& drawn);
/// How that agrees with what history was of, the best of four texels (catalogue 12.2 to 12.5, 13.7).
struct GeometryMatch {
  float object = 0.0f; ///< stored with history
  bool isSameObject = true, isSameClass = true;
  float normalAgreement = 1.0f; ///< cosine
  float velocityChange = 0.0f;  ///< px a frame
};
GeometryMatch compareGeometry(const Inputs& inputs, const Settings& settings, const Geometry& own,
                              const glm::vec2& readPosition);
/// How far the motion around a render texel parts (catalogue 12.7).
float motionDivergence(const Inputs& inputs, const WeightSettings& settings, const glm::ivec2& drawn);

enum class RejectReason : int {
  Kept,
  NoHistory,
  NoPrevious,
  OffScreen,
  Depth,
  Speed,
  Object,
  Class,
  Normal,
  Velocity
};
/// Whether the history belongs to this surface (catalogue §5, §12).
struct Validated {
  float depthExpected = 0.0f; ///< m
  float historyDepth = 0.0f;  ///< m
  float depthMismatch = 0.0f; ///< relative to depthExpected
  float depthAllowed = 0.0f;  ///< the largest mismatch that is kept
  RejectReason reason = RejectReason::Kept;
  float invalid = 0.0f; ///< least α
};
Validated validateHistory(const Inputs& inputs, const ValidateSettings& settings, const Dilated& dilated,
                          const Reprojected& reprojected, const glm::vec2& readPosition,
                          const glm::ivec2& pixel, const GeometryMatch& geometry = {});

/// What the terms of α look at: luma of scene-linear colors, luma of box space, and motion.
struct Seen {
  bool hasHistory = false;
  float lumaCurrent = 0.0f, lumaHistory = 0.0f; ///< filtered; rectified
  float boxCurrent = 0.0f, boxHistoryRaw = 0.0f, boxHistory = 0.0f, boxLow = 0.0f, boxHigh = 0.0f;
  float compressedCurrent = 0.0f, compressedHistory = 0.0f; ///< luma of c/(1 + c)
  glm::vec3 contrast{0.0f}; ///< range of the nine samples over the filtered color
  float depth = 0.0f;       ///< device
  float speed = 0.0f;       ///< px a frame
  glm::vec2 motion{0.0f};   ///< px
  glm::vec2 motionUv{0.0f};
  glm::vec2 mask{0.0f};        ///< reactive, responsive
  float relax = 0.0f;          ///< the larger of them where it relaxes the box
  float velocityChange = 0.0f; ///< px a frame
  float divergence = 0.0f;     ///< 0 to 1
  float confidence = 1.0f;     ///< κ
  glm::vec2 jitterPx{0.0f};
  double stepSeconds = 1.0 / 60.0;
};
/// Bevy's confidence after a frame (catalogue §16).
float confidenceAfter(float before, const glm::vec2& motionPx);
/// Terms of α, the weight of the current frame (catalogue §13).
struct Weights {
  float base = 0.0f;
  float floor = 0.0f;
  float lumaFlicker = 1.0f, nearClamp = 1.0f, historyContrast = 1.0f, relax = 1.0f, sampleDistance = 1.0f;
  float motion = 0.0f, velocityChange = 0.0f, divergence = 0.0f;
  float byFrameRate = 0.0f; ///< all of that, for the time the frame took
  float mask = 0.0f;
  float invalid = 0.0f;
  float alpha = 0.0f;       ///< composed
  glm::vec3 channels{0.0f}; ///< α of red, green and blue
};
Weights weigh(const WeightSettings& settings, float historyLength, float invalid, const Seen& seen = {});

/// The output (catalogue §14–16).
struct Blended {
  float toneWeightCurrent = 1.0f;
  float toneWeightHistory = 1.0f;
  float factor = 1.0f;        ///< share of the current color
  float historyLength = 1.0f; ///< N after this frame
  glm::vec3 resolved{0.0f};
};
/// What is mixed.
struct Mix {
  glm::vec3 current{0.0f};
  glm::vec3 history{0.0f};
  float alpha = 1.0f;
  glm::vec3 channels{1.0f}; ///< α of each channel, where the source has three
  float historyLength = 0.0f;
  float confidence = 1.0f; ///< κ
  glm::vec2 motion{0.0f};  ///< px
  glm::ivec2 pixel{0};     ///< it and the frame's number choose the dither
  int frame = 0;
};
Blended blend(const Settings& settings, const Mix& mix);

/// The middle of nine resolved colors sharpened (catalogue §18), `current`: this frame's; 3×3, row-major.
glm::vec3 sharpen(const OutputSettings& settings, const std::array<glm::vec3, 9>& resolved,
                  const std::array<glm::vec3, 9>& current);
/// What is shown of a pixel of `inputs.resolved`, which may be larger than the inputs (§18, 14.4).
struct Shown {
  float detail = 0.0f; ///< luma that sharpening adds
  float trust = 1.0f;  ///< share of the resolved color
  glm::vec3 color{0.0f};
};
Shown showOutput(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel);

} // namespace taa::reference
