#include "core/inspect/TwinFrames.h"

#include <utility>

namespace taa {

TwinFrames::TwinFrames(ShotPlayer& player, int lane, const Progress& progress)
    : player_(player), state_(player.onlyLane(lane)), lane_(lane), progress_(progress) {}

const twin::Inputs& TwinFrames::at(int frame, const std::vector<gl::Rect>& parts) {
  if (frame_ == frame) return inputs_;
  frame_.reset();
  inputs_ = {};
  previous_ = startsHistory(state_, frame) ? nullptr : leftBy(frame - 1);
  inputs_ = drawn_.open(*state_.frames, state_.request(0), frame, previous_.get(), parts);
  frame_ = frame;
  return inputs_;
}

HistoryHandle TwinFrames::leftBy(int frame) {
  const HistoryHandle kept = player_.checkpoints()[static_cast<std::size_t>(lane_)].at(frame);
  if (kept) return kept;
  ShownFrame made = player_.makeInBackground(frame, kept_, progress_, lane_);
  HistoryHandle left = made.lanes[0].current;
  player_.maker().recycle(std::move(made));
  return left;
}

} // namespace taa
