// Stages 5 to 7 of the resolve on the CPU: the box around this frame's colors, whether history belongs to the
// surface at all, and history brought into the box.
#pragma once

#include "core/taa/twin/SampleStages.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace taa::twin {

/// A color that the box is made from.
struct NeighborhoodSample {
  glm::vec3 color{0.0f};    ///< scene-linear
  std::size_t distance = 0; ///< steps from the center along the axes that it weighs as, 0 to 2
};
/// What it counts for mean and deviation (manual 10.7).
float momentWeight(const Settings& settings, const NeighborhoodSample& member);
/// The colors around the pixel and the box that bounds them, box space (manual §8–10).
struct Neighborhood {
  glm::vec3 mean{0.0f};
  glm::vec3 deviation{0.0f};
  glm::vec3 min{0.0f};
  glm::vec3 max{0.0f};
  float gamma = 0.0f; ///< the one used
  glm::vec3 boxMin{0.0f};
  glm::vec3 boxMax{0.0f};
  std::array<glm::vec3, 9> samples{};      ///< in box space, row-major
  std::array<glm::vec3, 9> colors{};       ///< the same, scene-linear
  std::vector<NeighborhoodSample> members; ///< of the shape, in the order they are summed
  float tapReach = 0.0f;                   ///< how far taps that vary lie from the center along both axes, px
};
/// What the box may depend on besides this frame's colors.
struct NeighborhoodInputs {
  glm::vec3 history{0.0f}; ///< scene-linear, as it was read
  float speed = 0.0f;      ///< px a frame
  float relax = 0.0f;      ///< the larger mask
  float depth = 0.0f;      ///< view depth of whose motion it is, m; 0: sky
  glm::vec2 motion{0.0f};  ///< px
};
Neighborhood measureNeighborhood(const Inputs& inputs, const Settings& settings,
                                 const glm::vec3& currentFiltered, const glm::ivec2& pixel,
                                 const NeighborhoodInputs& given = {});

/// A point moved into a box, box space, how far on its way (0 kept, 1 all the way), and which part of that is
/// applied.
struct Rectified {
  glm::vec3 value{0.0f};
  float amount = 0.0f;
  float strength = 1.0f;
  bool moved = false; ///< it was outside
};
/// Of the methods that need no more than the box (11.1 to 11.3).
Rectified clip(RectifyMethod method, const glm::vec3& value, const glm::vec3& target, const glm::vec3& boxMin,
               const glm::vec3& boxMax);
/// What a method moves history towards, box space (manual §11); nothing where it has no such point.
std::optional<glm::vec3> rectifyTarget(RectifyMethod method, const glm::vec3& currentFiltered,
                                       const Neighborhood& neighborhood);
/// Directions across which a method measures slabs around the samples, in box space (manual 9.7, 10.12);
/// none where it has no slabs.
std::vector<glm::vec3> slabDirections(RectifyMethod method, ColorSpace space);
/// Number of the sample that is nearest to a color of box space (manual 11.8).
std::size_t nearestSample(const glm::vec3& h, const Neighborhood& neighborhood);
/// What rectification may depend on besides colors.
struct RectifyInputs {
  float speed = 0.0f;      ///< px a frame
  float protection = 0.0f; ///< share of the correction that is taken back
  bool isFlicker = false;  ///< its depth differs, and it is the same (13.9)
};
/// Where the method moves history with all of its correction, scene-linear, and how far on its way.
Rectified rectifiedFully(const Settings& settings, const glm::vec3& historyRaw,
                         const glm::vec3& currentFiltered, const Neighborhood& neighborhood);
/// History pulled into the box, scene-linear (manual §11).
Rectified rectifyHistory(const Inputs& inputs, const Settings& settings, const glm::vec3& historyRaw,
                         const glm::vec3& currentFiltered, const Neighborhood& neighborhood,
                         const RectifyInputs& applied = {});
/// N of history after it was rectified (manual 11.7).
float lengthKept(const Settings& settings, float historyLength, const Rectified& clipped, float protection);

/// What of the correction is taken back (manual 17.3, 17.4).
struct LockState {
  float lock = 0.0f, lockLife = 0.0f, instability = 0.0f;
  float protection = 0.0f; ///< of the correction
  glm::vec2 keptLock{0.0f};
  glm::vec4 keptLumas{0.0f};
  // What decided it
  float luma = 0.0f;           ///< mean of 3×3
  glm::vec2 storedLock{0.0f};  ///< life, luma
  bool isThin = false;         ///< a ridge of luma
  bool isChanged = false;      ///< luma is another than when it was locked
  glm::vec4 storedLumas{0.0f}; ///< of L/(1 + L) 255ths, latest first
};
LockState holdHistory(const Inputs& inputs, const Settings& settings, const Reprojection& reprojected,
                      const glm::vec2& readPosition, const Neighborhood& neighborhood, bool isValid,
                      const glm::ivec2& pixel, const glm::ivec2& drawn);

/// What the dilated sample belongs to.
struct Geometry {
  float object = 0.0f, objectClass = 0.0f;
  glm::vec3 normal{0.0f};
  glm::vec2 motion{0.0f};
};
Geometry geometryOf(const Inputs& inputs, const DilatedMotion& dilated, const glm::ivec2& drawn);
/// How that agrees with what history was of, the best of nine texels (manual 12.2 to 12.5, 13.7).
struct GeometryMatch {
  float object = 0.0f; ///< stored with history
  bool isSameObject = true, isSameClass = true;
  float normalAgreement = 1.0f; ///< cosine
  float velocityChange = 0.0f;  ///< px a frame
  glm::vec3 normal{0.0f};       ///< the stored one that agrees best
  glm::vec2 motion{0.0f};       ///< px, likewise
};
GeometryMatch compareGeometry(const Inputs& inputs, const Settings& settings, const Geometry& own,
                              const glm::vec2& readPosition);
/// How far the motion around a render texel parts (manual 12.7).
struct Divergence {
  float least = 1.0f;   ///< part of the longer motion that the other goes along
  float fastest = 0.0f; ///< speed squared, px² a frame
  float value = 0.0f;   ///< 0 to 1
};
Divergence motionDivergence(const Inputs& inputs, const WeightSettings& settings, const glm::ivec2& drawn);

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
/// Whether the history belongs to this surface (manual §5, §12).
struct Validity {
  float depthExpected = 0.0f; ///< m
  float historyDepth = 0.0f;  ///< m
  float depthMismatch = 0.0f; ///< relative to depthExpected
  float depthAllowed = 0.0f;  ///< the largest mismatch that is kept
  RejectReason reason = RejectReason::Kept;
  float invalid = 0.0f;   ///< least α; where N decays, what is added to α
  bool isFrozen = false;  ///< outside as printed (D9): nothing of the current frame is taken
  bool isFlicker = false; ///< kept, though its depth differs (13.9)
};
/// N of history that may decay by what is rejected (Godot).
float lengthLeft(const ValidateSettings& settings, float historyLength, const Validity& validated);
Validity validateHistory(const Inputs& inputs, const ValidateSettings& settings, const DilatedMotion& dilated,
                         const Reprojection& reprojected, const glm::vec2& readPosition,
                         const glm::ivec2& pixel, const GeometryMatch& geometry = {});

} // namespace taa::twin
