#include "core/doctor/examination/CorrectedFrames.h"

#include <cstddef>
#include <utility>

namespace taa::doctor {

FrameReader withJitter(FrameReader read, JitterCorrector corrector, int first, bool isDepthJittered) {
  return [read = std::move(read), corrector = std::move(corrector), first, isDepthJittered](int frame) {
    DoctorFrame out = read(frame);
    const auto jitter = corrector(frame);
    if (!jitter || (frame > first && !corrector(frame - 1))) out.startsHistory = true;
    if (!jitter) return out;
    out.jitterPx = *jitter;
    if (isDepthJittered) out.depthJitterPx = *jitter;
    return out;
  };
}

FrameReader withDepth(FrameReader read, DepthRelation relation) {
  return [read = std::move(read), relation](int frame) {
    DoctorFrame out = read(frame);
    correctDepth(relation, out);
    return out;
  };
}

FrameReader withFlippedMatrices(FrameReader read) {
  return [read = std::move(read)](int frame) {
    DoctorFrame out = read(frame);
    if (out.previousClipFromClip) out.previousClipFromClip = flippedMatrix(*out.previousClipFromClip);
    if (out.cameras)
      for (int column = 0; column < 4; ++column) out.cameras->clipFromView[column][1] *= -1.0;
    return out;
  };
}

FrameReader withoutDepth(FrameReader read) {
  return [read = std::move(read)](int frame) {
    DoctorFrame out = read(frame);
    out.depth = out.depthView = out.previousDepthView = {};
    out.previousClipFromClip.reset();
    out.cameras.reset();
    out.distanceFactor = 0.0f;
    return out;
  };
}

bool correctsAlone(const MotionTrial& trial) {
  const MotionMadeOf made = madeOf(trial.kind);
  return made == MotionMadeOf::Factors || made == MotionMadeOf::Curve || made == MotionMadeOf::Jitter;
}

FrameReader withMotion(FrameReader read, MotionTrial trial, std::map<int, glm::vec2> stated) {
  return [read = std::move(read), trial, stated = std::move(stated)](int frame) {
    DoctorFrame out = read(frame);
    DoctorFrame before; // of which these explanations ask for the jitter alone
    const auto known = stated.find(frame - 1);
    before.jitterPx = known == stated.end() ? out.jitterPx : known->second;
    Image corrected = out.motionPx;
    for (int y = 0; y < corrected.height; ++y)
      for (int x = 0; x < corrected.width; ++x) {
        if (!isMotion(out.motionAt(x, y))) continue;
        const auto motion = trueMotion(trial, {out, before}, {x, y});
        corrected.at(x, y)[0] = motion->x;
        corrected.at(x, y)[1] = motion->y;
      }
    out.motionPx = std::move(corrected);
    return out;
  };
}

} // namespace taa::doctor
