#include "app/views/timeline/PlaybackRate.h"

#include <cstddef>

namespace taa::app {

namespace {
constexpr double kWindow = 1.0; ///< seconds
}

void PlaybackRate::note(int frame, double seconds) {
  if (!shown_.empty() && shown_.back().first == frame) return;
  shown_.emplace_back(frame, seconds);
  while (shown_.size() > 2 && shown_.front().second < seconds - kWindow) shown_.pop_front();
}

std::optional<double> PlaybackRate::value() const {
  if (shown_.size() < 2) return {};
  const double took = shown_.back().second - shown_.front().second;
  if (took <= 0.0) return {};
  return static_cast<double>(shown_.size() - 1) / took;
}

} // namespace taa::app
