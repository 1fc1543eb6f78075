// Any frames of a lane as the CPU twin reads them, exactly: a few pixels of many frames cost little.
#pragma once

#include "core/base/Progress.h"
#include "core/gl/Rect.h"
#include "core/probe/PartlyDrawn.h"
#include "core/replay/ShotPlayer.h"
#include "core/taa/twin/Twin.h"

#include <optional>
#include <vector>

namespace taa {

/// One frame at a time; what is on show stays. Its history is replayed where it is not kept, and its inputs
/// are drawn where they are read. Needs the current context for its whole life.
class TwinFrames {
 public:
  TwinFrames(ShotPlayer& player, int lane, const Progress& progress);

  /// Frame `frame`, of which `parts` of the picture are looked at first; good until another is asked for.
  /// Cheapest in falling order. Throws Error, Cancelled.
  const twin::Inputs& at(int frame, const std::vector<gl::Rect>& parts);
  /// Of the lane alone.
  const ShotState& state() const { return state_; }
  const Settings& settings() const { return state_.lanes[0]; }

 private:
  HistoryHandle leftBy(int frame);

  ShotPlayer& player_;
  ShotState state_;
  int lane_;
  const Progress& progress_;
  Checkpoints kept_;
  PartlyDrawn drawn_;
  HistoryHandle previous_; // what the frame was resolved on; null: it starts history
  std::optional<int> frame_;
  twin::Inputs inputs_; // refers to the two before it
};

} // namespace taa
