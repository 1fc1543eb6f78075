// What the bar of long work leaves of what lies below it.
#include "app/widgets/bars/WorkBar.h"

#include <QPaintEvent>
#include <QRegion>
#include <QTest>
#include <QVBoxLayout>
#include <QWidget>

#include <gtest/gtest.h>

using taa::app::WorkBar;

namespace {

/// A picture that covers its place: nothing is painted below it.
class OpaquePicture : public QWidget {
 public:
  OpaquePicture() { setAttribute(Qt::WA_OpaquePaintEvent); }
  QRegion painted;

 protected:
  void paintEvent(QPaintEvent* event) override { painted += event->region(); }
};

} // namespace

TEST(WorkBarTest, WordsThatWereLongerAreGoneFromThePictureBelow) {
  QWidget views;
  auto* column = new QVBoxLayout(&views);
  column->setContentsMargins(0, 0, 0, 0);
  auto* picture = new OpaquePicture;
  column->addWidget(picture);
  views.resize(600, 200);
  WorkBar bar(&views, 0);
  views.show();
  bar.setWork(QStringLiteral("a step that takes many words to say"), 0, 9);
  ASSERT_TRUE(QTest::qWaitFor([&] { return bar.isVisible(); }));
  QTest::qWait(50);
  QRect covered; // by words, of the picture
  for (int x = 0; x < picture->width() && covered.isNull(); ++x)
    if (bar.mask().contains(QPoint(x, 20))) covered = QRect(x, 20, 4, 4);
  ASSERT_FALSE(covered.isNull());
  for (const QString& shorter : {QStringLiteral("less"), QString()}) {
    picture->painted = QRegion();
    bar.setWork(shorter, 0, 9);
    QTest::qWait(50);
    EXPECT_TRUE(picture->painted.contains(covered)) << shorter.toStdString();
    if (shorter.isEmpty()) break;
    covered = QRect(bar.mask().boundingRect().right() - 20, 20, 4, 4);
  }
}
