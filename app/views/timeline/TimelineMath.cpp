#include "app/views/timeline/TimelineMath.h"

#include <algorithm>
#include <cmath>

namespace taa::app {

double TimelineScale::spacing() const {
  const Span span = frames();
  return span.length() > 0.0 ? width / span.length() : width;
}

Span TimelineScale::frames() const {
  return shown.value_or(Span{0.0, frameCount - 1.0});
}

double TimelineScale::position(int frame) const {
  return left + (frame - frames().low) * spacing();
}

int TimelineScale::frameAt(double position) const {
  if (frameCount <= 1 || width <= 0) return 0;
  const double frame = std::round(frames().low + (position - left) / spacing());
  return static_cast<int>(std::clamp(frame, 0.0, frameCount - 1.0));
}

int TimelineScale::tickStep(double least) const {
  int power = 1;
  for (;;) {
    for (const int digit : {1, 2, 5})
      if (digit * power * spacing() >= least || digit * power >= frameCount) return digit * power;
    power *= 10;
  }
}

std::vector<int> TimelineScale::ticks(int step) const {
  const int first = static_cast<int>(std::ceil(frames().low / step)) * step;
  const int last = static_cast<int>(std::floor(frames().high));
  std::vector<int> multiples;
  for (int frame = first; frame <= last; frame += step) multiples.push_back(frame);
  return multiples;
}

std::vector<std::pair<int, int>> runsOfFrames(const std::vector<int>& frames) {
  std::vector<std::pair<int, int>> runs;
  for (const int frame : frames) {
    if (!runs.empty() && runs.back().second + 1 == frame)
      runs.back().second = frame;
    else
      runs.emplace_back(frame, frame);
  }
  return runs;
}

std::pair<int, int> withEnd(std::pair<int, int> range, bool isLast, int frame) {
  if (isLast) return {std::min(range.first, frame), frame};
  return {frame, std::max(range.second, frame)};
}

} // namespace taa::app
