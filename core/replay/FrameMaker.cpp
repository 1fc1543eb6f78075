#include "core/replay/FrameMaker.h"

#include "core/base/Say.h"
#include "core/gl/Context.h"
#include "core/gl/PassTimer.h"
#include "core/render/FrameClock.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

namespace taa {

namespace {

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

gl::Rect wholePicture(const ShotState& state) {
  return {0, 0, state.width, state.height};
}

void fitExposed(ExposedRows& exposedRows, const ExposedLayout& layout, const gl::Rect& picture) {
  if (exposedRows.region() == picture && exposedRows.layout().hasSamePlaces(layout)) {
    exposedRows.take(layout);
    return;
  }
  exposedRows = ExposedRows(); // the old textures first: there may not be room for both
  exposedRows = ExposedRows(layout, picture);
}

/// The first frame that has to be resolved again to reach `frame`; the one after it when it is kept.
int firstToResolve(const ShotState& state, const Checkpoints& checkpoints, int frame) {
  assert(frame >= 0);
  if (isKept(state, checkpoints, frame)) return frame + 1;
  while (!startsHistory(state, frame) && !checkpoints.at(frame - 1)) --frame;
  return frame;
}

// Gives a lane what was kept of the frame. Beside one that goes on through a cut its history may start.
void restore(const ShotState& state, const Checkpoints& checkpoints, int frame, const Settings& settings,
             ShownLane& lane) {
  const bool starts = startsHistory(state, frame) || (!isOn(settings.fault.keepsAtCuts) &&
                                                      startsHistory(*state.scene, state.restarts, frame));
  lane.previous = starts ? nullptr : checkpoints.at(frame - 1);
  lane.current = checkpoints.at(frame);
  lane.exact = true;
  lane.isExposed = false;
  lane.asked.reset();
}

bool isCached(const ShotState& state, const Checkpoints& checkpoints, int frame) {
  return startsHistory(state, frame) || checkpoints.at(frame - 1);
}

} // namespace

CameraTrackHandle ShotState::track() const {
  const auto found =
      std::ranges::find(tracks, camera, [](const CameraTrackHandle& handle) { return handle->name; });
  return found == tracks.end() ? nullptr : *found;
}

Shot ShotState::shot() const {
  Shot shot = scene->shot;
  shot.cuts.insert(shot.cuts.end(), restarts.begin(), restarts.end());
  return shot;
}

FrameRequest ShotState::request(std::size_t lane) const {
  return {.camera = camera,
          .width = width,
          .height = height,
          .jitter = lanes[lane].jitter,
          .inputs = lanes[lane].inputs,
          .motionModes = motionModes,
          .filter = filter,
          .track = track(),
          .objectClasses = objectClasses,
          .restarts = restarts,
          .faults = lanes[lane].fault};
}

FrameCameraPair ShotState::cameras(std::size_t lane, int frame) const {
  const FrameRequest wanted = request(lane);
  FrameCameraPair cameras{frames->camera(wanted, frame),
                          frames->camera(wanted, previousFrame(*scene, frame))};
  if (wanted.inputs.motion == MotionSource::CurrentProjectionAsPrinted)
    cameras.previous.clipFromView = cameras.now.clipFromView; // manual §26, D16
  return cameras;
}

bool startsHistory(const ShotState& state, int frame) {
  const bool goesOn = std::ranges::any_of(
      state.lanes, [](const Settings& settings) { return isOn(settings.fault.keepsAtCuts); });
  if (goesOn && frame > 0) return std::ranges::find(state.restarts, frame) != state.restarts.end();
  return taa::startsHistory(*state.scene, state.restarts, frame);
}

bool isKept(const ShotState& state, const Checkpoints& checkpoints, int frame) {
  return checkpoints.at(frame) && isCached(state, checkpoints, frame);
}

std::size_t checkpointShare(const ShotState& state, std::size_t lane, std::size_t budget) {
  const auto bytesOf = [&](const Settings& settings) {
    return historyBytes(state.width, state.height, settings);
  };
  std::size_t frameOfAll = 0;
  for (const Settings& settings : state.lanes) frameOfAll += bytesOf(settings);
  assert(frameOfAll > 0);
  return budget / frameOfAll * bytesOf(state.lanes[lane]);
}

int replayLength(const ShotState& state, const std::vector<Checkpoints>& checkpoints, int frame) {
  int most = 0;
  for (const Checkpoints& kept : checkpoints)
    most = std::max(most, frame + 1 - firstToResolve(state, kept, frame));
  return most;
}

int nearestCached(const ShotState& state, const std::vector<Checkpoints>& checkpoints, int frame) {
  const auto isFound = [&](int candidate) {
    return candidate >= 0 && candidate < state.scene->shot.frames &&
           std::ranges::all_of(checkpoints,
                               [&](const Checkpoints& kept) { return isCached(state, kept, candidate); });
  };
  int distance = 0; // frame 0 is always one
  while (!isFound(frame - distance) && !isFound(frame + distance)) ++distance;
  return isFound(frame - distance) ? frame - distance : frame + distance;
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
  keptInputs.clear();
  pool_.clear();
}

const FrameInputs& FrameMaker::inputs(const ShotState& state, ShownFrame& shown, std::size_t lane) {
  LazyInputs& inputs = *shown.lanes[lane].inputs;
  if (inputs.areDrawn) return inputs.textures;
  const auto start = std::chrono::steady_clock::now();
  state.frames->draw(state.request(lane), shown.frame, inputs.textures);
  gl::finish();
  shown.sceneMs += millisecondsSince(start);
  inputs.areDrawn = true;
  keptInputs.keep(state.frames, state.request(lane), shown.frame, shown.lanes[lane].inputs,
                  inputBytes(state.lanes[lane].inputs, {state.width, state.height}, state.scene.get()));
  return inputs.textures;
}

// Gives every lane its inputs: those of the step, else those of the first lane that draws the same, else kept
// ones, else new ones, not drawn, whose textures are used again unless another frame has them too.
void FrameMaker::arrange(const ShotState& state, const FrameStep& step, ShownFrame& frame) {
  std::vector<InputsHandle> free;
  for (ShownLane& lane : frame.lanes) {
    InputsHandle inputs = std::exchange(lane.inputs, nullptr);
    if (inputs.use_count() == 1) free.push_back(std::move(inputs)); // its last lane
  }
  frame.lanes.resize(state.lanes.size());
  std::size_t taken = 0;
  for (std::size_t lane = 0; lane < state.lanes.size(); ++lane) {
    InputsHandle& inputs = frame.lanes[lane].inputs;
    if (!step.inputs.empty()) inputs = step.inputs[lane];
    for (std::size_t other = 0; other < lane && !inputs; ++other)
      if (sameInputs(state.lanes[other], state.lanes[lane])) inputs = frame.lanes[other].inputs;
    if (!inputs) inputs = keptInputs.find(state.frames, state.request(lane), step.frame);
    if (inputs) continue;
    inputs = taken < free.size() ? free[taken++] : keptInputs.takeFree();
    inputs->areDrawn = false;
  }
}

std::vector<IntermediateId> FrameMaker::rowsToExpose(const Settings& settings) const {
  return ExposedLayout(watched, rowSources(settings)).isWritten() ? watched : std::vector<IntermediateId>();
}

void FrameMaker::make(const ShotState& state, const FrameStep& step, ShownFrame& next) {
  gl::PassTimer::startFrame();
  arrange(state, step, next);
  next.frame = step.frame;
  next.sceneMs = 0.0;
  for (std::size_t lane = 0; lane < next.lanes.size(); ++lane)
    if (step.active[lane]) inputs(state, next, lane);
  const auto drawn = std::chrono::steady_clock::now();
  for (std::size_t index = 0; index < next.lanes.size(); ++index) {
    if (!step.active[index]) continue;
    ShownLane& lane = next.lanes[index];
    const FrameInputs& inputs = lane.inputs->textures;
    lane.previous = inputs.info.startsHistory ? nullptr : step.previous[index];
    lane.asked.reset();
    lane.isExposed = step.exposes && !rowsToExpose(state.lanes[index]).empty();
    if (lane.isExposed)
      fitExposed(lane.watched, ExposedLayout(watched, rowSources(state.lanes[index])), wholePicture(state));
    const std::shared_ptr<History> out = pool_.take();
    pass.resolve(inputs, lane.previous.get(), state.lanes[index], *out,
                 lane.isExposed ? &lane.watched : nullptr);
    lane.current = out;
  }
  gl::finish();
  next.resolveMs = millisecondsSince(drawn);
  gl::checkErrors(say<"cannot make frame %1">(step.frame));
}

ShownFrame FrameMaker::replay(const ShotState& state, std::vector<Checkpoints>& checkpoints, int frame,
                              std::size_t budget, const Progress& progress) {
  const std::size_t lanes = state.lanes.size();
  std::vector<int> first(lanes);
  FrameStep step{
      .previous = std::vector<HistoryHandle>(lanes), .active = std::vector<bool>(lanes), .inputs = {}};
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    first[lane] = firstToResolve(state, checkpoints[lane], frame);
    step.previous[lane] = checkpoints[lane].at(first[lane] - 1);
  }
  const int begin = *std::ranges::min_element(first);
  ShownFrame next = take();
  next.frame = frame;
  next.sceneMs = next.resolveMs = 0.0;
  step.frame = frame;
  arrange(state, step, next);
  for (step.frame = begin; step.frame <= frame; ++step.frame) {
    report(progress, say<"Replaying frames">(), step.frame - begin, frame - begin + 1);
    step.exposes = step.frame == frame;
    for (std::size_t lane = 0; lane < lanes; ++lane) step.active[lane] = step.frame >= first[lane];
    make(state, step, next);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      if (!step.active[lane]) continue;
      next.lanes[lane].exact = true;
      step.previous[lane] = next.lanes[lane].current;
      checkpoints[lane].keep(step.frame, next.lanes[lane].current);
      checkpoints[lane].trim(checkpointShare(state, lane, budget), step.frame, state.shot());
    }
  }
  for (std::size_t lane = 0; lane < lanes; ++lane)
    if (first[lane] > frame) restore(state, checkpoints[lane], frame, state.lanes[lane], next.lanes[lane]);
  return next;
}

// What the history holds is there at once; for all else the inputs are drawn.
void FrameMaker::fill(const ShotState& state, ShownFrame& shown, std::size_t index,
                      ExposedRows& exposedRows) {
  const ShownLane& lane = shown.lanes[index];
  if (!exposedRows.layout().needsInputs()) {
    exposedRows.readFrom(nullptr, *lane.current);
    return;
  }
  pass.expose(inputs(state, shown, index), lane.previous.get(), *lane.current, state.lanes[index],
              exposedRows);
}

ExposedRows FrameMaker::expose(const ShotState& state, ShownFrame& shown,
                               const std::vector<IntermediateId>& ids, int laneIndex) {
  const auto index = static_cast<std::size_t>(laneIndex);
  ExposedRows exposedRows(ExposedLayout(ids, rowSources(state.lanes[index])), wholePicture(state));
  fill(state, shown, index, exposedRows);
  return exposedRows;
}

const ExposedRows& FrameMaker::exposed(const ShotState& state, ShownFrame& shown, IntermediateId id,
                                       int laneIndex) {
  return exposedAll(state, shown, {id}, laneIndex);
}

// What is watched is exposed together.
const ExposedRows& FrameMaker::exposedAll(const ShotState& state, ShownFrame& shown,
                                          const std::vector<IntermediateId>& ids, int laneIndex) {
  const auto index = static_cast<std::size_t>(laneIndex);
  ShownLane& lane = shown.lanes[index];
  const auto hasAll = [&](const ExposedRows& exposedRows) {
    return std::ranges::all_of(ids, [&](IntermediateId id) { return exposedRows.holds(id); });
  };
  if (lane.isExposed && hasAll(lane.watched)) return lane.watched;
  if (lane.asked && hasAll(*lane.asked)) return *lane.asked;
  const auto isWatched = [&](IntermediateId id) { return std::ranges::find(watched, id) != watched.end(); };
  if (!std::ranges::all_of(ids, isWatched)) return lane.asked.emplace(expose(state, shown, ids, laneIndex));
  lane.isExposed = false;
  fitExposed(lane.watched, ExposedLayout(watched, rowSources(state.lanes[index])), wholePicture(state));
  fill(state, shown, index, lane.watched);
  lane.isExposed = true;
  return lane.watched;
}

} // namespace taa
