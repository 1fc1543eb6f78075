#include "core/inspect/verdicts/EvidenceFrames.h"

#include "core/base/Say.h"
#include "core/gl/PassTimer.h"
#include "core/measure/Profiler.h"
#include "core/measure/References.h"
#include "core/probe/SurfaceSteps.h"
#include "core/probe/TwinInputs.h"
#include "core/verdict/lineage/TwinStep.h"

#include <limits>
#include <utility>
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
    : player_(player), references_(references), state_(player.onlyLane(lane)), lane_(lane), samples_(samples),
      progress_(progress) {}

EvidenceFrames::~EvidenceFrames() {
  close();
}

PixelStep EvidenceFrames::step(int frame, const glm::ivec2& pixel) {
  open(frame);
  return pixelStep(inputs_, settings(), pixel);
}

twin::PixelRecord EvidenceFrames::record(int frame, const glm::ivec2& pixel) {
  open(frame);
  return twin::resolvePixel(inputs_, settings(), pixel.x, pixel.y);
}

const Image& EvidenceFrames::reference(int frame) {
  const auto known = means_.find(frame);
  if (known != means_.end()) return known->second;
  const gl::PassGroup group(pass_group::kReference);
  const ReferenceKey wanted{referenceRequest(state_.request(0)), frame};
  return means_[frame] =
             references_.foundOrDrawn(*state_.frames, wanted, samples_, references_, progress_).mean();
}

const Image& EvidenceFrames::steps(int frame) {
  const auto known = steps_.find(frame);
  if (known != steps_.end()) return known->second;
  const gl::PassGroup group(pass_group::kReference);
  const bool isFirst = startsHistory(state_, frame);
  return steps_[frame] = isFirst ? firstSteps(drawSurfaces(*state_.frames, state_.request(0), frame))
                                 : drawSteps(*state_.frames, state_.request(0), frame, seen_);
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
    if (position.x < 0.0 || position.y < 0.0 || position.x >= state_.width || position.y >= state_.height)
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

void EvidenceFrames::open(int frame) {
  if (frame_ == frame) return;
  close();
  const gl::PassGroup group(pass_group::kProbe);
  const ShownLane& shown = player_.lane(lane_);
  if (frame == player_.shown().frame && shown.exact) {
    inputs_ = twinInputs(player_.inputs(lane_), shown.previous.get(), TwinReading::Parts);
  } else {
    made_ = player_.makeInBackground(frame, kept_, progress_, lane_);
    const FrameInputs& drawn = player_.maker().inputs(state_, *made_, 0);
    inputs_ = twinInputs(drawn, made_->lanes[0].previous.get(), TwinReading::Parts);
  }
  frame_ = frame;
}

// Textures go back after what reads them has gone.
void EvidenceFrames::close() {
  frame_.reset();
  inputs_ = {};
  if (made_) player_.maker().recycle(std::move(*made_));
  made_.reset();
}

} // namespace taa
