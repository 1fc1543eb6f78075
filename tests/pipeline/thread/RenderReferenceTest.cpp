// The reference and the figures of frames, on the render thread.
#include "tests/support/RenderRecorder.h"

#include <algorithm>
#include <utility>
#include <vector>

using taa::Figure;
using taa::IntermediateId;
using taa::test::onThread::viewOf;

namespace {
constexpr auto kWork = "Drawing the reference";
} // namespace

class RenderReferenceTest : public taa::test::onThread::RenderThreadTest {
 protected:
  std::vector<int> samplesShown() {
    std::vector<int> samples;
    for (const taa::ViewResult& picture : recorder.pictures)
      if (taa::isOfReference(picture.request.id)) samples.push_back(picture.referenceSamples);
    return samples;
  }
};

TEST_F(RenderReferenceTest, IsRefinedWhileAViewShowsIt) {
  thread->post(taa::request::SetReferenceSamples{48});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.statuses.back().referenceGoal, 48);
  EXPECT_TRUE(recorder.works.empty() || recorder.works.back().what != kWork) << "nobody looks";
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::reference), viewOf(IntermediateId::resolved)}});
  thread->waitUntilIdle();
  EXPECT_EQ(samplesShown(), (std::vector{0, 4, 16, 48}));
  EXPECT_FALSE(recorder.pictures.front().error);
  const taa::ViewResult& last = recorder.pictures.back();
  ASSERT_TRUE(last.error);
  EXPECT_GT(last.error->rmse, 0.0);
  EXPECT_EQ(std::ranges::count(recorder.pictures, IntermediateId::resolved,
                               [](const taa::ViewResult& picture) { return picture.request.id; }),
            1)
      << "the others are not drawn again";
  const auto told = std::ranges::find(recorder.works, 48, &taa::Work::done);
  ASSERT_NE(told, recorder.works.end());
  EXPECT_EQ(told->what, kWork);
  EXPECT_EQ(told->total, 48);
  EXPECT_TRUE(recorder.works.back().what.empty());
  EXPECT_TRUE(recorder.errors.empty());
}

TEST_F(RenderReferenceTest, AnswersWishesMeanwhileAndStops) {
  bool asked = false;
  recorder.onWork = [&](const taa::Work& work) {
    if (work.what != kWork || work.done < 20 || asked) return;
    asked = true;
    thread->post(taa::request::SetPins{.pins = {{.pixel = {3, 4}}}, .active = 0});
    thread->post(taa::request::Cancel{});
  };
  thread->post(taa::request::SetReferenceSamples{1024});
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::referenceError)}});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.probes.size(), 1u);
  EXPECT_TRUE(recorder.works.back().what.empty());
  EXPECT_EQ(samplesShown().back(), 16);
  thread->post(taa::request::SetReferenceSamples{16}); // fewer than there are: anew
  thread->waitUntilIdle();
  EXPECT_EQ(samplesShown().back(), 16);
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.pictures.back().frame, 1);
  EXPECT_EQ(samplesShown().back(), 16) << "another frame starts again by itself";
}

TEST_F(RenderReferenceTest, IsNotDrawnWhilePlaying) {
  thread->post(taa::request::SetReferenceSamples{4});
  thread->post(taa::request::SetPlaying{true});
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::reference)}});
  ASSERT_TRUE(recorder.waitFor([&] { return recorder.pictures.size() > 3; }));
  recorder.read([&] {
    for (const int samples : samplesShown()) EXPECT_EQ(samples, 0);
  });
  thread->post(taa::request::SetPlaying{false});
  thread->waitUntilIdle();
  EXPECT_EQ(samplesShown().back(), 4);
}

TEST_F(RenderReferenceTest, FiguresComeWithEachFrameThatIsShown) {
  thread->post(taa::request::SetPlayback{{.range = std::pair(0, 4)}});
  thread->post(taa::request::SetFigures{{Figure::MeanAlpha, Figure::HistoryLength}});
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  const auto found = std::ranges::find(recorder.figures, 2, &taa::FrameFigures::frame);
  ASSERT_NE(found, recorder.figures.end());
  const taa::FrameFigures& last = *found;
  EXPECT_EQ(last.frame, 2);
  EXPECT_TRUE(last.exact);
  ASSERT_TRUE(last.at(Figure::MeanAlpha) && last.at(Figure::HistoryLength));
  EXPECT_GT(*last.at(Figure::HistoryLength), 1.0);
  EXPECT_FALSE(last.at(Figure::Rmse));
  thread->post(taa::request::SetFigures{{}});
  thread->waitUntilIdle();
  const std::size_t before = recorder.figures.size();
  thread->post(taa::request::Step{1});
  thread->waitUntilIdle();
  EXPECT_EQ(recorder.figures.size(), before);
}

TEST_F(RenderReferenceTest, AFigureAgainstTheReferenceHasItDrawn) {
  thread->post(taa::request::SetReferenceSamples{8});
  thread->post(taa::request::SetPlayback{{.range = std::pair(0, 2)}});
  thread->post(taa::request::SetFigures{{Figure::Rmse}});
  thread->waitUntilIdle();
  ASSERT_FALSE(recorder.figures.empty());
  EXPECT_FALSE(recorder.figures.front().at(Figure::Rmse)) << "at once, as far as it is known";
  const auto found = std::ranges::find(recorder.figures, 8, &taa::FrameFigures::referenceSamples);
  ASSERT_NE(found, recorder.figures.end());
  EXPECT_EQ(found->frame, 0);
  ASSERT_TRUE(found->at(Figure::Rmse));
  EXPECT_GT(*found->at(Figure::Rmse), 0.0);
}
