// Samples that the active probe's pixel is made of, on the render thread.
#include "tests/support/RenderRecorder.h"

#include <gtest/gtest.h>

#include <cstddef>

using taa::Follow;
using taa::Lineage;
using taa::LineageDelivery;

class RenderLineageTest : public taa::test::onThread::RenderThreadTest {};

TEST_F(RenderLineageTest, ComesForEachFrameThatRestsAndEachProbe) {
  thread->post(taa::request::SetProbes{{{.pixel = {10, 5}}, {.pixel = {20, 9}}}, 0});
  thread->post(taa::request::Seek{5});
  thread->waitUntilIdle();
  EXPECT_TRUE(recorder.all<LineageDelivery>().empty()) << "nobody looks";
  thread->post(taa::request::SetLineage{4});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<LineageDelivery>().size(), 1u);
  EXPECT_EQ(recorder.all<LineageDelivery>()[0].frame, 5);
  ASSERT_TRUE(recorder.all<LineageDelivery>()[0].lineage);
  const Lineage& first = *recorder.all<LineageDelivery>()[0].lineage;
  EXPECT_EQ(first.pixel, glm::ivec2(10, 5));
  EXPECT_LE(first.frames.size(), 4u);
  EXPECT_NEAR(first.weight + first.rectified + first.older + first.pruned + first.blank, 1.0, 1e-9);
  thread->post(taa::request::SetProbes{{{.pixel = {10, 5}}, {.pixel = {20, 9}}}, 1});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<LineageDelivery>().size(), 2u);
  EXPECT_EQ(recorder.all<LineageDelivery>()[1].lineage->pixel, glm::ivec2(20, 9));
  thread->post(taa::request::Seek{7});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<LineageDelivery>().size(), 3u);
  EXPECT_EQ(recorder.all<LineageDelivery>()[2].frame, 7);
  EXPECT_EQ(recorder.all<LineageDelivery>()[2].lineage->frames[0].frame, 7);
  thread->post(taa::request::SetLineage{0});
  thread->post(taa::request::Seek{8});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<LineageDelivery>().size(), 3u);
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

TEST_F(RenderLineageTest, IsOfSettingsThatHold) {
  thread->post(taa::request::SetProbes{{{.pixel = {10, 5}}}, 0});
  thread->post(taa::request::SetLineage{4});
  thread->post(taa::request::Seek{5});
  thread->waitUntilIdle();
  ASSERT_FALSE(recorder.all<LineageDelivery>().empty());
  const LineageDelivery before = recorder.all<LineageDelivery>().back();
  taa::Settings settings;
  taa::applyAssignment(settings, "weight.source=constant");
  taa::applyAssignment(settings, "weight.alpha=0.5");
  taa::applyAssignment(settings, "validate.depth=off");
  taa::applyAssignment(settings, "blend.tone=none");
  thread->post(taa::request::SetSettings{settings});
  thread->waitUntilIdle();
  const LineageDelivery& after = recorder.all<LineageDelivery>().back();
  EXPECT_EQ(after.frame, 5);
  EXPECT_GT(after.shotVersion, before.shotVersion);
  EXPECT_EQ(after.lineage->frames[0].weight, 0.5);
}

TEST_F(RenderLineageTest, KnowsAProbeThatIsNotInThePicture) {
  thread->post(taa::request::SetLineage{4});
  thread->post(taa::request::SetProbes{{{.pixel = {200, 5}}}, 0}); // of a larger picture
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<LineageDelivery>().size(), 1u);
  EXPECT_EQ(recorder.all<LineageDelivery>()[0].probe.pixel, glm::ivec2(200, 5));
  EXPECT_FALSE(recorder.all<LineageDelivery>()[0].lineage);
}
