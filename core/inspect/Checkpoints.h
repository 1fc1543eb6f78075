// Kept histories of a lane: what lets it go back in time without starting from frame 0.
#pragma once

#include "core/taa/TaaPass.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace taa {

/// A history that nobody writes any more. Owned by checkpoints and by the frames on show, whichever lets go
/// last; then its textures go back to the pool they came from.
using HistoryHandle = std::shared_ptr<const History>;

/// Histories whose textures are used again: a frame each 10 ms would otherwise ask the driver for them anew.
class HistoryPool {
 public:
  /// A history to resolve into; its textures may be of any size, or none.
  std::shared_ptr<History> take();
  /// Frees what nobody uses.
  void clear();

 private:
  using Free = std::vector<std::unique_ptr<History>>;
  std::shared_ptr<Free> free_ = std::make_shared<Free>(); // handles that outlive the pool see it end
};

/// Which of `frames` (rising) to give up first: the farthest from `playhead` of those that are no multiple of
/// `stride`, then of all. The playhead and the frame before it stay. Nothing when none is left to give up.
std::optional<int> frameToGiveUp(std::span<const int> frames, int playhead, int stride);

/// Exact histories by frame, as many as a budget allows: half of them around the playhead, half spread over
/// the shot, so that a step back is cheap and a leap back replays a part of the shot only.
class Checkpoints {
 public:
  /// Keeps the history that frame `frame` left.
  void keep(int frame, HistoryHandle history);
  /// Gives up what `budget` bytes cannot hold, for a shot of `frameCount` frames.
  void trim(std::size_t budget, int playhead, int frameCount);
  /// Null when it is not kept.
  HistoryHandle at(int frame) const;
  void clear() { kept_.clear(); }
  std::size_t size() const { return kept_.size(); }
  std::size_t bytes() const;

 private:
  std::map<int, HistoryHandle> kept_;
};

} // namespace taa
