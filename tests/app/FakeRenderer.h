// A renderer without GL for tests of the window: answers at once with values that can be predicted.
#pragma once

#include "app/session/Renderer.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::app::test {

/// Remembers what was asked of it. The value of every channel at pixel (x, y) of frame n is x + 100·y + n,
/// and 10,000 more for each lane; stages have rejected n % of its pixels.
class FakeRenderer final : public Renderer {
 public:
  explicit FakeRenderer(RenderListener listener) : listener_(std::move(listener)) {}

  static float valueAt(int x, int y, int frame) { return static_cast<float>(x + 100 * y + frame); }

  /// Levels of the pictures: of a view, of its other side, of a difference.
  static constexpr int kGray = 160, kOtherGray = 80, kDifferenceGray = 240;

  void open(const std::string& source) override;
  void setSize(int width, int height) override;
  void setCamera(const std::string& name) override;
  void setMotionModes(const std::vector<MotionOverride>& modes) override;
  void setSettings(const Settings& settings) override;
  void prepare(const Settings& settings) override { prepared = settings; }
  void setPlaying(bool playing) override;
  void setLooping(bool looping) override { isLooping = looping; }
  void seek(int frame) override;
  void step(int frames) override { seek(status.info.frame + frames); }
  void setViews(const std::vector<ViewRequest>& wanted) override;
  void setPins(const PinWish& wanted) override;
  void setCheckpointBudget(std::size_t bytes) override;
  void setProfiling(bool wanted) override { profiling = wanted; }
  void measureStages() override;
  void setThumbnails(int width, int height) override;
  void setReferenceSamples(int samples) override;
  void setFigures(const std::vector<Figure>& wanted) override;
  void setOtherLanes(const std::vector<Settings>& lanes) override;
  void reloadShaders() override { ++reloads; }
  void cancel() override { ++cancels; }
  void setPlayback(const Playback& playback) override;
  void exportSequence(const SequenceRequest& request) override { exported = request; }
  void setObjectFilter(const ObjectFilter& filter) override;
  void setObjectClasses(const std::vector<ClassOverride>& classes) override;
  void setRestarts(const std::vector<int>& frames) override;
  void fly(const CameraPose& pose, RenderThread::Clock::duration took) override;
  void setRecording(bool recording) override;
  void addCameraTrack(const CameraTrack& track) override;
  void setFlownCameras(const FlownCameras& cameras) override;
  void locate(const std::vector<int>& objects) override;
  RequestId lastRequest() override { return ++requests; }
  void setTracing(bool wanted) override;
  void fillTraces(int first, int last) override;

  Status status;
  std::vector<ViewRequest> views;
  std::vector<ProbePin> pins;
  PinWish pinWish;
  std::optional<Settings> prepared; ///< the last ones
  bool holdsBack = false;           ///< does what is asked and answers nothing
  bool isLooping = true, profiling = false, tracing = false;
  glm::ivec2 thumbnails{0};    ///< size wanted
  std::vector<Figure> figures; ///< wanted; the value of each is 0.01 times the frame
  std::vector<Settings> otherLanes;
  std::optional<SequenceRequest> exported;
  std::vector<int> located;           ///< objects
  RequestId requests = 0;             ///< so far
  std::optional<RequestKind> refused; ///< answers the next wish of this kind with an error and nothing else
  int reloads = 0, cancels = 0, settingsSent = 0;
  const RenderListener& listener() const { return listener_; }
  void deliver(); ///< all that there is

 private:
  bool refuses(RequestKind kind);
  void deliverThumbnails();
  void deliverTrace(const ProbePin& pin, int frame);
  void deliverProfile();
  void deliverFigures();
  void deliverPin(const ProbePin& pin);
  ViewResult draw(int view) const;
  Image valuesOf(IntermediateId id, int lane, int frame) const;
  static Picture gray(const ViewRequest& request, int level);

  RenderListener listener_;
};

} // namespace taa::app::test
