#include "core/replay/Checkpoints.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace taa {

namespace {

// More are never in use at once between two frames of a playing lane.
constexpr std::size_t kMaxFree = 4;

// Rank by which frames stay: the higher, the longer.
int rankOf(int frame, const Spread& spread) {
  if (std::ranges::find(spread.ends, frame) != spread.ends.end()) return 2;
  return frame % spread.stride == 0 ? 1 : 0;
}

} // namespace

std::shared_ptr<History> HistoryPool::take() {
  auto history = std::make_unique<History>();
  if (!free_->empty()) {
    history = std::move(free_->back());
    free_->pop_back();
  }
  const std::weak_ptr<Free> pool = free_;
  return {history.release(), [pool](History* used) {
            std::unique_ptr<History> owned(used);
            const std::shared_ptr<Free> free = pool.lock();
            if (free && free->size() < kMaxFree) free->push_back(std::move(owned));
          }};
}

void HistoryPool::clear() {
  free_->clear();
}

Spread spreadOver(const Shot& shot, std::size_t capacity, int playhead) {
  Spread spread{.playhead = playhead, .ends = {}};
  // More cuts than that would leave too little for the playhead, and one frame is all it takes to be there.
  if (shot.cuts.size() <= capacity / 4) spread.ends = shot.cuts;
  for (const int end : {0, shot.frames - 2, shot.frames - 1}) spread.ends.push_back(end);
  const auto anchors = std::clamp<std::size_t>(capacity / 2, 1, static_cast<std::size_t>(shot.frames));
  const int count = static_cast<int>(anchors);
  spread.stride = (shot.frames + count - 1) / count;
  return spread;
}

std::optional<int> frameToGiveUp(std::span<const int> frames, const Spread& spread) {
  // The worst of all: of the lowest rank, and the farthest of those.
  std::optional<std::pair<int, int>> worst; // − rank, distance
  std::optional<int> found;
  for (const int frame : frames) {
    if (frame == spread.playhead || frame == spread.playhead - 1) continue;
    const std::pair candidate(-rankOf(frame, spread), std::abs(frame - spread.playhead));
    if (worst && candidate <= *worst) continue;
    worst = candidate;
    found = frame;
  }
  return found;
}

void Checkpoints::keep(int frame, HistoryHandle history) {
  kept_[frame] = std::move(history);
}

void Checkpoints::keepAll(const Checkpoints& others) {
  for (const auto& [frame, history] : others.kept_) kept_[frame] = history;
}

void Checkpoints::trim(std::size_t budget, int playhead, const Shot& shot) {
  std::size_t used = bytes();
  if (used <= budget) return;
  const Spread spread = spreadOver(shot, budget * kept_.size() / used, playhead);
  std::vector<int> frames;
  frames.reserve(kept_.size());
  for (const auto& [frame, history] : kept_) frames.push_back(frame);
  while (used > budget) {
    const std::optional<int> frame = frameToGiveUp(frames, spread);
    if (!frame) return;
    used -= kept_.at(*frame)->bytes();
    kept_.erase(*frame);
    std::erase(frames, *frame);
  }
}

HistoryHandle Checkpoints::at(int frame) const {
  const auto found = kept_.find(frame);
  return found == kept_.end() ? nullptr : found->second;
}

std::vector<int> Checkpoints::frames() const {
  std::vector<int> frames;
  frames.reserve(kept_.size());
  for (const auto& [frame, history] : kept_) frames.push_back(frame);
  return frames;
}

std::size_t Checkpoints::bytes() const {
  std::size_t sum = 0;
  for (const auto& [frame, history] : kept_) sum += history->bytes();
  return sum;
}

} // namespace taa
