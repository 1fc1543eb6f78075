// What the render thread's errors, works and pictures say they are about.
#include "core/requests/RequestQueue.h"
#include "tests/support/Paths.h"
#include "tests/support/RenderRecorder.h"
#include "tests/support/ShaderFolder.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

using taa::IntermediateId;
using taa::test::otherJitter;
using taa::test::onThread::viewOf;

using RenderAnswersTest = taa::test::onThread::RenderThreadTest;

} // namespace

// An error is an answer to one request; what else was asked for is done.
TEST_F(RenderAnswersTest, AnErrorSaysWhatItAnswersAndNothingElseIsDropped) {
  const taa::RequestId settings = thread->post(taa::request::SetSettings{otherJitter()});
  taa::SequenceRequest bad;
  bad.target = "/dev/null/at/all.png"; // no folder can be made there, not even by root
  bad.picture.width = 8;
  bad.picture.height = 8;
  const taa::RequestId exported = thread->post(taa::request::ExportSequence{bad});
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::alpha)}});
  const taa::RequestId modes =
      thread->post(taa::request::SetMotionModes{{{"nobody", taa::MotionMode::None}}});
  thread->waitUntilIdle();
  EXPECT_LT(settings, exported);
  ASSERT_EQ(recorder.all<taa::Failure>().size(), 2u);
  // Some may be taken up together.
  std::ranges::sort(recorder.all<taa::Failure>(), {}, &taa::Failure::request);
  EXPECT_EQ(recorder.all<taa::Failure>()[0].kind, taa::RequestKind::Export);
  EXPECT_EQ(recorder.all<taa::Failure>()[0].request, exported);
  EXPECT_EQ(recorder.all<taa::Failure>()[1].kind, taa::RequestKind::MotionModes);
  EXPECT_EQ(recorder.all<taa::Failure>()[1].request, modes);
  EXPECT_EQ(recorder.all<taa::Status>().back().settings, otherJitter());
  EXPECT_EQ(recorder.all<taa::ViewResult>().back().request.id, IntermediateId::alpha);
}

TEST_F(RenderAnswersTest, AFailingShaderAnswersTheSettingsThatNeedIt) {
  taa::Settings wanted;
  taa::applyAssignment(wanted, "rectify.method=clamp");
  {
    const taa::test::ShaderFolder folder;
    folder.write("taa/resolve.frag", "#error no more\n");
    recorder.clear();
    const taa::RequestId refused = thread->post(taa::request::SetSettings{wanted});
    thread->post(taa::request::SetMotionModes{{{"rotor", taa::MotionMode::None}}});
    thread->waitUntilIdle();
    ASSERT_FALSE(recorder.all<taa::Failure>().empty());
    EXPECT_EQ(recorder.all<taa::Failure>()[0].kind, taa::RequestKind::Settings);
    EXPECT_EQ(recorder.all<taa::Failure>()[0].request, refused);
  }
  EXPECT_EQ(recorder.all<taa::Status>().back().settings, taa::Settings{}) << "says what is in force";
}

namespace {

/// What waits of a type, in its order.
template <typename Asked>
std::vector<Asked> waitingOf(const taa::RequestQueue& queue) {
  std::vector<Asked> found;
  for (const taa::PostedRequest& posted : queue.waiting())
    if (const Asked* asked = std::get_if<Asked>(&posted.request)) found.push_back(*asked);
  return found;
}

} // namespace

// What was asked of the scene before a missing file was asked for is still wanted of it.
TEST(RequestQueueTest, WhatWasAskedBeforeASourceCountsWhereThatIsRefused) {
  using namespace taa::request;
  taa::RequestQueue queue;
  taa::RequestId id = 0;
  const auto post = [&](taa::Request request) { queue.post({++id, std::move(request)}); };
  post(SetCamera{"pan"});
  post(SetMotionModes{{{"rotor", taa::MotionMode::None}}});
  post(SetObjectFilter{{{"wall"}, {}}});
  post(Seek{7});
  post(Step{2});
  post(Open{"missing.glb"});
  post(SetObjectFilter{{{"floor"}, {}}}); // newer
  post(Open{"missing too.glb"});
  EXPECT_EQ(waitingOf<SetObjectFilter>(queue).size(), 1u) << "the other was of one that is never opened";
  post(Step{1});
  const auto source = queue.takeSource();
  ASSERT_TRUE(source);
  EXPECT_EQ(source->source, "missing too.glb");
  taa::RequestQueue opened = queue;
  queue.settleSource(false);
  ASSERT_EQ(waitingOf<SetCamera>(queue).size(), 1u);
  EXPECT_EQ(waitingOf<SetCamera>(queue)[0].name, "pan");
  EXPECT_EQ(waitingOf<SetMotionModes>(queue).size(), 1u);
  EXPECT_EQ(waitingOf<SetObjectFilter>(queue)[0].filter.hidden, std::vector<std::string>{"wall"});
  EXPECT_EQ(waitingOf<Seek>(queue)[0].frame, 7);
  EXPECT_EQ(waitingOf<Step>(queue).size(), 2u) << "steps add up";
  opened.settleSource(true);
  EXPECT_TRUE(waitingOf<SetCamera>(opened).empty() && waitingOf<Seek>(opened).empty());
  EXPECT_EQ(waitingOf<Step>(opened).size(), 1u) << "asked of the new one";
}

// The last one of a type wins, except where each counts; some make others void.
TEST(RequestQueueTest, ANewerRequestMakesVoidWhatItsTypeSays) {
  using namespace taa::request;
  taa::RequestQueue queue;
  taa::RequestId id = 0;
  const auto post = [&](taa::Request request) { queue.post({++id, std::move(request)}); };
  for (const int frame : {1, 2, 3}) post(Seek{frame});
  for (const int frames : {1, 1}) post(Step{frames});
  EXPECT_EQ(waitingOf<Seek>(queue).size(), 1u);
  EXPECT_EQ(waitingOf<Step>(queue).size(), 2u);
  post(Seek{9});
  EXPECT_TRUE(waitingOf<Step>(queue).empty()) << "were relative to where it is not going";
  post(SetPlaying{true});
  post(Step{1});
  EXPECT_TRUE(waitingOf<SetPlaying>(queue).empty()) << "a step pauses";
  post(Fly{});
  post(Fly{});
  EXPECT_EQ(waitingOf<Fly>(queue).size(), 2u) << "a recording has all of them";
  post(SetCamera{"pan"});
  EXPECT_TRUE(waitingOf<Fly>(queue).empty());
  post(SetFlownCameras{});
  EXPECT_TRUE(waitingOf<SetCamera>(queue).empty());
}

// What is cancelled before it was begun is not begun; what is asked for after that is.
TEST(RequestQueueTest, CancellingMakesVoidTheLongWorkThatWaits) {
  using namespace taa::request;
  taa::RequestQueue queue;
  queue.post({1, ExportSequence{}});
  queue.post({2, MeasureStages{}});
  queue.post({3, FillTraces{0, 9}});
  queue.post({4, SetSettings{}});
  queue.post({5, Cancel{}});
  queue.post({6, FillTraces{3, 5}});
  EXPECT_TRUE(waitingOf<ExportSequence>(queue).empty() && waitingOf<MeasureStages>(queue).empty());
  ASSERT_EQ(waitingOf<FillTraces>(queue).size(), 1u);
  EXPECT_EQ(waitingOf<FillTraces>(queue)[0].first, 3);
  EXPECT_EQ(waitingOf<SetSettings>(queue).size(), 1u);
}

// An export is of what is open when it is asked for.
TEST_F(RenderAnswersTest, AnExportOfNothingIsNotDoneOfWhatIsOpenedLater) {
  taa::SequenceRequest sequence;
  sequence.target = taa::test::temporaryFolder() / "later.png";
  sequence.picture.width = sequence.picture.height = 8;
  recorder.clear();
  taa::RenderThread other(recorder.listener());
  other.post(taa::request::ExportSequence{sequence});
  other.waitUntilIdle();
  other.post(taa::request::Open{"builtin:fan"});
  other.waitUntilIdle();
  EXPECT_TRUE(recorder.all<taa::ExportResult>().empty());
}

// Requests come out turn by turn, as they were asked for within one.
TEST(RequestQueueTest, TakesTurns) {
  using namespace taa::request;
  taa::RequestQueue queue;
  queue.post({1, Seek{4}});
  queue.post({2, SetSettings{}});
  queue.post({3, SetViews{}});
  queue.post({4, SetSize{8, 8}});
  std::vector<taa::RequestId> order;
  for (const taa::Turn turn : taa::kTurns)
    for (const taa::PostedRequest& posted : queue.take(turn)) order.push_back(posted.id);
  EXPECT_EQ(order, (std::vector<taa::RequestId>{3, 2, 4, 1}));
  EXPECT_TRUE(queue.isEmpty());
}

// Each work says why it is done.
TEST_F(RenderAnswersTest, SaysWhyItReplays) {
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->post(taa::request::Seek{12});
  thread->waitUntilIdle();
  const auto saidAfter = [&](const std::function<void()>& wish) {
    recorder.clear();
    wish();
    thread->waitUntilIdle();
    EXPECT_TRUE(recorder.all<taa::Status>().back().exact);
    EXPECT_TRUE(recorder.all<taa::Status>().back().inexactSince.empty());
    return recorder.all<taa::Work>().empty() ? std::string() : recorder.all<taa::Work>().front().what;
  };
  EXPECT_EQ(saidAfter([&] { thread->post(taa::request::SetCamera{"orbit"}); }),
            "Replaying with the new camera");
  EXPECT_EQ(saidAfter([&] { thread->post(taa::request::SetSize{40, 24}); }), "Replaying at the new size");
  EXPECT_EQ(saidAfter([&] { thread->post(taa::request::SetSettings{otherJitter()}); }),
            "Replaying with the new settings");
  EXPECT_EQ(saidAfter([&] {
              thread->post(taa::request::SetMotionModes{{{"rotor", taa::MotionMode::None}}});
            }),
            "Replaying with the new motion of objects");
  EXPECT_EQ(saidAfter([&] {
              thread->post(taa::request::SetObjectFilter{{{"rotor"}, {}}});
            }),
            "Replaying with the objects that are drawn now");
  EXPECT_EQ(saidAfter([&] {
              thread->post(taa::request::Fly{{{0, 1, 3}, 0, 0, 45}});
            }),
            "Replaying with the new camera");
  EXPECT_EQ(saidAfter([&] { thread->post(taa::request::SetOtherLanes{{otherJitter()}}); }),
            "Replaying with the settings to compare with");
  EXPECT_EQ(saidAfter([&] { thread->post(taa::request::ReloadShaders{}); }),
            "Replaying with the new shaders");
  EXPECT_EQ(saidAfter([&] { thread->post(taa::request::Seek{20}); }), "Going to frame 20");
  EXPECT_EQ(taa::replayText({taa::RequestKind::Camera, taa::RequestKind::Flight}),
            "Replaying with the new camera");
  EXPECT_EQ(taa::replayText({taa::RequestKind::Camera, taa::RequestKind::Settings}),
            "Replaying after several changes");
}

// A picture has the shot version of its status: what is not there yet is not called exact.
TEST_F(RenderAnswersTest, PicturesAndThumbnailsSayWhichShotVersionTheyAreOf) {
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->post(taa::request::SetThumbnails{16, 9});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::ViewResult>().back().shotVersion,
            recorder.all<taa::Status>().back().shotVersion);
  ASSERT_TRUE(recorder.waitFor([&] { return !recorder.all<taa::Thumbnail>().empty(); }));
  const std::uint64_t before = recorder.last<taa::Status>().shotVersion;
  EXPECT_EQ(recorder.last<taa::Thumbnail>().shotVersion, before);
  const taa::RequestId request = thread->post(taa::request::Open{"builtin:fence"});
  thread->waitUntilIdle();
  EXPECT_GT(recorder.last<taa::Status>().shotVersion, before);
  EXPECT_EQ(recorder.last<taa::Status>().opened, request);
  EXPECT_EQ(recorder.last<taa::ViewResult>().shotVersion, recorder.last<taa::Status>().shotVersion);
}
