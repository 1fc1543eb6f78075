#include "core/inspect/FrameMaker.h"

#include "core/gl/Context.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <chrono>

namespace taa {

namespace {

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

gl::Rect wholePicture(const Subject& subject) {
  return {0, 0, subject.width, subject.height};
}

// Gives every lane its inputs: those of the first lane that draws the same.
void arrange(const Subject& subject, ShownFrame& frame) {
  frame.lanes.resize(subject.lanes.size());
  std::vector<std::size_t> drawn; // lane that each of the inputs is drawn for
  for (std::size_t lane = 0; lane < subject.lanes.size(); ++lane) {
    const auto found = std::ranges::find_if(
        drawn, [&](std::size_t other) { return sameInputs(subject.lanes[other], subject.lanes[lane]); });
    frame.lanes[lane].inputs = static_cast<std::size_t>(found - drawn.begin());
    if (found == drawn.end()) drawn.push_back(lane);
  }
  frame.inputs.resize(drawn.size());
}

void drawInputs(const Subject& subject, const FrameStep& step, ShownFrame& next) {
  std::vector<bool> done(next.inputs.size(), false);
  for (std::size_t lane = 0; lane < next.lanes.size(); ++lane) {
    const std::size_t inputs = next.lanes[lane].inputs;
    if (!step.active[lane] || done[inputs]) continue;
    const Settings& settings = subject.lanes[lane];
    subject.renderer->draw({.camera = subject.camera,
                            .width = subject.width,
                            .height = subject.height,
                            .jitter = settings.jitter,
                            .inputs = settings.inputs,
                            .motionModes = subject.motionModes},
                           step.frame, next.inputs[inputs]);
    done[inputs] = true;
  }
}

void fitExposure(Exposure& exposure, const std::vector<IntermediateId>& ids, const gl::Rect& region) {
  if (exposure.watched() == ids && exposure.region() == region) return;
  exposure = Exposure(); // the old textures first: there may not be room for both
  exposure = Exposure(ids, region);
}

/// The first frame that has to be resolved again to reach `frame`.
int firstToResolve(const Subject& subject, const Checkpoints& checkpoints, int frame) {
  while (!startsHistory(subject, frame) && !checkpoints.at(frame - 1)) --frame;
  return frame;
}

} // namespace

bool startsHistory(const Subject& subject, int frame) {
  return frameInfo(*subject.scene, {}, frame).startsHistory;
}

ShownFrame FrameMaker::take() {
  if (!spare_) return {};
  ShownFrame frame = std::move(*spare_);
  spare_.reset();
  return frame;
}

void FrameMaker::recycle(ShownFrame&& frame) {
  for (ShownLane& lane : frame.lanes) {
    lane.previous = lane.current = nullptr;
    lane.asked.reset();
  }
  spare_ = std::move(frame);
}

void FrameMaker::freeTextures() {
  spare_.reset();
  pool_.clear();
}

void FrameMaker::make(const Subject& subject, const FrameStep& step, ShownFrame& next) {
  arrange(subject, next);
  next.frame = step.frame;
  const auto start = std::chrono::steady_clock::now();
  drawInputs(subject, step, next);
  gl::finish();
  next.sceneMs = millisecondsSince(start);
  const auto drawn = std::chrono::steady_clock::now();
  for (std::size_t index = 0; index < next.lanes.size(); ++index) {
    if (!step.active[index]) continue;
    ShownLane& lane = next.lanes[index];
    const FrameInputs& inputs = next.inputs[lane.inputs];
    lane.previous = inputs.info.startsHistory ? nullptr : step.previous[index];
    lane.asked.reset();
    lane.isExposed = step.exposes && !watched.empty();
    if (lane.isExposed) fitExposure(lane.watched, watched, wholePicture(subject));
    const std::shared_ptr<History> out = pool_.take();
    pass.resolve(inputs, lane.previous.get(), subject.lanes[index], *out,
                 lane.isExposed ? &lane.watched : nullptr);
    lane.current = out;
  }
  gl::finish();
  next.resolveMs = millisecondsSince(drawn);
  gl::checkErrors("cannot make frame " + std::to_string(step.frame));
}

ShownFrame FrameMaker::replay(const Subject& subject, std::vector<Checkpoints>& checkpoints, int frame,
                              std::size_t budget, const Progress& progress) {
  const std::size_t lanes = subject.lanes.size();
  std::vector<int> first(lanes);
  FrameStep step{0, std::vector<HistoryHandle>(lanes), std::vector<bool>(lanes)};
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    first[lane] = firstToResolve(subject, checkpoints[lane], frame);
    step.previous[lane] = checkpoints[lane].at(first[lane] - 1);
  }
  const int begin = *std::ranges::min_element(first);
  ShownFrame next = take();
  for (step.frame = begin; step.frame <= frame; ++step.frame) {
    report(progress, "Replaying frames", step.frame - begin, frame - begin + 1);
    step.exposes = step.frame == frame;
    for (std::size_t lane = 0; lane < lanes; ++lane) step.active[lane] = step.frame >= first[lane];
    make(subject, step, next);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (!step.active[lane]) continue;
      next.lanes[lane].exact = true;
      step.previous[lane] = next.lanes[lane].current;
      checkpoints[lane].keep(step.frame, next.lanes[lane].current);
      checkpoints[lane].trim(budget / lanes, step.frame, subject.scene->shot.frames);
    }
  }
  return next;
}

const Exposure& FrameMaker::exposed(const Subject& subject, ShownFrame& shown, IntermediateId id,
                                    int laneIndex) {
  ShownLane& lane = shown.lanes[static_cast<std::size_t>(laneIndex)];
  const Settings& settings = subject.lanes[static_cast<std::size_t>(laneIndex)];
  if (lane.isExposed && lane.watched.holds(id)) return lane.watched;
  if (lane.asked && lane.asked->holds(id)) return *lane.asked;
  const FrameInputs& inputs = shown.inputs[lane.inputs];
  if (std::ranges::find(watched, id) == watched.end()) {
    Exposure exposure({id}, wholePicture(subject));
    pass.expose(inputs, lane.previous.get(), *lane.current, settings, exposure);
    return lane.asked.emplace(std::move(exposure));
  }
  lane.isExposed = false;
  fitExposure(lane.watched, watched, wholePicture(subject));
  pass.expose(inputs, lane.previous.get(), *lane.current, settings, lane.watched);
  lane.isExposed = true;
  return lane.watched;
}

} // namespace taa
