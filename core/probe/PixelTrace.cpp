#include "core/probe/PixelTrace.h"

#include <algorithm>

namespace taa {

void PixelTrace::add(int frame, const TraceSample& sample) {
  samples_.insert_or_assign(frame, sample);
}

const TraceSample* PixelTrace::at(int frame) const {
  const auto found = samples_.find(frame);
  return found == samples_.end() ? nullptr : &found->second;
}

std::vector<int> missingFrames(const PixelTrace& trace, int first, int last) {
  std::vector<int> frames;
  for (int frame = first; frame <= last; ++frame)
    if (!trace.at(frame)) frames.push_back(frame);
  return frames;
}

std::vector<double> alphasUpTo(const PixelTrace& trace, int frame, int most) {
  std::vector<double> alphas;
  for (int at = frame; at >= 0 && static_cast<int>(alphas.size()) < most; --at) {
    const TraceSample* sample = trace.at(at);
    if (!sample) break;
    alphas.push_back(static_cast<double>(twin::at(sample->record, IntermediateId::alpha).x));
    if (alphas.back() >= 1.0) break;
  }
  std::ranges::reverse(alphas);
  return alphas;
}

bool isSamePlace(const Probe& a, const Probe& b) {
  return a.pixel == b.pixel && a.follow == b.follow && (a.follow == Follow::Screen || a.frame == b.frame);
}

} // namespace taa
