// What the render thread does with the scene: hides objects, flies and records a camera, finds objects.
#include "core/RenderWorker.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace taa {

namespace {

/// "Recorded 1", or the first number that is free.
std::string freeName(const std::vector<std::string>& cameras) {
  for (int number = 1;; ++number)
    if (std::string name = "Recorded " + std::to_string(number); std::ranges::count(cameras, name) == 0)
      return name;
}

/// Where pixels of `ids` that hold one of `objects` are.
ObjectArea areaOf(const Image& ids, const std::vector<int>& objects) {
  const std::unordered_set<int> wanted(objects.begin(), objects.end());
  ObjectArea area;
  area.objects = objects;
  glm::dvec2 sum(0.0);
  glm::ivec2 low(ids.width, ids.height), high(-1);
  std::vector<glm::ivec2> found;
  for (int y = 0; y < ids.height; ++y)
    for (int x = 0; x < ids.width; ++x) {
      if (!wanted.contains(static_cast<int>(*ids.at(x, y)))) continue;
      found.emplace_back(x, y);
      sum += glm::dvec2(x, y);
      low = glm::min(low, glm::ivec2(x, y));
      high = glm::max(high, glm::ivec2(x, y));
    }
  if (found.empty()) return area;
  area.pixels = static_cast<int>(found.size());
  area.box = {low.x, low.y, high.x - low.x + 1, high.y - low.y + 1};
  const glm::dvec2 middle = sum / static_cast<double>(found.size());
  area.pixel = *std::ranges::min_element(found, {}, [&](const glm::ivec2& pixel) {
    const glm::dvec2 away = glm::dvec2(pixel) - middle;
    return away.x * away.x + away.y * away.y;
  });
  return area;
}

} // namespace

void RenderWorker::applyScene(const Wishes& wishes) {
  const SceneWishes& scene = wishes.scene;
  if (scene.located) {
    located_ = *scene.located;
    areaDelivered_ = 0;
  }
  if (!isOpen()) return;
  if (scene.filter && !(*scene.filter == inspector_.objectFilter()))
    change([&] { inspector_.setObjectFilter(*scene.filter); });
  if (scene.classes && *scene.classes != inspector_.objectClasses())
    change([&] { inspector_.setObjectClasses(*scene.classes); });
  if (scene.restarts && *scene.restarts != inspector_.restarts())
    change([&] { inspector_.setRestarts(*scene.restarts); });
  if (scene.recording) change([&] { setRecording(*scene.recording); });
  if (!scene.pose) return;
  flight_.pose.reset();
  if (playing_)
    flight_.pose = scene.pose; // of the next frame
  else
    change([&] { fly(*scene.pose); });
}

// At rest: a recording gives the pose to the frame on show and to those after it; else all frames have it.
void RenderWorker::fly(const CameraPose& pose) {
  if (flight_.recorded.empty()) return inspector_.setCameraTrack({kFreeCamera, 0, {pose}});
  layTrack(inspector_.frame(), pose);
}

void RenderWorker::setRecording(bool recording) {
  if (recording == !flight_.recorded.empty()) return;
  if (!recording) return flight_.recorded.clear();
  // What was flown up to here belongs to it, so that the frame on show stays what it is.
  CameraTrack track{"", inspector_.frame(), {inspector_.cameraPose()}};
  const CameraTrackHandle flown = currentTrack();
  if (flown && flown->firstFrame <= inspector_.frame()) track = *flown;
  std::string name = freeName(inspector_.cameras());
  track.name = name;
  track.put(inspector_.frame(), inspector_.cameraPose());
  inspector_.setCameraTrack(std::move(track));
  flight_.recorded = std::move(name);
}

CameraTrackHandle RenderWorker::currentTrack() const {
  for (const CameraTrackHandle& track : inspector_.cameraTracks())
    if (track->name == inspector_.camera()) return track;
  return nullptr;
}

// Gives `frame`, the one on show or the next one, a pose; what is flown starts from where the camera is.
void RenderWorker::layTrack(int frame, const CameraPose& pose) {
  const std::string name = flight_.recorded.empty() ? kFreeCamera : flight_.recorded;
  CameraTrack track{name, inspector_.frame(), {inspector_.cameraPose()}};
  // One that begins later was begun before somebody jumped here.
  const CameraTrackHandle flown = currentTrack();
  if (flown && flown->name == name && flown->firstFrame <= inspector_.frame()) track = *flown;
  track.put(frame, pose);
  inspector_.setCameraTrack(std::move(track));
  // What is known of the frames up to here stays true; of those to come nothing is once they were dropped.
  if (!std::exchange(flight_.isLaying, true)) ++subject_;
}

// Somebody jumps, stops or starts again: a recording is done, and a camera that was only flown rests where it
// is, in all frames.
void RenderWorker::endFlight() {
  flight_.isLaying = false;
  if (!flight_.recorded.empty()) statusChanged_ = true;
  flight_.recorded.clear();
  if (!isOpen() || inspector_.camera() != kFreeCamera) return flight_.pose.reset();
  const CameraPose pose = flight_.pose.value_or(inspector_.cameraPose());
  flight_.pose.reset();
  CameraTrack rests{kFreeCamera, 0, {pose}};
  if (*currentTrack() == rests) return;
  if (!attempt([&] { inspector_.setCameraTrack(std::move(rests)); })) return;
  ++version_;
  ++subject_;
  statusChanged_ = true;
}

// A recording goes on at rest; its last pose may not have had a frame yet.
void RenderWorker::pauseFlight() {
  flight_.isLaying = false;
  if (flight_.recorded.empty()) return endFlight();
  if (!flight_.pose || !attempt([&] { layTrack(inspector_.frame(), *flight_.pose); })) return;
  flight_.pose.reset();
  ++version_;
  statusChanged_ = true;
}

// Only of frames that it rests at: reading a whole picture back takes longer than a frame that plays may.
void RenderWorker::deliverArea() {
  if (located_.empty() || areaDelivered_ == version_ || playing_ || goal_) return;
  areaDelivered_ = version_;
  attempt([&] {
    ObjectArea area = areaOf(inspector_.image(IntermediateId::objectId), located_);
    area.frame = inspector_.frame();
    if (listener_.onObjectArea) listener_.onObjectArea(std::move(area));
  });
}

} // namespace taa
