// What the render thread's errors, works and pictures say they are about.
#include "core/requests/RenderWishes.h"
#include "tests/support/RenderRecorder.h"
#include "tests/support/ShaderFolder.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace {

using taa::IntermediateId;
using taa::test::otherJitter;
using taa::test::onThread::viewOf;

using RenderAnswersTest = taa::test::onThread::RenderThreadTest;

} // namespace

// An error is an answer to one request; what else was asked for is done.
TEST_F(RenderAnswersTest, AnErrorSaysWhatItAnswersAndNothingElseIsDropped) {
  thread->setSettings(otherJitter());
  const taa::RequestId settings = thread->lastRequest();
  taa::SequenceRequest bad;
  bad.target = "/dev/null/at/all.png"; // no folder can be made there, not even by root
  bad.picture.width = 8;
  bad.picture.height = 8;
  thread->exportSequence(bad);
  const taa::RequestId exported = thread->lastRequest();
  thread->setViews({viewOf(IntermediateId::alpha)});
  thread->setMotionModes({{"nobody", taa::MotionMode::None}});
  const taa::RequestId modes = thread->lastRequest();
  thread->waitUntilIdle();
  EXPECT_LT(settings, exported);
  ASSERT_EQ(recorder.failures.size(), 2u);
  std::ranges::sort(recorder.failures, {}, &taa::Failure::request); // some may be taken up together
  EXPECT_EQ(recorder.failures[0].kind, taa::RequestKind::Export);
  EXPECT_EQ(recorder.failures[0].request, exported);
  EXPECT_EQ(recorder.failures[1].kind, taa::RequestKind::MotionModes);
  EXPECT_EQ(recorder.failures[1].request, modes);
  EXPECT_EQ(recorder.statuses.back().settings, otherJitter());
  EXPECT_EQ(recorder.pictures.back().request.id, IntermediateId::alpha);
}

TEST_F(RenderAnswersTest, AFailingShaderAnswersTheSettingsThatNeedIt) {
  taa::Settings wanted;
  taa::applyAssignment(wanted, "rectify.method=clamp");
  {
    const taa::test::ShaderFolder folder;
    folder.write("taa/resolve.frag", "#error no more\n");
    recorder.clear();
    thread->setSettings(wanted);
    const taa::RequestId refused = thread->lastRequest();
    thread->setMotionModes({{"rotor", taa::MotionMode::None}});
    thread->waitUntilIdle();
    ASSERT_FALSE(recorder.failures.empty());
    EXPECT_EQ(recorder.failures[0].kind, taa::RequestKind::Settings);
    EXPECT_EQ(recorder.failures[0].request, refused);
  }
  EXPECT_EQ(recorder.statuses.back().settings, taa::Settings{}) << "says what is in force";
}

// What was asked of the scene before a missing file was asked for is still wanted of it.
TEST(RenderWishesTest, WhatWasAskedBeforeASourceCountsWhereThatIsRefused) {
  taa::Wishes wishes;
  wishes.camera = "pan";
  wishes.motionModes = std::vector<taa::MotionOverride>{{"rotor", taa::MotionMode::None}};
  wishes.scene.filter = taa::ObjectFilter{{"wall"}, {}};
  wishes.frame = 7;
  wishes.steps = 2;
  wishes.open("missing.glb");
  EXPECT_FALSE(wishes.camera || wishes.motionModes || wishes.scene.filter || wishes.frame);
  wishes.scene.filter = taa::ObjectFilter{{"floor"}, {}}; // newer
  wishes.open("missing too.glb");
  EXPECT_FALSE(wishes.scene.filter) << "it was of one that is never opened";
  wishes.steps = 1;
  wishes.refuseSource();
  EXPECT_EQ(wishes.camera, "pan");
  ASSERT_TRUE(wishes.motionModes);
  EXPECT_EQ(wishes.scene.filter->hidden, std::vector<std::string>{"wall"});
  EXPECT_EQ(wishes.frame, 7);
  EXPECT_EQ(wishes.steps, 3);
}

// Each work says why it is done.
TEST_F(RenderAnswersTest, SaysWhyItReplays) {
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->seek(12);
  thread->waitUntilIdle();
  const auto saidAfter = [&](const std::function<void()>& wish) {
    recorder.clear();
    wish();
    thread->waitUntilIdle();
    EXPECT_TRUE(recorder.statuses.back().exact);
    EXPECT_TRUE(recorder.statuses.back().inexactSince.empty());
    return recorder.works.empty() ? std::string() : recorder.works.front().what;
  };
  EXPECT_EQ(saidAfter([&] { thread->setCamera("orbit"); }), "Replaying with the new camera");
  EXPECT_EQ(saidAfter([&] { thread->setSize(40, 24); }), "Replaying at the new size");
  EXPECT_EQ(saidAfter([&] { thread->setSettings(otherJitter()); }), "Replaying with the new settings");
  EXPECT_EQ(saidAfter([&] {
              thread->setMotionModes({{"rotor", taa::MotionMode::None}});
            }),
            "Replaying with the new motion of objects");
  EXPECT_EQ(saidAfter([&] {
              thread->setObjectFilter({{"rotor"}, {}});
            }),
            "Replaying with the objects that are drawn now");
  EXPECT_EQ(saidAfter([&] { thread->fly({{0, 1, 3}, 0, 0, 45}); }), "Replaying with the new camera");
  EXPECT_EQ(saidAfter([&] { thread->setOtherLanes({otherJitter()}); }),
            "Replaying with the settings to compare with");
  EXPECT_EQ(saidAfter([&] { thread->reloadShaders(); }), "Replaying with the new shaders");
  EXPECT_EQ(saidAfter([&] { thread->seek(20); }), "Going to frame 20");
  EXPECT_EQ(taa::replayText({taa::RequestKind::Camera, taa::RequestKind::Flight}),
            "Replaying with the new camera");
  EXPECT_EQ(taa::replayText({taa::RequestKind::Camera, taa::RequestKind::Settings}),
            "Replaying after several changes");
}

// The subject of a picture is that of its status: what is not there yet is not called exact.
TEST_F(RenderAnswersTest, PicturesAndThumbnailsSayWhichSubjectTheyAreOf) {
  thread->setViews({viewOf(IntermediateId::resolved)});
  thread->setThumbnails(16, 9);
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.pictures.back().subject, recorder.statuses.back().subject);
  ASSERT_TRUE(recorder.waitFor([&] { return !recorder.thumbnails.empty(); }));
  const std::uint64_t before = recorder.read([&] { return recorder.statuses.back().subject; });
  EXPECT_EQ(recorder.read([&] { return recorder.thumbnails.back().subject; }), before);
  thread->open("builtin:fence");
  const taa::RequestId request = thread->lastRequest();
  thread->waitUntilIdle();
  EXPECT_GT(recorder.read([&] { return recorder.statuses.back().subject; }), before);
  EXPECT_EQ(recorder.read([&] { return recorder.statuses.back().opened; }), request);
  EXPECT_EQ(recorder.read([&] { return recorder.pictures.back().subject; }),
            recorder.read([&] { return recorder.statuses.back().subject; }));
}
