// Views with two sides from the render thread: lanes, other frames, differences, all of the frame they say.
#include "core/gl/ContextLock.h"
#include "core/settings/Parameters.h"
#include "tests/support/RenderRecorder.h"

#include <cstddef>
#include <future>

using taa::IntermediateId;
using taa::OtherSide;
using taa::Picture;
using taa::PictureSource;
using taa::Settings;
using taa::ViewRequest;
using taa::ViewResult;
using taa::test::onThread::kHeight;
using taa::test::onThread::kWidth;
using taa::test::onThread::viewOf;

namespace {

/// The picture of a view from an inspector that only has these settings, on a thread of its own.
Picture alone(const Settings& settings, IntermediateId id, int frame) {
  const auto make = [&] {
    const taa::gl::ContextLock lock;
    taa::Inspector inspector;
    inspector.shot().setSize(kWidth, kHeight);
    inspector.shot().setSettings(settings);
    inspector.shot().open("builtin:fan");
    inspector.shot().seek(frame);
    return inspector.views().picture(id, defaultStyle(taa::intermediate(id)), {}, kWidth, kHeight);
  };
  return std::async(std::launch::async, make).get();
}

OtherSide ofLane(int lane) {
  OtherSide side;
  side.lane = lane;
  return side;
}

OtherSide ofFrame(int frame, IntermediateId id = IntermediateId::resolved) {
  OtherSide side;
  side.id = id;
  side.frame = frame;
  return side;
}

OtherSide framesBefore(int frames) {
  OtherSide side;
  side.framesBefore = frames;
  return side;
}

Settings otherSettings() {
  Settings settings;
  taa::applyAssignment(settings, "rectify.method=none");
  taa::applyAssignment(settings, "weight.minimum=0.02");
  return settings;
}

class RenderSidesTest : public taa::test::onThread::RenderThreadTest {
 protected:
  static ViewRequest comparing(OtherSide other) {
    ViewRequest view = viewOf(IntermediateId::resolved);
    other.style = defaultStyle(taa::intermediate(other.id));
    view.other = other;
    return view;
  }
  ViewResult last() {
    thread->waitUntilIdle();
    return recorder.read([&] {
      return recorder.all<ViewResult>().empty() ? ViewResult{} : recorder.all<ViewResult>().back();
    });
  }
};

} // namespace

TEST_F(RenderSidesTest, BothSidesOfALaneAreThePicturesThatEachPresetGivesAlone) {
  thread->post(taa::request::Seek{5});
  thread->post(taa::request::SetOtherLanes{{otherSettings()}});
  thread->post(taa::request::SetViews{{comparing(ofLane(1))}});
  const ViewResult result = last();
  ASSERT_TRUE(result.other);
  EXPECT_TRUE(result.exact && result.other->exact);
  EXPECT_EQ(result.frame, 5);
  EXPECT_EQ(result.other->frame, 5);
  EXPECT_EQ(result.picture.rgba, alone(Settings{}, IntermediateId::resolved, 5).rgba);
  EXPECT_EQ(result.other->picture.rgba, alone(otherSettings(), IntermediateId::resolved, 5).rgba);
  EXPECT_NE(result.picture.rgba, result.other->picture.rgba);
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

TEST_F(RenderSidesTest, ALaneFollowsItsSettingsAndTheFirstFollowsThose) {
  thread->post(taa::request::SetOtherLanes{{otherSettings()}});
  thread->post(taa::request::SetViews{{comparing(ofLane(1))}});
  thread->post(taa::request::Step{3});
  thread->waitUntilIdle();
  thread->post(taa::request::SetSettings{otherSettings()});
  thread->post(taa::request::SetOtherLanes{{Settings{}}});
  const ViewResult result = last();
  ASSERT_TRUE(result.other);
  EXPECT_EQ(result.picture.rgba, alone(otherSettings(), IntermediateId::resolved, 3).rgba);
  EXPECT_EQ(result.other->picture.rgba, alone(Settings{}, IntermediateId::resolved, 3).rgba);
}

TEST_F(RenderSidesTest, ALaneThatGoesTakesItsSideWithIt) {
  thread->post(taa::request::SetOtherLanes{{otherSettings()}});
  thread->post(taa::request::SetViews{{comparing(ofLane(1))}});
  ASSERT_TRUE(last().other);
  thread->post(taa::request::SetOtherLanes{{}});
  EXPECT_FALSE(last().other);
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

TEST_F(RenderSidesTest, AnotherFrameIsThatFrameAndFollowsChanges) {
  thread->post(taa::request::Seek{8});
  thread->post(taa::request::SetViews{{comparing(ofFrame(3, IntermediateId::alpha))}});
  ViewResult result = last();
  ASSERT_TRUE(result.other);
  EXPECT_EQ(result.frame, 8);
  EXPECT_EQ(result.other->frame, 3);
  EXPECT_EQ(result.other->picture.rgba, alone(Settings{}, IntermediateId::alpha, 3).rgba);
  EXPECT_EQ(result.picture.rgba, alone(Settings{}, IntermediateId::resolved, 8).rgba);
  thread->post(taa::request::SetSettings{otherSettings()});
  result = last();
  ASSERT_TRUE(result.other);
  EXPECT_TRUE(result.other->exact);
  EXPECT_EQ(result.other->picture.rgba, alone(otherSettings(), IntermediateId::alpha, 3).rgba);
  EXPECT_EQ(recorder.frame(), 8) << "the frame on show stays";
}

TEST_F(RenderSidesTest, TheFrameBeforeStaysOneBehind) {
  thread->post(taa::request::SetViews{{comparing(framesBefore(1))}});
  EXPECT_EQ(last().other->frame, 0) << "there is none before the first";
  thread->post(taa::request::Step{2});
  EXPECT_EQ(last().other->frame, 1);
  thread->post(taa::request::Step{1});
  const ViewResult result = last();
  EXPECT_EQ(result.other->frame, 2);
  EXPECT_EQ(result.other->picture.rgba, alone(Settings{}, IntermediateId::resolved, 2).rgba);
}

TEST_F(RenderSidesTest, AFrameBeyondTheEndIsTheLast) {
  thread->post(taa::request::SetViews{{comparing(ofFrame(1000000))}});
  const ViewResult result = last();
  ASSERT_TRUE(result.other);
  EXPECT_EQ(result.other->frame, recorder.last<taa::Status>().frameCount - 1);
}

TEST_F(RenderSidesTest, ADifferenceBringsItsValues) {
  thread->post(taa::request::Seek{4});
  thread->post(taa::request::SetOtherLanes{{otherSettings()}});
  ViewRequest view = comparing(ofLane(1));
  view.withValues = true;
  thread->post(taa::request::SetViews{{view}});
  const ViewResult sides = last();
  view.asDifference = true;
  thread->post(taa::request::SetViews{{view}});
  const ViewResult difference = last();
  ASSERT_TRUE(sides.other && difference.other);
  ASSERT_EQ(difference.values.pixels.size(), sides.values.pixels.size());
  bool differs = false;
  for (std::size_t index = 0; index < sides.values.pixels.size(); ++index) {
    const float expected = sides.values.pixels[index] - sides.other->values.pixels[index];
    ASSERT_EQ(difference.values.pixels[index], expected);
    differs = differs || expected != 0.0f;
  }
  EXPECT_TRUE(differs);
}

// Found by random requests: values of both sides were taken from each other, one channel from three.
TEST_F(RenderSidesTest, ADifferenceOfOtherChannelsIsRefused) {
  ViewRequest view = comparing(OtherSide{.id = IntermediateId::depth});
  view.asDifference = view.withValues = true;
  thread->post(taa::request::SetViews{{view}});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::Failure>().size(), 1u);
  EXPECT_EQ(recorder.all<taa::Failure>()[0].kind, taa::RequestKind::Views);
  EXPECT_EQ(recorder.all<taa::Failure>()[0].sentence,
            "there is no difference between resolved and depth: one has more channels");
}

TEST_F(RenderSidesTest, TheFrameBeforeAlongTheMotionSaysWhereThereIsNone) {
  OtherSide before;
  before.alongMotion = true;
  ViewRequest view = comparing(before);
  view.asDifference = view.withValues = true;
  thread->post(taa::request::SetViews{{view}});
  const ViewResult first = last();
  ASSERT_EQ(first.absence.pixels.size(), std::size_t(kWidth) * kHeight);
  for (const float absence : first.absence.pixels)
    EXPECT_EQ(absence, static_cast<float>(taa::Absence::FirstFrame));
  ASSERT_TRUE(first.other);
  EXPECT_EQ(first.other->allAbsent, taa::Absence::FirstFrame);
  thread->post(taa::request::Step{3});
  const ViewResult third = last();
  ASSERT_TRUE(third.other);
  EXPECT_EQ(third.frame, 3);
  EXPECT_EQ(third.other->frame, 2);
  EXPECT_EQ(third.other->allAbsent, taa::Absence::None);
  const auto make = [&] {
    const taa::gl::ContextLock lock;
    taa::Inspector inspector;
    inspector.shot().setSize(kWidth, kHeight);
    inspector.shot().open("builtin:fan");
    inspector.shot().seek(3);
    inspector.views().keepComparisonFrames({2});
    return inspector.views().picture({IntermediateId::resolved},
                                     PictureSource{IntermediateId::resolved, 0, 2, true}, view.style, {},
                                     kWidth, kHeight);
  };
  EXPECT_EQ(third.picture.rgba, std::async(std::launch::async, make).get().rgba);
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

TEST_F(RenderSidesTest, TheActiveProbeComesWithTheOtherSide) {
  OtherSide before;
  before.alongMotion = true;
  thread->post(taa::request::SetViews{{comparing(before)}});
  thread->post(taa::request::SetProbes{.all = {{.pixel = {5, 6}}}, .active = 0, .other = before});
  thread->post(taa::request::Step{3});
  thread->waitUntilIdle();
  const auto lastProbe = [this] { return recorder.last<taa::ProbeResult>(); };
  const taa::ProbeResult probe = lastProbe();
  ASSERT_TRUE(probe.compared);
  EXPECT_EQ(probe.frame, 3);
  EXPECT_EQ(probe.compared->frame, 2);
  thread->post(taa::request::SetProbes{.all = {{.pixel = {5, 6}}}, .active = 0});
  thread->waitUntilIdle();
  EXPECT_FALSE(lastProbe().compared);
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

TEST_F(RenderSidesTest, WhatIsUnderWayCanBeStoppedAndIsNotStartedAgain) {
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (work.kind == taa::WorkKind::Comparing && work.done > 2) thread->post(taa::request::Cancel{});
  });
  const ViewRequest view = comparing(ofFrame(200));
  thread->post(taa::request::SetViews{{view}});
  EXPECT_FALSE(last().other);
  recorder.on<taa::Work>([](const taa::Work&) {});
  recorder.clear();
  thread->post(taa::request::SetViews{{view, viewOf(IntermediateId::alpha)}});
  EXPECT_FALSE(last().other);
  for (const taa::Work& work : recorder.all<taa::Work>()) EXPECT_TRUE(work.what.empty()) << work.what;
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.read([&] {
    for (const ViewResult& picture : recorder.all<ViewResult>())
      if (picture.other && picture.other->frame == 200) return true;
    return false;
  })) << "another frame on show asks for it again";
}
