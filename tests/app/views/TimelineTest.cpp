// The timeline: what is kept, cuts, the user's marks, the repeated part, speed, and a strip of one metric.
#include "app/views/timeline/Timeline.h"

#include "app/panels/TimelinePanel.h"
#include "app/widgets/Prompt.h"
#include "app/widgets/parameters/ChoiceButton.h"
#include "tests/app/WindowFixture.h"

#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

class TimelineTest : public test::FakeWindow {
 protected:
  Timeline* timeline() const { return window.timeline()->timeline(); }
  QPoint placeOf(int frame, int y) const {
    return {static_cast<int>(std::lround(timeline()->scale().position(frame))), y};
  }
  void drag(bool isLast, int frame) {
    const QPoint from = timeline()->handle(isLast).center().toPoint();
    QTest::mousePress(timeline(), Qt::LeftButton, {}, from);
    QTest::mouseMove(timeline(), placeOf(frame, from.y()));
    QTest::mouseRelease(timeline(), Qt::LeftButton, {}, placeOf(frame, from.y()));
    settle();
  }
  std::vector<int> markedFrames() const {
    std::vector<int> frames;
    for (const auto& [frame, name] : window.timeline()->marks().all()) frames.push_back(frame);
    return frames;
  }
};

using Range = std::optional<std::pair<int, int>>;

} // namespace

TEST_F(TimelineTest, TheEndsOfTheRepeatedPartAreDragged) {
  EXPECT_EQ(renderer->status.playback.range, Range());
  drag(false, 60);
  ASSERT_TRUE(renderer->status.playback.range);
  EXPECT_EQ(renderer->status.playback.range->first, timeline()->scale().frameAt(placeOf(60, 0).x()));
  EXPECT_EQ(renderer->status.playback.range->second, 239);
  drag(true, 120);
  EXPECT_EQ(renderer->status.playback.range->second, timeline()->scale().frameAt(placeOf(120, 0).x()));
  EXPECT_EQ(renderer->status.info.frame, 0) << "dragging a handle goes nowhere";
  key(Qt::Key_Backslash);
  EXPECT_EQ(renderer->status.playback.range, Range());
}

TEST_F(TimelineTest, TheEndsOfTheRepeatedPartAreSetByKeys) {
  session.seek(20);
  settle();
  key(Qt::Key_BracketLeft);
  session.seek(50);
  settle();
  key(Qt::Key_BracketRight);
  EXPECT_EQ(renderer->status.playback.range, Range(std::pair(20, 50)));
  session.seek(70);
  settle();
  key(Qt::Key_BracketLeft);
  EXPECT_EQ(renderer->status.playback.range, Range(std::pair(70, 70))) << "the end goes along";
}

TEST_F(TimelineTest, MarksAreSetTakenAwayAndVisitedByKeys) {
  for (const int frame : {30, 10, 80}) {
    session.seek(frame);
    settle();
    key(Qt::Key_K);
  }
  EXPECT_EQ(markedFrames(), (std::vector{10, 30, 80}));
  key(Qt::Key_PageUp);
  EXPECT_EQ(renderer->status.info.frame, 30);
  key(Qt::Key_PageUp);
  key(Qt::Key_PageUp);
  EXPECT_EQ(renderer->status.info.frame, 10) << "there is none before it";
  key(Qt::Key_PageDown);
  EXPECT_EQ(renderer->status.info.frame, 30);
  key(Qt::Key_K);
  EXPECT_EQ(markedFrames(), (std::vector{10, 80}));
  renderer->status.cuts = {40};
  session.seek(20);
  settle();
  key(Qt::Key_PageDown);
  EXPECT_EQ(renderer->status.info.frame, 40) << "a cut";
}

TEST_F(TimelineTest, AMarkIsNamed) {
  session.seek(12);
  settle();
  key(Qt::Key_K, Qt::ShiftModifier);
  auto* prompt = window.findChild<Prompt*>();
  ASSERT_TRUE(prompt);
  QTest::keyClicks(prompt->field(), "ghost");
  QTest::keyClick(prompt->field(), Qt::Key_Return);
  settle();
  EXPECT_EQ(window.timeline()->marks().nameOf(12), "ghost");
  EXPECT_TRUE(timeline()->textAt(12).contains("ghost")) << timeline()->textAt(12).toStdString();
  EXPECT_FALSE(timeline()->textAt(13).contains("ghost"));
}

TEST_F(TimelineTest, MarksAndRangeBelongToTheirShot) {
  session.seek(12);
  settle();
  key(Qt::Key_K);
  key(Qt::Key_BracketLeft);
  window.openSource("builtin:fence");
  settle();
  EXPECT_TRUE(markedFrames().empty());
  EXPECT_EQ(renderer->status.playback.range, Range());
  window.openSource("builtin:fan");
  settle();
  EXPECT_EQ(markedFrames(), std::vector{12});
  EXPECT_EQ(renderer->status.playback.range, Range(std::pair(12, 239)));
}

TEST_F(TimelineTest, SpeedAndRateAreChosen) {
  key(Qt::Key_BracketLeft, Qt::ControlModifier);
  EXPECT_EQ(renderer->status.playback.speed, 0.5);
  key(Qt::Key_BracketRight, Qt::ControlModifier);
  key(Qt::Key_BracketRight, Qt::ControlModifier);
  EXPECT_EQ(renderer->status.playback.speed, 2.0);
  auto* rate = window.timeline()->findChild<ChoiceButton*>("rate");
  rate->setFocus();
  QTest::keyClick(rate, Qt::Key_Down);
  EXPECT_EQ(renderer->status.playback.framesPerSecond, TimelinePanel::rates()[1]);
  auto* speed = window.timeline()->findChild<ChoiceButton*>("speed");
  EXPECT_EQ(TimelinePanel::speeds()[static_cast<std::size_t>(speed->current())], 2.0);
}

TEST_F(TimelineTest, ItsStateComesBack) {
  session.seek(33);
  settle();
  key(Qt::Key_K);
  key(Qt::Key_BracketRight);
  key(Qt::Key_BracketLeft, Qt::ControlModifier);
  const QJsonObject state = window.timeline()->state();
  window.timeline()->setState({});
  settle();
  EXPECT_TRUE(markedFrames().empty());
  EXPECT_EQ(renderer->status.playback, Playback());
  window.timeline()->setState(state);
  settle();
  EXPECT_EQ(markedFrames(), std::vector{33});
  EXPECT_EQ(renderer->status.playback.range, Range(std::pair(0, 33)));
  EXPECT_EQ(renderer->status.playback.speed, 0.5);
  EXPECT_EQ(window.timeline()->state(), state);
  window.timeline()->setState({{"speed", "fast"}, {"shots", 4}, {"more", true}});
  EXPECT_EQ(renderer->status.playback, Playback()) << "wrong values are defaults";
}

TEST_F(TimelineTest, SaysWhichFramesAreKeptAndCut) {
  renderer->status.keptFrames = {0, 5, 6, 7};
  renderer->status.cuts = {6};
  session.seek(1);
  settle();
  EXPECT_EQ(timeline()->kept(), (std::vector{0, 5, 6, 7}));
  EXPECT_EQ(timeline()->textAt(5), "frame 5 · kept");
  EXPECT_EQ(timeline()->textAt(6), "frame 6 · cut: history starts anew · kept");
  EXPECT_EQ(timeline()->textAt(8), "frame 8");
}

TEST_F(TimelineTest, AStripShowsAMetricOfEachFrame) {
  const int without = timeline()->height();
  window.timeline()->setStrip({"mean α", "", {0.5, std::nullopt, 0.25}});
  EXPECT_GT(timeline()->height(), without);
  EXPECT_TRUE(timeline()->textAt(2).contains("mean α 0.25")) << timeline()->textAt(2).toStdString();
  EXPECT_TRUE(timeline()->textAt(1).contains("not known")) << timeline()->textAt(1).toStdString();
  EXPECT_TRUE(timeline()->textAt(9).contains("not known"));
  session.seek(50); // the playhead out of the way
  settle();
  const QImage image = timeline()->grab().toImage();
  const auto columnAt = [&](int frame) { // lit pixels of the strip above its ground
    int count = 0;
    for (int y = timeline()->height() - 21; y < timeline()->height() - 1; ++y)
      if (image.pixelColor(placeOf(frame, 0).x(), y) == themeColors(timeline()).secondary) ++count;
    return count;
  };
  EXPECT_NEAR(columnAt(0), 2 * columnAt(2), 1);
  window.timeline()->setStrip({});
  EXPECT_EQ(timeline()->height(), without);
}

TEST_F(TimelineTest, ReadoutStaysInPlaceWhileTimeGoesOnAt1280) {
  window.resize(1280, 800);
  const auto x = [&] { return timeline()->geometry(); };
  session.seek(0);
  settle();
  const QRect before = x();
  for (const int frame : {7, 63, 239}) {
    session.seek(frame);
    settle();
    EXPECT_EQ(x(), before) << frame;
  }
  EXPECT_GE(before.width(), 400);
  for (const QLabel* label : window.timeline()->findChildren<QLabel*>())
    EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString();
}

TEST_F(TimelineTest, AChosenMetricIsAskedForAndDrawnUnderTheRuler) {
  window.timeline()->setStripMetric(Metric::MeanAlpha);
  settle();
  EXPECT_EQ(renderer->last<request::SetMetrics>().metrics, std::vector{Metric::MeanAlpha});
  session.seek(40);
  settle();
  session.seek(50);
  settle();
  const TimelineStrip& strip = timeline()->strip();
  ASSERT_EQ(strip.values.size(), 240u);
  EXPECT_EQ(strip.values[40], 0.4);
  EXPECT_EQ(strip.values[50], 0.5);
  EXPECT_FALSE(strip.values[45]);
  session.presets().setParameter("jitter.period", 4);
  settle();
  EXPECT_FALSE(timeline()->strip().values[40]) << "no longer true";
  EXPECT_EQ(window.timeline()->state()["metric"].toString(), "meanAlpha");
  window.timeline()->setStripMetric({});
  settle();
  EXPECT_TRUE(renderer->last<request::SetMetrics>().metrics.empty());
  EXPECT_TRUE(timeline()->strip().name.isEmpty());
}
