// Kept histories of a lane: what lets it go back in time without starting from frame 0.
#pragma once

#include "core/scene/Scene.h"
#include "core/taa/TaaPass.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace taa {

/// Of 1280 × 720 with the default settings it holds 48 histories.
inline constexpr std::size_t kDefaultCheckpointBudget = std::size_t(1) << 30;
/// What a program can be asked for, MiB.
inline constexpr int kMaxCheckpointMiB = 1 << 20;

/// A history that nobody writes any more. Owned by checkpoints and by the frames on show, whichever lets go
/// last; then its textures go back to the pool they came from.
using HistoryHandle = std::shared_ptr<const History>;

/// A frame of a lane that has been resolved, to look into. The references must outlive the look.
struct ResolvedFrame {
  const FrameInputs& inputs;
  HistoryHandle previous, current; ///< current: also what tells one frame from another
  const Settings& settings;
};

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

/// How the kept frames of a shot are spread.
struct Spread {
  int playhead = 0;
  int stride = 1;        ///< every so many frames one is kept over the whole shot
  std::vector<int> ends; ///< kept before all others: where history starts, and the last two of the shot
};

/// Ends and stride for a shot of which `capacity` frames can be kept: half of them near the playhead, half
/// over the shot.
Spread spreadOver(const Shot& shot, std::size_t capacity, int playhead);

/// Which of `frames` (rising) to give up first: the farthest from the playhead of those that are neither a
/// multiple of the stride nor an end, then of those that are no end, then of all. The playhead and the frame
/// before it stay. Nothing when none is left to give up.
std::optional<int> frameToGiveUp(std::span<const int> frames, const Spread& spread);

/// Exact histories by frame, as many as a budget allows: half of them around the playhead, half spread over
/// the shot, so that a step back is cheap and a leap back replays a part of the shot only.
class Checkpoints {
 public:
  /// Keeps the history that frame `frame` left.
  void keep(int frame, HistoryHandle history);
  /// And all that `others` hold.
  void keepAll(const Checkpoints& others);
  /// Gives up what `budget` bytes cannot hold.
  void trim(std::size_t budget, int playhead, const Shot& shot);
  /// Null when it is not kept.
  HistoryHandle at(int frame) const;
  void clear() { kept_.clear(); }
  std::vector<int> frames() const; ///< rising
  /// Gives up frame `frame` and all after it.
  void dropFrom(int frame) { kept_.erase(kept_.lower_bound(frame), kept_.end()); }
  std::size_t size() const { return kept_.size(); }
  std::size_t bytes() const;

 private:
  std::map<int, HistoryHandle> kept_;
};

} // namespace taa
