// What other settings would have made of the last frames: a pixel's surface in them, and whole pictures.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"
#include "core/inspect/verdicts/EvidenceFrames.h"
#include "core/inspect/verdicts/PartlyResolved.h"
#include "core/verdict/pixel/Remedies.h"

#include <glm/vec2.hpp>

#include <map>
#include <memory>
#include <vector>

namespace taa {

/// Frames that are measured, the last of those that are tried.
inline constexpr int kMeasuredFrames = 4;

/// Frames `first` to `last`, on the history that the present settings left before them. All of it throws
/// Error, Cancelled.
class RemedyTrial {
 public:
  /// `evidence`, `progress`: stay as long as it does.
  RemedyTrial(ShotPlayer& player, EvidenceFrames& evidence, int last, int first, const Progress& progress);

  /// Looks at the surface that a pixel of the last frame shows.
  void follow(const glm::ivec2& pixel);
  /// Of that surface; expects follow(). Resolves no more than it takes.
  RemedyMeasure ofPixel(const Settings& settings);
  RemedyMeasure ofPicture(const Settings& settings);

 private:
  /// What a frame is held against, whatever the settings.
  struct Truth {
    Image shown;             ///< the reference as a screen is sent it
    Image historyPositionPx; ///< where each pixel's own motion vector points, far off where it has none
    double gradients = 0.0;  ///< gradientSum() of the reference
  };

  HistoryHandle historyBefore();
  /// What the frame leaves, by the settings of `state`.
  HistoryHandle resolve(const ShotState& state, int frame, const HistoryHandle& previous);
  /// Of a frame that was resolved.
  const Truth& truth(int frame);

  ShotPlayer& player_;
  EvidenceFrames& evidence_;
  int last_, first_;
  const Progress& progress_;
  HistoryHandle before_;
  std::vector<SurfaceMoment> moments_;    // latest first
  std::unique_ptr<PartlyResolved> parts_; // of the moments
  std::map<int, InputsHandle> inputs_;    // of whole pictures, drawn once for all
  std::map<int, Truth> truths_;
};

} // namespace taa
