// What the render thread does besides frames: profiles, the cost of stages, thumbnails, programs ahead of
// need.
#include "tests/support/RenderRecorder.h"
#include "tests/support/ShaderFolder.h"

#include <cstddef>
#include <vector>

using taa::IntermediateId;
using taa::test::onThread::viewOf;

using RenderIdleTest = taa::test::onThread::RenderThreadTest;

TEST_F(RenderIdleTest, ProfilesFramesWhileItIsAskedFor) {
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<taa::FrameProfile>().empty());
  thread->post(taa::request::SetProfiling{true});
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::FrameProfile>().size(), 1u);
  EXPECT_EQ(recorder.all<taa::FrameProfile>()[0].frame, 2);
  EXPECT_GT(recorder.all<taa::FrameProfile>()[0].totalMs, 0.0);
  thread->post(taa::request::SetProfiling{false});
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::FrameProfile>().size(), 1u);
}

TEST_F(RenderIdleTest, MeasuresStagesAndAnswersRequestsMeanwhile) {
  bool asked = false;
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (work.kind != taa::WorkKind::Stages || asked) return;
    asked = true;
    thread->post(taa::request::SetViews{{viewOf(IntermediateId::alpha)}});
  });
  thread->post(taa::request::MeasureStages{});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::StageCosts>().size(), 1u);
  EXPECT_EQ(recorder.all<taa::StageCosts>()[0].frame, 0);
  EXPECT_EQ(recorder.all<taa::ViewResult>().size(), 1u);
  EXPECT_TRUE(recorder.all<taa::Work>().back().what.empty());
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

TEST_F(RenderIdleTest, StopsMeasuringStages) {
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (work.kind == taa::WorkKind::Stages) thread->post(taa::request::Cancel{});
  });
  thread->post(taa::request::MeasureStages{});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<taa::StageCosts>().empty());
  EXPECT_TRUE(recorder.all<taa::Work>().back().what.empty());
}

TEST_F(RenderIdleTest, DrawsThumbnailsOfEveryStageWhenIdle) {
  thread->post(taa::request::SetThumbnails{16, 9});
  const std::size_t stages = taa::mainRows().size();
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.all<taa::Thumbnail>().size() >= stages; }));
  const std::vector<taa::Thumbnail> first = recorder.read([&] { return recorder.all<taa::Thumbnail>(); });
  for (std::size_t place = 0; place < stages; ++place) {
    EXPECT_EQ(first[place].id, taa::mainRows()[place]);
    EXPECT_EQ(first[place].picture.width, 16);
    EXPECT_EQ(first[place].picture.height, 9);
  }
  recorder.read([&] { recorder.all<taa::Thumbnail>().clear(); });
  thread->post(taa::request::Step{2});
  thread->waitUntilIdle();
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.all<taa::Thumbnail>().size() >= stages; }));
  EXPECT_EQ(recorder.last<taa::Thumbnail>().frame, 2);
  thread->post(taa::request::SetThumbnails{0, 0});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

// A shader that cannot be compiled any more shows who still has to.
TEST_F(RenderIdleTest, CompilesAheadWhatIsLookedAtAndNothingElseChanges) {
  taa::Settings wanted;
  taa::applyAssignment(wanted, "rectify.method=clamp");
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->post(taa::request::Step{3});
  thread->waitUntilIdle();
  recorder.clear();
  thread->post(taa::request::Prepare{wanted});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.read(
      [&] { return recorder.all<taa::ViewResult>().empty() && recorder.all<taa::Status>().empty(); }));
  const taa::test::ShaderFolder folder;
  folder.write("taa/resolve.frag", "#error no more\n");
  thread->post(taa::request::SetSettings{wanted});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
  EXPECT_EQ(recorder.last<taa::Status>().settings, wanted);
  taa::applyAssignment(wanted, "rectify.method=none");
  thread->post(taa::request::SetSettings{wanted});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::Failure>().size(), 1u);
}

TEST_F(RenderIdleTest, CompilesAheadBesideAPlayThatGoesOn) {
  taa::Settings wanted;
  taa::applyAssignment(wanted, "rectify.method=clamp");
  thread->post(taa::request::SetPlaying{true});
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.all<taa::Status>().back().playing; }));
  const std::size_t told = recorder.read([&] { return recorder.all<taa::Status>().size(); });
  thread->post(taa::request::Prepare{wanted});
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.all<taa::Status>().size() >= told + 3; }));
  thread->post(taa::request::SetPlaying{false});
  thread->waitUntilIdle();
  const taa::test::ShaderFolder folder;
  folder.write("taa/resolve.frag", "#error no more\n");
  thread->post(taa::request::SetSettings{wanted});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

TEST_F(RenderIdleTest, ForgetsWhatWasLookedAtOnceSomethingIsChosen) {
  taa::Settings wanted, chosen;
  taa::applyAssignment(wanted, "rectify.method=clamp");
  taa::applyAssignment(chosen, "rectify.method=none");
  thread->post(taa::request::SetPlaying{true});
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.all<taa::Status>().back().playing; }));
  thread->post(taa::request::Prepare{wanted});
  thread->post(taa::request::SetSettings{chosen});
  thread->post(taa::request::SetPlaying{false});
  thread->waitUntilIdle();
  thread->post(taa::request::Prepare{chosen}); // after which the other one is no longer being compiled either
  thread->waitUntilIdle();
  const taa::test::ShaderFolder folder;
  folder.write("taa/resolve.frag", "#error no more\n");
  thread->post(taa::request::SetSettings{wanted});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::Failure>().size(), 1u);
}

TEST_F(RenderIdleTest, SaysNothingOfWhatCannotBeCompiledAhead) {
  taa::Settings wanted;
  taa::applyAssignment(wanted, "rectify.method=clamp");
  const taa::test::ShaderFolder folder;
  folder.write("taa/resolve.frag", "#error no more\n");
  thread->post(taa::request::Prepare{wanted});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}
