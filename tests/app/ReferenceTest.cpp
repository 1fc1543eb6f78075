// The reference in the window: keys and menu, what a view says about it, metrics that arrive.
#include "app/views/ViewArea.h"
#include "app/views/ViewSides.h"
#include "tests/app/WindowFixture.h"

#include <QMenuBar>

#include <limits>
#include <vector>

using namespace taa;
using namespace taa::app;
using ReferenceKeys = test::FakeWindow;

namespace {

QAction* actionOf(const MainWindow& window, const QString& text) {
  for (QAction* action : window.menuBar()->findChildren<QAction*>())
    if (action->text().remove(QLatin1Char('&')) == text) return action;
  for (QAction* action : window.findChildren<QAction*>())
    if (action->text().remove(QLatin1Char('&')) == text) return action;
  return nullptr;
}

ViewResult resultOf(IntermediateId id, int samples) {
  ViewResult result;
  result.request.id = id;
  result.referenceSamples = samples;
  if (samples > 0) result.error = PictureError{0.01234, 38.26, 0.5};
  return result;
}

} // namespace

TEST_F(ReferenceKeys, ShowItAndGoBack) {
  const IntermediateId before = IntermediateId::alpha; // not what it starts with
  window.showIntermediate(before);
  settle();
  key(Qt::Key_U);
  EXPECT_EQ(renderer->last<request::SetViews>().views.at(0).id, IntermediateId::reference);
  key(Qt::Key_U, Qt::ShiftModifier);
  EXPECT_EQ(renderer->last<request::SetViews>().views.at(0).id, IntermediateId::referenceError);
  EXPECT_TRUE(actionOf(window, "Show the error against it")->isChecked());
  key(Qt::Key_U, Qt::ControlModifier);
  EXPECT_EQ(renderer->last<request::SetViews>().views.at(0).id, IntermediateId::referenceErrorAbs);
  EXPECT_EQ(renderer->last<request::SetViews>().views.at(0).style.map, ColorMap::Inferno);
  key(Qt::Key_U, Qt::ControlModifier);
  EXPECT_EQ(renderer->last<request::SetViews>().views.at(0).id, before);
}

TEST_F(ReferenceKeys, TheMenuSaysHowManySamplesThereShallBe) {
  QAction* many = actionOf(window, "256 samples in a pixel");
  ASSERT_TRUE(many);
  EXPECT_FALSE(many->isChecked());
  many->trigger();
  settle();
  EXPECT_EQ(renderer->status.referenceGoal, 256);
  EXPECT_TRUE(many->isChecked());
  EXPECT_FALSE(actionOf(window, "64 samples in a pixel")->isChecked());
}

TEST_F(ReferenceKeys, MetricsArriveForEachFrame) {
  std::vector<FrameMetrics> arrived;
  session.onArrival<FrameMetrics>(&window, [&](const FrameMetrics& metrics) { arrived.push_back(metrics); });
  session.post(request::SetMetrics{{Metric::Rmse}});
  session.seek(5);
  session.seek(6);
  settle();
  ASSERT_EQ(arrived.size(), 3u) << "none is lost";
  EXPECT_EQ(arrived[2].frame, 6);
  EXPECT_EQ(arrived[2].at(Metric::Rmse), 0.06);
  EXPECT_FALSE(arrived[2].at(Metric::MeanAlpha));
}

TEST(ReferenceNote, SaysSamplesAndError) {
  EXPECT_EQ(referenceNote(resultOf(IntermediateId::resolved, 0)), QString());
  EXPECT_EQ(referenceNote(resultOf(IntermediateId::reference, 0)), "not drawn yet: comes while paused");
  EXPECT_EQ(referenceNote(resultOf(IntermediateId::referenceError, 64)),
            QString::fromUtf8("64 samples · RMSE 0.0123 · PSNR 38.3 dB"));
  ViewResult same = resultOf(IntermediateId::reference, 4);
  same.error = PictureError{0.0, std::numeric_limits<double>::infinity(), 0.0};
  EXPECT_EQ(referenceNote(same), QString::fromUtf8("4 samples · RMSE 0.0000 · PSNR ∞"));
  same.isReferenceGiven = true;
  EXPECT_EQ(referenceNote(same), QString::fromUtf8("the capture's own · RMSE 0.0000 · PSNR ∞"));
  ViewResult seen = resultOf(IntermediateId::flip, 64);
  seen.number = 0.03127;
  EXPECT_EQ(referenceNote(seen), QString::fromUtf8("64 samples · FLIP 0.0313"));
}
