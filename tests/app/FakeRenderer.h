// A renderer without GL for tests of the window: answers at once with values that can be predicted.
#pragma once

#include "app/session/Renderer.h"
#include "core/base/ListsOf.h"
#include "tests/app/verdict/FakeVerdict.h"

#include <cstdint>
#include <optional>

namespace taa::app::test {

/// A source that ends so is opened as a capture with the output of its engine, of 64×36 pixels too.
inline constexpr const char* kFakeCapture = "/captured";

/// Has two animations.
inline constexpr const char* kFakeAnimated = "builtin:animated";

/// Draws this many triangles, and is refused by a budget of fewer.
inline constexpr const char* kFakeLarge = "builtin:large";
inline constexpr std::uint64_t kTrianglesOfLarge = 30'000'000;

/// Remembers what was asked of it and not refused: all<T>(). The value of every channel at pixel (x, y) of
/// frame n is x + 100·y + n, and 10,000 more for each lane; stages have rejected n % of its pixels, and the
/// value of each metric is 0.01·n.
class FakeRenderer final : public Renderer, public ListsOf<Request> {
 public:
  explicit FakeRenderer(Listener listener);
  ~FakeRenderer() override;

  static float valueAt(int x, int y, int frame) { return static_cast<float>(x + 100 * y + frame); }

  /// Levels of the pictures: of a view, of its other side, of a difference.
  static constexpr int kGray = 160, kOtherGray = 80, kDifferenceGray = 240;

  RequestId post(Request request) override;
  void tell(Result result) const; ///< as the render thread would

  /// The last one of its type, which is in force; as it is by default where nobody asked.
  template <class T>
  const T& last() const {
    static const T kDefault{};
    return all<T>().empty() ? kDefault : all<T>().back();
  }

  Status status;
  bool holdsBack = false;                  ///< does what is asked and answers nothing
  VerdictDelivery verdict = fakeVerdict(); ///< its answer, remedies and reason, for whatever is probed
  RequestId requests = 0;                  ///< so far
  /// The next request of this kind is answered with an error and nothing else.
  std::optional<RequestKind> refused;
  void deliver(); ///< all that there is

 private:
  template <class Value>
  void set(Value& value, const Value& asked) {
    value = asked;
    deliver();
  }
  void take(const request::Open& asked);
  void take(const request::SetSize& asked);
  void take(const request::SetSettings& asked);
  void take(const request::Seek& asked);
  void take(const request::MeasureStages&);
  void take(const request::AddCameraTrack& asked);
  void take(const request::SetFlownCameras& asked);
  void take(const request::Locate& asked);
  void take(const request::FindWorst& asked);
  void take(const request::FillTraces& asked);
  void take(const request::SetVerdicts&) {
    if (!holdsBack) deliverVerdict();
  }
  void take(const request::SetCamera& asked) { set(status.camera, asked.name); }
  void take(const request::SetMotionModes& asked) { set(status.motionModes, asked.modes); }
  void take(const request::SetPlaying& asked) { set(status.playing, asked.playing); }
  void take(const request::SetCheckpointBudget& asked) { set(status.checkpointBudget, asked.bytes); }
  void take(const request::SetReferenceSamples& asked) { set(status.referenceGoal, asked.samples); }
  void take(const request::SetPlayback& asked) { set(status.playback, asked.playback); }
  void take(const request::SetObjectFilter& asked) { set(status.filter, asked.filter); }
  void take(const request::SetObjectClasses& asked) { set(status.objectClasses, asked.classes); }
  void take(const request::SetRestarts& asked) { set(status.restarts, asked.frames); }
  void take(const request::SetRecording& asked) { set(status.recording, asked.on); }
  void take(const request::Step& asked) { take(request::Seek{status.info.frame + asked.frames}); }
  void take(const request::Fly& asked) { take(request::AddCameraTrack{{kFreeCamera, 0, {asked.pose}}}); }
  void take(const request::SetViews&) { deliver(); }
  void take(const request::SetProbes&) { deliver(); }
  void take(const request::SetThumbnails&) { deliver(); }
  void take(const request::SetMetrics&) { deliver(); }
  void take(const request::SetOtherLanes&) { deliver(); }
  void take(const request::SetLineage&) { deliver(); }
  void take(const request::SetTracing&) { deliver(); }
  void take(const auto&) {} ///< only remembered
  bool refuses(RequestKind kind);
  const Probe* activeProbe() const;
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
