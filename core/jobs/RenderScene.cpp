// What the render thread does with the scene: hides objects, flies and records a camera, finds objects.
#include "core/jobs/RenderWorker.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <optional>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

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
  if (scene.filter && !(*scene.filter == inspector_.shot().objectFilter()))
    change(RequestKind::Objects, [&] { inspector_.shot().setObjectFilter(*scene.filter); });
  if (scene.classes && *scene.classes != inspector_.shot().objectClasses())
    change(RequestKind::Classes, [&] { inspector_.shot().setObjectClasses(*scene.classes); });
  if (scene.restarts && *scene.restarts != inspector_.shot().restarts())
    change(RequestKind::Restarts, [&] { inspector_.shot().setRestarts(*scene.restarts); });
  applyFlight(wishes);
}

// A recording has all poses that were flown while it went on, also where its beginning and its end are taken
// up together; what is on show has the last one.
void RenderWorker::applyFlight(const ShotWishes& wishes) {
  const std::vector<FlownPose>& poses = wishes.scene.poses;
  const auto record = [&] {
    for (const FlownPose& flown : poses) flight_.recording->moveTo(flown.pose, flown.at, flown.took);
  };
  if (flight_.recording) record();
  std::vector<RecordingWish> recordings = wishes.earlierRecordings;
  if (wishes.scene.recording) recordings.push_back(*wishes.scene.recording);
  bool isLastRecorded = false;
  for (const RecordingWish& wish : recordings) {
    if (wish.on && !flight_.recording) {
      if (change(RequestKind::Recording, [&] { beginRecording(wish.at); })) record();
    } else if (!wish.on && flight_.recording) {
      endRecording(wish.at);
      isLastRecorded = !poses.empty() && poses.back().at <= wish.at;
    }
  }
  if (poses.empty() || isLastRecorded) return;
  const CameraPose& pose = poses.back().pose;
  flight_.pose.reset();
  if (playing_)
    flight_.pose = pose; // of the next frame
  else
    change(RequestKind::Flight, [&] { inspector_.shot().setCameraTrack({kFreeCamera, 0, {pose}}); });
}

// What was flown up to here belongs to it, so that the frame on show stays what it is.
void RenderWorker::beginRecording(Clock::time_point at) {
  const int frame = goal_.value_or(inspector_.shot().frame()), end = inspector_.shot().frameCount() - 1;
  const auto [first, last] = playedFrames();
  if (frame >= end)
    throw Error(say<"cannot record a flight at frame %1, which is the last one: go to another frame">(frame));
  CameraTrack track{"", frame, {inspector_.shot().cameraPose()}};
  const CameraTrackHandle flown = currentTrack();
  if (flown && flown->firstFrame <= frame) track = *flown;
  track.name = freeName(inspector_.shot().cameras());
  track.put(frame, inspector_.shot().cameraPose());
  inspector_.shot().setCameraTrack(track);
  flight_.recorded = std::move(track);
  flight_.recording.emplace(frame, frame >= first && frame < last ? last : end,
                            inspector_.shot().cameraPose(), at);
  flight_.recording->setRate(playedPerSecond(), at);
  flight_.playsAfter = playing_;
  setPlaying(true);
}

// Goes to the frame it ended at: how many of them could be shown meanwhile depends on the machine.
void RenderWorker::endRecording(Clock::time_point at) {
  const FlightRecording recording = *std::exchange(flight_.recording, {});
  const std::vector<CameraPose> poses = recording.poses(at);
  CameraTrack track = std::move(flight_.recorded);
  int frame = recording.firstFrame() - 1;
  for (const CameraPose& pose : poses) track.put(++frame, pose);
  change(RequestKind::Recording, [&] { inspector_.shot().setCameraTrack(std::move(track)); });
  flight_.pose.reset();
  flight_.isLaying = false;
  goal_ = frame;
  isNear_ = false;
  setPlaying(flight_.playsAfter);
}

CameraTrackHandle RenderWorker::currentTrack() const {
  for (const CameraTrackHandle& track : inspector_.shot().cameraTracks())
    if (track->name == inspector_.shot().camera()) return track;
  return nullptr;
}

// Gives the next frame a pose; what is flown starts from where the camera is. Until a recording is done its
// camera has the poses that were on show.
void RenderWorker::layTrack(int frame, const CameraPose& pose) {
  const std::string name = flight_.recording ? flight_.recorded.name : kFreeCamera;
  CameraTrack track{name, inspector_.shot().frame(), {inspector_.shot().cameraPose()}};
  // One that begins later was begun before somebody jumped here.
  const CameraTrackHandle flown = currentTrack();
  if (flown && flown->name == name && flown->firstFrame <= inspector_.shot().frame()) track = *flown;
  track.put(frame, pose);
  inspector_.shot().setCameraTrack(std::move(track));
  // What is known of the frames up to here stays true; of those to come nothing is once they were dropped.
  if (!std::exchange(flight_.isLaying, true)) ++subject_;
}

// Somebody jumps, pauses or opens another scene: a recording is done, and a camera that was only flown rests
// where it is, in all frames.
void RenderWorker::endFlight() {
  if (flight_.recording) return endRecording(now_());
  flight_.isLaying = false;
  if (!isOpen() || inspector_.shot().camera() != kFreeCamera) return flight_.pose.reset();
  const CameraPose pose = flight_.pose.value_or(inspector_.shot().cameraPose());
  flight_.pose.reset();
  CameraTrack rests{kFreeCamera, 0, {pose}};
  if (*currentTrack() == rests) return;
  if (!attempt(RequestKind::Flight, [&] { inspector_.shot().setCameraTrack(std::move(rests)); })) return;
  noteChange(RequestKind::Flight);
}

// Only of frames that it rests at: reading a whole picture back takes longer than a frame that plays may.
void RenderWorker::deliverArea() {
  if (located_.empty() || areaDelivered_ == version_ || playing_ || goal_) return;
  areaDelivered_ = version_;
  attempt(RequestKind::Objects, [&] {
    ObjectArea area = areaOf(inspector_.views().image(IntermediateId::objectId), located_);
    area.frame = inspector_.shot().frame();
    if (listener_.onObjectArea) listener_.onObjectArea(std::move(area));
  });
}

} // namespace taa
