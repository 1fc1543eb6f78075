#include "app/session/Renderer.h"

#include <string>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

class ThreadRenderer final : public Renderer {
 public:
  explicit ThreadRenderer(RenderListener listener) : thread_(std::move(listener)) {}

  void open(const std::string& source) override { thread_.open(source); }
  void setSize(int width, int height) override { thread_.setSize(width, height); }
  void setCamera(const std::string& name) override { thread_.setCamera(name); }
  void setMotionModes(const std::vector<MotionOverride>& modes) override { thread_.setMotionModes(modes); }
  void setSettings(const Settings& settings) override { thread_.setSettings(settings); }
  void prepare(const Settings& settings) override { thread_.prepare(settings); }
  void setPlaying(bool playing) override { thread_.setPlaying(playing); }
  void setLooping(bool looping) override { thread_.setLooping(looping); }
  void seek(int frame) override { thread_.seek(frame); }
  void step(int frames) override { thread_.step(frames); }
  void setViews(const std::vector<ViewRequest>& views) override { thread_.setViews(views); }
  void setPins(const PinWish& pins) override { thread_.setPins(pins); }
  void setCheckpointBudget(std::size_t bytes) override { thread_.setCheckpointBudget(bytes); }
  void setProfiling(bool profiling) override { thread_.setProfiling(profiling); }
  void measureStages() override { thread_.measureStages(); }
  void setThumbnails(int width, int height) override { thread_.setThumbnails(width, height); }
  void setReferenceSamples(int samples) override { thread_.setReferenceSamples(samples); }
  void setFigures(const std::vector<Figure>& figures) override { thread_.setFigures(figures); }
  void setOtherLanes(const std::vector<Settings>& lanes) override { thread_.setOtherLanes(lanes); }
  void reloadShaders() override { thread_.reloadShaders(); }
  void cancel() override { thread_.cancel(); }
  void setTracing(bool tracing) override { thread_.setTracing(tracing); }
  void fillTraces(int first, int last) override { thread_.fillTraces(first, last); }
  void setPlayback(const Playback& playback) override { thread_.setPlayback(playback); }
  void exportSequence(const SequenceRequest& request) override { thread_.exportSequence(request); }
  void setObjectFilter(const ObjectFilter& filter) override { thread_.setObjectFilter(filter); }
  void setObjectClasses(const std::vector<ClassOverride>& classes) override {
    thread_.setObjectClasses(classes);
  }
  void setRestarts(const std::vector<int>& frames) override { thread_.setRestarts(frames); }
  void fly(const CameraPose& pose, RenderThread::Clock::duration took) override { thread_.fly(pose, took); }
  void setRecording(bool recording) override { thread_.setRecording(recording); }
  void addCameraTrack(const CameraTrack& track) override { thread_.addCameraTrack(track); }
  void setFlownCameras(const FlownCameras& cameras) override { thread_.setFlownCameras(cameras); }
  void locate(const std::vector<int>& objects) override { thread_.locate(objects); }
  RequestId lastRequest() override { return thread_.lastRequest(); }

 private:
  RenderThread thread_;
};

} // namespace

std::unique_ptr<Renderer> makeRenderThread(RenderListener listener) {
  return std::make_unique<ThreadRenderer>(std::move(listener));
}

} // namespace taa::app
