// What other settings would have made of the last frames: whole pictures, and a pixel's surface in them.
#pragma once

#include "core/base/Image.h"
#include "core/inspect/verdicts/EvidenceFrames.h"
#include "core/verdict/pixel/Remedies.h"

#include <map>
#include <vector>

namespace taa {

/// Frames that are measured, the last of those that are tried.
inline constexpr int kMeasuredFrames = 4;

class RemedyTrial {
 public:
  /// `moments`: where the surface was, latest first. `first`: frame that is tried first, on the history that
  /// the present settings left before it.
  RemedyTrial(ShotPlayer& player, EvidenceFrames& evidence, const std::vector<SurfaceMoment>& moments,
              int first);

  /// Throws Error, Cancelled.
  TriedRemedy measure(const Remedy& remedy, const Progress& progress);

 private:
  /// What a frame is held against, whatever the settings.
  struct Truth {
    Image shown;             ///< the reference as a screen is sent it
    Image historyPositionPx; ///< where each pixel's own motion vector points, far off where it has none
    double gradients = 0.0;  ///< gradientSum() of the reference
  };

  HistoryHandle historyBefore(const Progress& progress);
  /// What the frame leaves, by the settings of `state`.
  HistoryHandle resolve(const ShotState& state, int frame, const HistoryHandle& previous);
  /// Of a frame that was resolved.
  const Truth& truth(int frame);

  ShotPlayer& player_;
  EvidenceFrames& evidence_;
  const std::vector<SurfaceMoment>& moments_;
  int first_;
  HistoryHandle before_;
  std::map<int, InputsHandle> inputs_; // drawn once for all
  std::map<int, Truth> truths_;
};

} // namespace taa
