// Whether motion and depth lie on the surfaces that they are of: at the rims of objects, read at another
// texel or at a lower resolution, they are those of what is beside.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/frames/SharedTexels.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace taa::doctor {

/// Which texel is read for a pixel: the middle one of a square of `side`, less `shift`.
struct RimReading {
  glm::ivec2 shift{0};
  int side = 1;

  glm::ivec2 texel(const glm::ivec2& pixel) const { return pixel / side * side + side / 2 - shift; }
};
inline constexpr std::size_t kRimReadings = 12;
/// Beside by a texel, in eight directions, and coarsely.
const std::array<RimReading, kRimReadings>& rimReadings();

enum class RimVerdict : std::uint8_t {
  Right,
  TooFew,
  Shifted,    ///< read beside
  Coarse,     ///< several pixels have one value
  Unjittered, ///< where jitter moved the rims outward
  Unclear,
};

/// Pixels at the rims of objects, where a plane differs between the two sides.
struct RimCounts {
  std::size_t pixels = 0;  ///< all of them
  std::size_t foreign = 0; ///< those with the value of what is beside
  /// By rimReadings(): those that would have it, and of these those that have.
  std::array<std::size_t, kRimReadings> expected{}, met{};
  std::size_t outward = 0; ///< foreign ones whose rim the frame's jitter moves outward
  double unjittered = 0.0; ///< foreign ones that there would be without that jitter, in the mean

  /// The reading that explains nearly all that is foreign, and expects little else; null: none does.
  const RimReading* reading() const;
  RimVerdict verdict() const;
};

/// Over all frames. Rims rest on object numbers: without them none are counted, and texels alone say what is
/// coarse.
struct RimEvidence {
  RimCounts motion, depth;
  SharedTexels motionTexels, depthTexels, lightTexels;

  void add(const DoctorFrame& frame);
  /// px: the side of squares that have one value; nothing where the picture itself is made of these.
  std::optional<int> coarseDepth() const;
  std::optional<int> coarseMotion() const;
};

/// Adds what is wrong or right at rims; `isMotionRight`: no finding tells of motion, which would show here
/// too.
void tellRims(const RimEvidence& evidence, bool isMotionRight, Diagnosis& out);

} // namespace taa::doctor
