// Metrics of the frames that are not on show, measured in idle time on the render thread.
#include "core/gl/ContextLock.h"
#include "tests/support/RenderRecorder.h"

#include "core/inspect/Inspector.h"

#include <algorithm>
#include <cstdlib>
#include <future>
#include <set>
#include <utility>
#include <vector>

using taa::FrameMetrics;
using taa::IntermediateId;
using taa::Metric;
using taa::test::onThread::viewOf;

namespace {

constexpr taa::WorkKind kWork = taa::WorkKind::Metrics;
constexpr int kSamples = 4;
const std::vector<Metric> kWanted{Metric::MeanAlpha, Metric::Clipped, Metric::Rmse, Metric::Psnr};

class RenderMetricsTest : public taa::test::onThread::RenderThreadTest {
 protected:
  /// Those that are whole, in the order they came.
  std::vector<FrameMetrics> whole() {
    std::vector<FrameMetrics> metrics;
    for (const FrameMetrics& one : recorder.all<FrameMetrics>())
      if (one.exact && one.at(Metric::Rmse)) metrics.push_back(one);
    return metrics;
  }
  void measure(int first, int last, int frame) {
    thread->post(taa::request::SetReferenceSamples{kSamples});
    thread->post(taa::request::SetPlayback{{.range = std::pair(first, last)}});
    thread->post(taa::request::Seek{frame});
    thread->waitUntilIdle();
    thread->post(taa::request::SetMetrics{kWanted});
  }
};

/// The frame's metrics where somebody goes there, from an inspector of its own thread's context.
FrameMetrics visited(const taa::Status& status, int frame) {
  const auto make = [&] {
    const taa::gl::ContextLock lock;
    taa::Inspector inspector;
    inspector.shot().setSize(status.width, status.height);
    inspector.shot().setSettings(status.settings);
    inspector.shot().open(status.source);
    inspector.shot().seek(frame);
    inspector.reference().refine(kSamples);
    return inspector.metrics().measure(kWanted);
  };
  return std::async(std::launch::async, make).get();
}

} // namespace

TEST_F(RenderMetricsTest, AllFramesThatArePlayedAreMeasuredAsIfTheyWereVisited) {
  measure(6, 22, 15);
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->waitUntilIdle();
  const std::vector<FrameMetrics> metrics = whole();
  std::set<int> frames;
  for (const FrameMetrics& one : metrics) frames.insert(one.frame);
  EXPECT_EQ(frames.size(), 17u);
  EXPECT_EQ(*frames.begin(), 6);
  EXPECT_EQ(*frames.rbegin(), 22);
  EXPECT_EQ(metrics.size(), frames.size()) << "each once";
  EXPECT_EQ(metrics.front().frame, 15);
  for (std::size_t index = 0; index < 9; ++index)
    EXPECT_LE(std::abs(metrics[index].frame - 15), 8) << "the nearest first";
  for (const FrameMetrics& one : metrics)
    if (one.frame % 5 == 1) {
      const FrameMetrics there = visited(recorder.all<taa::Status>().back(), one.frame);
      for (const Metric metric : kWanted) EXPECT_EQ(one.at(metric), there.at(metric)) << one.frame;
    }
  for (const taa::ViewResult& picture : recorder.all<taa::ViewResult>())
    EXPECT_EQ(picture.frame, 15) << "what is shown stays";
  EXPECT_TRUE(recorder.all<taa::Work>().back().what.empty());
  EXPECT_TRUE(std::ranges::any_of(recorder.all<taa::Work>(), [](const taa::Work& work) {
    return work.kind == kWork && work.done > 8 && work.total == 17;
  }));
  EXPECT_TRUE(recorder.all<taa::Failure>().empty());
}

TEST_F(RenderMetricsTest, WhatTakesSecondsIsNotMadeWithThePicture) {
  thread->post(taa::request::SetReferenceSamples{kSamples});
  thread->post(taa::request::SetPlayback{{.range = std::pair(3, 4)}});
  thread->post(taa::request::Seek{3});
  thread->post(taa::request::SetMetrics{{Metric::Flip, Metric::HdrFlip}});
  thread->waitUntilIdle();
  std::set<int> frames;
  for (const FrameMetrics& one : recorder.all<FrameMetrics>())
    if (one.at(Metric::HdrFlip)) {
      frames.insert(one.frame);
      EXPECT_TRUE(one.at(Metric::Flip)) << "all of them come together";
    }
  EXPECT_EQ(frames, (std::set<int>{3, 4})) << "while nothing else is to be done";
  const auto first = std::ranges::find_if(
      recorder.all<FrameMetrics>(), [](const FrameMetrics& one) { return one.at(Metric::Flip).has_value(); });
  ASSERT_NE(first, recorder.all<FrameMetrics>().end());
  EXPECT_FALSE(first->at(Metric::HdrFlip)) << "of the frame on show what is cheap comes first";
}

TEST_F(RenderMetricsTest, RequestsAreAnsweredMeanwhileAndCancelEndsIt) {
  bool asked = false;
  recorder.on<taa::Work>([&](const taa::Work& work) {
    if (work.kind != kWork || work.done < 3 || asked) return;
    asked = true;
    thread->post(taa::request::SetProbes{.all = {{.pixel = {3, 4}}}, .active = 0});
    thread->post(taa::request::Cancel{});
  });
  measure(0, 60, 30);
  thread->waitUntilIdle();
  EXPECT_TRUE(asked);
  EXPECT_EQ(recorder.all<taa::ProbeResult>().size(), 1u);
  EXPECT_LT(whole().size(), 6u);
  EXPECT_TRUE(recorder.all<taa::Work>().back().what.empty());
  thread->post(taa::request::SetMetrics{{Metric::MeanAlpha}}); // asked again: from the beginning
  thread->waitUntilIdle();
  EXPECT_TRUE(std::ranges::any_of(recorder.all<FrameMetrics>(),
                                  [](const FrameMetrics& one) { return one.frame == 60; }));
}

TEST_F(RenderMetricsTest, NothingIsMeasuredWhileItPlays) {
  thread->post(taa::request::SetPlayback{{.range = std::pair(0, 40)}});
  thread->post(taa::request::SetPlaying{true});
  thread->post(taa::request::SetMetrics{{Metric::MeanAlpha}});
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.all<FrameMetrics>().size() > 6; }));
  recorder.read([&] {
    for (const taa::Work& work : recorder.all<taa::Work>()) EXPECT_NE(work.kind, kWork);
  });
  thread->post(taa::request::SetPlaying{false});
  thread->waitUntilIdle();
  std::set<int> frames;
  for (const FrameMetrics& one : recorder.all<FrameMetrics>()) frames.insert(one.frame);
  EXPECT_EQ(frames.size(), 41u) << "those that were played are known";
  std::vector<int> times(41, 0);
  for (const FrameMetrics& one : recorder.all<FrameMetrics>()) ++times[static_cast<std::size_t>(one.frame)];
  EXPECT_LT(std::ranges::count_if(times, [](int count) { return count > 1; }), 41);
}
