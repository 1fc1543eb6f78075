// The arithmetic of the timeline: frames on a ruler. Lengths are logical pixels.
#pragma once

#include "app/models/ChartMath.h"

#include <optional>
#include <utility>
#include <vector>

namespace taa::app {

/// A ruler of `frameCount` frames; the first that is shown lies at `left`, the last at `left + width`.
struct TimelineScale {
  int frameCount = 1;
  double left = 0.0;
  double width = 1.0;
  std::optional<Span> shown{}; ///< frames; none: the whole shot

  double position(int frame) const;
  /// The frame nearest to a position, 0 to frameCount − 1.
  int frameAt(double position) const;
  double spacing() const; ///< between neighboring frames
  Span frames() const;    ///< that are shown

  /// Frames between ticks that lie at least `spacing` apart: 1, 2 or 5 times a power of ten.
  int tickStep(double spacing) const;
  /// The multiples of `step` among the frames that are shown.
  std::vector<int> ticks(int step) const;
};

/// Runs of neighboring frames: {1, 2, 3, 7} gives (1, 3) and (7, 7). `frames` rise.
std::vector<std::pair<int, int>> runsOfFrames(const std::vector<int>& frames);

/// Moves one end of `range` to `frame`; the other end goes along where it would be passed.
std::pair<int, int> withEnd(std::pair<int, int> range, bool isLast, int frame);

} // namespace taa::app
