// Figures of frames on their way to the strip of the timeline.
#include "app/models/FigureHistory.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

FrameFigures figuresOf(int frame, double alpha) {
  FrameFigures figures;
  figures.frame = frame;
  figures.at(Figure::MeanAlpha) = alpha;
  return figures;
}

using Values = std::vector<std::optional<double>>;

} // namespace

TEST(FigureHistory, KeepsTheExactFiguresOfTheFirstLane) {
  FigureHistory history;
  EXPECT_TRUE(history.add(figuresOf(1, 0.5)));
  FrameFigures other = figuresOf(2, 0.25);
  other.exact = false;
  EXPECT_FALSE(history.add(other));
  other.exact = true;
  other.lane = 1;
  EXPECT_FALSE(history.add(other));
  EXPECT_EQ(history.strip(Figure::MeanAlpha, 4).values, (Values{{}, 0.5, {}, {}}));
  EXPECT_EQ(history.strip(Figure::Rmse, 2).values, (Values{{}, {}}));
  EXPECT_EQ(history.strip(Figure::Rejected, 2).unit, " %");
}

TEST(FigureHistory, ForgetsWhatIsNoLongerTrueAndIgnoresWhatComesTooLate) {
  FigureHistory history;
  history.add(figuresOf(1, 0.5));
  EXPECT_TRUE(history.setShotVersion(3));
  EXPECT_EQ(history.strip(Figure::MeanAlpha, 2).values, (Values{{}, {}}));
  FrameFigures late = figuresOf(1, 0.5);
  late.shotVersion = 2;
  EXPECT_FALSE(history.add(late));
  late.shotVersion = 3;
  EXPECT_TRUE(history.add(late));
  EXPECT_FALSE(history.setShotVersion(3));
  EXPECT_EQ(history.strip(Figure::MeanAlpha, 2).values, (Values{{}, 0.5}));
}

TEST(FigureHistory, LeavesOutWhatCannotBeDrawn) {
  FigureHistory history;
  FrameFigures figures = figuresOf(0, 0.5);
  figures.at(Figure::Psnr) = std::numeric_limits<double>::infinity();
  history.add(figures);
  EXPECT_EQ(history.strip(Figure::Psnr, 1).values, (Values{{}}));
}
