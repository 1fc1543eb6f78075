// A renderer without GL for tests of the window: answers at once with values that can be predicted.
#pragma once

#include "app/session/Renderer.h"
#include "tests/app/verdict/FakeVerdict.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace taa::app::test {

/// A source that ends so is opened as a capture with the output of its engine, of 64×36 pixels too.
inline constexpr const char* kFakeCapture = "/captured";

/// Has two animations.
inline constexpr const char* kFakeAnimated = "builtin:animated";

/// Draws this many triangles, and is refused by a budget of fewer.
inline constexpr const char* kFakeLarge = "builtin:large";
inline constexpr std::uint64_t kTrianglesOfLarge = 30'000'000;

/// Remembers what was asked of it. The value of every channel at pixel (x, y) of frame n is x + 100·y + n,
/// and 10,000 more for each lane; stages have rejected n % of its pixels.
class FakeRenderer final : public Renderer {
 public:
  explicit FakeRenderer(Listener listener);
  ~FakeRenderer() override;

  static float valueAt(int x, int y, int frame) { return static_cast<float>(x + 100 * y + frame); }

  /// Levels of the pictures: of a view, of its other side, of a difference.
  static constexpr int kGray = 160, kOtherGray = 80, kDifferenceGray = 240;

  RequestId post(Request request) override;
  void tell(Result result) const; ///< as the render thread would

  Status status;
  SceneBudget sceneBudget;
  std::vector<ViewRequest> views;
  request::SetProbes probes;        ///< wanted
  std::optional<Settings> prepared; ///< the last ones
  bool holdsBack = false;           ///< does what is asked and answers nothing
  bool isLooping = true, profiling = false, tracing = false;
  request::TraceInIdleTime idleTraces;     ///< only noted
  glm::ivec2 thumbnails{0};                ///< size wanted
  std::vector<Metric> metrics;             ///< wanted; the value of each is 0.01 times the frame
  bool verdicts = false;                   ///< wanted
  VerdictDelivery verdict = fakeVerdict(); ///< its answer, remedies and reason, for whatever is probed
  std::vector<Settings> otherLanes;
  std::optional<SequenceRequest> exported;
  std::vector<int> located; ///< objects
  std::vector<request::FindWorst> worstAsked;
  int lineageFrames = 0;  ///< wanted
  RequestId requests = 0; ///< so far
  /// The next request of this kind is answered with an error and nothing else.
  std::optional<RequestKind> refused;
  int reloads = 0, cancels = 0, settingsSent = 0;
  void deliver(); ///< all that there is

 private:
  void take(const request::Open& asked);
  void take(const request::SetSize& asked);
  void take(const request::SetCamera& asked);
  void take(const request::SetMotionModes& asked);
  void take(const request::SetSettings& asked);
  void take(const request::SetPlaying& asked);
  void take(const request::Seek& asked);
  void take(const request::SetViews& asked);
  void take(const request::SetProbes& asked);
  void take(const request::SetCheckpointBudget& asked);
  void take(const request::SetSceneBudget& asked);
  void take(const request::MeasureStages&);
  void take(const request::SetThumbnails& asked);
  void take(const request::SetReferenceSamples& asked);
  void take(const request::SetMetrics& asked);
  void take(const request::SetOtherLanes& asked);
  void take(const request::SetPlayback& asked);
  void take(const request::SetObjectFilter& asked);
  void take(const request::SetObjectClasses& asked);
  void take(const request::SetRestarts& asked);
  void take(const request::SetRecording& asked);
  void take(const request::AddCameraTrack& asked);
  void take(const request::SetFlownCameras& asked);
  void take(const request::Locate& asked);
  void take(const request::FindWorst& asked);
  void take(const request::SetLineage& asked);
  void take(const request::SetTracing& asked);
  void take(const request::FillTraces& asked);
  void take(const request::TraceInIdleTime& asked) { idleTraces = asked; }
  void take(const request::Prepare& asked) { prepared = asked.settings; }
  void take(const request::SetVerdicts& asked);
  void take(const request::SetPreviews&) {}
  void take(const request::SetLooping& asked) { isLooping = asked.looping; }
  void take(const request::Step& asked) { take(request::Seek{status.info.frame + asked.frames}); }
  void take(const request::SetProfiling& asked) { profiling = asked.on; }
  void take(const request::ReloadShaders&) { ++reloads; }
  void take(const request::Cancel&) { ++cancels; }
  void take(const request::ExportSequence& asked) { exported = asked.sequence; }
  void take(const request::Fly& asked) { take(request::AddCameraTrack{{kFreeCamera, 0, {asked.pose}}}); }
  bool refuses(RequestKind kind);
  void deliverThumbnails();
  void deliverTrace(const Probe& probe, int frame);
  void deliverProfile();
  void deliverMetrics();
  void deliverProbe(const Probe& probe);
  void deliverLineage();
  void deliverVerdict();
  ProbeSpot spotOf(const Probe& probe) const;
  ViewResult draw(int view) const;
  int frameOf(const OtherSide& other) const;
  void addAbsence(ViewResult& result) const;
  Image valuesOf(IntermediateId id, int lane, int frame) const;
  static Picture gray(const ViewRequest& request, int level);

  Listener listener_;
};

} // namespace taa::app::test
