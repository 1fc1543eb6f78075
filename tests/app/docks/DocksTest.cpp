// Panels are torn off, put back, moved to other screens and come back with the layout; the views keep their
// room.
#include "app/docks/PanelCycle.h"
#include "app/docks/PanelDock.h"
#include "app/docks/Workspace.h"
#include "app/doctor/DoctorPanel.h"
#include "app/panels/JitterPanel.h"
#include "app/panels/LeftArea.h"
#include "app/panels/LowerArea.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/ProbePanel.h"
#include "app/session/keeping/SessionKeeper.h"
#include "app/views/ViewArea.h"
#include "tests/app/WindowFixture.h"

#include <QContextMenuEvent>
#include <QJsonObject>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QScreen>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QToolButton>

#include <memory>
#include <utility>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

class Docks : public test::FakeWindow {
 protected:
  PanelDock* dock(const char* id) const { return window.findChild<PanelDock*>(QLatin1String(id)); }
  void click(const char* button) {
    QTest::mouseClick(window.findChild<QToolButton*>(QLatin1String(button)), Qt::LeftButton);
    settle();
  }
  QRect screen() const { return window.screen()->availableGeometry(); }
};

} // namespace

TEST_F(Docks, AButtonInItsHeadGivesAPanelAWindowOfItsOwnAndPutsItBack) {
  ASSERT_FALSE(dock("probe")->isFloating());
  const int before = window.views()->width();
  click("probe.tearOff");
  EXPECT_TRUE(dock("probe")->isFloating());
  EXPECT_TRUE(window.probe()->isVisible());
  EXPECT_NE(window.probe()->window(), &window);
  EXPECT_GT(window.views()->width(), before + 200) << "the views take the room";
  // Its keys are the window's.
  QTest::keyClick(dock("probe"), Qt::Key_F10);
  settle();
  EXPECT_FALSE(window.probe()->isVisible());
  key(Qt::Key_F10);
  EXPECT_TRUE(window.probe()->isVisible());
  EXPECT_TRUE(dock("probe")->isFloating()) << "where it was";
  click("probe.tearOff");
  EXPECT_FALSE(dock("probe")->isFloating());
  EXPECT_EQ(window.probe()->window(), &window);
  EXPECT_EQ(window.views()->width(), before);
}

// Qt's menu of docks would show one whose panel stays hidden, and hide one whose panel counts as shown.
TEST_F(Docks, ARightClickOnAHeadOpensNoMenuThatGoesPastThePanels) {
  const std::unique_ptr<QMenu> ofQt(window.workspace()->QMainWindow::createPopupMenu());
  ASSERT_TRUE(ofQt && !ofQt->actions().isEmpty());
  int heads = 0;
  for (PanelDock* panel : window.workspace()->docks()) {
    QWidget* head = panel->titleBarWidget();
    if (!head || !head->isVisible()) continue;
    ++heads;
    QContextMenuEvent event(QContextMenuEvent::Mouse, head->rect().center(),
                            head->mapToGlobal(head->rect().center()));
    QApplication::sendEvent(head, &event);
    EXPECT_FALSE(QApplication::activePopupWidget()) << panel->objectName().toStdString();
  }
  EXPECT_GE(heads, 2);
}

TEST_F(Docks, ClosingTheWindowOfAPanelClosesThePanel) {
  click("left.tearOff");
  ASSERT_TRUE(dock("left")->isFloating());
  dock("left")->close();
  settle();
  EXPECT_TRUE(window.left()->isHidden());
  key(Qt::Key_F9);
  EXPECT_TRUE(window.left()->isVisible());
}

TEST_F(Docks, PagesBelowAreTornOffOneByOneAndKeepTheirKeys) {
  key(Qt::Key_F6);
  ASSERT_TRUE(window.plots()->isVisible());
  click("tearOffPage");
  EXPECT_TRUE(window.plots()->isVisible());
  EXPECT_NE(window.plots()->window(), &window);
  EXPECT_FALSE(window.lower()->isVisible());
  EXPECT_FALSE(window.lower()->tabs()->isTabVisible(static_cast<int>(LowerPage::Plots)));
  key(Qt::Key_F7);
  EXPECT_TRUE(window.jitter()->isVisible());
  EXPECT_TRUE(window.plots()->isVisible()) << "beside it";
  key(Qt::Key_F6);
  EXPECT_FALSE(window.plots()->isVisible());
  EXPECT_TRUE(window.jitter()->isVisible());
  key(Qt::Key_F6);
  EXPECT_TRUE(window.plots()->isVisible());
  click("page.plots.tearOff");
  EXPECT_EQ(window.plots()->window(), &window);
  EXPECT_TRUE(window.lower()->shows(LowerPage::Plots));
  EXPECT_TRUE(window.lower()->tabs()->isTabVisible(static_cast<int>(LowerPage::Plots)));
  EXPECT_TRUE(dock("page.plots")->isHidden());
}

TEST_F(Docks, EveryPageCanBeTornOffAtOnce) {
  for (int page = 0; page < kLowerPageCount; ++page) {
    window.lower()->setShown(static_cast<LowerPage>(page), true);
    window.workspace()->setTornOff(window.workspace()->dockOf(static_cast<LowerPage>(page)), true);
  }
  settle();
  EXPECT_FALSE(window.lower()->isVisible());
  for (int page = 0; page < kLowerPageCount; ++page)
    EXPECT_TRUE(window.lower()->page(static_cast<LowerPage>(page))->isVisible()) << page;
  key(Qt::Key_0, Qt::ControlModifier | Qt::AltModifier);
  for (int page = 0; page < kLowerPageCount; ++page)
    EXPECT_FALSE(window.lower()->isTaken(static_cast<LowerPage>(page))) << page;
}

TEST_F(Docks, ResetLayoutPutsAllBackWhereItWasAtFirst) {
  const QRect left = dock("left")->geometry(), probe = dock("probe")->geometry();
  click("probe.tearOff");
  key(Qt::Key_F9);
  key(Qt::Key_F6);
  click("tearOffPage");
  key(Qt::Key_F7);
  ASSERT_TRUE(window.left()->isHidden());
  key(Qt::Key_0, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(dock("left")->geometry(), left);
  EXPECT_EQ(dock("probe")->geometry(), probe);
  EXPECT_FALSE(window.lower()->isVisible());
  key(Qt::Key_F6);
  EXPECT_TRUE(window.lower()->shows(LowerPage::Plots));
}

TEST_F(Docks, TheLayoutComesBackWithASession) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("it.taa.json");
  key(Qt::Key_F6);
  click("tearOffPage");
  click("probe.tearOff");
  dock("probe")->setGeometry(QRect(screen().topLeft() + QPoint(210, 120), QSize(420, 520)));
  window.workspace()->resizeDocks({dock("left")}, {333}, Qt::Horizontal);
  settle();
  const QRect probe = dock("probe")->geometry();
  ASSERT_EQ(dock("left")->width(), 333);
  window.keeper()->saveTo(path);
  key(Qt::Key_0, Qt::ControlModifier | Qt::AltModifier);
  ASSERT_NE(dock("left")->width(), 333);
  window.openSource(path);
  QTest::qWait(100);
  EXPECT_EQ(dock("left")->width(), 333);
  EXPECT_TRUE(dock("probe")->isFloating());
  EXPECT_EQ(dock("probe")->geometry(), probe);
  EXPECT_TRUE(window.lower()->isTaken(LowerPage::Plots));
  EXPECT_TRUE(window.plots()->isVisible());
  EXPECT_FALSE(window.lower()->isVisible());
}

// Random input found it: the key Esc, which ends a presentation, while the mouse held an edge between panels.
TEST_F(Docks, ALayoutThatComesBackWhileAnEdgeIsDraggedEndsTheDrag) {
  Workspace* workspace = window.workspace();
  const QJsonObject before = workspace->state();
  const int probeWidth = dock("probe")->width();
  QPoint edge(0, workspace->height() / 3);
  while (edge.x() < workspace->width() &&
         !(edge.x() > workspace->width() / 2 && workspace->isSeparator(edge)))
    edge.rx() += 1;
  ASSERT_TRUE(workspace->isSeparator(edge));
  const auto mouse = [&](QEvent::Type type, int left) {
    const QPointF at = edge + QPoint(1 - left, 0);
    const bool isMove = type == QEvent::MouseMove;
    QMouseEvent event(type, at, workspace->mapToGlobal(at), isMove ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
    QApplication::sendEvent(workspace, &event);
  };
  for (int round = 0; round < 3; ++round) {
    mouse(QEvent::MouseButtonPress, 0);
    mouse(QEvent::MouseMove, 60);
    settle();
    EXPECT_GT(dock("probe")->width(), probeWidth + 40) << "it is dragged";
    mouse(QEvent::MouseMove, 80); // of which Qt thinks in a moment
    workspace->setState(before);
    mouse(QEvent::MouseMove, 90);
    settle();
    EXPECT_EQ(dock("probe")->width(), probeWidth);
    mouse(QEvent::MouseButtonRelease, 90);
    settle();
    EXPECT_EQ(dock("probe")->width(), probeWidth);
  }
}

// A panel, too, while its head is dragged.
TEST_F(Docks, ALayoutThatComesBackWhileAPanelIsDraggedEndsTheDrag) {
  Workspace* workspace = window.workspace();
  const QJsonObject before = workspace->state();
  QWidget* head = dock("probe")->titleBarWidget();
  const QPoint from = head->mapTo(dock("probe"), QPoint(head->width() / 2, head->height() / 2));
  QTest::mousePress(dock("probe"), Qt::LeftButton, {}, from);
  for (int step = 1; step <= 4; ++step) QTest::mouseMove(dock("probe"), from - QPoint(60 * step, -20 * step));
  QTest::qWait(20);
  EXPECT_TRUE(dock("probe")->isFloating()) << "it is dragged";
  workspace->setState(before);
  settle();
  EXPECT_FALSE(dock("probe")->isFloating());
  QTest::mouseRelease(dock("probe"), Qt::LeftButton, {}, from);
  settle();
  EXPECT_FALSE(dock("probe")->isFloating());
  EXPECT_TRUE(window.probe()->isVisible());
}

TEST_F(Docks, APanelOfAScreenThatIsGoneComesBack) {
  click("probe.tearOff");
  dock("probe")->move(screen().bottomRight() + QPoint(5000, 300));
  settle();
  const QJsonObject far = window.workspace()->state();
  key(Qt::Key_0, Qt::ControlModifier | Qt::AltModifier);
  window.workspace()->setState(far);
  settle();
  EXPECT_TRUE(dock("probe")->isFloating());
  EXPECT_TRUE(screen().contains(dock("probe")->geometry().center()));
}

TEST(ReachablePlace, KeepsWhatCanBeReachedAndCentersTheRest) {
  const QList<QRect> screens{{0, 0, 1000, 800}, {1000, 0, 500, 400}};
  const QRect beside(1100, 50, 300, 300), half(900, 700, 400, 300), lost(1200, 500, 300, 200);
  EXPECT_EQ(reachablePlace(beside, screens), beside);
  EXPECT_EQ(reachablePlace(half, screens), QRect(300, 250, 400, 300)) << "too little of it is seen";
  EXPECT_EQ(reachablePlace(lost, screens), QRect(350, 300, 300, 200)) << "below the lower screen";
  EXPECT_EQ(reachablePlace({3000, 0, 1600, 1200}, screens), QRect(0, 0, 1000, 800)) << "no larger than it";
  EXPECT_EQ(reachablePlace({20, 20, 50, 30}, screens), QRect(20, 20, 50, 30)) << "small, but whole";
}

// Sides that were wide in a wide window would leave nothing in a narrow one.
TEST_F(Docks, ALayoutOfAWideWindowLeavesTheViewsTheirShareOfANarrowOne) {
  window.resize(2400, 1200);
  key(Qt::Key_F6);
  window.workspace()->resizeDocks({dock("left"), dock("probe")}, {800, 1000}, Qt::Horizontal);
  window.workspace()->resizeDocks({dock("lower")}, {700}, Qt::Vertical);
  settle();
  ASSERT_GE(dock("probe")->width(), 900);
  const QJsonObject wide = window.workspace()->state();
  window.resize(1024, 600);
  settle();
  window.workspace()->setState(wide);
  const auto hasRoom = [&] { return window.views()->width() >= 4 * window.workspace()->width() / 10 - 2; };
  EXPECT_TRUE(test::waitFor(hasRoom)) << window.views()->width();
  EXPECT_GE(window.views()->height(), 150);
  EXPECT_EQ(window.width(), 1024);
  EXPECT_EQ(window.height(), 600);
}

TEST(WindowLayout, IsRememberedFromOneStartToTheNext) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
  int width = 0;
  for (const bool isFirst : {true, false}) {
    Session session(
        [](Listener listener) { return std::make_unique<test::FakeRenderer>(std::move(listener)); });
    test::TestWindow window(session, &settings);
    window.resize(1400, 900);
    window.show();
    QTest::qWait(50);
    auto* left = window.findChild<PanelDock*>("left");
    if (isFirst) {
      window.workspace()->resizeDocks({left}, {371}, Qt::Horizontal);
      window.workspace()->setTornOff(window.findChild<PanelDock*>("probe"), true);
      QTest::qWait(30);
      width = left->width();
    } else {
      EXPECT_EQ(left->width(), width);
      EXPECT_TRUE(window.findChild<PanelDock*>("probe")->isFloating());
    }
    window.close();
  }
  EXPECT_EQ(width, 371);
}

// A window of its own is hidden by its destructor, after the views are destroyed, in which the doctor's page
// shows where it found something.
TEST(WindowLayout, PanelsThatAreTornOffSayNothingOnceTheViewsAreGone) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath("settings.ini"), QSettings::IniFormat);
  Session session(
      [](Listener listener) { return std::make_unique<test::FakeRenderer>(std::move(listener)); });
  bool areViewsGone = false, isSaidAfter = false;
  {
    test::TestWindow window(session, &settings);
    window.resize(1400, 900);
    window.show();
    window.lower()->setShown(LowerPage::Doctor, true);
    QTest::qWait(50);
    window.workspace()->setTornOff(window.findChild<PanelDock*>("lower"), true);
    QTest::qWait(30);
    ASSERT_TRUE(window.doctor()->isVisible());
    ASSERT_NE(window.doctor()->window(), &window);
    QObject::connect(window.views(), &QObject::destroyed, [&] { areViewsGone = true; });
    QObject::connect(window.doctor(), &DoctorPanel::changed,
                     [&] { isSaidAfter = isSaidAfter || areViewsGone; });
  }
  EXPECT_TRUE(areViewsGone);
  EXPECT_FALSE(isSaidAfter);
}

// As when a window is taken down: what held the focus goes, and the panels went before.
TEST(PanelCycleTest, PanelsThatAreGoneArePassedOver) {
  QWidget window;
  auto* gone = new QWidget(&window);
  auto* stays = new QWidget(&window);
  auto* goneField = new QLineEdit(gone);
  auto* field = new QLineEdit(stays);
  auto* elsewhere = new QLineEdit(&window);
  PanelCycle cycle({gone, stays}, &window);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  goneField->setFocus();
  ASSERT_TRUE(goneField->hasFocus());
  delete gone;
  elsewhere->setFocus();
  ASSERT_TRUE(elsewhere->hasFocus());
  cycle.go(1);
  EXPECT_TRUE(field->hasFocus()) << "the first one is gone";
}
