// What the session asks of the thread that renders; tests put a synthetic one in its place.
#pragma once

#include "core/RenderThread.h"

#include <memory>
#include <string>
#include <vector>

namespace taa::app {

/// As RenderThread: every member returns at once, answers come through the listener on another thread.
class Renderer {
 public:
  Renderer() = default;
  virtual ~Renderer() = default;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  virtual void open(const std::string& source) = 0;
  virtual void setSize(int width, int height) = 0;
  virtual void setCamera(const std::string& name) = 0;
  virtual void setMotionModes(const std::vector<MotionOverride>& modes) = 0;
  virtual void setSettings(const Settings& settings) = 0;
  virtual void prepare(const Settings& settings) = 0;
  virtual void setPlaying(bool playing) = 0;
  virtual void setLooping(bool looping) = 0;
  virtual void seek(int frame) = 0;
  virtual void step(int frames) = 0;
  virtual void setViews(const std::vector<ViewRequest>& views) = 0;
  virtual void setPins(const PinWish& pins) = 0;
  virtual void setCheckpointBudget(std::size_t bytes) = 0;
  virtual void setProfiling(bool profiling) = 0;
  virtual void measureStages() = 0;
  virtual void setThumbnails(int width, int height) = 0;
  virtual void setReferenceSamples(int samples) = 0;
  virtual void setFigures(const std::vector<Figure>& figures) = 0;
  virtual void setOtherLanes(const std::vector<Settings>& lanes) = 0;
  virtual void reloadShaders() = 0;
  virtual void cancel() = 0;
  virtual void setTracing(bool tracing) = 0;
  virtual void fillTraces(int first, int last) = 0;
  virtual void setPlayback(const Playback& playback) = 0;
  virtual void exportSequence(const SequenceRequest& request) = 0;
  virtual void setObjectFilter(const ObjectFilter& filter) = 0;
  virtual void setObjectClasses(const std::vector<ClassOverride>& classes) = 0;
  virtual void setRestarts(const std::vector<int>& frames) = 0;
  virtual void fly(const CameraPose& pose, RenderThread::Clock::duration took) = 0;
  virtual void setRecording(bool recording) = 0;
  virtual void addCameraTrack(const CameraTrack& track) = 0;
  virtual void setFlownCameras(const FlownCameras& cameras) = 0;
  virtual void locate(const std::vector<int>& objects) = 0;
  /// Of what was called last.
  virtual RequestId lastRequest() = 0;
};

/// The real one.
std::unique_ptr<Renderer> makeRenderThread(RenderListener listener);

} // namespace taa::app
