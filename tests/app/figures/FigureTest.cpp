// Figures for files: cropped to what is shown, with frame and settings below, as pixels and as drawing.
#include "app/figures/Figure.h"
#include "app/figures/FigureExport.h"
#include "app/style/Theme.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/views/plots/JitterView.h"
#include "tests/app/WindowFixture.h"

#include <QContextMenuEvent>
#include <QFile>
#include <QFileDialog>
#include <QMenu>
#include <QPainter>
#include <QPointer>
#include <QTemporaryDir>

#include <algorithm>

using namespace taa::app;
using namespace taa::app::test;

namespace {

/// A square on nothing.
class SquareWidget : public QWidget {
 public:
  SquareWidget() { resize(200, 100); }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.fillRect(60, 30, 20, 10, QColor(200, 30, 30));
    painter.drawText(QPointF(60, 40), QStringLiteral("w"));
  }
};

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

TEST(FigureTest, IsCroppedToWhatTheWidgetPaints) {
  SquareWidget widget;
  const QRect shown = shownPart(widget);
  EXPECT_TRUE(shown.contains(QRect(60 - kUnit, 30 - kUnit, 20 + 2 * kUnit, 10 + 2 * kUnit)));
  EXPECT_LT(shown.width(), 40);
  const FigureContent two = widgetsContent({&widget, &widget}, Qt::Horizontal, {});
  EXPECT_EQ(two.size.height(), shown.height());
  EXPECT_GT(two.size.width(), 2 * shown.width()) << "with room between";
}

TEST(FigureTest, TheCaptionStandsBelowAndIsWrapped) {
  SquareWidget widget;
  const FigureContent content = widgetsContent({&widget}, Qt::Vertical, {});
  const QString line = QStringLiteral("One."), lines = QStringLiteral("Many words. ").repeated(40);
  const QImage shorter = figurePicture(content, line, widget), longer = figurePicture(content, lines, widget);
  EXPECT_EQ(shorter.width(), longer.width());
  EXPECT_GT(longer.height(), shorter.height() + 100);
  int red = 0;
  for (int y = 0; y < shorter.height(); ++y)
    for (int x = 0; x < shorter.width(); ++x) red += shorter.pixelColor(x, y) == QColor(200, 30, 30) ? 1 : 0;
  EXPECT_GT(red, 500) << "twice as fine as on the screen";
}

TEST(FigureTest, AsDrawingItKeepsItsTexts) {
  SquareWidget widget;
  const QByteArray svg = figureSvg(widgetsContent({&widget}, Qt::Vertical, {}), QStringLiteral("Square"),
                                   QStringLiteral("builtin:fan, frame 40."), widget);
  EXPECT_TRUE(svg.contains("<title>Square</title>")) << svg.toStdString();
  EXPECT_TRUE(svg.contains("builtin:fan, frame 40."));
  EXPECT_TRUE(svg.contains("<text"));
}

class FigureExportTest : public FakeWindow {
 protected:
  FigureExport* figures() { return window.findChild<FigureExport*>(); }
  QStringList shown() {
    QStringList ids;
    for (const Figure& figure : figures()->shown()) ids << figure.id;
    return ids;
  }
  QMenu* menu() { return qobject_cast<QMenu*>(QApplication::activePopupWidget()); }
};

TEST_F(FigureExportTest, AListHoldsWhatIsOnShow) {
  EXPECT_FALSE(shown().contains(QStringLiteral("jitter")));
  EXPECT_TRUE(shown().contains(QStringLiteral("view-a")));
  key(Qt::Key_F7);
  EXPECT_TRUE(shown().contains(QStringLiteral("jitter")));
  key(Qt::Key_G, Qt::ControlModifier | Qt::AltModifier);
  ASSERT_TRUE(menu());
  QStringList labels;
  for (const QAction* action : menu()->actions()) labels << action->text();
  EXPECT_TRUE(labels.contains(QStringLiteral("Jitter pattern"))) << labels.join(u'|').toStdString();
  menu()->close();
}

TEST_F(FigureExportTest, AFigureIsWrittenWithFrameAndSettings) {
  key(Qt::Key_F7);
  const QTemporaryDir folder;
  const QString svg = folder.filePath(QStringLiteral("j.svg")),
                png = folder.filePath(QStringLiteral("j.png"));
  figures()->write(QStringLiteral("jitter"), svg);
  figures()->write(QStringLiteral("jitter"), png);
  const QByteArray drawing = bytesOf(svg);
  EXPECT_TRUE(drawing.contains("Jitter pattern"));
  const QByteArray frame = "frame " + QByteArray::number(session.status().info.frame);
  EXPECT_TRUE(drawing.contains(frame)) << drawing.left(600).toStdString();
  EXPECT_TRUE(drawing.contains(session.presets().presetId().c_str()));
  EXPECT_FALSE(QImage(png).isNull());
  figures()->write(QStringLiteral("lineage"), folder.filePath(QStringLiteral("l.png")));
  EXPECT_TRUE(bytesOf(folder.filePath(QStringLiteral("l.png"))).isEmpty()) << "it is not on show";
}

TEST_F(FigureExportTest, AViewIsCroppedToItsPictureAndHasItsLegend) {
  const Viewport* viewport = window.views()->view(0)->viewport();
  ASSERT_TRUE(waitFor([&] { return !viewport->picture(false).isNull(); }, 5000));
  const QRect picture = viewport->pictureRect();
  EXPECT_LT(picture.width() * picture.height(), viewport->width() * viewport->height());
  const auto all = figures()->shown();
  const FigureContent content = all.front().content();
  EXPECT_EQ(all.front().id, QStringLiteral("view-a"));
  EXPECT_EQ(content.size.width(), std::max(picture.width(), 80 * kUnit));
  EXPECT_GT(content.size.height(), picture.height());
}

TEST_F(FigureExportTest, TheContextMenuOfAFigureOffersIt) {
  key(Qt::Key_F7);
  auto* view = window.findChild<JitterView*>();
  QContextMenuEvent event(QContextMenuEvent::Mouse, QPoint(5, 5), view->mapToGlobal(QPoint(5, 5)));
  QApplication::sendEvent(view, &event);
  const QPointer<QMenu> opened = menu();
  ASSERT_TRUE(opened);
  opened->actions().front()->trigger();
  if (opened) opened->close();
  auto* dialog = window.findChild<QFileDialog*>();
  ASSERT_TRUE(dialog);
  EXPECT_EQ(dialog->nameFilters().size(), 2);
  dialog->reject();
}
