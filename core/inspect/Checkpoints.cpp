#include "core/inspect/Checkpoints.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace taa {

namespace {

// More are never in use at once between two frames of a playing lane.
constexpr std::size_t kMostFree = 4;

// Distance of the anchors, of which half the budget is made.
int anchorStride(std::size_t capacity, int frameCount) {
  const int anchors = static_cast<int>(std::min<std::size_t>(capacity / 2, std::numeric_limits<int>::max()));
  return anchors > 0 ? std::max(1, (frameCount + anchors - 1) / anchors) : std::numeric_limits<int>::max();
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
            if (free && free->size() < kMostFree) free->push_back(std::move(owned));
          }};
}

void HistoryPool::clear() {
  free_->clear();
}

std::optional<int> frameToGiveUp(std::span<const int> frames, int playhead, int stride) {
  std::optional<int> farthest, farthestAnchor;
  const auto isFarther = [&](int frame, const std::optional<int>& than) {
    return !than || std::abs(frame - playhead) > std::abs(*than - playhead);
  };
  for (int frame : frames) {
    if (frame == playhead || frame == playhead - 1) continue;
    std::optional<int>& candidate = frame % stride == 0 ? farthestAnchor : farthest;
    if (isFarther(frame, candidate)) candidate = frame;
  }
  return farthest ? farthest : farthestAnchor;
}

void Checkpoints::keep(int frame, HistoryHandle history) {
  kept_[frame] = std::move(history);
}

void Checkpoints::trim(std::size_t budget, int playhead, int frameCount) {
  std::size_t used = bytes();
  if (used <= budget) return;
  const int stride = anchorStride(budget * kept_.size() / used, frameCount);
  std::vector<int> frames;
  frames.reserve(kept_.size());
  for (const auto& [frame, history] : kept_) frames.push_back(frame);
  while (used > budget) {
    const std::optional<int> frame = frameToGiveUp(frames, playhead, stride);
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

std::size_t Checkpoints::bytes() const {
  std::size_t sum = 0;
  for (const auto& [frame, history] : kept_) sum += history->bytes();
  return sum;
}

} // namespace taa
