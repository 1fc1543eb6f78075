// Which explanation each region's motion is told by: by depth and matrices where these say more than pixels
// can, by pixels elsewhere, and the most by the fewest.
#pragma once

#include "core/doctor/frames/Regions.h"
#include "core/doctor/motion/MotionDecision.h"
#include "core/doctor/motion/MotionEvidence.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace taa::doctor {

/// What the pixels say of an explanation that rests on depth and matrices.
enum class PixelsSay : std::uint8_t { Nothing, Yes, No };

/// A region with what was measured and decided.
struct JudgedRegion {
  const Region* region = nullptr;
  const RegionEvidence* evidence = nullptr;
  MotionDecision decision;
  std::optional<std::size_t> trial; ///< of a wrong one: what it is told by; none: what was searched for
  ConsistencyDecision consistency;
  bool isChecked = false; ///< told by depth and matrices
  PixelsSay pixelsSay = PixelsSay::Nothing;
};

/// What silhouettes are evidence of.
struct SilhouettesSeen {
  bool ofTime = true;  ///< depth has the silhouettes of the pictures: they say when motion was made
  bool ofPlace = true; ///< so has motion: outlines say where regions lay
};

struct Judged {
  std::vector<JudgedRegion> regions; ///< that were measured, and whose motion is one
  /// An explanation that depth and matrices make, and pixels contradict: these may be wrong instead.
  std::optional<std::size_t> contradicted;
  std::vector<const Region*> contradictedIn; ///< regions that it would explain
  bool areMatricesTrusted = false;           ///< so much has the camera's motion that they are right
  /// One that was fitted, and that pixels neither confirm nor contradict: wrong depth looks the same.
  std::optional<std::size_t> unconfirmed;
  std::size_t unseen = 0; ///< regions that have no pixel well inside them
  bool isLate = false;    ///< isLateAtSilhouettes() of all that rests
};

/// An explanation that fits a region.
struct FittingTrial {
  std::size_t trial = 0;
  double pixels = 0.0; ///< of the region
  double gain = 0.0;   ///< what it leaves less there than what is given; below 0 where outlines or centroids
                       ///< tell it and pixels lose by it
};

/// Of the trials that fit: the one with the most pixels; of those with as many, the first that gains nearly
/// as much as any. Expects one at least.
std::size_t broadestTrial(const std::vector<FittingTrial>& fitting);

/// `regions`: those of the evidence, which live as long as what is returned.
Judged judgeMotion(const MotionEvidence& evidence, const std::vector<Region>& regions,
                   const SilhouettesSeen& silhouettes = {});

/// Explanations that fit a region as well; those that lead elsewhere, and those that lead to the same places.
std::vector<std::size_t> rivalsOf(const JudgedRegion& region);
bool isAlike(const JudgedRegion& region, std::size_t other);

} // namespace taa::doctor
