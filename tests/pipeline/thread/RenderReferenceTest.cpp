// The reference and the metrics of frames, on the render thread.
#include "core/taa/twin/Known.h"
#include "tests/support/RenderRecorder.h"

#include <algorithm>
#include <utility>
#include <vector>

using taa::IntermediateId;
using taa::Metric;
using taa::test::onThread::viewOf;

namespace {
constexpr taa::WorkKind kWork = taa::WorkKind::Reference;
} // namespace

class RenderReferenceTest : public taa::test::onThread::RenderThreadTest {
 protected:
  std::vector<int> samplesShown() {
    std::vector<int> samples;
    for (const taa::ViewResult& picture : recorder.all<taa::ViewResult>())
      if (taa::isOfReference(picture.request.id)) samples.push_back(picture.referenceSamples);
    return samples;
  }
};

TEST_F(RenderReferenceTest, IsRefinedWhileAViewShowsIt) {
  thread->post(taa::request::SetReferenceSamples{48});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::Status>().back().referenceGoal, 48);
  EXPECT_TRUE(recorder.all<taa::Work>().empty() || recorder.all<taa::Work>().back().kind != kWork)
      << "nobody looks";
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::reference), viewOf(IntermediateId::resolved)}});
  thread->waitUntilIdle();
  EXPECT_EQ(samplesShown(), (std::vector{0, 4, 16, 48}));
  EXPECT_FALSE(recorder.all<taa::ViewResult>().front().error);
  const taa::ViewResult& last = recorder.all<taa::ViewResult>().back();
  ASSERT_TRUE(last.error);
  EXPECT_GT(last.error->rmse, 0.0);
  EXPECT_EQ(std::ranges::count(recorder.all<taa::ViewResult>(), IntermediateId::resolved,
                               [](const taa::ViewResult& picture) { return picture.request.id; }),
            1)
      << "the others are not drawn again";
  const auto told = std::ranges::find(recorder.all<taa::Work>(), 48, &taa::Work::done);
  ASSERT_NE(told, recorder.all<taa::Work>().end());
  EXPECT_EQ(told->kind, kWork);
  EXPECT_EQ(told->what, "Drawing the reference");
  EXPECT_EQ(told->total, 48);
  EXPECT_TRUE(recorder.all<taa::Work>().back().what.empty());
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

TEST_F(RenderReferenceTest, IsDrawnForProbesThatAreToComeWithIt) {
  thread->post(taa::request::SetReferenceSamples{8});
  thread->post(taa::request::SetProbes{.all = {{.pixel = {3, 4}}}, .active = 0});
  thread->waitUntilIdle();
  ASSERT_FALSE(recorder.all<taa::ProbeResult>().empty());
  const auto hasReference = [&] {
    return taa::twin::isKnown(recorder.all<taa::ProbeResult>().back().around[taa::kProbedMiddle],
                              IntermediateId::reference);
  };
  EXPECT_FALSE(hasReference()) << "nobody asked for it";
  thread->post(taa::request::SetProbes{.all = {{.pixel = {3, 4}}}, .active = 0, .reference = true});
  thread->waitUntilIdle();
  EXPECT_TRUE(hasReference()) << "the probe comes again once it is there";
  thread->post(taa::request::SetProbes{.all = {{.pixel = {3, 4}}}, .active = 0});
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_FALSE(hasReference()) << "of another frame none is drawn any more";
}

TEST_F(RenderReferenceTest, AnswersRequestsMeanwhileAndStops) {
  bool asked = false;
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (work.kind != kWork || work.done < 20 || asked) return;
    asked = true;
    thread->post(taa::request::SetProbes{.all = {{.pixel = {3, 4}}}, .active = 0});
    thread->post(taa::request::Cancel{});
  });
  thread->post(taa::request::SetReferenceSamples{1024});
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::referenceError)}});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::ProbeResult>().size(), 1u);
  EXPECT_TRUE(recorder.all<taa::Work>().back().what.empty());
  EXPECT_EQ(samplesShown().back(), 16);
  thread->post(taa::request::SetReferenceSamples{16}); // fewer than there are: anew
  thread->waitUntilIdle();
  EXPECT_EQ(samplesShown().back(), 16);
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::ViewResult>().back().frame, 1);
  EXPECT_EQ(samplesShown().back(), 16) << "another frame starts again by itself";
}

TEST_F(RenderReferenceTest, IsNotDrawnWhilePlaying) {
  thread->post(taa::request::SetReferenceSamples{4});
  thread->post(taa::request::SetPlaying{true});
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::reference)}});
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.all<taa::ViewResult>().size() > 3; }));
  recorder.read([&] {
    for (const int samples : samplesShown()) EXPECT_EQ(samples, 0);
  });
  thread->post(taa::request::SetPlaying{false});
  thread->waitUntilIdle();
  EXPECT_EQ(samplesShown().back(), 4);
}

TEST_F(RenderReferenceTest, MetricsComeWithEachFrameThatIsShown) {
  thread->post(taa::request::SetPlayback{{.range = std::pair(0, 4)}});
  thread->post(taa::request::SetMetrics{{Metric::MeanAlpha, Metric::HistoryLength}});
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  const auto found = std::ranges::find(recorder.all<taa::FrameMetrics>(), 2, &taa::FrameMetrics::frame);
  ASSERT_NE(found, recorder.all<taa::FrameMetrics>().end());
  const taa::FrameMetrics& last = *found;
  EXPECT_EQ(last.frame, 2);
  EXPECT_TRUE(last.exact);
  ASSERT_TRUE(last.at(Metric::MeanAlpha) && last.at(Metric::HistoryLength));
  EXPECT_GT(*last.at(Metric::HistoryLength), 1.0);
  EXPECT_FALSE(last.at(Metric::Rmse));
  thread->post(taa::request::SetMetrics{{}});
  thread->waitUntilIdle();
  const std::size_t before = recorder.all<taa::FrameMetrics>().size();
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::FrameMetrics>().size(), before);
}

TEST_F(RenderReferenceTest, AMetricAgainstTheReferenceHasItDrawn) {
  thread->post(taa::request::SetReferenceSamples{8});
  thread->post(taa::request::SetPlayback{{.range = std::pair(0, 2)}});
  thread->post(taa::request::SetMetrics{{Metric::Rmse}});
  thread->waitUntilIdle();
  ASSERT_FALSE(recorder.all<taa::FrameMetrics>().empty());
  EXPECT_FALSE(recorder.all<taa::FrameMetrics>().front().at(Metric::Rmse))
      << "at once, as far as it is known";
  const auto found =
      std::ranges::find(recorder.all<taa::FrameMetrics>(), 8, &taa::FrameMetrics::referenceSamples);
  ASSERT_NE(found, recorder.all<taa::FrameMetrics>().end());
  EXPECT_EQ(found->frame, 0);
  ASSERT_TRUE(found->at(Metric::Rmse));
  EXPECT_GT(*found->at(Metric::Rmse), 0.0);
}
