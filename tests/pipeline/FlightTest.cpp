// Hidden objects and flown cameras: frame n stays a function, by hand and on the render thread.
#include "tests/support/RenderRecorder.h"
#include "tests/support/SmallInspector.h"

#include "core/base/Error.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using taa::allRows;
using taa::CameraPose;
using taa::CameraTrack;
using taa::Image;
using taa::Inspector;
using taa::IntermediateId;
using taa::test::onThread::viewOf;
using taa::test::small::expectSame;
using taa::test::small::isSame;

using SceneChoices = taa::test::small::InspectorTest;
using FlightThread = taa::test::onThread::RenderThreadTest;

/// A render thread whose clock of flights the test sets.
class RecordingThread : public taa::test::onThread::RenderThreadTest {
 protected:
  using Clock = taa::RenderThread::Clock;

  void SetUp() override {
    RenderThreadTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    thread = std::make_unique<taa::RenderThread>(recorder.listener(), [this] { return now(); });
    thread->post(taa::request::SetSize{taa::test::onThread::kWidth, taa::test::onThread::kHeight});
    thread->post(taa::request::Open{"builtin:fan"});
    thread->post(taa::request::SetCamera{"still"});
  }
  Clock::time_point now() const { return Clock::time_point(Clock::duration(ticks)); }
  void setClock(double seconds) {
    ticks = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)).count();
  }
  void startAt(int frame) {
    setClock(0.0);
    thread->post(taa::request::Seek{frame});
    thread->waitUntilIdle();
    first = recorder.last<taa::Status>().pose;
  }
  void flyAt(double seconds, const CameraPose& pose, double took) {
    setClock(seconds);
    thread->post(taa::request::Fly{
        pose, std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(took))});
  }
  std::atomic<Clock::rep> ticks = 0;
  CameraPose first; ///< at the frame that was started at
};

CameraPose shifted(CameraPose pose, int steps) {
  pose.position.x += 0.05f * static_cast<float>(steps);
  pose.yaw += 0.4f * static_cast<float>(steps);
  return pose;
}

/// A frame of another inspector that went straight there; on a thread of its own, for its own context.
std::vector<Image> straight(int width, int height, int frame, const std::function<void(Inspector&)>& choose) {
  const auto make = [&] {
    Inspector inspector;
    inspector.shot().setSize(width, height);
    inspector.shot().open("builtin:fan");
    choose(inspector);
    inspector.shot().seek(frame);
    return inspector.views().images(allRows());
  };
  return std::async(std::launch::async, make).get();
}

std::vector<Image> straight(int frame, const std::function<void(Inspector&)>& choose) {
  return straight(taa::test::small::kWidth, taa::test::small::kHeight, frame, choose);
}

} // namespace

TEST_F(SceneChoices, HidesObjectsInAllFrames) {
  const auto inspector = opened();
  inspector->shot().seek(4);
  const std::vector<Image> whole = inspector->views().images(allRows());
  EXPECT_THROW(inspector->shot().setObjectFilter({{"rotor", "nobody"}, {}}), taa::Error);
  expectSame(inspector->views().images(allRows()), whole);
  inspector->shot().setObjectFilter({{"rotor"}, {}});
  EXPECT_FALSE(inspector->shot().isExact());
  inspector->shot().refine();
  const std::vector<Image> hidden = inspector->views().images(allRows());
  EXPECT_FALSE(isSame(hidden[0], whole[0]));
  expectSame(hidden, straight(4, [](Inspector& other) { other.shot().setObjectFilter({{"rotor"}, {}}); }));
  inspector->shot().setObjectFilter({{}, {"rotor"}});
  inspector->shot().refine();
  EXPECT_FALSE(isSame(inspector->views().images(allRows())[0], hidden[0]));
  inspector->shot().setObjectFilter({});
  inspector->shot().refine();
  expectSame(inspector->views().images(allRows()), whole);
}

TEST_F(SceneChoices, ATrackThatGrowsWhileItPlaysIsWhatSeekingShows) {
  const auto inspector = opened();
  const CameraPose first = inspector->shot().cameraPose();
  CameraTrack track{"flown", 0, {first}};
  inspector->shot().setCameraTrack(track);
  for (int frame = 1; frame <= 6; ++frame) {
    track.put(frame, shifted(first, frame * frame));
    inspector->shot().setCameraTrack(track);
    EXPECT_TRUE(inspector->shot().isExact()) << "nothing of it is on show";
    inspector->shot().advance();
    EXPECT_EQ(inspector->shot().cameraPose(), track.at(frame));
  }
  EXPECT_TRUE(inspector->shot().isExact());
  const std::vector<Image> played = inspector->views().images(allRows());
  expectSame(played, straight(6, [&](Inspector& other) { other.shot().setCameraTrack(track); }));
  // Back and forth over kept frames.
  inspector->shot().seek(2);
  expectSame(inspector->views().images(allRows()),
             straight(2, [&](Inspector& other) { other.shot().setCameraTrack(track); }));
  inspector->shot().seek(6);
  expectSame(inspector->views().images(allRows()), played);
}

TEST_F(SceneChoices, AnotherPoseOfTheFrameOnShowKeepsWhatWasBefore) {
  const auto inspector = opened();
  const CameraPose first = inspector->shot().cameraPose();
  CameraTrack track{"flown", 0, {first}};
  inspector->shot().setCameraTrack(track);
  inspector->shot().seek(5);
  track.put(5, shifted(first, 3));
  inspector->shot().setCameraTrack(track);
  EXPECT_TRUE(inspector->shot().isExact()) << "the frames before it are as they were";
  expectSame(inspector->views().images(allRows()),
             straight(5, [&](Inspector& other) { other.shot().setCameraTrack(track); }));
  track.put(3, shifted(first, 1));
  inspector->shot().setCameraTrack(track);
  EXPECT_FALSE(inspector->shot().isExact());
  inspector->shot().refine();
  expectSame(inspector->views().images(allRows()),
             straight(5, [&](Inspector& other) { other.shot().setCameraTrack(track); }));
  EXPECT_THROW(inspector->shot().setCameraTrack({"orbit", 0, {first}}), taa::Error) << "the scene has one";
  inspector->shot().setCamera("orbit");
  EXPECT_EQ(inspector->shot().cameras().back(), "flown");
}

TEST_F(SceneChoices, OfFramesKeptToCompareWithThoseThatItChangesGo) {
  const auto inspector = opened();
  const CameraPose first = inspector->shot().cameraPose();
  inspector->shot().setCameraTrack({"flown", 0, {first}});
  inspector->shot().seek(3);
  inspector->views().keepComparisonFrames({2, 6, 8});
  inspector->shot().setCameraTrack({"flown", 0, {first, first, first, first, first, shifted(first, 1)}});
  EXPECT_TRUE(inspector->views().isCached({.frame = 2}));
  EXPECT_FALSE(inspector->views().isCached({.frame = 6}));
  EXPECT_FALSE(inspector->views().isCached({.frame = 8}));
}

TEST_F(FlightThread, RestsWhereItWasFlownTo) {
  thread->post(taa::request::Seek{3});
  thread->waitUntilIdle();
  const CameraPose start = recorder.last<taa::Status>().pose;
  for (int step = 1; step < 5; ++step) thread->post(taa::request::Fly{shifted(start, step)});
  thread->waitUntilIdle();
  const taa::Status status = recorder.last<taa::Status>();
  EXPECT_EQ(status.camera, taa::kFreeCamera);
  EXPECT_EQ(status.pose, shifted(start, 4));
  EXPECT_TRUE(status.exact);
  ASSERT_EQ(status.tracks.size(), 1u);
  EXPECT_EQ(status.tracks[0]->poses.size(), 1u);
  thread->post(taa::request::SetCamera{"orbit"});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.last<taa::Status>().camera, "orbit");
}

// Three seconds on the clock of whoever flies, of which this machine shows as many frames as it can.
TEST_F(RecordingThread, HasAPoseForEachFrameOfTheShotsClock) {
  startAt(20);
  thread->post(taa::request::SetRecording{true});
  for (int told = 1; told <= 10; ++told) flyAt(0.1 * told, shifted(first, told), 0.1); // then it waits
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.all<taa::Status>().back().recording; }));
  EXPECT_TRUE(recorder.last<taa::Status>().playing);
  flyAt(3.0, shifted(first, 20), 0.5);
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.all<taa::Status>().back().recordedFrames == 181; }));
  thread->post(taa::request::SetRecording{false});
  thread->waitUntilIdle();
  const taa::Status status = recorder.last<taa::Status>();
  EXPECT_FALSE(status.recording);
  EXPECT_FALSE(status.playing) << "it was at rest";
  EXPECT_EQ(status.camera, "Recorded 1");
  EXPECT_EQ(status.info.frame, 200) << "where the clock is";
  EXPECT_TRUE(status.exact);
  EXPECT_EQ(status.pose, shifted(first, 20));
  ASSERT_EQ(status.tracks.size(), 1u);
  const CameraTrack& track = *status.tracks[0];
  EXPECT_EQ(track.firstFrame, 20);
  ASSERT_EQ(track.poses.size(), 181u);
  for (int frame = 0; frame <= 60; ++frame) // six of them for each pose that was told
    EXPECT_NEAR(track.at(20 + frame).yaw, first.yaw + 0.4f * static_cast<float>(frame) / 6.0f, 1e-3f)
        << frame;
  for (int frame = 60; frame <= 150; ++frame)
    EXPECT_EQ(track.at(20 + frame), shifted(first, 10)) << frame << ": it waited";
  EXPECT_NEAR(track.at(20 + 165).yaw, first.yaw + 0.4f * 15.0f, 1e-3f);
}

TEST_F(RecordingThread, WhatItShowsAtItsEndIsWhatSeekingShows) {
  startAt(3);
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->post(taa::request::SetRecording{true});
  for (int told = 1; told <= 5; ++told) flyAt(0.1 * told, shifted(first, told * told), 0.1);
  thread->post(taa::request::SetRecording{false});
  thread->waitUntilIdle();
  const auto shown = recorder.last<taa::ViewResult>();
  EXPECT_EQ(shown.frame, 33);
  EXPECT_TRUE(shown.exact);
  thread->post(taa::request::Seek{0});
  thread->post(taa::request::ReloadShaders{}); // nothing is kept after it
  thread->post(taa::request::Seek{33});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.last<taa::ViewResult>().picture.rgba, shown.picture.rgba);
}

TEST_F(RecordingThread, EndsWithTheShotAndGoesOnPlayingWhereItPlayed) {
  startAt(200);
  thread->post(taa::request::SetLooping{false});
  thread->post(taa::request::SetRecording{true});
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.all<taa::Status>().back().recording; }));
  flyAt(5.0, shifted(first, 4), 5.0);
  // It ends by the clock, which no wish waits for.
  ASSERT_TRUE(recorder.waitFor([&] {
    const taa::Status& status = recorder.all<taa::Status>().back();
    return !status.recording && !status.playing && status.info.frame == 239;
  }));
  taa::Status status = recorder.last<taa::Status>();
  EXPECT_EQ(status.tracks[0]->poses.size(), 40u) << "frames 200 to 239";
  EXPECT_EQ(status.info.frame, 239);
  EXPECT_FALSE(status.playing);
  thread->post(taa::request::SetRecording{true});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::Failure>().size(), 1u) << "there is no frame after it";
  EXPECT_EQ(recorder.all<taa::Failure>().back().kind, taa::RequestKind::Recording);
}

TEST_F(RecordingThread, APauseAStepAndAJumpEndIt) {
  const std::function<void()> ends[] = {[&] { thread->post(taa::request::SetPlaying{false}); },
                                        [&] { thread->post(taa::request::Step{2}); },
                                        [&] { thread->post(taa::request::Seek{5}); }};
  const int shown[] = {40, 42, 5};
  for (int way = 0; way < 3; ++way) {
    startAt(10);
    thread->post(taa::request::SetRecording{true});
    flyAt(0.5, shifted(first, 3), 0.25);
    ends[way]();
    thread->waitUntilIdle();
    const taa::Status status = recorder.last<taa::Status>();
    EXPECT_FALSE(status.recording) << way;
    EXPECT_FALSE(way < 2 && status.playing) << way;
    if (status.playing) thread->post(taa::request::SetPlaying{false});
    EXPECT_EQ(status.info.frame, shown[way]) << way;
    EXPECT_EQ(status.camera, "Recorded " + std::to_string(way + 1));
    EXPECT_EQ(status.tracks.back()->poses.size(), 31u) << way;
  }
}

TEST_F(FlightThread, WhatIsKnownOfTheFramesBeforeStaysTrueWhileItIsFlown) {
  for (const bool isRecorded : {false, true}) {
    recorder.clear();
    thread->post(taa::request::Seek{0});
    if (isRecorded) thread->post(taa::request::SetRecording{true});
    thread->waitUntilIdle();
    const CameraPose start = recorder.last<taa::Status>().pose;
    thread->post(taa::request::SetPlaying{true});
    ASSERT_TRUE(recorder.waitFor([&] { return recorder.all<taa::Status>().back().playing; }));
    std::vector<std::uint64_t> shotVersions;
    for (int step = 1; step < 6; ++step) {
      thread->post(taa::request::Fly{shifted(start, step)});
      ASSERT_TRUE(
          recorder.waitFor([&] { return recorder.all<taa::Status>().back().pose == shifted(start, step); }));
      shotVersions.push_back(recorder.last<taa::Status>().shotVersion);
    }
    EXPECT_EQ(std::ranges::count(shotVersions, shotVersions.front()), 5) << "dropped once, when it began";
    thread->post(taa::request::SetPlaying{false});
    thread->post(taa::request::SetRecording{false});
    thread->waitUntilIdle();
    thread->post(taa::request::SetCamera{"orbit"});
    thread->waitUntilIdle();
    EXPECT_GT(recorder.last<taa::Status>().shotVersion, shotVersions.back());
  }
}

TEST_F(SceneChoices, ARenamedCameraShowsTheSameAndARemovedOneNothing) {
  const auto inspector = opened();
  const CameraPose first = inspector->shot().cameraPose();
  CameraTrack track{"flown", 0, {first, shifted(first, 3), shifted(first, 9)}};
  inspector->shot().setCameraTrack({"other", 0, {shifted(first, 4)}});
  inspector->shot().setCameraTrack(track);
  inspector->shot().seek(4);
  const std::vector<Image> flown = inspector->views().images(allRows());
  const CameraTrack other = *inspector->shot().cameraTracks()[0];
  CameraTrack named = track;
  named.name = "By the wall";
  inspector->shot().setFlownCameras({{other, named}, "By the wall"});
  EXPECT_TRUE(inspector->shot().isExact()) << "it is the same camera";
  EXPECT_EQ(inspector->shot().camera(), "By the wall");
  expectSame(inspector->views().images(allRows()), flown);
  EXPECT_THROW(inspector->shot().setFlownCameras({{other, other}, "other"}), taa::Error);
  EXPECT_THROW(inspector->shot().setFlownCameras({{other}, "flown"}), taa::Error);
  EXPECT_EQ(inspector->shot().camera(), "By the wall") << "an error changes nothing";
  inspector->shot().setFlownCameras({{other}, "orbit"});
  EXPECT_EQ(inspector->shot().cameras().back(), "other");
  inspector->shot().refine();
  expectSame(inspector->views().images(allRows()),
             straight(4, [](Inspector& one) { one.shot().setCamera("orbit"); }));
}

TEST_F(FlightThread, SaysWhereObjectsAreSeen) {
  const std::vector<taa::ObjectArea>& areas = recorder.all<taa::ObjectArea>();
  const auto outline = recorder.last<taa::Status>().outline;
  ASSERT_TRUE(outline);
  taa::RenderThread other(recorder.listener());
  other.post(taa::request::SetSize{64, 36});
  other.post(taa::request::Open{"builtin:fan"});
  const auto wall = std::ranges::find(outline->nodes, "wall", &taa::OutlineNode::key);
  other.post(taa::request::Locate{outline->objectsBelow(static_cast<int>(wall - outline->nodes.begin()))});
  other.waitUntilIdle();
  ASSERT_EQ(areas.size(), 1u);
  EXPECT_GT(areas[0].pixels, 100);
  EXPECT_GE(areas[0].pixel.x, areas[0].box.x);
  EXPECT_LT(areas[0].pixel.x, areas[0].box.x + areas[0].box.width);
  EXPECT_LE(areas[0].pixels, areas[0].box.width * areas[0].box.height);
  taa::ObjectFilter filter;
  filter.hidden = {"wall"};
  other.post(taa::request::SetObjectFilter{filter});
  other.waitUntilIdle();
  EXPECT_EQ(areas.back().pixels, 0);
}
