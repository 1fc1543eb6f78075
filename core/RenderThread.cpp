#include "core/RenderThread.h"

#include "core/jobs/RenderWorker.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace taa {

struct RenderThread::Parts {
  RenderListener listener;
  ClockNow now;
  std::mutex mutex; // held for a moment only: never while GL works or the listener is called
  std::condition_variable wished, answered;
  Wishes wishes;
  std::uint64_t posted = 0, done = 0; // wishes so far, and how many of them are answered
  std::atomic<bool> ends = false;
  std::thread thread;

  template <typename Change>
  void post(RequestKind kind, Change change);
  void run();
  void runWorker();
  bool takeWishes(Wishes& taken, RenderWorker* worker);
  bool pending(bool (*question)(const Wishes&));
};

template <typename Change>
void RenderThread::Parts::post(RequestKind kind, Change change) {
  {
    const std::lock_guard lock(mutex);
    change(wishes);
    wishes.latest.of(kind) = ++posted;
  }
  wished.notify_one();
}

bool RenderThread::Parts::pending(bool (*question)(const Wishes&)) {
  const std::lock_guard lock(mutex);
  return question(wishes);
}

// Waits until there is something to do; false at the end. Without a worker wishes are taken and forgotten.
bool RenderThread::Parts::takeWishes(Wishes& taken, RenderWorker* worker) {
  std::unique_lock lock(mutex);
  const auto hasNews = [&] { return ends || !wishes.isEmpty(); };
  if (!hasNews() && !(worker && worker->hasGoal())) {
    done = posted;
    answered.notify_all();
    if (const auto wakeAt = worker ? worker->wakeAt() : std::nullopt)
      wished.wait_until(lock, *wakeAt, hasNews);
    else
      wished.wait(lock, hasNews);
  }
  taken = std::exchange(wishes, {});
  return !ends;
}

void RenderThread::Parts::run() {
  try {
    runWorker();
  } catch (const std::exception& error) { // no GL
    if (listener.onError) listener.onError({error.what()});
    Wishes ignored;
    while (takeWishes(ignored, nullptr)) continue;
  }
}

void RenderThread::Parts::runWorker() {
  RenderWorker worker(
      listener, [this](bool (*question)(const Wishes&)) { return pending(question); }, ends, now);
  worker.deliver();
  for (Wishes taken; takeWishes(taken, &worker);) {
    worker.apply(taken);
    worker.deliver();
    worker.work();
    worker.deliver();
    worker.useIdleTime();
  }
}

RenderThread::RenderThread(RenderListener listener, ClockNow now) : parts_(std::make_unique<Parts>()) {
  parts_->listener = std::move(listener);
  parts_->now = std::move(now);
  parts_->thread = std::thread([parts = parts_.get()] { parts->run(); });
}

RenderThread::~RenderThread() {
  {
    const std::lock_guard lock(parts_->mutex);
    parts_->ends = true;
  }
  parts_->wished.notify_one();
  parts_->thread.join();
}

void RenderThread::open(const std::string& source) {
  parts_->post(RequestKind::Source, [&](Wishes& wishes) { wishes.open(source); });
}

void RenderThread::setSize(int width, int height) {
  parts_->post(RequestKind::Size, [&](Wishes& wishes) { wishes.size = glm::ivec2(width, height); });
}

void RenderThread::setCamera(const std::string& name) {
  parts_->post(RequestKind::Camera, [&](Wishes& wishes) {
    wishes.camera = name;
    wishes.scene.poses.clear();
  });
}

void RenderThread::setMotionModes(const std::vector<MotionOverride>& modes) {
  parts_->post(RequestKind::MotionModes, [&](Wishes& wishes) { wishes.motionModes = modes; });
}

void RenderThread::setSettings(const Settings& settings) {
  parts_->post(RequestKind::Settings, [&](Wishes& wishes) { wishes.settings = settings; });
}

void RenderThread::prepare(const Settings& settings) {
  parts_->post(RequestKind::None, [&](Wishes& wishes) { wishes.prepared = settings; });
}

void RenderThread::setPlaying(bool playing) {
  parts_->post(RequestKind::Time, [&](Wishes& wishes) { wishes.playing = playing; });
}

void RenderThread::setLooping(bool looping) {
  parts_->post(RequestKind::Time, [&](Wishes& wishes) { wishes.looping = looping; });
}

void RenderThread::setPlayback(const Playback& playback) {
  parts_->post(RequestKind::Time, [&](Wishes& wishes) { wishes.playback = playback; });
}

void RenderThread::seek(int frame) {
  parts_->post(RequestKind::Time, [&](Wishes& wishes) {
    wishes.frame = frame;
    wishes.steps = 0;
  });
}

void RenderThread::step(int frames) {
  parts_->post(RequestKind::Time, [&](Wishes& wishes) {
    wishes.steps += frames;
    wishes.playing = false;
  });
}

void RenderThread::setViews(const std::vector<ViewRequest>& views) {
  parts_->post(RequestKind::Views, [&](Wishes& wishes) { wishes.views = views; });
}

void RenderThread::setPins(const PinWish& pins) {
  parts_->post(RequestKind::Probes, [&](Wishes& wishes) { wishes.pins = pins; });
}

void RenderThread::setCheckpointBudget(std::size_t bytes) {
  parts_->post(RequestKind::None, [&](Wishes& wishes) { wishes.checkpointBudget = bytes; });
}

void RenderThread::setProfiling(bool profiling) {
  parts_->post(RequestKind::Profile, [&](Wishes& wishes) { wishes.profiling = profiling; });
}

void RenderThread::measureStages() {
  parts_->post(RequestKind::Profile, [&](Wishes& wishes) { wishes.measureStages = true; });
}

void RenderThread::setThumbnails(int width, int height) {
  parts_->post(RequestKind::Thumbnails,
               [&](Wishes& wishes) { wishes.thumbnails = glm::ivec2(width, height); });
}

void RenderThread::setReferenceSamples(int samples) {
  parts_->post(RequestKind::Reference, [&](Wishes& wishes) { wishes.referenceSamples = samples; });
}

void RenderThread::setFigures(const std::vector<Figure>& figures) {
  parts_->post(RequestKind::Figures, [&](Wishes& wishes) { wishes.figures = figures; });
}

void RenderThread::setOtherLanes(const std::vector<Settings>& lanes) {
  parts_->post(RequestKind::Lanes, [&](Wishes& wishes) { wishes.otherLanes = lanes; });
}

void RenderThread::setObjectFilter(const ObjectFilter& filter) {
  parts_->post(RequestKind::Objects, [&](Wishes& wishes) { wishes.scene.filter = filter; });
}

void RenderThread::setObjectClasses(const std::vector<ClassOverride>& classes) {
  parts_->post(RequestKind::Classes, [&](Wishes& wishes) { wishes.scene.classes = classes; });
}

void RenderThread::setRestarts(const std::vector<int>& frames) {
  parts_->post(RequestKind::Restarts, [&](Wishes& wishes) { wishes.scene.restarts = frames; });
}

void RenderThread::fly(const CameraPose& pose, Clock::duration took) {
  const FlownPose flown{pose, parts_->now(), took};
  parts_->post(RequestKind::Flight, [&](Wishes& wishes) { wishes.scene.poses.push_back(flown); });
}

void RenderThread::setRecording(bool recording) {
  const RecordingWish wish{recording, parts_->now()};
  parts_->post(RequestKind::Recording, [&](Wishes& wishes) {
    if (wishes.scene.recording) wishes.earlierRecordings.push_back(*wishes.scene.recording);
    wishes.scene.recording = wish;
  });
}

void RenderThread::setFlownCameras(const FlownCameras& cameras) {
  parts_->post(RequestKind::FlownCameras, [&](Wishes& wishes) {
    wishes.scene.cameras = cameras;
    wishes.scene.tracks.clear();
    wishes.scene.poses.clear();
    wishes.camera.reset();
  });
}

void RenderThread::addCameraTrack(const CameraTrack& track) {
  parts_->post(RequestKind::FlownCameras, [&](Wishes& wishes) {
    wishes.scene.tracks.push_back(track);
    wishes.scene.poses.clear();
    wishes.camera.reset();
  });
}

void RenderThread::locate(const std::vector<int>& objects) {
  parts_->post(RequestKind::Objects, [&](Wishes& wishes) { wishes.scene.located = objects; });
}

void RenderThread::setTracing(bool tracing) {
  parts_->post(RequestKind::Traces, [&](Wishes& wishes) { wishes.tracing = tracing; });
}

void RenderThread::fillTraces(int first, int last) {
  parts_->post(RequestKind::Traces, [&](Wishes& wishes) { wishes.fillTraces = std::pair(first, last); });
}

void RenderThread::reloadShaders() {
  parts_->post(RequestKind::Shaders, [&](Wishes& wishes) { wishes.reload = true; });
}

void RenderThread::cancel() {
  parts_->post(RequestKind::None, [&](Wishes& wishes) { wishes.cancel = true; });
}

void RenderThread::exportSequence(const SequenceRequest& request) {
  parts_->post(RequestKind::Export, [&](Wishes& wishes) { wishes.exported = request; });
}

RequestId RenderThread::lastRequest() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->posted;
}

void RenderThread::waitUntilIdle() {
  std::unique_lock lock(parts_->mutex);
  const std::uint64_t upTo = parts_->posted;
  parts_->answered.wait(lock, [&] { return parts_->done >= upTo; });
}

} // namespace taa
