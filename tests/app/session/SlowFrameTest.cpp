// While a frame takes its time the window shows at once what is known.
#include "app/models/ProbeModel.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/StatusLine.h"
#include "app/style/Numbers.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewPanel.h"
#include "app/views/Viewport.h"
#include "app/widgets/parameters/NumberField.h"
#include "app/widgets/parameters/ParameterRow.h"
#include "tests/app/WindowFixture.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>

using namespace taa;
using namespace taa::app;

namespace {

constexpr int kSoonMs = 50;

class SlowFrame : public test::FakeWindow {
 protected:
  void SetUp() override {
    FakeWindow::SetUp();
    session.probes().setPixel(glm::ivec2(12, 7));
    hover(viewport()->rect().center() - QPoint(40, 20)); // its values come with the pictures then
    settle();
    renderer->holdsBack = true;
  }
  Viewport* viewport() const { return window.views()->view(0)->viewport(); }
  void hover(const QPoint& place) {
    QMouseEvent move(QEvent::MouseMove, place, viewport()->mapToGlobal(place), Qt::NoButton, Qt::NoButton,
                     {});
    QApplication::sendEvent(viewport(), &move);
  }
  QPoint middle() const { return viewport()->rect().center(); }
  QString cell(IntermediateId id) const {
    return window.probe()->model()->indexOf(id, ProbeModel::Value).data().toString();
  }
  QString place() const { return window.probe()->head()->findChild<QLabel*>("place")->text(); }
  static QString textOf(const glm::ivec2& pixel) {
    return QStringLiteral("(%1, %2)").arg(pixel.x).arg(pixel.y);
  }
};

} // namespace

TEST_F(SlowFrame, APickShowsAtOnceWhatTheViewsKnowAndNothingOfThePixelBefore) {
  const QString before = cell(IntermediateId::depth);
  ASSERT_FALSE(before.isEmpty());
  QTest::mouseClick(viewport(), Qt::RightButton, {}, middle());
  const glm::ivec2 pixel = *session.probes().pixel();
  ASSERT_NE(pixel, glm::ivec2(12, 7));
  QTest::qWait(kSoonMs);
  EXPECT_TRUE(place().contains(textOf(pixel))) << place().toStdString();
  const auto values = viewport()->valueAt(pixel);
  ASSERT_TRUE(values);
  const QString shown = cell(window.views()->view(0)->id());
  EXPECT_TRUE(shown.contains(roundedText(values->front()))) << shown.toStdString();
  EXPECT_EQ(cell(IntermediateId::depth), "") << "no view shows it";
  QApplication::clipboard()->setText("untouched");
  QTest::keyClick(&window, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(QApplication::clipboard()->text(), "untouched");
  renderer->holdsBack = false;
  renderer->deliver();
  settle();
  EXPECT_EQ(cell(IntermediateId::depth).trimmed().toFloat(),
            test::FakeRenderer::valueAt(pixel.x, pixel.y, renderer->status.info.frame));
}

TEST_F(SlowFrame, AnAnswerThatComesSoonTakesThePlaceOfTheOldOneAtOnce) {
  const QString before = cell(IntermediateId::depth);
  renderer->holdsBack = false;
  QStringList seen;
  const ProbeModel* model = window.probe()->model();
  QObject::connect(model, &ProbeModel::dataChanged, model, [&] { seen << cell(IntermediateId::depth); });
  session.probes().setPixel(glm::ivec2(20, 9));
  settle();
  ASSERT_FALSE(seen.isEmpty());
  EXPECT_FALSE(seen.contains(QString())) << "no flicker";
  EXPECT_NE(cell(IntermediateId::depth), before);
}

TEST_F(SlowFrame, ADraggedNumberShowsItsValueAtOnce) {
  window.pipeline()->setAllExpanded(true);
  const auto& rows = window.pipeline()->parameterRows();
  const auto row = std::ranges::find_if(
      rows, [](const ParameterRow* each) { return each->path() == QLatin1String("weight.minimum"); });
  auto* field = qobject_cast<NumberField*>((*row)->editor());
  ASSERT_TRUE(field);
  const double before = field->value();
  const QPoint from = field->rect().center(), to = from + QPoint(30, 0);
  QTest::mousePress(field, Qt::LeftButton, {}, from);
  QMouseEvent move(QEvent::MouseMove, to, field->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(field, &move);
  QTest::qWait(kSoonMs);
  EXPECT_NE(field->value(), before);
  EXPECT_FLOAT_EQ(static_cast<float>(field->value()), session.presets().settings().weight.minimum);
  QTest::mouseRelease(field, Qt::LeftButton, {}, to);
}

TEST_F(SlowFrame, TheMouseOverAPictureShowsItsValueAndTheWheelZoomsAtOnce) {
  hover(middle());
  QTest::qWait(kSoonMs);
  const auto pixel = viewport()->hovered();
  ASSERT_TRUE(pixel);
  const auto values = viewport()->valueAt(*pixel);
  ASSERT_TRUE(values);
  EXPECT_TRUE(window.statusLine()->hover().contains(textOf(*pixel)));
  EXPECT_TRUE(window.statusLine()->hover().contains(shortText(values->front(), 5)));
  const double zoom = viewport()->zoom();
  QWheelEvent turn(middle(), viewport()->mapToGlobal(middle()), {}, {0, 120}, {}, {}, Qt::NoScrollPhase,
                   false);
  QApplication::sendEvent(viewport(), &turn);
  QTest::qWait(kSoonMs);
  EXPECT_GT(viewport()->zoom(), zoom);
  const QImage shown = viewport()->grab().toImage();
  EXPECT_NE(shown.pixelColor(middle()), QColor(Qt::black)) << "the picture that is there, larger";
}
