// What the render thread remembers of what it has delivered, and of work that it does piece by piece.
// Versions are those of the frame on show.
#pragma once

#include "core/measure/FigureCursor.h"
#include "core/measure/Metrics.h"
#include "core/measure/References.h"
#include "core/picture/ViewRequest.h"
#include "core/probe/PixelTrace.h"
#include "core/probe/ProbePin.h"

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace taa {

/// What a view was last delivered of: the same again is no news.
struct DeliveredView {
  ViewRequest request;
  std::uint64_t version = 0, asides = 0, reference = 0;
  bool operator==(const DeliveredView&) const = default;
};

/// Frames beside the one on show.
struct AsideWork {
  std::uint64_t version = 1;   ///< changes when others are at hand
  std::uint64_t stoppedAt = 0; ///< version for which `framesStopped` were cancelled or failed: not again
  std::vector<int> framesStopped;
};

/// The reference that is drawn while nothing else is to be done.
struct ReferenceWork {
  int goal = kReferenceSamples;
  std::uint64_t version = 1;   ///< changes with each picture of it that is to be shown
  std::uint64_t stoppedAt = 0; ///< version that it was cancelled or failed for
  bool isTold = false;         ///< somebody was told that it is under way
  bool isFlickerTold = false;  ///< the same of flicker
};

struct FigureWork {
  std::vector<Figure> wanted;
  std::pair<std::uint64_t, std::uint64_t> deliveredOf; ///< versions of frame and reference
  std::uint64_t subject = 0;                           ///< what follows is of this one
  std::set<int> known;                                 ///< frames whose figures are whole
  std::optional<std::pair<int, int>> frames;           ///< that are measured in a row
  int around = 0;                                      ///< the frame on show when that was decided
  FigureCursor cursor;
  bool isStopped = false; ///< cancelled or failed
  bool isTold = false;    ///< somebody was told that it is under way
};

/// What was delivered of the pins, and what is to be filled in.
struct TraceWork {
  bool wanted = false;
  std::uint64_t subject = 0;                             ///< what follows is of this one
  std::vector<std::pair<ProbePin, std::set<int>>> known; ///< frames
  std::optional<std::pair<int, int>> filling;            ///< first and last frame
  TraceCursor cursor;
};

} // namespace taa
