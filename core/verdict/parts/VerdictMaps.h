// Whether history was treated as it deserved, pixel by pixel. No GL.
#pragma once

#include "core/base/Image.h"

namespace taa {

/// Largest difference that is no error: eight steps of 8 bits of what is shown (sRGB, 0 to 1), as in verdicts
/// on pixels. Of two steps half of a textured picture that moves is off, by resampling and by the samples
/// that the reference itself is short of.
inline constexpr float kSeenDifference = 8.0f / 255.0f;

/// Values of both maps.
enum class HistoryVerdict : int {
  RightlyKept, ///< nothing was needed or done, or there was no history
  Removed,     ///< needed and done
  LetThrough,  ///< needed and not done
  ThrownAway,  ///< done without need
};
inline constexpr int kHistoryVerdicts = 4;

constexpr HistoryVerdict historyVerdict(bool isNeeded, bool isDone) {
  if (isNeeded) return isDone ? HistoryVerdict::Removed : HistoryVerdict::LetThrough;
  return isDone ? HistoryVerdict::ThrownAway : HistoryVerdict::RightlyKept;
}

/// Pictures of one size, colors scene-linear.
struct TreatedHistory {
  Image raw, rectified, reference; ///< three channels
  Image rejectReason;              ///< 0: kept, 1: there is no history
};

/// Removal of history was needed where it differs from the reference by more than `tolerance` as both are
/// shown, in red, green or blue, and done where it was rejected or rectified by more than that.
Image verdictMap(const TreatedHistory& history, float tolerance = kSeenDifference);

/// Rejection was needed where history is of something else (isOfOtherSurface()), and done where there is a
/// reason. `steps`: surfaceSteps() from the frame before; empty: history starts.
Image geometryVerdict(const Image& rejectReason, const Image& historyPosition, const Image& steps);

} // namespace taa
