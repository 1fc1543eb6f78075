// Whether motion and depth lie on the surfaces that they are of: at the silhouettes of objects, read at
// another texel or at a lower resolution, they are those of what is beside.
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
struct SilhouetteReading {
  glm::ivec2 shift{0};
  int side = 1;

  glm::ivec2 texel(const glm::ivec2& pixel) const { return pixel / side * side + side / 2 - shift; }
};
inline constexpr std::size_t kSilhouetteReadings = 12;
/// Beside by a texel, in eight directions, and coarsely.
const std::array<SilhouetteReading, kSilhouetteReadings>& silhouetteReadings();

enum class SilhouetteVerdict : std::uint8_t {
  Right,
  TooFew,
  Shifted,    ///< read beside
  Coarse,     ///< several pixels have one value
  Unjittered, ///< where jitter moved the silhouettes outward
  Unclear,
};

/// Pixels at the silhouettes of objects, where a plane differs between the two sides.
struct SilhouetteCounts {
  std::size_t pixels = 0;  ///< all of them
  std::size_t foreign = 0; ///< those with the value of what is beside
  /// By silhouetteReadings(): those that would have it, and of these those that have.
  std::array<std::size_t, kSilhouetteReadings> expected{}, met{};
  std::size_t outward = 0; ///< foreign ones whose silhouette the frame's jitter moves outward
  double unjittered = 0.0; ///< foreign ones that there would be without that jitter, in the mean

  /// The reading that explains nearly all that is foreign, and expects little else; null: none does.
  const SilhouetteReading* reading() const;
  SilhouetteVerdict verdict() const;
};

/// Over all frames. Silhouettes rest on object numbers: without them none are counted, and texels alone say
/// what is coarse.
struct SilhouetteEvidence {
  SilhouetteCounts motion, depth;
  SharedTexels motionTexels, depthTexels, lightTexels;

  void add(const DoctorFrame& frame);
  /// px: the side of squares that have one value; nothing where the picture itself is made of these.
  std::optional<int> coarseDepth() const;
  std::optional<int> coarseMotion() const;
};

/// Adds what is wrong or right at silhouettes; `isMotionRight`: no finding tells of motion, which would show
/// here too.
void tellSilhouettes(const SilhouetteEvidence& evidence, bool isMotionRight, Diagnosis& out);

} // namespace taa::doctor
