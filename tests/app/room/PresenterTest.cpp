// Presenting to a room: what goes away and comes back, a presenter's keys, and the value beside the mouse.
#include "app/room/Presenter.h"
#include "app/docks/Workspace.h"
#include "app/learn/LearnPanel.h"
#include "app/learn/Learning.h"
#include "app/panels/LeftArea.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/StatusLine.h"
#include "app/panels/TimelinePanel.h"
#include "app/room/PointerLabel.h"
#include "app/style/TextSize.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"
#include "tests/app/WindowFixture.h"

#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QSplitter>

using namespace taa::app;
using namespace taa::app::test;

class PresenterTest : public FakeWindow {
 protected:
  void TearDown() override { window.setTextPercent(100); }
  Presenter* presenter() { return window.findChild<Presenter*>(); }
  Learning* learning() { return window.findChild<Learning*>(); }
  void present() { key(Qt::Key_F11, Qt::ControlModifier); }
  QList<QList<int>> splitters() {
    QList<QList<int>> sizes;
    for (const QSplitter* splitter : window.findChildren<QSplitter*>()) sizes << splitter->sizes();
    return sizes;
  }
};

TEST_F(PresenterTest, LeavesPicturesAloneInLargeTextAndEscapeGivesEverythingBack) {
  window.workspace()->resizeDocks(
      {window.findChild<QDockWidget*>("left"), window.findChild<QDockWidget*>("probe")}, {311, 369},
      Qt::Horizontal);
  settle();
  const QList<QList<int>> sizes = splitters();
  const QRect geometry = window.geometry();
  const int menus = window.menuBar()->height();
  QJsonObject state = window.state();
  state.remove("docks"); // also has sizes of what is hidden
  present();
  EXPECT_TRUE(window.isFullScreen());
  EXPECT_EQ(textPercent(), Presenter::kRoomTextPercent);
  EXPECT_EQ(window.menuBar()->height(), 0);
  for (const QWidget* part :
       {static_cast<QWidget*>(window.left()), static_cast<QWidget*>(window.probe()),
        static_cast<QWidget*>(window.timeline()), static_cast<QWidget*>(window.statusLine()),
        static_cast<QWidget*>(window.views()->view(0)->header())})
    EXPECT_FALSE(part->isVisible()) << part->metaObject()->className();
  EXPECT_TRUE(window.views()->isVisible());
  EXPECT_TRUE(presenter()->line()->isVisible());
  key(Qt::Key_Escape);
  EXPECT_FALSE(presenter()->isOn());
  EXPECT_FALSE(window.isFullScreen());
  ASSERT_TRUE(waitFor([&] { return window.geometry() == geometry; }, 5000));
  settle();
  EXPECT_EQ(textPercent(), 100);
  EXPECT_EQ(window.menuBar()->height(), menus);
  EXPECT_EQ(splitters(), sizes);
  QJsonObject after = window.state();
  after.remove("docks");
  EXPECT_EQ(after, state);
  const auto widthOf = [&](const char* dock) { return window.findChild<QDockWidget*>(dock)->width(); };
  EXPECT_TRUE(waitFor([&] { return widthOf("left") == 311 && widthOf("probe") == 369; }, 5000))
      << widthOf("left") << ' ' << widthOf("probe");
}

TEST_F(PresenterTest, KeysOfAPresenterGoFromFrameToFrame) {
  present();
  const int frame = session.status().info.frame;
  key(Qt::Key_PageDown);
  EXPECT_TRUE(waitFor([&] { return session.status().info.frame == frame + 1; }, 5000));
  EXPECT_TRUE(presenter()->line()->text().contains(QString::number(frame + 1)));
  key(Qt::Key_PageUp);
  EXPECT_TRUE(waitFor([&] { return session.status().info.frame == frame; }, 5000));
}

TEST_F(PresenterTest, KeysOfAPresenterGoFromStepToStepOfALessonWhosePanelsStayAway) {
  key(Qt::Key_F12);
  settle();
  present();
  key(Qt::Key_PageDown);
  EXPECT_EQ(learning()->step(), 1);
  settle();
  EXPECT_TRUE(window.findChild<LearnPanel*>()->isVisible());
  EXPECT_FALSE(window.left()->isVisible()) << "the step shows it in the window that is not for a room";
  key(Qt::Key_PageUp);
  key(Qt::Key_PageUp);
  EXPECT_EQ(learning()->step(), 0) << "before the first there is none";
  key(Qt::Key_Escape);
  EXPECT_TRUE(window.left()->isVisible());
}

TEST_F(PresenterTest, TheMouseShowsTheValueBesideItAndShortcutsStillWork) {
  Viewport* viewport = window.views()->view(0)->viewport();
  present();
  const PointerLabel* pointer = presenter()->pointer();
  EXPECT_FALSE(pointer->isVisible());
  QTest::mouseMove(viewport, viewport->rect().center());
  ASSERT_TRUE(waitFor([&] { return pointer->isVisible(); }, 5000));
  ASSERT_TRUE(viewport->hovered());
  const QString place = QStringLiteral("A (%1, %2)").arg(viewport->hovered()->x).arg(viewport->hovered()->y);
  EXPECT_TRUE(pointer->text().startsWith(place)) << pointer->text().toStdString();
  EXPECT_TRUE(window.rect().contains(pointer->words()));
  EXPECT_TRUE(pointer->ring().contains(viewport->mapTo(&window, viewport->rect().center())));
  const int views = window.views()->viewCount();
  key(Qt::Key_V);
  EXPECT_NE(window.views()->viewCount(), views);
  presenter()->setOn(false);
  EXPECT_FALSE(pointer->isVisible());
}

TEST_F(PresenterTest, F11FillsTheScreenAndGivesItBack) {
  const QRect geometry = window.geometry();
  key(Qt::Key_F11);
  EXPECT_TRUE(window.isFullScreen());
  EXPECT_TRUE(window.left()->isVisible()) << "with all panels";
  key(Qt::Key_F11);
  EXPECT_FALSE(window.isFullScreen());
  EXPECT_TRUE(waitFor([&] { return window.geometry() == geometry; }, 5000));
}
