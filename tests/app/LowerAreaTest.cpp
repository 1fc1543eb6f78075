// The area above the timeline: one page at a time, by key, menu and tab; jitter and weights say what the
// frame's are.
#include "app/panels/LowerArea.h"

#include "app/panels/JitterPanel.h"
#include "app/panels/ProfilerPanel.h"
#include "app/panels/WeightsPanel.h"
#include "app/views/plots/CurveChart.h"
#include "app/views/plots/JitterView.h"
#include "app/widgets/ValueTable.h"
#include "core/probe/SampleWeights.h"
#include "tests/app/WindowFixture.h"

#include <QTabBar>
#include <QToolButton>

#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

class Lower : public test::FakeWindow {
 protected:
  void clickTab(LowerPage page) {
    QTabBar* tabs = window.lower()->tabs();
    QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(static_cast<int>(page)).center());
    settle();
  }
  /// Goes to a frame and opens a page, which shows it after a moment.
  void openAt(int frame, Qt::Key page, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    session.probes().setPixel({}); // the settings alone, nothing measured
    session.seek(frame);
    settle();
    key(page, modifiers);
    QTest::qWait(200);
  }
  /// Halton of 4 places and a constant α.
  void useSimpleSettings() {
    session.presets().setParameter("jitter.period", 4);
    session.presets().setParameter("weight.source", static_cast<double>(AlphaSource::Constant));
    session.presets().setParameter("weight.alpha", 0.1);
    settle();
  }
};

} // namespace

TEST_F(Lower, ShowsOnePageAtATimeAndClosesByTheSameKey) {
  EXPECT_FALSE(window.lower()->isVisible());
  key(Qt::Key_F7);
  EXPECT_TRUE(window.jitter()->isVisible());
  EXPECT_FALSE(renderer->last<request::SetProfiling>().on) << "a page that is not shown costs nothing";
  key(Qt::Key_F11, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(window.profiler()->isVisible());
  EXPECT_FALSE(window.jitter()->isVisible());
  EXPECT_TRUE(renderer->last<request::SetProfiling>().on);
  clickTab(LowerPage::Weights);
  EXPECT_TRUE(window.weights()->isVisible());
  EXPECT_FALSE(renderer->last<request::SetProfiling>().on);
  EXPECT_TRUE(window.lower()->shows(LowerPage::Weights));
  key(Qt::Key_F7, Qt::ShiftModifier);
  EXPECT_FALSE(window.lower()->isVisible());
  key(Qt::Key_F7, Qt::ShiftModifier);
  EXPECT_TRUE(window.weights()->isVisible());
  QTest::mouseClick(window.findChild<QToolButton*>("closeLower"), Qt::LeftButton);
  EXPECT_FALSE(window.lower()->isVisible());
}

TEST_F(Lower, PagesHaveIdsForCommandLines) {
  for (int page = 0; page < kLowerPageCount; ++page)
    EXPECT_EQ(lowerPageWithId(lowerPageId(static_cast<LowerPage>(page))), static_cast<LowerPage>(page));
  EXPECT_FALSE(lowerPageWithId("else"));
}

TEST_F(Lower, JitterShowsEverySampleWithItsWeight) {
  useSimpleSettings();
  openAt(5, Qt::Key_F7);
  const JitterView* view = window.jitter()->view();
  ASSERT_EQ(view->pattern().samples.size(), 4u);
  EXPECT_EQ(view->current(), 1) << "frame 5 of a period of 4";
  // Frames 5 and 1 took sample 1: α + (1 − α)⁴·α.
  const double alpha = static_cast<double>(0.1f);
  const double expected = alpha + std::pow(1.0 - alpha, 4.0) * alpha;
  EXPECT_NEAR(view->pattern().samples[1].weight, expected, 1e-12);
  const ValueTable* table = window.jitter()->table();
  ASSERT_EQ(table->topLevelItemCount(), 4);
  EXPECT_EQ(table->topLevelItem(1)->text(0), "1 now");
  EXPECT_EQ(table->topLevelItem(1)->text(3), QString::number(100.0 * expected, 'f', 2));
  EXPECT_EQ(table->topLevelItem(2)->text(4), "2") << "the frame that took it last";
  EXPECT_GT(view->radiusOf(view->pattern().samples[1]), view->radiusOf(view->pattern().samples[2]));
}

// Also one that weighs nearly all, at the pixel's border, with the ring of the current frame.
TEST_F(Lower, DisksOfTheJitterPatternAreNotCut) {
  useSimpleSettings();
  openAt(5, Qt::Key_F7);
  JitterView* view = window.jitter()->view();
  JitterPattern pattern = view->pattern();
  for (const glm::dvec2& corner : {glm::dvec2(0.46, 0.99), glm::dvec2(0.01, 0.02), glm::dvec2(0.5, 0.5)}) {
    pattern.samples[1].position = corner;
    pattern.samples[1].weight = 0.97;
    view->setPattern(pattern, 1);
    const double reach = view->radiusOf(pattern.samples[1]) + 5.0;
    const QPointF center = view->pointOf(corner);
    EXPECT_TRUE(
        QRectF(view->rect()).contains(QRectF(center.x() - reach, center.y() - reach, 2 * reach, 2 * reach)))
        << corner.x << ", " << corner.y;
  }
}

TEST_F(Lower, NumbersOfTheJitterPatternAreReadable) {
  openAt(5, Qt::Key_F7);
  JitterView* view = window.jitter()->view();
  JitterPattern pattern = view->pattern();
  const auto indices = [&] {
    std::set<int> found;
    for (const JitterView::Number& number : view->numbers()) found.insert(number.index);
    return found;
  };
  pattern.samples.assign(4, {glm::dvec2(0.25), 0.25});
  for (std::size_t index = 0; index < 4; ++index)
    pattern.samples[index].position = {index % 2 == 0 ? 0.25 : 0.75, index < 2 ? 0.25 : 0.75};
  view->setPattern(pattern, 1);
  EXPECT_EQ(indices(), (std::set{0, 1, 2, 3})) << "few have all of them";

  pattern.samples = {{glm::dvec2(0.95, 0.5), 0.0}};
  view->setPattern(pattern, 0);
  ASSERT_EQ(view->numbers().size(), 1u);
  EXPECT_LT(view->numbers()[0].place.right(), view->pointOf({1.0, 0.5}).x())
      << "the edge is not drawn over it";

  window.setTextPercent(200);
  pattern.samples.resize(64);
  for (std::size_t index = 0; index < 64; ++index)
    pattern.samples[index] = {(glm::dvec2(index % 8, index / 8) + 0.5) / 8.0, 1.0 / 64.0};
  view->setPattern(pattern, 37);
  view->setHighlighted(38);
  view->resize(170, 170);
  const std::vector<JitterView::Number> numbers = view->numbers();
  for (std::size_t one = 0; one < numbers.size(); ++one) {
    EXPECT_TRUE(QRectF(view->rect()).contains(numbers[one].place)) << numbers[one].index;
    for (std::size_t other = 2; other < one; ++other)
      EXPECT_FALSE(numbers[one].place.intersects(numbers[other].place))
          << numbers[one].index << " and " << numbers[other].index;
  }
  EXPECT_TRUE(indices().contains(37)) << "the current one";
  EXPECT_TRUE(indices().contains(38)) << "the one under the mouse";
  EXPECT_LT(numbers.size(), 40u);
  window.setTextPercent(100);
}

TEST_F(Lower, AClickOnASampleGoesToTheFrameThatTookItLast) {
  useSimpleSettings();
  openAt(9, Qt::Key_F7);
  JitterView* view = window.jitter()->view();
  ASSERT_EQ(view->current(), 1);
  QTest::mouseClick(view, Qt::LeftButton, {}, view->pointOf(view->pattern().samples[3].position).toPoint());
  settle();
  EXPECT_EQ(renderer->status.info.frame, 7);
}

TEST_F(Lower, WeightsDecayFromTheLatestFrame) {
  useSimpleSettings();
  openAt(9, Qt::Key_F7, Qt::ShiftModifier);
  const CurveChart* chart = window.weights()->weights();
  ASSERT_EQ(chart->curves().size(), 1u) << "no probe has measured anything";
  const std::vector<QPointF>& points = chart->curves()[0].points;
  ASSERT_EQ(points.size(), 10u);
  const double alpha = static_cast<double>(0.1f);
  EXPECT_NEAR(points[0].y(), alpha, 1e-12);
  EXPECT_NEAR(points[3].y(), std::pow(1.0 - alpha, 3) * alpha, 1e-12);
  EXPECT_NEAR(points[9].y(), std::pow(1.0 - alpha, 9), 1e-12) << "frame 0 had no history";
  const std::vector<QPointF>& samples = window.weights()->samples()->curves()[0].points;
  EXPECT_NEAR(samples[9].y(), 5.13, 0.005) << "the Unity blog's table";
  EXPECT_TRUE(window.weights()->summary().contains("effective samples: 5.133 now, 19 at last"))
      << window.weights()->summary().toStdString();
}

TEST_F(Lower, AClickOnEffectiveSamplesGoesToThatFrame) {
  openAt(9, Qt::Key_F7, Qt::ShiftModifier);
  CurveChart* chart = window.weights()->samples();
  QTest::mouseClick(chart, Qt::LeftButton, {},
                    {static_cast<int>(std::lround(chart->viewXOf(4.0))), chart->height() / 2});
  settle();
  EXPECT_EQ(renderer->status.info.frame, 4);
}
