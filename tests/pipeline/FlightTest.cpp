// Hidden objects and flown cameras: frame n stays a function, by hand and on the render thread.
#include "tests/support/RenderRecorder.h"
#include "tests/support/SmallInspector.h"

#include "core/base/Error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <future>
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

CameraPose shifted(CameraPose pose, int steps) {
  pose.position.x += 0.05f * static_cast<float>(steps);
  pose.yaw += 0.4f * static_cast<float>(steps);
  return pose;
}

/// A frame of another inspector that went straight there; on a thread of its own, for its own context.
std::vector<Image> straight(int width, int height, int frame, const std::function<void(Inspector&)>& choose) {
  const auto make = [&] {
    Inspector inspector;
    inspector.setSize(width, height);
    inspector.open("builtin:fan");
    choose(inspector);
    inspector.seek(frame);
    return inspector.images(allRows());
  };
  return std::async(std::launch::async, make).get();
}

std::vector<Image> straight(int frame, const std::function<void(Inspector&)>& choose) {
  return straight(taa::test::small::kWidth, taa::test::small::kHeight, frame, choose);
}

} // namespace

TEST_F(SceneChoices, HidesObjectsInAllFrames) {
  const auto inspector = opened();
  inspector->seek(4);
  const std::vector<Image> whole = inspector->images(allRows());
  EXPECT_THROW(inspector->setObjectFilter({{"rotor", "nobody"}, {}}), taa::Error);
  expectSame(inspector->images(allRows()), whole);
  inspector->setObjectFilter({{"rotor"}, {}});
  EXPECT_FALSE(inspector->isExact());
  inspector->refine();
  const std::vector<Image> hidden = inspector->images(allRows());
  EXPECT_FALSE(isSame(hidden[0], whole[0]));
  expectSame(hidden, straight(4, [](Inspector& other) { other.setObjectFilter({{"rotor"}, {}}); }));
  inspector->setObjectFilter({{}, {"rotor"}});
  inspector->refine();
  EXPECT_FALSE(isSame(inspector->images(allRows())[0], hidden[0]));
  inspector->setObjectFilter({});
  inspector->refine();
  expectSame(inspector->images(allRows()), whole);
}

TEST_F(SceneChoices, ATrackThatGrowsWhileItPlaysIsWhatSeekingShows) {
  const auto inspector = opened();
  const CameraPose first = inspector->cameraPose();
  CameraTrack track{"flown", 0, {first}};
  inspector->setCameraTrack(track);
  for (int frame = 1; frame <= 6; ++frame) {
    track.put(frame, shifted(first, frame * frame));
    inspector->setCameraTrack(track);
    EXPECT_TRUE(inspector->isExact()) << "nothing of it is on show";
    inspector->advance();
    EXPECT_EQ(inspector->cameraPose(), track.at(frame));
  }
  EXPECT_TRUE(inspector->isExact());
  const std::vector<Image> played = inspector->images(allRows());
  expectSame(played, straight(6, [&](Inspector& other) { other.setCameraTrack(track); }));
  // Back and forth over kept frames.
  inspector->seek(2);
  expectSame(inspector->images(allRows()),
             straight(2, [&](Inspector& other) { other.setCameraTrack(track); }));
  inspector->seek(6);
  expectSame(inspector->images(allRows()), played);
}

TEST_F(SceneChoices, AnotherPoseOfTheFrameOnShowKeepsWhatWasBefore) {
  const auto inspector = opened();
  const CameraPose first = inspector->cameraPose();
  CameraTrack track{"flown", 0, {first}};
  inspector->setCameraTrack(track);
  inspector->seek(5);
  track.put(5, shifted(first, 3));
  inspector->setCameraTrack(track);
  EXPECT_TRUE(inspector->isExact()) << "the frames before it are as they were";
  expectSame(inspector->images(allRows()),
             straight(5, [&](Inspector& other) { other.setCameraTrack(track); }));
  track.put(3, shifted(first, 1));
  inspector->setCameraTrack(track);
  EXPECT_FALSE(inspector->isExact());
  inspector->refine();
  expectSame(inspector->images(allRows()),
             straight(5, [&](Inspector& other) { other.setCameraTrack(track); }));
  EXPECT_THROW(inspector->setCameraTrack({"orbit", 0, {first}}), taa::Error) << "the scene has one";
  inspector->setCamera("orbit");
  EXPECT_EQ(inspector->cameras().back(), "flown");
}

TEST_F(FlightThread, RestsWhereItWasFlownTo) {
  thread->seek(3);
  thread->waitUntilIdle();
  const CameraPose start = recorder.read([&] { return recorder.statuses.back().pose; });
  for (int step = 1; step < 5; ++step) thread->fly(shifted(start, step));
  thread->waitUntilIdle();
  const taa::Status status = recorder.read([&] { return recorder.statuses.back(); });
  EXPECT_EQ(status.camera, taa::kFreeCamera);
  EXPECT_EQ(status.pose, shifted(start, 4));
  EXPECT_TRUE(status.exact);
  ASSERT_EQ(status.tracks.size(), 1u);
  EXPECT_EQ(status.tracks[0]->poses.size(), 1u);
  thread->setCamera("orbit");
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.read([&] { return recorder.statuses.back().camera; }), "orbit");
}

TEST_F(FlightThread, RecordsAPoseForEachFrameThatIsSteppedTo) {
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->seek(2);
  thread->waitUntilIdle();
  thread->setRecording(true);
  thread->waitUntilIdle();
  const CameraPose start = recorder.read([&] { return recorder.statuses.back().pose; });
  EXPECT_TRUE(recorder.read([&] { return recorder.statuses.back().recording; }));
  for (int step = 1; step <= 4; ++step) {
    thread->step(1);
    thread->waitUntilIdle();
    thread->fly(shifted(start, step * step));
    thread->waitUntilIdle();
  }
  const std::vector<std::uint8_t> shown =
      recorder.read([&] { return recorder.pictures.back().picture.rgba; });
  EXPECT_TRUE(recorder.read([&] { return recorder.pictures.back().exact; }));
  thread->setRecording(false);
  thread->waitUntilIdle();
  const taa::Status status = recorder.read([&] { return recorder.statuses.back(); });
  EXPECT_FALSE(status.recording);
  EXPECT_EQ(status.camera, "Recorded 1");
  ASSERT_EQ(status.tracks.size(), 1u);
  for (int step = 0; step <= 4; ++step)
    EXPECT_EQ(status.tracks[0]->at(2 + step), shifted(start, step * step)) << step;
  // There and back again.
  thread->seek(0);
  thread->waitUntilIdle();
  thread->seek(6);
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.read([&] { return recorder.pictures.back().picture.rgba; }), shown);
  EXPECT_EQ(recorder.read([&] { return recorder.statuses.back().camera; }), "Recorded 1");
}

TEST_F(FlightThread, RecordsWhileItPlays) {
  thread->setRecording(true);
  thread->waitUntilIdle();
  const CameraPose start = recorder.read([&] { return recorder.statuses.back().pose; });
  thread->setPlaying(true);
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.statuses.back().playing; })); // else it is still at rest
  for (int step = 1; step < 6; ++step) {
    thread->fly(shifted(start, step));
    ASSERT_TRUE(recorder.waitFor([&] { return recorder.statuses.back().pose == shifted(start, step); }));
  }
  thread->setPlaying(false);
  thread->setRecording(false);
  thread->waitUntilIdle();
  const taa::Status status = recorder.read([&] { return recorder.statuses.back(); });
  ASSERT_EQ(status.tracks.size(), 1u);
  const CameraTrack track = *status.tracks[0];
  EXPECT_TRUE(status.exact) << "it was exact where it began";
  EXPECT_EQ(track.at(status.info.frame), shifted(start, 5));
  int changes = 0;
  for (int frame = 1; frame <= status.info.frame; ++frame)
    changes += !(track.at(frame) == track.at(frame - 1));
  EXPECT_EQ(changes, 5);
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->waitUntilIdle();
  const auto shown = recorder.read([&] { return recorder.pictures.back().picture.rgba; });
  thread->seek(0);
  thread->waitUntilIdle();
  thread->reloadShaders(); // nothing is kept after it
  thread->seek(status.info.frame);
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.read([&] { return recorder.pictures.back().picture.rgba; }), shown);
}

TEST_F(FlightThread, WhatIsKnownOfTheFramesBeforeStaysTrueWhileItIsFlown) {
  for (const bool isRecorded : {false, true}) {
    recorder.clear();
    thread->seek(0);
    if (isRecorded) thread->setRecording(true);
    thread->waitUntilIdle();
    const CameraPose start = recorder.read([&] { return recorder.statuses.back().pose; });
    thread->setPlaying(true);
    ASSERT_TRUE(recorder.waitFor([&] { return recorder.statuses.back().playing; }));
    std::vector<std::uint64_t> subjects;
    for (int step = 1; step < 6; ++step) {
      thread->fly(shifted(start, step));
      ASSERT_TRUE(recorder.waitFor([&] { return recorder.statuses.back().pose == shifted(start, step); }));
      subjects.push_back(recorder.read([&] { return recorder.statuses.back().subject; }));
    }
    EXPECT_EQ(std::ranges::count(subjects, subjects.front()), 5) << "dropped once, when it began";
    thread->setPlaying(false);
    thread->setRecording(false);
    thread->waitUntilIdle();
    thread->setCamera("orbit");
    thread->waitUntilIdle();
    EXPECT_GT(recorder.read([&] { return recorder.statuses.back().subject; }), subjects.back());
  }
}

TEST_F(SceneChoices, ARenamedCameraShowsTheSameAndARemovedOneNothing) {
  const auto inspector = opened();
  const CameraPose first = inspector->cameraPose();
  CameraTrack track{"flown", 0, {first, shifted(first, 3), shifted(first, 9)}};
  inspector->setCameraTrack({"other", 0, {shifted(first, 4)}});
  inspector->setCameraTrack(track);
  inspector->seek(4);
  const std::vector<Image> flown = inspector->images(allRows());
  const CameraTrack other = *inspector->cameraTracks()[0];
  CameraTrack named = track;
  named.name = "By the wall";
  inspector->setFlownCameras({{other, named}, "By the wall"});
  EXPECT_TRUE(inspector->isExact()) << "it is the same camera";
  EXPECT_EQ(inspector->camera(), "By the wall");
  expectSame(inspector->images(allRows()), flown);
  EXPECT_THROW(inspector->setFlownCameras({{other, other}, "other"}), taa::Error);
  EXPECT_THROW(inspector->setFlownCameras({{other}, "flown"}), taa::Error);
  EXPECT_EQ(inspector->camera(), "By the wall") << "an error changes nothing";
  inspector->setFlownCameras({{other}, "orbit"});
  EXPECT_EQ(inspector->cameras().back(), "other");
  inspector->refine();
  expectSame(inspector->images(allRows()), straight(4, [](Inspector& one) { one.setCamera("orbit"); }));
}

TEST_F(FlightThread, SaysWhereObjectsAreSeen) {
  std::vector<taa::ObjectArea> areas;
  const auto outline = recorder.read([&] { return recorder.statuses.back().outline; });
  ASSERT_TRUE(outline);
  taa::RenderListener listener = recorder.listener();
  listener.onObjectArea = [&](taa::ObjectArea area) { recorder.add(areas, std::move(area)); };
  taa::RenderThread other(listener);
  other.setSize(64, 36);
  other.open("builtin:fan");
  const auto wall = std::ranges::find(outline->nodes, "wall", &taa::OutlineNode::key);
  other.locate(outline->objectsBelow(static_cast<int>(wall - outline->nodes.begin())));
  other.waitUntilIdle();
  ASSERT_EQ(areas.size(), 1u);
  EXPECT_GT(areas[0].pixels, 100);
  EXPECT_GE(areas[0].pixel.x, areas[0].box.x);
  EXPECT_LT(areas[0].pixel.x, areas[0].box.x + areas[0].box.width);
  EXPECT_LE(areas[0].pixels, areas[0].box.width * areas[0].box.height);
  taa::ObjectFilter filter;
  filter.hidden = {"wall"};
  other.setObjectFilter(filter);
  other.waitUntilIdle();
  EXPECT_EQ(areas.back().pixels, 0);
}
