// Flicker of what is shown up to the frame on show (core/measure/Flicker.h), whose rows are isOverTime().
// Always of exact frames. It is kept, and what the next frame needs of it.
#pragma once

#include "core/base/Progress.h"
#include "core/measure/FlickerRows.h"
#include "core/settings/Lanes.h"
#include "core/taa/rows/Intermediates.h"

#include <array>
#include <optional>

namespace taa::gl {
struct Driver;
}

namespace taa {

class References;
class ShotPlayer;

/// Of which frame of a lane.
struct FlickerNeed {
  int lane = 0, last = 0; ///< the frame whose flicker it is
  int samples = 0;        ///< of the reference, 0: none
};

class FlickerOfShot {
 public:
  /// `references`: those of all frames, which it uses and adds to.
  FlickerOfShot(ShotPlayer& player, References& references, const gl::Driver& driver);

  /// Against references of so many samples of all its frames, 0: without, so that only the deviation is
  /// known. Cancelled: goes on from there when it is asked again. Throws Error.
  void refine(int samples, const Progress& progress = {}, int lane = 0);
  std::optional<int> samples(int lane = 0) const; ///< nothing: there is none
  /// kMinFlickerFrames to kMaxFlickerFrames; kFlickerFrames unless told otherwise.
  void setFrames(int frames);
  int frames() const { return frames_; }

  // What other parts make of it
  /// Rows of the frame on show; null where the row is not made.
  FlickerRows* rows(IntermediateId id, int lane);
  /// Of the frame on show. Expects samples().
  const FlickerMaps& maps(int lane) const;
  /// Makes what is missing of a window but what the last frame shows; references are drawn into `drawn`.
  void fill(FlickerWindow& window, References& drawn, const FlickerNeed& need, const Progress& progress);
  /// Of frame `last`, of whose window all is made.
  FlickerMaps mapsOf(const FlickerWindow& window, int last, const Progress& progress) const;
  /// The scene is another one, or is drawn by other shaders.
  void forget();

 private:
  FlickerKey keyOf(int lane) const;
  int firstFrame(int last) const;
  Image shownColorsOf(int frame, TraceCursor& cursor, const Progress& progress, int lane);
  Image shownNow(TraceCursor& cursor, const Progress& progress, int lane);

  ShotPlayer& player_;
  References& references_;
  const gl::Driver& driver_;
  std::array<FlickerRows, kMaxLanes> rows_; // one a lane
  int frames_ = kFlickerFrames;
};

} // namespace taa
