#include "core/verdict/parts/VerdictMaps.h"

#include "core/measure/Metrics.h"
#include "core/taa/twin/HistoryTaps.h"
#include "core/verdict/parts/FrameErrors.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace taa {

namespace {

constexpr float kKept = 0.0f, kNoHistory = 1.0f; // of rejectReason

bool differs(const float* a, const float* b, float tolerance) {
  float largest = 0.0f;
  for (int channel = 0; channel < 3; ++channel)
    largest = std::max(largest, std::fabs(a[channel] - b[channel]));
  return largest > tolerance;
}

void setVerdict(Image& map, int x, int y, bool isNeeded, bool isDone) {
  *map.at(x, y) = static_cast<float>(historyVerdict(isNeeded, isDone));
}

} // namespace

Image verdictMap(const TreatedHistory& history, float tolerance) {
  const Image raw = shownColors(history.raw), rectified = shownColors(history.rectified),
              reference = shownColors(history.reference);
  Image map(raw.width, raw.height, 1);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const float reason = *history.rejectReason.at(x, y);
      if (reason == kNoHistory) continue;
      const float* read = raw.at(x, y);
      setVerdict(map, x, y, differs(read, reference.at(x, y), tolerance),
                 reason != kKept || differs(read, rectified.at(x, y), tolerance));
    }
  return map;
}

Image geometryVerdict(const Image& rejectReason, const Image& historyPosition, const Image& steps) {
  Image map(rejectReason.width, rejectReason.height, 1);
  if (steps.empty()) return map;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const float reason = *rejectReason.at(x, y);
      if (reason == kNoHistory) continue;
      const float* position = historyPosition.at(x, y);
      const glm::vec2 read = twin::readPosition({position[0], position[1]}, {x, y});
      setVerdict(map, x, y, isOfOtherSurface(steps.at(x, y), read, {x, y}), reason != kKept);
    }
  return map;
}

} // namespace taa
