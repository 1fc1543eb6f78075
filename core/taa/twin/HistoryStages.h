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
template <typename Real>
struct NeighborhoodSampleOf {
  Vec3<Real> color{0.0f};   ///< scene-linear
  std::size_t distance = 0; ///< steps from the center along the axes that it weighs as, 0 to 2
};
using NeighborhoodSample = NeighborhoodSampleOf<float>;
/// The colors around the pixel and the box that bounds them, box space (manual §8–10).
template <typename Real>
struct NeighborhoodOf {
  Vec3<Real> mean{0.0f};
  Vec3<Real> deviation{0.0f};
  Vec3<Real> min{0.0f};
  Vec3<Real> max{0.0f};
  Real gamma = 0.0f; ///< the one used
  Vec3<Real> boxMin{0.0f};
  Vec3<Real> boxMax{0.0f};
  std::array<Vec3<Real>, 9> samples{};             ///< in box space, row-major
  std::array<Vec3<Real>, 9> colors{};              ///< the same, scene-linear
  std::vector<NeighborhoodSampleOf<Real>> members; ///< of the shape, in the order they are summed
  Real tapReach = 0.0f; ///< how far taps that vary lie from the center along both axes, px
};
using Neighborhood = NeighborhoodOf<float>;
/// What the box may depend on besides this frame's colors.
template <typename Real>
struct NeighborhoodInputsOf {
  Vec3<Real> history{0.0f}; ///< scene-linear, as it was read
  Real speed = 0.0f;        ///< px a frame
  Real relax = 0.0f;        ///< the larger mask
  Real depth = 0.0f;        ///< view depth of whose motion it is, m; 0: sky
  Vec2<Real> motion{0.0f};  ///< px
};
using NeighborhoodInputs = NeighborhoodInputsOf<float>;
template <typename Real = float>
NeighborhoodOf<Real> measureNeighborhood(const Inputs& inputs, const Settings& settings,
                                         const Vec3<Real>& currentFiltered, const glm::ivec2& pixel,
                                         const NeighborhoodInputsOf<Real>& given = {});

/// A point moved into a box, box space, how far on its way (0 kept, 1 all the way), and which part of that is
/// applied.
template <typename Real>
struct RectifiedOf {
  Vec3<Real> value{0.0f};
  Real amount = 0.0f;
  Real strength = 1.0f;
  bool moved = false;     ///< it was outside
  Vec3<Real> boxed{0.0f}; ///< of what moved: where to, box space, whatever the value's space is
};
using Rectified = RectifiedOf<float>;
/// Of the methods that need no more than the box (11.1 to 11.3).
template <typename Real = float>
RectifiedOf<Real> clip(RectifyMethod method, const Vec3<Real>& value, const Vec3<Real>& target,
                       const Vec3<Real>& boxMin, const Vec3<Real>& boxMax);
/// What a method moves history towards, box space (manual §11); nothing where it has no such point.
template <typename Real = float>
std::optional<Vec3<Real>> rectifyTarget(RectifyMethod method, const Vec3<Real>& currentFiltered,
                                        const NeighborhoodOf<Real>& neighborhood);
/// Directions across which a method measures slabs around the samples, in box space (manual 9.7, 10.12);
/// none where it has no slabs.
template <typename Real = float>
std::vector<Vec3<Real>> slabDirections(RectifyMethod method, ColorSpace space);
/// Number of the sample that is nearest to a color of box space (manual 11.8).
template <typename Real = float>
std::size_t nearestSample(const Vec3<Real>& h, const NeighborhoodOf<Real>& neighborhood);
/// What rectification may depend on besides colors.
template <typename Real>
struct RectifyInputsOf {
  Real speed = 0.0f;      ///< px a frame
  Real protection = 0.0f; ///< share of the correction that is taken back
  bool isFlicker = false; ///< its depth differs, and it is the same (13.9)
};
using RectifyInputs = RectifyInputsOf<float>;
/// Where the method moves history with all of its correction, scene-linear, and how far on its way.
template <typename Real = float>
RectifiedOf<Real> rectifiedFully(const Settings& settings, const Vec3<Real>& historyRaw,
                                 const Vec3<Real>& currentFiltered, const NeighborhoodOf<Real>& neighborhood);
/// History pulled into the box, scene-linear (manual §11).
template <typename Real = float>
RectifiedOf<Real> rectifyHistory(const Inputs& inputs, const Settings& settings, const Vec3<Real>& historyRaw,
                                 const Vec3<Real>& currentFiltered, const NeighborhoodOf<Real>& neighborhood,
                                 const RectifyInputsOf<Real>& applied = {});
/// N of history after it was rectified (manual 11.7).
template <typename Real = float>
Real lengthKept(const Settings& settings, Real historyLength, const RectifiedOf<Real>& clipped,
                Real protection);

/// What of the correction is taken back (manual 17.3, 17.4).
template <typename Real>
struct LockStateOf {
  Real lock = 0.0f, lockLife = 0.0f, instability = 0.0f;
  Real protection = 0.0f; ///< of the correction
  Vec2<Real> keptLock{0.0f};
  Vec4<Real> keptLumas{0.0f};
  // What decided it
  Real luma = 0.0f;             ///< mean of 3×3
  Vec2<Real> storedLock{0.0f};  ///< life, luma
  bool isThin = false;          ///< a ridge of luma
  bool isChanged = false;       ///< luma is another than when it was locked
  Vec4<Real> storedLumas{0.0f}; ///< of L/(1 + L) 255ths, latest first
};
using LockState = LockStateOf<float>;
template <typename Real = float>
LockStateOf<Real> holdHistory(const Inputs& inputs, const Settings& settings,
                              const ReprojectionOf<Real>& reprojected, const Vec2<Real>& readPosition,
                              const NeighborhoodOf<Real>& neighborhood, bool isValid, const glm::ivec2& pixel,
                              const glm::ivec2& drawn);

/// What the dilated sample belongs to.
template <typename Real>
struct GeometryOf {
  Real object = 0.0f, objectClass = 0.0f;
  Vec3<Real> normal{0.0f};
  Vec2<Real> motion{0.0f};
};
using Geometry = GeometryOf<float>;
template <typename Real = float>
GeometryOf<Real> geometryOf(const Inputs& inputs, const DilatedMotionOf<Real>& dilated,
                            const glm::ivec2& drawn);
/// How that agrees with what history was of, the best of nine texels (manual 12.2 to 12.5, 13.7).
template <typename Real>
struct GeometryMatchOf {
  Real object = 0.0f; ///< stored with history
  bool isSameObject = true, isSameClass = true;
  Real normalAgreement = 1.0f; ///< cosine
  Real velocityChange = 0.0f;  ///< px a frame
  Vec3<Real> normal{0.0f};     ///< the stored one that agrees best
  Vec2<Real> motion{0.0f};     ///< px, likewise
};
using GeometryMatch = GeometryMatchOf<float>;
template <typename Real = float>
GeometryMatchOf<Real> compareGeometry(const Inputs& inputs, const Settings& settings,
                                      const GeometryOf<Real>& own, const Vec2<Real>& readPosition);
/// How far the motion around a render texel parts (manual 12.7).
template <typename Real>
struct DivergenceOf {
  Real least = 1.0f;   ///< part of the longer motion that the other goes along
  Real fastest = 0.0f; ///< speed squared, px² a frame
  Real value = 0.0f;   ///< 0 to 1
};
using Divergence = DivergenceOf<float>;
template <typename Real = float>
DivergenceOf<Real> motionDivergence(const Inputs& inputs, const WeightSettings& settings,
                                    const glm::ivec2& drawn);

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
template <typename Real>
struct ValidityOf {
  Real depthExpected = 0.0f; ///< m
  Real historyDepth = 0.0f;  ///< m
  Real depthMismatch = 0.0f; ///< relative to depthExpected
  Real depthAllowed = 0.0f;  ///< the largest mismatch that is kept
  RejectReason reason = RejectReason::Kept;
  Real invalid = 0.0f;    ///< least α; where N decays, what is added to α
  bool isFrozen = false;  ///< outside as printed (D9): nothing of the current frame is taken
  bool isFlicker = false; ///< kept, though its depth differs (13.9)
};
using Validity = ValidityOf<float>;
/// N of history that may decay by what is rejected (Godot).
template <typename Real = float>
Real lengthLeft(const ValidateSettings& settings, Real historyLength, const ValidityOf<Real>& validated);
template <typename Real = float>
ValidityOf<Real> validateHistory(const Inputs& inputs, const ValidateSettings& settings,
                                 const DilatedMotionOf<Real>& dilated,
                                 const ReprojectionOf<Real>& reprojected, const Vec2<Real>& readPosition,
                                 const glm::ivec2& pixel, const GeometryMatchOf<Real>& geometry = {});

} // namespace taa::twin
