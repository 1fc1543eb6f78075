#include "core/inspect/InspectedShot.h"

#include "core/base/EmbeddedFiles.h"
#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/source/OpenSource.h"
#include "core/inspect/MemoryNeed.h"
#include "core/inspect/ReferenceOfShot.h"
#include "core/inspect/ShotProfiler.h"
#include "core/picture/Visualizer.h"
#include "core/render/CaptureFacts.h"
#include "core/render/FrameClock.h"
#include "core/replay/ShotPlayer.h"
#include "core/scene/Pose.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace taa {

namespace {

std::vector<Settings> usedOn(const CaptureFacts* capture, std::vector<Settings> lanes) {
  if (capture)
    for (Settings& settings : lanes) settings = settingsOn(*capture, settings);
  return lanes;
}

// A capture's size is its own, and what of the settings only a renderer can be asked for.
void takeOwn(const CaptureFacts* capture, const std::vector<Settings>& lanes, const glm::ivec2& scenePx,
             ShotState& next) {
  next.lanes = usedOn(capture, lanes);
  const glm::ivec2 sizePx = capture ? capture->outputPx : scenePx;
  next.width = sizePx.x;
  next.height = sizePx.y;
}

} // namespace

InspectedShot::InspectedShot(const gl::Driver& driver, ShotPlayer& player, Visualizer& visualizer,
                             ReferenceOfShot& reference, const ShotProfiler& profiler)
    : driver_(driver), player_(player), visualizer_(visualizer), reference_(reference), profiler_(profiler) {}

void InspectedShot::open(const std::string& source, const Progress& progress, const ShotChoice& choice,
                         const std::optional<SceneBudget>& budget) {
  OpenedSource opened = openSource(source, progress, choice, budget.value_or(sceneBudget_));
  ShotState next = player_.state();
  next.source = source;
  next.scene = std::move(opened.scene);
  next.frames = std::move(opened.frames);
  const auto captured = next.frames->capture();
  const glm::ivec2 scenePx = scenePx_.value_or(player_.picturePx());
  takeOwn(captured.get(), lanes_, scenePx, next);
  const glm::ivec2 sizePx{next.width, next.height};
  const bool isResized = sizePx != player_.picturePx();
  if (isResized) requirePicture(driver_, next.lanes, sizePx, player_.watched(), next.scene.get());
  next.camera = next.scene->shot.camera;
  next.motionModes.clear();
  next.filter = {};
  next.tracks.clear();
  next.objectClasses.clear();
  next.restarts.clear();
  next.frames->warmUp(next.request(0), progress);
  player_.open(std::move(next));
  choice_ = choice;
  scenePx_ = captured ? std::optional(scenePx) : std::nullopt;
  if (isResized) player_.freeTextures();
  reference_.forget();
}

const std::string& InspectedShot::source() const {
  return player_.state().source;
}

const Scene& InspectedShot::scene() const {
  assert(player_.isOpen());
  return *player_.state().scene;
}

std::shared_ptr<const CaptureFacts> InspectedShot::capture() const {
  return player_.isOpen() ? player_.state().frames->capture() : nullptr;
}

void InspectedShot::requireScene() const {
  if (capture()) throw Error(whyNoScene());
}

Settings InspectedShot::used(const Settings& settings) const {
  return used(std::vector{settings}).front();
}

std::vector<Settings> InspectedShot::used(const std::vector<Settings>& lanes) const {
  return usedOn(capture().get(), lanes);
}

void InspectedShot::setSize(int width, int height) {
  if (width == this->width() && height == this->height()) return;
  if (const auto captured = capture()) throw Error(whyOneSize(*captured));
  requirePicture(driver_, player_.state().lanes, {width, height}, player_.watched(), player_.scene());
  ShotState next = player_.state();
  next.width = width;
  next.height = height;
  player_.redrawAll(std::move(next), false);
  player_.freeTextures();
}

int InspectedShot::width() const {
  return player_.state().width;
}

int InspectedShot::height() const {
  return player_.state().height;
}

void InspectedShot::checkLanes(const std::vector<Settings>& lanes) const {
  if (lanes.empty() || lanes.size() > kMaxLanes)
    throw Error(say<"cannot run %1 lanes: there are one to %2">(lanes.size(), kMaxLanes));
  requirePicture(driver_, used(lanes), player_.picturePx(), player_.watched(), player_.scene());
}

void InspectedShot::setLanes(const std::vector<Settings>& lanes) {
  checkLanes(lanes);
  player_.setLanes(used(lanes));
  lanes_ = lanes;
}

void InspectedShot::changeLanes(const std::vector<Settings>& lanes) {
  checkLanes(lanes);
  if (player_.isOpen())
    player_.changeLanes(used(lanes));
  else
    player_.setLanes(lanes);
  lanes_ = lanes;
}

int InspectedShot::laneCount() const {
  return static_cast<int>(player_.state().lanes.size());
}

const Settings& InspectedShot::settings(int lane) const {
  return lanes_.at(static_cast<std::size_t>(lane));
}

const Settings& InspectedShot::usedSettings(int lane) const {
  return player_.settings(lane);
}

void InspectedShot::setSettings(const Settings& settings, int lane) {
  if (settings == this->settings(lane)) return;
  const auto index = static_cast<std::size_t>(lane);
  if (const Settings counting = used(settings); !(counting == usedSettings(lane))) {
    ShotState next = player_.state();
    next.lanes[index] = counting;
    std::vector<bool> changed(next.lanes.size(), false);
    changed[index] = true;
    player_.redraw(std::move(next), changed, true);
  }
  lanes_[index] = settings;
}

int InspectedShot::frameCount() const {
  return scene().shot.frames;
}

int InspectedShot::frame() const {
  return player_.shown().frame;
}

FrameInfo InspectedShot::info(int lane) const {
  const ShotState& state = player_.state();
  return state.frames->info(state.request(static_cast<std::size_t>(lane)), frame());
}

void InspectedShot::seek(int frame, const Progress& progress) {
  if (frame < 0 || frame >= frameCount())
    throw Error(say<"there is no frame %1: the shot has frames 0 to %2">(frame, frameCount() - 1));
  if (frame == this->frame() && player_.isExact()) return;
  player_.goTo(frame, progress);
}

void InspectedShot::advance() {
  assert(frame() + 1 < frameCount());
  player_.advance();
}

void InspectedShot::refine(const Progress& progress) {
  seek(frame(), progress);
}

bool InspectedShot::isExact(int lane) const {
  return player_.lane(lane).exact;
}

FrameTimes InspectedShot::times() const {
  return {player_.shown().sceneMs, player_.shown().resolveMs};
}

int InspectedShot::replayLength(int frame) const {
  return taa::replayLength(player_.state(), player_.checkpoints(), frame);
}

int InspectedShot::nearestCached(int frame) const {
  return taa::nearestCached(player_.state(), player_.checkpoints(), frame);
}

std::size_t InspectedShot::checkpointBudget() const {
  return player_.budget();
}

void InspectedShot::setCheckpointBudget(std::size_t bytes) {
  player_.setBudget(bytes);
}

void InspectedShot::setInputsBudget(std::size_t bytes) {
  player_.maker().keptInputs.setBudget(bytes);
}

bool InspectedShot::areAllExact() const {
  return player_.isExact();
}

std::vector<int> InspectedShot::keptFrames() const {
  std::vector<int> frames = player_.checkpoints().front().frames();
  std::erase_if(frames, [&](int frame) {
    return !std::ranges::all_of(player_.checkpoints(),
                                [&](const Checkpoints& kept) { return kept.at(frame) != nullptr; });
  });
  return frames;
}

std::vector<std::string> InspectedShot::cameras() const {
  if (capture()) return {kCaptureCamera};
  std::vector<std::string> names = cameraNames(scene());
  for (const CameraTrackHandle& track : player_.state().tracks) names.push_back(track->name);
  return names;
}

const std::string& InspectedShot::camera() const {
  return player_.state().camera;
}

FrameCameraPair InspectedShot::shownCameras(int lane) const {
  return player_.state().cameras(static_cast<std::size_t>(lane), frame());
}

void InspectedShot::setCamera(const std::string& name) {
  assert(player_.isOpen());
  if (name == camera()) return;
  requireScene();
  ShotState next = player_.state();
  next.camera = name;
  player_.redrawAll(std::move(next), false);
}

const std::vector<MotionOverride>& InspectedShot::motionModes() const {
  return player_.state().motionModes;
}

void InspectedShot::setMotionModes(const std::vector<MotionOverride>& modes) {
  assert(player_.isOpen());
  if (modes == motionModes()) return;
  requireScene();
  checkMotionOverrides(scene(), modes);
  ShotState next = player_.state();
  next.motionModes = modes;
  player_.redrawAll(std::move(next), true);
}

const ObjectFilter& InspectedShot::objectFilter() const {
  return player_.state().filter;
}

void InspectedShot::setObjectFilter(const ObjectFilter& filter) {
  assert(player_.isOpen());
  if (filter == objectFilter()) return;
  requireScene();
  checkObjectFilter(scene(), filter);
  ShotState next = player_.state();
  next.filter = filter;
  player_.redrawAll(std::move(next), true);
}

const std::vector<ClassOverride>& InspectedShot::objectClasses() const {
  return player_.state().objectClasses;
}

void InspectedShot::setObjectClasses(const std::vector<ClassOverride>& classes) {
  assert(player_.isOpen());
  if (classes == objectClasses()) return;
  requireScene();
  checkClassOverrides(scene(), classes);
  ShotState next = player_.state();
  next.objectClasses = classes;
  player_.redrawAll(std::move(next), true);
}

const std::vector<int>& InspectedShot::restarts() const {
  return player_.state().restarts;
}

void InspectedShot::setRestarts(std::vector<int> frames) {
  assert(player_.isOpen());
  checkRestarts(frames, frameCount());
  std::ranges::sort(frames);
  frames.erase(std::ranges::unique(frames).begin(), frames.end());
  std::erase(frames, 0); // history starts there anyway
  std::vector<int> changed;
  std::ranges::set_symmetric_difference(frames, restarts(), std::back_inserter(changed));
  if (changed.empty()) return;
  ShotState next = player_.state();
  next.restarts = std::move(frames);
  player_.follow(std::move(next), changed.front(), true);
}

const std::vector<CameraTrackHandle>& InspectedShot::cameraTracks() const {
  return player_.state().tracks;
}

void InspectedShot::setCameraTrack(CameraTrack track) {
  assert(player_.isOpen());
  requireScene();
  checkCameraTrack(track);
  requireNewCamera(scene(), track.name);
  ShotState next = player_.state();
  const CameraTrackHandle old = next.track();
  if (old && *old == track) return; // another handle would make other references of the same pictures
  const auto made = std::make_shared<const CameraTrack>(std::move(track));
  const auto known = std::ranges::find_if(
      next.tracks, [&](const CameraTrackHandle& handle) { return handle->name == made->name; });
  if (known == next.tracks.end())
    next.tracks.push_back(made);
  else
    *known = made;
  next.camera = made->name;
  constexpr int kNever = std::numeric_limits<int>::max();
  player_.follow(std::move(next), old ? firstDifference(*old, *made).value_or(kNever) : 0);
}

void InspectedShot::setFlownCameras(const FlownCameras& cameras) {
  assert(player_.isOpen());
  if (capture() && cameras.tracks.empty() && cameras.camera == camera()) return;
  requireScene();
  ShotState next = player_.state();
  next.tracks.clear();
  std::vector<std::string> names = cameraNames(scene());
  for (const CameraTrack& track : cameras.tracks) {
    checkCameraTrack(track);
    if (std::ranges::count(names, track.name) > 0)
      throw Error(say<"there is a camera called \"%1\" already; give the path another name">(track.name));
    names.push_back(track.name);
    next.tracks.push_back(std::make_shared<const CameraTrack>(track));
  }
  if (std::ranges::count(names, cameras.camera) == 0)
    throw Error(say<"there is no camera called \"%1\"">(cameras.camera));
  next.camera = cameras.camera;
  const CameraTrackHandle now = next.track(), old = player_.state().track();
  const bool isSame = now && old ? now->firstFrame == old->firstFrame && now->poses == old->poses
                                 : !now && !old && next.camera == camera();
  player_.follow(std::move(next), isSame ? std::numeric_limits<int>::max() : 0);
}

CameraPose InspectedShot::cameraPose() const {
  if (const CameraTrackHandle track = player_.state().track()) return track->at(frame());
  return poseOf(player_.state().frames->camera(player_.state().request(0), frame()));
}

void InspectedShot::prepare(const Settings& settings, int lane) {
  if (player_.isOpen() && !profiler_.isProfiling()) player_.prepare(used(settings), lane);
}

void InspectedShot::prepareInBackground(const Settings& settings, int lane) {
  const Settings counting = used(settings);
  if (!player_.isOpen() || !sameInputs(counting, usedSettings(lane))) return;
  compiler_.want({counting, {width(), height()}, player_.maker().rowsToExpose(counting)});
}

bool InspectedShot::waitUntilPrepared(std::chrono::milliseconds duration) {
  return compiler_.waitFor(duration);
}

void InspectedShot::reloadShaders() {
  const auto before = useShaders(readShaders());
  try {
    Visualizer fresh = visualizer_.reloaded();
    player_.reloadShaders();
    visualizer_ = std::move(fresh);
    reference_.forget();
  } catch (...) {
    useShaders(before); // whatever is compiled later goes on with these
    throw;
  }
}

} // namespace taa
