#include "core/render/faults/JitterFaults.h"

#include <algorithm>

namespace taa {

namespace {

glm::vec2 misreported(JitterFault fault, const glm::vec2& j) {
  switch (fault) {
  case JitterFault::NegatedX:
    return {-j.x, j.y};
  case JitterFault::NegatedY:
    return {j.x, -j.y};
  case JitterFault::Negated:
    return -j;
  case JitterFault::Swapped:
    return {j.y, j.x};
  case JitterFault::Unreported:
    return glm::vec2(0.0f);
  case JitterFault::None:
  case JitterFault::Late:
  case JitterFault::Early:
    break; // right, of this frame or of another
  }
  return j;
}

} // namespace

bool isFaultyFrame(const FaultSettings& faults, int frame) {
  return frame >= faults.firstFrame && frame <= faults.lastFrame;
}

FaultyJitter faultyJitter(const FaultSettings& faults, const JitterOfFrame& given, int frame, bool isDrawn) {
  if (!isFaultyFrame(faults, frame)) return {given(frame), given(frame)};
  const auto drawn = [&](int number) {
    if (!isDrawn) return given(number);
    const int place = faults.jitterPeriod > 0 ? number % faults.jitterPeriod : number;
    return given(place) + glm::vec2(faults.jitterMeanX, faults.jitterMeanY);
  };
  int told = frame;
  if (faults.jitter == JitterFault::Late) told = std::max(frame - 1, 0);
  if (faults.jitter == JitterFault::Early) told = frame + 1;
  return {(isDrawn ? faults.jitterApplied : 1.0f) * drawn(frame),
          faults.jitterReported * misreported(faults.jitter, drawn(told))};
}

} // namespace taa
