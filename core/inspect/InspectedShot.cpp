#include "core/inspect/InspectedShot.h"

#include "core/base/Say.h"
#include "core/inspect/FirstSize.h"
#include "core/inspect/InspectorParts.h"
#include "core/inspect/MemoryNeed.h"
#include "core/scene/Pose.h"
#include "core/scene/SceneSource.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

namespace taa {

namespace {

/// Throws Error where the driver or its memory is too small for lanes of a picture. What is held now is not
/// counted on: it goes only when the new is there.
void checkSize(const glm::ivec2& size, const std::vector<Settings>& lanes,
               const std::vector<IntermediateId>& watched, const gl::Driver& driver, bool hasFog) {
  const int most = driver.maxTextureSize;
  if (size.x < 4 || size.y < 4 || size.x > most || size.y > most)
    throw Error(say<"cannot use a picture of %1 × %2 pixels: this driver allows 4 to %3 a side">(
        size.x, size.y, most));
  // Asked before anything is allocated: a software driver does not run out of memory, its process is killed.
  const std::optional<std::size_t> available = gl::availableMemory(driver);
  if (!available) return;
  const std::string refusal = memoryRefusal(memoryNeed(lanes, size, watched, hasFog), size, *available);
  if (!refusal.empty()) throw Error(refusal);
}

} // namespace

InspectedShot::InspectedShot() : parts_(std::make_unique<Parts>()) {
  const glm::ivec2 size = firstSize(driver());
  parts_->subject.width = size.x;
  parts_->subject.height = size.y;
}
InspectedShot::~InspectedShot() = default;

const gl::Driver& InspectedShot::driver() const {
  return parts_->context.driver();
}

void InspectedShot::open(const std::string& source, const Progress& progress) {
  Subject next = parts_->subject;
  next.source = source;
  next.scene = std::make_shared<const Scene>(openScene(source, progress));
  next.renderer = std::make_shared<SceneRenderer>(next.scene, progress);
  next.camera = next.scene->shot.camera;
  next.motionModes.clear();
  next.filter = {};
  next.tracks.clear();
  next.objectClasses.clear();
  next.restarts.clear();
  next.renderer->warmUp(next.request(0), progress);
  parts_->startAnew(std::move(next), std::vector<Checkpoints>(parts_->subject.lanes.size()), 0);
  parts_->forgetReferences();
}

const std::string& InspectedShot::source() const {
  return parts_->subject.source;
}

const Scene& InspectedShot::scene() const {
  assert(parts_->isOpen());
  return *parts_->subject.scene;
}

void InspectedShot::setSize(int width, int height) {
  if (width == this->width() && height == this->height()) return;
  checkSize({width, height}, parts_->subject.lanes, parts_->watched(), driver(), parts_->hasFog());
  Subject next = parts_->subject;
  next.width = width;
  next.height = height;
  const std::vector<bool> changed(next.lanes.size(), true);
  parts_->redraw(std::move(next), changed, false);
  parts_->maker.freeTextures();
}

int InspectedShot::width() const {
  return parts_->subject.width;
}

int InspectedShot::height() const {
  return parts_->subject.height;
}

void InspectedShot::checkLanes(const std::vector<Settings>& lanes) const {
  if (lanes.empty() || lanes.size() > kMostLanes)
    throw Error(say<"cannot run %1 lanes: there are one to %2">(lanes.size(), kMostLanes));
  checkSize({width(), height()}, lanes, parts_->watched(), driver(), parts_->hasFog());
}

void InspectedShot::setLanes(const std::vector<Settings>& lanes) {
  checkLanes(lanes);
  Subject next = parts_->subject;
  next.lanes = lanes;
  std::vector<Checkpoints> kept(lanes.size());
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    for (std::size_t old = 0; old < parts_->subject.lanes.size(); ++old)
      if (lanes[lane] == parts_->subject.lanes[old]) kept[lane] = parts_->checkpoints[old];
  if (parts_->isOpen()) return parts_->startAnew(std::move(next), std::move(kept), frame());
  parts_->subject = std::move(next);
  parts_->checkpoints = std::move(kept);
}

int InspectedShot::laneCount() const {
  return static_cast<int>(parts_->subject.lanes.size());
}

const Settings& InspectedShot::settings(int lane) const {
  return parts_->settings(lane);
}

void InspectedShot::setSettings(const Settings& settings, int lane) {
  if (settings == this->settings(lane)) return;
  Subject next = parts_->subject;
  next.lanes[static_cast<std::size_t>(lane)] = settings;
  std::vector<bool> changed(next.lanes.size(), false);
  changed[static_cast<std::size_t>(lane)] = true;
  parts_->redraw(std::move(next), changed, true);
}

int InspectedShot::frameCount() const {
  return scene().shot.frames;
}

int InspectedShot::frame() const {
  return parts_->shown.frame;
}

FrameInfo InspectedShot::info(int lane) const {
  return frameInfo(scene(), parts_->subject.request(static_cast<std::size_t>(lane)), frame());
}

void InspectedShot::seek(int frame, const Progress& progress) {
  if (frame < 0 || frame >= frameCount())
    throw Error(say<"there is no frame %1: the shot has frames 0 to %2">(frame, frameCount() - 1));
  if (frame == this->frame() && parts_->isExact()) return;
  parts_->goTo(frame, progress);
}

void InspectedShot::advance() {
  assert(frame() + 1 < frameCount());
  const std::size_t lanes = parts_->subject.lanes.size();
  FrameStep step{
      .frame = frame() + 1, .previous = {}, .active = std::vector<bool>(lanes, true), .inputs = {}};
  for (const ShownLane& lane : parts_->shown.lanes) step.previous.push_back(lane.current);
  ShownFrame next = parts_->maker.take();
  parts_->maker.make(parts_->subject, step, next);
  for (std::size_t lane = 0; lane < lanes; ++lane)
    next.lanes[lane].exact = parts_->shown.lanes[lane].exact || startsHistory(parts_->subject, step.frame);
  parts_->show(std::move(next));
  parts_->keepShown();
  parts_->trimCheckpoints();
}

void InspectedShot::refine(const Progress& progress) {
  seek(frame(), progress);
}

bool InspectedShot::isExact(int lane) const {
  return parts_->lane(lane).exact;
}

FrameTimes InspectedShot::times() const {
  return {parts_->shown.sceneMs, parts_->shown.resolveMs};
}

int InspectedShot::replayLength(int frame) const {
  return taa::replayLength(parts_->subject, parts_->checkpoints, frame);
}

int InspectedShot::nearestAtHand(int frame) const {
  return taa::nearestAtHand(parts_->subject, parts_->checkpoints, frame);
}

std::size_t InspectedShot::checkpointBudget() const {
  return parts_->budget;
}

void InspectedShot::setCheckpointBudget(std::size_t bytes) {
  parts_->budget = bytes;
  if (parts_->isOpen()) parts_->trimCheckpoints();
}

void InspectedShot::changeLanes(const std::vector<Settings>& lanes) {
  const std::size_t old = parts_->subject.lanes.size();
  if (!parts_->isOpen()) return setLanes(lanes);
  checkLanes(lanes);
  const auto resize = [&](std::size_t count) {
    parts_->subject.lanes.resize(count, lanes.back());
    parts_->checkpoints.resize(count);
    parts_->shown.lanes.resize(count);
    parts_->aside.clear();
  };
  std::vector<bool> changed(lanes.size(), false);
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    changed[lane] = lane >= old || !(lanes[lane] == parts_->subject.lanes[lane]);
  resize(lanes.size());
  if (std::ranges::none_of(changed, [](bool is) { return is; })) return;
  try {
    Subject next = parts_->subject;
    next.lanes = lanes;
    parts_->redraw(std::move(next), changed, true);
  } catch (...) {
    resize(std::min(old, lanes.size()));
    throw;
  }
}

bool InspectedShot::areAllExact() const {
  return parts_->isExact();
}

std::vector<int> InspectedShot::keptFrames() const {
  std::vector<int> frames = parts_->checkpoints.front().frames();
  std::erase_if(frames, [&](int frame) {
    return !std::ranges::all_of(parts_->checkpoints,
                                [&](const Checkpoints& kept) { return kept.at(frame) != nullptr; });
  });
  return frames;
}

void InspectedShot::prepare(const Settings& settings, int lane) {
  if (parts_->isOpen() && !parts_->timer) parts_->prepare(settings, static_cast<std::size_t>(lane));
}

void InspectedShot::prepareAside(const Settings& settings, int lane) {
  if (!parts_->isOpen() || !sameInputs(settings, this->settings(lane))) return;
  parts_->compiler.want({settings, {width(), height()}, parts_->maker.exposedRows(settings)});
}

bool InspectedShot::waitUntilPrepared(std::chrono::milliseconds duration) {
  return parts_->compiler.waitFor(duration);
}

void InspectedShot::reloadShaders() {
  const auto before = useShaders(readShaders());
  try {
    parts_->reloadShaders();
  } catch (...) {
    useShaders(before); // whatever is compiled later goes on with these
    throw;
  }
}

} // namespace taa
