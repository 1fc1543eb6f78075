#include "core/replay/KeptInputs.h"

#include "core/gl/PassTimer.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace taa {

void KeptInputs::setBudget(std::size_t bytes) {
  budget_ = bytes;
  trim();
}

// A frame whose time is taken is drawn, as in a game.
InputsHandle KeptInputs::find(const std::shared_ptr<FrameSource>& source, const FrameRequest& request,
                              int frame) {
  if (gl::PassTimer::isTiming()) return nullptr;
  const auto found = std::ranges::find_if(frames_, [&](const Frame& kept) {
    return kept.number == frame && kept.request == request && kept.source.lock() == source;
  });
  if (found == frames_.end()) return nullptr;
  frames_.splice(frames_.begin(), frames_, found);
  return frames_.front().inputs;
}

void KeptInputs::keep(const std::shared_ptr<FrameSource>& source, FrameRequest request, int frame,
                      const InputsHandle& drawn, std::size_t bytes) {
  assert(drawn->areDrawn);
  if (bytes > budget_) return;
  frames_.push_front({source, std::move(request), frame, drawn, bytes});
  trim();
}

InputsHandle KeptInputs::takeFree() {
  if (free_.use_count() == 1) return std::exchange(free_, nullptr);
  return std::make_shared<LazyInputs>();
}

void KeptInputs::clear() {
  frames_.clear();
  free_.reset();
}

void KeptInputs::trim() {
  std::erase_if(frames_, [](const Frame& kept) { return kept.source.expired(); });
  std::size_t sum = 0;
  for (const Frame& kept : frames_) sum += kept.bytes;
  for (; sum > budget_; frames_.pop_back()) {
    sum -= frames_.back().bytes;
    free_ = std::move(frames_.back().inputs);
  }
}

} // namespace taa
