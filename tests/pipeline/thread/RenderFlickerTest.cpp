// Flicker of frames, on the render thread.
#include "tests/support/RenderRecorder.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

using taa::IntermediateId;
using taa::Metric;
using taa::test::onThread::viewOf;

namespace {
constexpr taa::WorkKind kWork = taa::WorkKind::OverTime;
constexpr int kSamples = 4;
} // namespace

class RenderFlickerTest : public taa::test::onThread::RenderThreadTest {
 protected:
  void goTo(int frame) {
    thread->post(taa::request::SetReferenceSamples{kSamples});
    thread->post(taa::request::Seek{frame});
    thread->waitUntilIdle();
  }
  bool wasTold() const {
    return std::ranges::any_of(recorder.all<taa::Work>(),
                               [](const taa::Work& work) { return work.kind == kWork; });
  }
};

TEST_F(RenderFlickerTest, IsMeasuredWhileAViewShowsIt) {
  goTo(3);
  EXPECT_FALSE(wasTold()) << "nobody looks";
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::deviationOverTime)}});
  thread->waitUntilIdle();
  ASSERT_EQ(recorder.all<taa::ViewResult>().size(), 2u);
  EXPECT_FALSE(recorder.all<taa::ViewResult>().front().overTimeSamples) << "at once, as far as it is known";
  EXPECT_EQ(recorder.all<taa::ViewResult>().back().overTimeSamples, 0) << "no reference was drawn for it";
  const std::optional<double> deviation = recorder.all<taa::ViewResult>().back().number;
  ASSERT_TRUE(deviation);
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::flicker)}});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::ViewResult>().back().overTimeSamples, kSamples);
  ASSERT_TRUE(recorder.all<taa::ViewResult>().back().number);
  EXPECT_LE(*recorder.all<taa::ViewResult>().back().number, *deviation);
  EXPECT_TRUE(wasTold());
  EXPECT_TRUE(recorder.all<taa::Work>().back().what.empty());
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

TEST_F(RenderFlickerTest, StopsWhenItIsTold) {
  goTo(8);
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (work.kind == kWork && work.done == 2) thread->post(taa::request::Cancel{});
  });
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::flicker)}});
  thread->waitUntilIdle();
  EXPECT_TRUE(wasTold());
  EXPECT_FALSE(recorder.all<taa::ViewResult>().back().overTimeSamples);
  EXPECT_TRUE(recorder.all<taa::Work>().back().what.empty());
  recorder.on<taa::Work>([](const taa::Work&) {});
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.all<taa::ViewResult>().back().overTimeSamples, kSamples)
      << "another frame starts again by itself";
}

TEST_F(RenderFlickerTest, MetricsOfAllPlayedFramesHaveIt) {
  thread->post(taa::request::SetPlayback{{.range = std::pair(0, 4)}});
  goTo(2);
  thread->post(taa::request::SetMetrics{{Metric::Flicker, Metric::Deviation}});
  thread->waitUntilIdle();
  std::vector<std::optional<double>> flicker(5);
  for (const taa::FrameMetrics& metrics : recorder.all<taa::FrameMetrics>())
    if (metrics.flickerSamples == kSamples)
      flicker.at(static_cast<std::size_t>(metrics.frame)) = metrics.at(Metric::Flicker);
  EXPECT_FALSE(flicker[0]) << "nothing was seen before";
  for (std::size_t frame = 1; frame < flicker.size(); ++frame) EXPECT_TRUE(flicker[frame]) << frame;
  EXPECT_TRUE(recorder.all<taa::Work>().back().what.empty());
}
