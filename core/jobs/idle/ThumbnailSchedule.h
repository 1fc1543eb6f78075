// When the render thread may draw the next thumbnail: only where nothing else waits for it.
#pragma once

#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace taa {

/// Draws every stage's main row once a frame, one row an idle slice and each at most four times a second.
/// While frames come one by one, by hand, it waits until none has come for a moment: the first thumbnail of a
/// frame that was restored has to draw the scene.
class ThumbnailSchedule {
 public:
  using Clock = std::chrono::steady_clock;

  /// Texels of a thumbnail; 0: none are wanted.
  void want(const glm::ivec2& texels);
  const glm::ivec2& texels() const { return texels_; }

  /// When the next one is to be drawn, now that a frame of this version is on show; nothing while none is.
  /// `busyAt`, when it plays: when the next frame must be begun; nothing when the thumbnail would not be done
  /// by then.
  std::optional<Clock::time_point> dueAt(std::uint64_t version, Clock::time_point now,
                                         std::optional<Clock::time_point> busyAt = {});
  /// The row to draw when one is due.
  IntermediateId next() const { return rows_[place_]; }
  /// That row was drawn of the frame that dueAt() was last told of.
  void drawn(Clock::time_point began, Clock::time_point ended);

 private:
  glm::ivec2 texels_{0};
  std::vector<IntermediateId> rows_ = mainRows();
  std::size_t place_ = 0, left_ = 0;       // next row; how many have not the latest frame
  std::uint64_t latest_ = 0, drawnOf_ = 0; // versions: on show, and of the last thumbnail
  Clock::time_point latestSince_, lastBegan_;
  Clock::duration cost_{}; // of the last one that had to compute its values
};

} // namespace taa
