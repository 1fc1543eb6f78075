// Plots of the probes over frames: what is shown adds points, a click seeks, zoom is shared, the CSV is that
// of taa-batch.
#include "app/panels/PlotsPanel.h"

#include "app/panels/JitterPanel.h"
#include "app/panels/LowerArea.h"
#include "app/panels/TimelinePanel.h"
#include "app/panels/WeightsPanel.h"
#include "app/views/plots/CurveChart.h"
#include "app/views/timeline/Timeline.h"
#include "core/report/TraceText.h"
#include "tests/app/WindowFixture.h"

#include <QClipboard>
#include <QFile>
#include <QHelpEvent>
#include <QMenu>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>
#include <cstddef>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

class Plots : public test::FakeWindow {
 protected:
  void SetUp() override {
    FakeWindow::SetUp();
    session.probes().setPixel(glm::ivec2(3, 2));
    settle();
    key(Qt::Key_F6);
    plots()->setRows(
        {{IntermediateId::alpha}, {IntermediateId::clipAmount}, {IntermediateId::historyLength}});
    refresh();
  }
  /// Charts follow a few times a second.
  void refresh() { QTest::qWait(200); }
  void goTo(int frame) {
    session.seek(frame);
    test::waitFor([&] { return session.status().info.frame == frame; }, 5000);
    settle();
  }
  PlotsPanel* plots() const { return window.plots(); }
  CurveChart* chart(std::size_t index = 0) const { return plots()->charts().at(index); }
  QPoint placeOf(double frame) const {
    return {static_cast<int>(std::lround(chart()->viewXOf(frame))), chart()->height() / 2};
  }
  void wheel(const QPoint& at, int notches) {
    QWheelEvent event(at, chart()->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(chart(), &event);
    settle();
  }
};

} // namespace

TEST_F(Plots, TellInTheTipOfANameHowTheProbesValueWasMade) {
  std::vector<IntermediateId> asked;
  plots()->setFormulas([&asked](IntermediateId id) {
    asked.push_back(id);
    return id == IntermediateId::alpha ? QStringLiteral("1 / (7 + 1) = 0.125") : QString();
  });
  const auto tipOf = [this](const QString& label) {
    for (QToolButton* chip : plots()->findChildren<QToolButton*>())
      if (chip->text() == label) {
        QHelpEvent event(QEvent::ToolTip, {2, 2}, chip->mapToGlobal(QPoint(2, 2)));
        QApplication::sendEvent(chip, &event);
      }
    return QToolTip::text();
  };
  const QString alpha = tipOf(QString::fromUtf8(intermediate(IntermediateId::alpha).label.data()));
  EXPECT_TRUE(alpha.endsWith("At the probe, frame 0: 1 / (7 + 1) = 0.125")) << alpha.toStdString();
  const Intermediate& clip = intermediate(IntermediateId::clipAmount);
  EXPECT_EQ(tipOf(QString::fromUtf8(clip.label.data())).toStdString(), clip.description);
  EXPECT_EQ(asked, (std::vector{IntermediateId::alpha, IntermediateId::clipAmount}));
}

TEST_F(Plots, EveryFrameThatIsShownAddsAPoint) {
  for (const int frame : {5, 6, 9}) goTo(frame);
  ASSERT_EQ(chart()->curves().size(), 1u);
  ASSERT_TRUE(test::waitFor([&] { return valueAt(chart()->curves()[0].points, 9).has_value(); }, 5000));
  const std::vector<QPointF>& points = chart()->curves()[0].points;
  for (const int frame : {0, 5, 6, 9})
    EXPECT_EQ(valueAt(points, frame), static_cast<double>(test::FakeRenderer::valueAt(3, 2, frame))) << frame;
  EXPECT_FALSE(valueAt(points, 7));
  EXPECT_EQ(runsOf(points).size(), 3u) << "lines break where frames are not known";
}

TEST_F(Plots, OpenWithTheResolvedColorBesideTheFramesOwn) {
  plots()->setRows(firstPlotRows());
  goTo(5);
  refresh();
  const std::vector<Curve>& curves = chart()->curves();
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].name, "1 (3, 2) Resolved G");
  EXPECT_EQ(curves[1].name, "1 (3, 2) Current filtered G");
  EXPECT_TRUE(
      plots()->csv().startsWith(QStringLiteral("probe,frame,x,y,resolved.R,resolved.G,resolved.B,"
                                               "currentFiltered.R,currentFiltered.G,currentFiltered.B,"
                                               "alpha")))
      << plots()->csv().left(120).toStdString();
}

TEST_F(Plots, StandAboveTheTimelineFrameByFrame) {
  const Timeline& ruler = *window.timeline()->timeline();
  const auto expectInLine = [&] {
    for (const CurveChart* each : plots()->charts())
      for (const int frame : {0, 40, 239})
        EXPECT_NEAR(each->mapToGlobal(QPointF(each->viewXOf(frame), 0)).x(),
                    ruler.mapToGlobal(QPointF(ruler.scale().position(frame), 0)).x(), 0.01)
            << frame;
  };
  expectInLine();
  window.resize(1024, 600);
  settle();
  expectInLine();
  wheel(placeOf(60), 5);
  EXPECT_EQ(ruler.scale().frames(), chart()->shown()) << "the ruler zooms along";
  expectInLine();
  QWheelEvent back({200, 20}, ruler.mapToGlobal(QPoint(200, 20)), {}, {0, -2400}, Qt::NoButton,
                   Qt::ControlModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(window.timeline()->timeline(), &back);
  settle();
  EXPECT_EQ(chart()->shown(), (Span{0.0, 239.0})) << "and the plots with the ruler";
}

TEST_F(Plots, AreFilledInInIdleTimeUntilSomebodyStopsThem) {
  EXPECT_EQ(renderer->last<request::TraceInIdleTime>().first, 0);
  EXPECT_EQ(renderer->last<request::TraceInIdleTime>().last, 239);
  renderer->all<request::TraceInIdleTime>().clear();
  goTo(3);
  EXPECT_EQ(renderer->last<request::TraceInIdleTime>().last, -1) << "asked for once";
  session.probes().setPixel(glm::ivec2(8, 5));
  settle();
  EXPECT_EQ(renderer->last<request::TraceInIdleTime>().last, 239) << "of another pixel anew";
}

TEST_F(Plots, CostNothingWhileTheyAreHidden) {
  EXPECT_TRUE(renderer->last<request::SetTracing>().on);
  key(Qt::Key_F11, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(renderer->last<request::SetTracing>().on);
  key(Qt::Key_F7, Qt::ShiftModifier);
  EXPECT_TRUE(renderer->last<request::SetTracing>().on) << "weights are measured at the probe, too";
  key(Qt::Key_F7, Qt::ShiftModifier);
  EXPECT_FALSE(renderer->last<request::SetTracing>().on);
}

TEST_F(Plots, MeasuredWeightsSayWhatTheyDoNotTell) {
  const auto says = [](const AlphaPage* page) {
    return page->summary().contains("easured at (") && page->summary().contains("the page Lineage");
  };
  key(Qt::Key_F7, Qt::ShiftModifier);
  ASSERT_TRUE(app::test::waitFor([&] { return says(window.weights()); }));
  key(Qt::Key_F7);
  ASSERT_TRUE(app::test::waitFor([&] { return says(window.jitter()); }));
  session.probes().removeAll();
  ASSERT_TRUE(app::test::waitFor([&] { return !says(window.jitter()); }));
}

TEST_F(Plots, AClickGoesToItsFrame) {
  QTest::mouseClick(chart(), Qt::LeftButton, {}, placeOf(120));
  settle();
  EXPECT_EQ(renderer->status.info.frame, static_cast<int>(std::round(chart()->xAt(placeOf(120).x()))));
  EXPECT_NEAR(renderer->status.info.frame, 120, 1);
}

TEST_F(Plots, WheelAndDragZoomAllChartsAndAKeyShowsEverything) {
  ASSERT_GE(plots()->charts().size(), 2u);
  const double under = chart()->xAt(placeOf(60).x());
  wheel(placeOf(60), 3);
  EXPECT_LT(chart()->shown().length(), 239.0);
  EXPECT_NEAR(chart()->xAt(placeOf(under).x()), under, 0.5);
  EXPECT_EQ(chart(1)->shown(), chart()->shown());
  key(Qt::Key_0, Qt::ControlModifier);
  EXPECT_EQ(chart()->shown(), (Span{0.0, 239.0}));
  QTest::mousePress(chart(), Qt::LeftButton, {}, placeOf(50));
  QTest::mouseMove(chart(), placeOf(100));
  const QPoint end = placeOf(100);
  QTest::mouseRelease(chart(), Qt::LeftButton, {}, end);
  settle();
  EXPECT_NEAR(chart()->shown().low, 50.0, 1.0);
  EXPECT_NEAR(chart()->shown().high, 100.0, 1.0);
  EXPECT_EQ(renderer->status.info.frame, 0) << "a drag is no click";
  QTest::mouseDClick(chart(), Qt::LeftButton, {}, placeOf(70));
  EXPECT_EQ(chart(1)->shown(), (Span{0.0, 239.0}));
}

TEST_F(Plots, AllFramesAreFilledInByKey) {
  key(Qt::Key_F6, Qt::ControlModifier);
  refresh();
  EXPECT_EQ(runsOf(chart()->curves()[0].points).size(), 1u);
  EXPECT_EQ(chart()->curves()[0].points.size(), 240u);
  EXPECT_TRUE(plots()->summary().contains("240 of 240")) << plots()->summary().toStdString();
  renderer->tell(Work{WorkKind::Traces, "Tracing the probes", 3, 240});
  settle();
  EXPECT_FALSE(plots()->findChild<QPushButton*>("fillTraces")->isEnabled());
  renderer->tell(Work{});
  settle();
  EXPECT_TRUE(plots()->findChild<QPushButton*>("fillTraces")->isEnabled());
}

TEST_F(Plots, MarkRejectionsAndCuts) {
  renderer->status.cuts = {33};
  goTo(20);
  goTo(21);
  refresh();
  const std::vector<ChartMark> expected{
      {33.0, MarkKind::Cut, "cut"}, {0.0, MarkKind::Reject, "depth"}, {20.0, MarkKind::Reject, "depth"}};
  EXPECT_EQ(chart()->marks(), expected);
  chart()->setHovered(20.0);
  EXPECT_TRUE(chart()->readout().contains("depth")) << chart()->readout().toStdString();
}

TEST_F(Plots, SayTheValuesUnderTheMouse) {
  key(Qt::Key_F6, Qt::ControlModifier);
  refresh();
  QTest::mouseMove(chart(), placeOf(80));
  settle();
  const int frame = static_cast<int>(std::round(chart()->xAt(placeOf(80).x())));
  const QString value = QString::number(test::FakeRenderer::valueAt(3, 2, frame));
  EXPECT_TRUE(chart()->readout().contains("1 (3, 2) " + value)) << chart()->readout().toStdString();
  EXPECT_TRUE(chart(1)->readout().contains(QString("frame %1").arg(frame))) << "the others follow";
}

TEST_F(Plots, SeveralProbesAndChannelsAreToldApartWithoutColor) {
  session.probes().add(glm::ivec2(9, 9));
  plots()->addRow(IntermediateId::resolved);
  settle();
  refresh();
  const std::vector<Curve>& curves = plots()->charts().back()->curves();
  ASSERT_EQ(curves.size(), 6u);
  EXPECT_EQ(curves[0].name, "1 (3, 2) R");
  EXPECT_EQ(curves[4].name, "2 (9, 9) G");
  for (std::size_t curve = 1; curve < 5; ++curve) EXPECT_NE(curves[curve].dash, curves[curve - 1].dash);
  plots()->setChannel(IntermediateId::resolved, 1, false);
  refresh();
  EXPECT_EQ(plots()->charts().back()->curves().size(), 4u);
}

TEST_F(Plots, NameChannelsByTheSettingsOfTheValues) {
  plots()->setRows({{IntermediateId::boxMin}});
  const auto first = [&](ColorSpace space) {
    session.presets().setParameter("space.color", static_cast<double>(space));
    goTo(session.status().info.frame == 1 ? 2 : 1);
    refresh();
    EXPECT_FALSE(plots()->charts().back()->curves().empty());
    return plots()->charts().back()->curves()[1].name;
  };
  EXPECT_EQ(first(ColorSpace::Rgb), "1 (3, 2) G");
  EXPECT_TRUE(plots()->csv().startsWith(QStringLiteral("probe,frame,x,y,boxMin.R,boxMin.G,boxMin.B\n")));
  EXPECT_EQ(first(ColorSpace::YCbCr), "1 (3, 2) Cb");
  EXPECT_EQ(first(ColorSpace::YCoCg), "1 (3, 2) Co");
}

TEST_F(Plots, ForgetWhatIsNoLongerTrue) {
  goTo(5);
  goTo(6);
  session.presets().setParameter("jitter.period", 4);
  settle();
  refresh();
  const std::vector<QPointF>& points = chart()->curves()[0].points;
  EXPECT_FALSE(valueAt(points, 5));
  EXPECT_TRUE(valueAt(points, 6)) << "the frame on show was made anew";
}

TEST_F(Plots, GiveTheirValuesAwayAsTaaBatchPrintsThem) {
  goTo(1);
  plots()->setRows({{IntermediateId::alpha}, {IntermediateId::motion}});
  const QString expected = "probe,frame,x,y,alpha,motion.X,motion.Y\n"
                           "1,0,3,2,203,203,203\n"
                           "1,1,3,2,204,204,204\n";
  EXPECT_EQ(plots()->csv(), expected);
  QApplication::clipboard()->clear();
  auto* menu = plots()->findChild<QWidget*>("copyTraces")->findChild<QMenu*>();
  menu->actions().first()->trigger();
  EXPECT_EQ(QApplication::clipboard()->text(), expected);
  const QTemporaryDir folder;
  const QString path = folder.filePath("trace.csv");
  EXPECT_EQ(plots()->saveCsvTo(path), QString());
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(QString::fromUtf8(file.readAll()), expected);
  EXPECT_TRUE(plots()->saveCsvTo("/nowhere/trace.csv").contains("cannot write /nowhere/trace.csv"));
}

TEST_F(Plots, TheirStateComesBack) {
  plots()->setRows({{IntermediateId::resolved, 0b101}, {IntermediateId::speed}});
  const QJsonObject state = plots()->state();
  plots()->setState({});
  EXPECT_EQ(plots()->rows(), firstPlotRows());
  plots()->setState(state);
  ASSERT_EQ(plots()->rows().size(), 2u);
  EXPECT_TRUE(plots()->rows()[0].has(0) && !plots()->rows()[0].has(1) && plots()->rows()[0].has(2));
  EXPECT_EQ(plots()->state(), state);
  plots()->setState({{"rows", QJsonArray{QJsonObject{{"row", "nothing"}}, 7}}});
  EXPECT_TRUE(plots()->rows().empty());
}

// They were those of the frame on show alone until another was shown.
TEST_F(Plots, WeightsFollowFramesBeforeThatAreFilledIn) {
  goTo(9);
  key(Qt::Key_F7, Qt::ShiftModifier);
  const auto tellOf = [&](int frame) {
    const Probe& probe = session.probes().all().at(0);
    TraceDelivery trace{.probe = probe,
                        .frame = frame,
                        .sample = {probe.pixel, {}},
                        .shotVersion = session.status().shotVersion};
    trace.sample.record.fill(glm::vec4(0.1f)); // α with the rest
    renderer->tell(trace);
  };
  const std::vector<Curve>& curves = window.weights()->weights()->curves();
  const auto measures = [&](std::size_t frames) {
    return test::waitFor([&] { return curves.size() == 2 && curves[0].points.size() == frames; }, 5000);
  };
  tellOf(9);
  EXPECT_TRUE(measures(1));
  for (int frame = 0; frame < 9; ++frame) tellOf(frame);
  EXPECT_TRUE(measures(10));
}

TEST_F(Plots, WeightsAreMeasuredAtTheProbe) {
  for (const int frame : {1, 2, 3}) goTo(frame);
  key(Qt::Key_F7, Qt::ShiftModifier);
  refresh();
  const std::vector<Curve>& curves = window.weights()->weights()->curves();
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_TRUE(curves[0].name.contains("(3, 2)")) << curves[0].name.toStdString();
  EXPECT_EQ(curves[0].points[0].y(), static_cast<double>(test::FakeRenderer::valueAt(3, 2, 3)));
}
