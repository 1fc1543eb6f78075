// Whether the brightness of the whole picture steps from one frame to the next, which history does not
// follow.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/motion/MotionTrials.h"

#include <cstddef>
#include <map>
#include <vector>

namespace taa::doctor {

/// A pair of frames: what has become of the light of the same places.
struct BrightnessPair {
  int frame = 0;           ///< the later one
  double stops = 0.0;      ///< log2 of the light over that of the frame before, the median of all places
  std::size_t squares = 0; ///< of the picture, with places enough …
  std::size_t even = 0;    ///< … and those whose own median is the same
  /// Medians of |luma − luma of the frame before|: as it is, and with the frame before brighter by `stops`.
  double given = 0.0, stepped = 0.0;

  /// Whether the picture has become brighter or darker by so much that one sees it.
  bool isChange() const;
  /// All of it by one factor: a light that changes leaves what it does not shine on.
  bool isEven() const;
};

/// Over all pairs of frames; those in which too few places can be followed are not among them.
struct BrightnessEvidence {
  std::vector<BrightnessPair> pairs;

  void add(const FrameNeighbors& frames);
  /// Changes of the whole picture. A light that flickers may look like one where it changes little: what is
  /// less than a change that is not even is none.
  std::vector<const BrightnessPair*> steps() const;
  /// log2 of the light by frame, against what it would be without the steps; empty: there are none.
  std::map<int, double> stepped() const;
};

/// The same frames without steps of brightness: as bright as those before the first one. `stepped`: see
/// BrightnessEvidence; a frame that is not in it is as bright as the one before.
FrameReader withBrightness(FrameReader read, std::map<int, double> stepped);

/// Adds what is wrong, right or not decided about brightness.
void tellBrightness(const BrightnessEvidence& evidence, const CaptureInfo& captureInfo, Diagnosis& out);

} // namespace taa::doctor
