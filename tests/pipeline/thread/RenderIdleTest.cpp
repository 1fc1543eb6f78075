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
  EXPECT_TRUE(recorder.profiles.empty());
  thread->post(taa::request::SetProfiling{true});
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.profiles.size(), 1u);
  EXPECT_EQ(recorder.profiles[0].frame, 2);
  EXPECT_GT(recorder.profiles[0].totalMs, 0.0);
  thread->post(taa::request::SetProfiling{false});
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.profiles.size(), 1u);
}

TEST_F(RenderIdleTest, MeasuresStagesAndAnswersRequestsMeanwhile) {
  bool asked = false;
  recorder.onWork = [&](const taa::Work& work) {
    if (work.kind != taa::WorkKind::Stages || asked) return;
    asked = true;
    thread->post(taa::request::SetViews{{viewOf(IntermediateId::alpha)}});
  };
  thread->post(taa::request::MeasureStages{});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.costs.size(), 1u);
  EXPECT_EQ(recorder.costs[0].frame, 0);
  EXPECT_EQ(recorder.pictures.size(), 1u);
  EXPECT_TRUE(recorder.works.back().what.empty());
  EXPECT_TRUE(recorder.errors.empty());
}

TEST_F(RenderIdleTest, StopsMeasuringStages) {
  recorder.onWork = [&](const taa::Work& work) {
    if (work.kind == taa::WorkKind::Stages) thread->post(taa::request::Cancel{});
  };
  thread->post(taa::request::MeasureStages{});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.costs.empty());
  EXPECT_TRUE(recorder.works.back().what.empty());
}

TEST_F(RenderIdleTest, DrawsThumbnailsOfEveryStageWhenIdle) {
  thread->post(taa::request::SetThumbnails{16, 9});
  const std::size_t stages = taa::mainRows().size();
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.thumbnails.size() >= stages; }));
  const std::vector<taa::Thumbnail> first = recorder.read([&] { return recorder.thumbnails; });
  for (std::size_t place = 0; place < stages; ++place) {
    EXPECT_EQ(first[place].id, taa::mainRows()[place]);
    EXPECT_EQ(first[place].picture.width, 16);
    EXPECT_EQ(first[place].picture.height, 9);
  }
  recorder.read([&] { recorder.thumbnails.clear(); });
  thread->post(taa::request::Step{2});
  thread->waitUntilIdle();
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.thumbnails.size() >= stages; }));
  EXPECT_EQ(recorder.read([&] { return recorder.thumbnails.back().frame; }), 2);
  thread->post(taa::request::SetThumbnails{0, 0});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.errors.empty());
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
  EXPECT_TRUE(recorder.read([&] { return recorder.pictures.empty() && recorder.statuses.empty(); }));
  const taa::test::ShaderFolder folder;
  folder.write("taa/resolve.frag", "#error no more\n");
  thread->post(taa::request::SetSettings{wanted});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.errors.empty());
  EXPECT_EQ(recorder.read([&] { return recorder.statuses.back().settings; }), wanted);
  taa::applyAssignment(wanted, "rectify.method=none");
  thread->post(taa::request::SetSettings{wanted});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.errors.size(), 1u);
}

TEST_F(RenderIdleTest, CompilesAheadBesideAPlayThatGoesOn) {
  taa::Settings wanted;
  taa::applyAssignment(wanted, "rectify.method=clamp");
  thread->post(taa::request::SetPlaying{true});
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.statuses.back().playing; }));
  const std::size_t told = recorder.read([&] { return recorder.statuses.size(); });
  thread->post(taa::request::Prepare{wanted});
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.statuses.size() >= told + 3; }));
  thread->post(taa::request::SetPlaying{false});
  thread->waitUntilIdle();
  const taa::test::ShaderFolder folder;
  folder.write("taa/resolve.frag", "#error no more\n");
  thread->post(taa::request::SetSettings{wanted});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.errors.empty());
}

TEST_F(RenderIdleTest, ForgetsWhatWasLookedAtOnceSomethingIsChosen) {
  taa::Settings wanted, chosen;
  taa::applyAssignment(wanted, "rectify.method=clamp");
  taa::applyAssignment(chosen, "rectify.method=none");
  thread->post(taa::request::SetPlaying{true});
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.statuses.back().playing; }));
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
  EXPECT_EQ(recorder.errors.size(), 1u);
}

TEST_F(RenderIdleTest, SaysNothingOfWhatCannotBeCompiledAhead) {
  taa::Settings wanted;
  taa::applyAssignment(wanted, "rectify.method=clamp");
  const taa::test::ShaderFolder folder;
  folder.write("taa/resolve.frag", "#error no more\n");
  thread->post(taa::request::Prepare{wanted});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.errors.empty());
}
