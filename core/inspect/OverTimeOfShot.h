// What is measured over the last frames up to the one on show: flicker of what is shown, and parts of the
// error. Rows of it are isOverTime(). Always of exact frames. They are kept, and what the next frame needs of
// them.
#pragma once

#include "core/base/Progress.h"
#include "core/inspect/FrameWindow.h"
#include "core/measure/RowsOverTime.h"
#include "core/settings/Lanes.h"
#include "core/taa/Intermediates.h"

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace taa::gl {
struct Driver;
}

namespace taa {

class References;
class ShotPlayer;

/// What is measured of which frame of a lane.
struct OverTimeNeed {
  std::vector<OverTime> kinds;
  int lane = 0, last = 0;
  int samples = 0; ///< of the references, 0: none; parts of the error need them

  bool has(OverTime kind) const;
};

class OverTimeOfShot {
 public:
  /// `references`: those of all frames, which it uses and adds to.
  OverTimeOfShot(ShotPlayer& player, References& references, const gl::Driver& driver);

  /// Against references of so many samples of all frames, 0: without, so that of flicker only the deviation
  /// is known. Frames of all kinds are made once. Cancelled: goes on from there when it is asked again.
  /// Throws Error.
  void refine(const std::vector<OverTime>& kinds, int samples, const Progress& progress = {}, int lane = 0);
  std::optional<int> samples(OverTime kind, int lane = 0) const; ///< nothing: it is not measured
  /// Frames that it is taken over, kMinFlickerFrames to kMaxFlickerFrames; kFlickerFrames unless told
  /// otherwise.
  void setFrames(int frames);
  int frames() const { return frames_; }

  // What other parts make of it
  /// Rows of the frame on show; null where the row is not made.
  RowsOverTime* rows(IntermediateId id, int lane);
  /// Of the frame on show. Expects samples().
  const RowImages& maps(OverTime kind, int lane) const;
  /// Makes what is missing of a window but what the last frame resolves to; references are drawn into
  /// `drawn`.
  void fill(FrameWindow& window, References& drawn, const OverTimeNeed& need, const Progress& progress);
  /// The rows that are taken of the last frame.
  std::vector<IntermediateId> rowsOfLast(const OverTimeNeed& need) const;
  /// Of a window that is filled. `resolve`: those rows.
  std::map<OverTime, RowImages> finish(FrameWindow& window, const OverTimeNeed& need,
                                       const RowImages& resolve, const Progress& progress) const;
  /// The scene is another one, or is drawn by other shaders.
  void forget();

 private:
  /// Of one lane.
  struct Measured {
    OverTimeKey key;
    FrameWindow window;
    std::map<OverTime, RowsOverTime> rows;
  };
  OverTimeKey keyOf(int lane) const;
  Measured& measuredOf(int lane);
  int firstFrame(int last) const;
  bool lacksErrors(const FrameWindow& window, const OverTimeNeed& need, int frame) const;
  std::vector<IntermediateId> missingRows(const FrameWindow& window, const OverTimeNeed& need,
                                          int frame) const;
  /// What another lane's window has of a frame with these references; null: none has it.
  const FlickerFrame* madeOfOtherLane(const FrameWindow& window, const FrameRequest& truth, int frame) const;
  void fillSteps(FrameWindow& window, const OverTimeNeed& need, int frame);
  void fillReference(FrameWindow& window, References& drawn, const OverTimeNeed& need, int frame,
                     const Progress& progress);
  void addResolve(FrameWindow& window, const OverTimeNeed& need, int frame, const RowImages& resolve) const;
  RowImages resolveOf(int frame, const std::vector<IntermediateId>& ids, TraceCursor& cursor,
                      const Progress& progress, int lane);
  RowImages resolveNow(const std::vector<IntermediateId>& ids, TraceCursor& cursor, const Progress& progress,
                       int lane);
  RowImages partsOf(const FrameWindow& window, const OverTimeNeed& need, const RowImages& resolve,
                    const Progress& progress) const;

  ShotPlayer& player_;
  References& references_;
  const gl::Driver& driver_;
  std::array<Measured, kMaxLanes> lanes_;
  int frames_ = kFlickerFrames;
};

} // namespace taa
