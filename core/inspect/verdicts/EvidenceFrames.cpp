#include "core/inspect/verdicts/EvidenceFrames.h"

#include "core/base/Say.h"
#include "core/gl/PassTimer.h"
#include "core/measure/Profiler.h"
#include "core/measure/References.h"
#include "core/probe/SurfaceSteps.h"
#include "core/verdict/lineage/TwinStep.h"

#include <limits>
#include <vector>

namespace taa {

namespace {

/// Of a frame that starts history: nothing was seen before.
Image firstSteps(const SeenSurfaces& seen) {
  Image steps(seen.objectId.width, seen.objectId.height, kStepChannels);
  for (int y = 0; y < steps.height; ++y)
    for (int x = 0; x < steps.width; ++x) {
      float* step = steps.at(x, y);
      step[0] = step[1] = std::numeric_limits<float>::quiet_NaN();
      step[2] = *seen.objectId.at(x, y);
    }
  return steps;
}

} // namespace

EvidenceFrames::EvidenceFrames(ShotPlayer& player, References& references, int lane, int samples,
                               const Progress& progress)
    : references_(references), frames_(player, lane, progress), lane_(lane), samples_(samples),
      progress_(progress) {}

PixelStep EvidenceFrames::step(int frame, const glm::ivec2& pixel) {
  const gl::PassGroup group(pass_group::kProbe);
  return pixelStep(frames_.at(frame, pixel), settings(), pixel);
}

twin::PixelRecord EvidenceFrames::record(int frame, const glm::ivec2& pixel) {
  const gl::PassGroup group(pass_group::kProbe);
  return twin::resolvePixel(frames_.at(frame, pixel), settings(), pixel.x, pixel.y);
}

const Image& EvidenceFrames::reference(int frame) {
  const auto known = means_.find(frame);
  if (known != means_.end()) return known->second;
  const gl::PassGroup group(pass_group::kReference);
  const ReferenceKey wanted{referenceRequest(state().request(0)), frame};
  return means_[frame] =
             references_.foundOrDrawn(*state().frames, wanted, samples_, references_, progress_).mean();
}

const Image& EvidenceFrames::steps(int frame) {
  const auto known = steps_.find(frame);
  if (known != steps_.end()) return known->second;
  const gl::PassGroup group(pass_group::kReference);
  const bool isFirst = startsHistory(state(), frame);
  return steps_[frame] = isFirst ? firstSteps(drawSurfaces(*state().frames, state().request(0), frame))
                                 : drawSteps(*state().frames, state().request(0), frame, seen_);
}

std::vector<SurfaceMoment> EvidenceFrames::moments(int frame, const glm::ivec2& pixel, int frames) {
  std::vector<SurfaceMoment> moments;
  glm::dvec2 position(pixel.x + 0.5, pixel.y + 0.5);
  const float object = steps(frame).at(pixel.x, pixel.y)[2];
  for (int age = 0; age < frames; ++age) {
    SurfaceMoment moment;
    moment.frame = frame - age;
    moment.pixel = glm::ivec2(position);
    moments.push_back(moment);
    const std::optional<glm::dvec2> step = stepAt(steps(moment.frame), position, object);
    if (!step) break;
    position -= *step;
    if (position.x < 0.0 || position.y < 0.0 || position.x >= state().width || position.y >= state().height)
      break;
  }
  return moments;
}

void EvidenceFrames::fill(std::vector<SurfaceMoment>& moments) {
  for (SurfaceMoment& moment : moments) {
    report(progress_, say<"Looking back">(), static_cast<int>(&moment - moments.data()),
           static_cast<int>(moments.size()));
    moment.record = record(moment.frame, moment.pixel);
    moment.resolved = glm::dvec3(glm::vec3(twin::at(moment.record, IntermediateId::resolved)));
    moment.reference = pixelColorAt(reference(moment.frame), moment.pixel);
  }
}

} // namespace taa
