// Figures of the frames that are not on show, measured in idle time on the render thread.
#include "tests/support/RenderRecorder.h"

#include "core/inspect/Inspector.h"

#include <algorithm>
#include <cstdlib>
#include <future>
#include <set>
#include <utility>
#include <vector>

using taa::Figure;
using taa::FrameFigures;
using taa::IntermediateId;
using taa::test::onThread::viewOf;

namespace {

constexpr auto kWork = "Measuring the frames";
constexpr int kSamples = 4;
const std::vector<Figure> kWanted{Figure::MeanAlpha, Figure::Clipped, Figure::Rmse, Figure::Psnr};

class RenderFiguresTest : public taa::test::onThread::RenderThreadTest {
 protected:
  /// Those that are whole, in the order they came.
  std::vector<FrameFigures> whole() {
    std::vector<FrameFigures> figures;
    for (const FrameFigures& one : recorder.figures)
      if (one.exact && one.at(Figure::Rmse)) figures.push_back(one);
    return figures;
  }
  void measure(int first, int last, int frame) {
    thread->post(taa::request::SetReferenceSamples{kSamples});
    thread->post(taa::request::SetPlayback{{.range = std::pair(first, last)}});
    thread->post(taa::request::Seek{frame});
    thread->waitUntilIdle();
    thread->post(taa::request::SetFigures{kWanted});
  }
};

/// The frame's figures where somebody goes there, from an inspector of its own thread's context.
FrameFigures visited(const taa::Status& status, int frame) {
  const auto make = [&] {
    taa::Inspector inspector;
    inspector.shot().setSize(status.width, status.height);
    inspector.shot().setSettings(status.settings);
    inspector.shot().open(status.source);
    inspector.shot().seek(frame);
    inspector.reference().refine(kSamples);
    return inspector.metrics().figures(kWanted);
  };
  return std::async(std::launch::async, make).get();
}

} // namespace

TEST_F(RenderFiguresTest, AllFramesThatArePlayedAreMeasuredAsIfTheyWereVisited) {
  measure(6, 22, 15);
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
  thread->waitUntilIdle();
  const std::vector<FrameFigures> figures = whole();
  std::set<int> frames;
  for (const FrameFigures& one : figures) frames.insert(one.frame);
  EXPECT_EQ(frames.size(), 17u);
  EXPECT_EQ(*frames.begin(), 6);
  EXPECT_EQ(*frames.rbegin(), 22);
  EXPECT_EQ(figures.size(), frames.size()) << "each once";
  EXPECT_EQ(figures.front().frame, 15);
  for (std::size_t index = 0; index < 9; ++index)
    EXPECT_LE(std::abs(figures[index].frame - 15), 8) << "the nearest first";
  for (const FrameFigures& one : figures)
    if (one.frame % 5 == 1) {
      const FrameFigures there = visited(recorder.statuses.back(), one.frame);
      for (const Figure figure : kWanted) EXPECT_EQ(one.at(figure), there.at(figure)) << one.frame;
    }
  for (const taa::ViewResult& picture : recorder.pictures)
    EXPECT_EQ(picture.frame, 15) << "what is shown stays";
  EXPECT_TRUE(recorder.works.back().what.empty());
  EXPECT_TRUE(std::ranges::any_of(recorder.works, [](const taa::Work& work) {
    return work.what == kWork && work.done > 8 && work.total == 17;
  }));
  EXPECT_TRUE(recorder.errors.empty());
}

TEST_F(RenderFiguresTest, WishesAreAnsweredMeanwhileAndCancelEndsIt) {
  bool asked = false;
  recorder.onWork = [&](const taa::Work& work) {
    if (work.what != kWork || work.done < 3 || asked) return;
    asked = true;
    thread->post(taa::request::SetPins{.pins = {{.pixel = {3, 4}}}, .active = 0});
    thread->post(taa::request::Cancel{});
  };
  measure(0, 60, 30);
  thread->waitUntilIdle();
  EXPECT_TRUE(asked);
  EXPECT_EQ(recorder.probes.size(), 1u);
  EXPECT_LT(whole().size(), 6u);
  EXPECT_TRUE(recorder.works.back().what.empty());
  thread->post(taa::request::SetFigures{{Figure::MeanAlpha}}); // asked again: from the beginning
  thread->waitUntilIdle();
  EXPECT_TRUE(std::ranges::any_of(recorder.figures, [](const FrameFigures& one) { return one.frame == 60; }));
}

TEST_F(RenderFiguresTest, NothingIsMeasuredWhileItPlays) {
  thread->post(taa::request::SetPlayback{{.range = std::pair(0, 40)}});
  thread->post(taa::request::SetPlaying{true});
  thread->post(taa::request::SetFigures{{Figure::MeanAlpha}});
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.figures.size() > 6; }));
  recorder.read([&] {
    for (const taa::Work& work : recorder.works) EXPECT_NE(work.what, kWork);
  });
  thread->post(taa::request::SetPlaying{false});
  thread->waitUntilIdle();
  std::set<int> frames;
  for (const FrameFigures& one : recorder.figures) frames.insert(one.frame);
  EXPECT_EQ(frames.size(), 41u) << "those that were played are known";
  std::vector<int> times(41, 0);
  for (const FrameFigures& one : recorder.figures) ++times[static_cast<std::size_t>(one.frame)];
  EXPECT_LT(std::ranges::count_if(times, [](int count) { return count > 1; }), 41);
}
