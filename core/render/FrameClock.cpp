#include "core/render/FrameClock.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/render/FrameInputs.h"
#include "core/render/FrameRequest.h"
#include "core/render/Jitter.h"

#include <algorithm>
#include <cassert>

namespace taa {

double frameTime(const Scene& scene, int frame) {
  return frame / scene.shot.framesPerSecond;
}

bool isCut(const Scene& scene, int frame) {
  return frame == 0 || std::ranges::find(scene.shot.cuts, frame) != scene.shot.cuts.end();
}

void checkRestarts(std::span<const int> frames, int frameCount) {
  for (const int frame : frames)
    if (frame < 0 || frame >= frameCount)
      throw Error(
          say<"cannot restart the history at frame %1: the shot has frames 0 to %2">(frame, frameCount - 1));
}

bool startsHistory(const Scene& scene, std::span<const int> restarts, int frame) {
  return isCut(scene, frame) || std::ranges::find(restarts, frame) != restarts.end();
}

int previousFrame(const Scene& scene, int frame) {
  return isCut(scene, frame) ? frame : frame - 1;
}

FrameInfo frameInfo(const Scene& scene, const FrameRequest& request, int frame) {
  assert(frame >= 0);
  const JitterSettings& jitter = request.jitter;
  FrameInfo info;
  info.frame = frame;
  info.time = frameTime(scene, frame);
  info.stepSeconds = 1.0 / scene.shot.framesPerSecond;
  info.jitterIndex = jitterIndex(jitter, frame);
  if (jitter.sequence == JitterSequence::Perpendicular) info.jitterWay = jitterWay(scene, request, frame);
  info.jitterPx = request.jitterPx.value_or(jitterPx(jitter, frame, info.jitterWay));
  info.startsHistory = startsHistory(scene, request.restarts, frame);
  return info;
}

} // namespace taa
