// The tree of the scene by real events, and flying by mouse and keys.
#include "tests/app/WindowFixture.h"

#include "app/commands/Flight.h"
#include "app/models/SceneTreeModel.h"
#include "app/panels/LeftArea.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ScenePanel.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/widgets/Prompt.h"
#include "app/widgets/SearchField.h"
#include "app/widgets/bars/FlightBar.h"

#include <QJsonArray>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QStyle>
#include <QStyleOptionViewItem>
#include <QTabWidget>
#include <QTreeView>
#include <QWheelEvent>

#include <cmath>
#include <string>
#include <vector>

namespace taa::app::test {
namespace {

class SceneTreeTest : public FakeWindow {
 protected:
  void SetUp() override {
    FakeWindow::SetUp();
    key(Qt::Key_F8);
  }
  QTreeView* tree() const { return window.scene()->tree(); }
  const QAbstractItemModel* model() const { return tree()->model(); }
  /// The tree's row of this name.
  QModelIndex row(const QString& name, int column = 0) const {
    const auto found =
        model()->match(model()->index(0, 0), Qt::DisplayRole, name, 1, Qt::MatchExactly | Qt::MatchRecursive);
    return found.isEmpty() ? QModelIndex() : found.first().siblingAtColumn(column);
  }
  void clickMark(const QModelIndex& index) {
    QStyleOptionViewItem option;
    option.rect = tree()->visualRect(index);
    option.features = QStyleOptionViewItem::HasCheckIndicator;
    const QRect mark =
        tree()->style()->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, tree());
    QTest::mouseClick(tree()->viewport(), Qt::LeftButton, {}, mark.center());
    settle();
  }
  void click(const QModelIndex& index) {
    QTest::mouseClick(tree()->viewport(), Qt::LeftButton, {}, tree()->visualRect(index).center());
    settle();
  }
};

TEST_F(SceneTreeTest, ShowsTheWholeTree) {
  EXPECT_TRUE(window.scene()->isVisible());
  EXPECT_FALSE(window.pipeline()->isVisible());
  EXPECT_EQ(model()->rowCount(), 2);
  ASSERT_TRUE(row("rotor & hub").isValid());
  EXPECT_EQ(row("rotor & hub").parent(), row("fan"));
  EXPECT_TRUE(row("lamp (light)").isValid());
  EXPECT_EQ(row("floor", 1).data().toString(), "Per object");
  EXPECT_FALSE(row("fan", 1).data().isValid()) << "it draws nothing";
  key(Qt::Key_F, Qt::ControlModifier); // the search of the pipeline
  EXPECT_TRUE(window.pipeline()->isVisible());
}

TEST_F(SceneTreeTest, HidesByTheCheckMarkAndByKey) {
  click(row("floor"));
  clickMark(row("floor"));
  EXPECT_EQ(renderer->status.filter.hidden, std::vector<std::string>{"floor"});
  EXPECT_EQ(row("floor").data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
  key(Qt::Key_H, Qt::ControlModifier);
  EXPECT_TRUE(renderer->status.filter.hidden.empty());
  EXPECT_EQ(row("floor").data(Qt::CheckStateRole).toInt(), Qt::Checked);
}

TEST_F(SceneTreeTest, IsolatesTheSelectedObjectAndShowsAllAgain) {
  click(row("rotor & hub"));
  key(Qt::Key_I, Qt::ControlModifier);
  EXPECT_EQ(renderer->status.filter.isolated, std::vector<std::string>{"rotor & hub"});
  EXPECT_TRUE(row("rotor & hub").data(Qt::FontRole).value<QFont>().bold());
  EXPECT_TRUE(row("floor").data(Qt::FontRole).value<QFont>().italic()) << "not drawn";
  EXPECT_TRUE(row("floor").data(Qt::ToolTipRole).toString().contains("others are isolated"));
  key(Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(renderer->status.filter, ObjectFilter{});
}

TEST_F(SceneTreeTest, WhatIsLeftOutHasNoCheckMarkAndIsIsolatedTooByIt) {
  click(row("rotor & hub"));
  key(Qt::Key_I, Qt::ControlModifier);
  EXPECT_EQ(row("rotor & hub").data(Qt::CheckStateRole).toInt(), Qt::Checked);
  EXPECT_EQ(row("floor").data(Qt::CheckStateRole).toInt(), Qt::Unchecked) << "it is not drawn";
  clickMark(row("floor"));
  EXPECT_EQ(renderer->status.filter.isolated, (std::vector<std::string>{"rotor & hub", "floor"}));
  EXPECT_TRUE(renderer->status.filter.hidden.empty());
  EXPECT_EQ(row("floor").data(Qt::CheckStateRole).toInt(), Qt::Checked);
}

TEST_F(SceneTreeTest, GivesAnObjectAnotherMotion) {
  click(row("rotor & hub", SceneTreeModel::Motion));
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_NE(menu, nullptr);
  EXPECT_TRUE(menu->actions().at(0)->isChecked());
  QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(menu->actions().at(1)).center());
  settle();
  ASSERT_EQ(renderer->status.motionModes.size(), 1u);
  EXPECT_EQ(renderer->status.motionModes[0], (MotionOverride{"rotor & hub", MotionMode::CameraOnly}));
  EXPECT_EQ(row("rotor & hub", 1).data().toString(), "Camera only");
}

TEST_F(SceneTreeTest, SelectsTheObjectOfAProbedPixel) {
  session.probes().setPixel(glm::ivec2(2, 0)); // the fake's object 2
  settle();
  EXPECT_EQ(tree()->currentIndex(), row("rotor & hub"));
  EXPECT_EQ(renderer->last<request::Locate>().objects, std::vector<int>{2});
  EXPECT_TRUE(waitFor([&] { return window.scene()->infoText().contains("12 pixels around (21, 6)"); }, 5000))
      << qPrintable(window.scene()->infoText());
  // It stays while time runs on under the probe.
  session.post(request::Step{-1});
  session.post(request::Step{1});
  settle();
  EXPECT_EQ(tree()->currentIndex(), row("rotor & hub"));
  click(row("floor"));
  EXPECT_EQ(renderer->last<request::Locate>().objects, std::vector<int>{1});
  key(Qt::Key_J, Qt::ControlModifier);
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(11, 6));
  EXPECT_EQ(tree()->currentIndex(), row("floor")) << "it was asked for";
  key(Qt::Key_F8);
  EXPECT_TRUE(renderer->last<request::Locate>().objects.empty()) << "nobody sees it";
}

TEST_F(SceneTreeTest, FindsObjectsByTheirNames) {
  key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(QApplication::focusWidget(), window.scene()->filterField());
  QTest::keyClicks(window.scene()->filterField(), "HUB");
  settle();
  EXPECT_TRUE(row("rotor & hub").isValid());
  EXPECT_TRUE(row("fan").isValid()) << "what it belongs to stays";
  EXPECT_FALSE(row("floor").isValid());
  session.probes().setPixel(glm::ivec2(1, 0)); // the floor, which is filtered out
  settle();
  EXPECT_EQ(tree()->currentIndex(), row("floor"));
}

class FlightWindow : public FakeWindow {
 protected:
  void SetUp() override {
    FakeWindow::SetUp();
    window.views()->active()->viewport()->setFocus();
    key(Qt::Key_F, Qt::ShiftModifier);
    ASSERT_TRUE(window.flight()->isOn());
  }
  Viewport* viewport() const { return window.views()->active()->viewport(); }
  CameraPose pose() const { return renderer->status.pose; }
};

TEST_F(FlightWindow, MovesByKeysWhileTheyAreHeld) {
  EXPECT_TRUE(window.flightBar()->isVisible());
  const Settings before = session.presets().settings();
  QTest::keyPress(viewport(), Qt::Key_W);
  ASSERT_TRUE(waitFor([&] { return pose().position.z < -0.1f; }, 5000));
  EXPECT_EQ(renderer->status.camera, kFreeCamera);
  QTest::keyRelease(viewport(), Qt::Key_W);
  settle();
  const CameraPose rest = pose();
  EXPECT_EQ(rest.position.x, 0.0f);
  QTest::keyClick(viewport(), Qt::Key_E); // brightens a view when nobody flies
  settle();
  EXPECT_GT(pose().position.y, 0.0f);
  EXPECT_EQ(window.views()->active()->style().exposure, ViewStyle{}.exposure);
  EXPECT_EQ(session.presets().settings(), before);
}

TEST_F(FlightWindow, LooksAroundByDraggingAndProbesAsEver) {
  const QPoint middle = viewport()->rect().center();
  const ViewCamera camera = viewport()->camera();
  QTest::mousePress(viewport(), Qt::LeftButton, {}, middle);
  QTest::mouseMove(viewport(), middle + QPoint(30, -20));
  QTest::mouseRelease(viewport(), Qt::LeftButton, {}, middle + QPoint(30, -20));
  settle();
  EXPECT_GT(pose().yaw, 0.5f);
  EXPECT_GT(pose().pitch, 0.3f);
  EXPECT_EQ(viewport()->camera(), camera) << "the picture is not panned";
  QTest::mouseClick(viewport(), Qt::RightButton, {}, middle);
  EXPECT_TRUE(session.probes().pixel().has_value());
}

TEST_F(FlightWindow, ChangesItsSpeedByTheWheelAndEndsByEscape) {
  const float speed = window.flight()->speed();
  EXPECT_FLOAT_EQ(speed, firstSpeed(2.0f));
  const QPointF middle = viewport()->rect().center();
  QWheelEvent wheel(middle, viewport()->mapToGlobal(middle), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(viewport(), &wheel);
  EXPECT_GT(window.flight()->speed(), 1.4f * speed);
  EXPECT_TRUE(viewport()->camera().fit) << "it is not zoomed";
  session.probes().setPixel(glm::ivec2(3, 3));
  QTest::keyClick(viewport(), Qt::Key_Escape);
  settle();
  EXPECT_FALSE(window.flight()->isOn());
  EXPECT_FALSE(window.flightBar()->isVisible());
  EXPECT_TRUE(session.probes().pixel().has_value()) << "escape ended the flight only";
}

TEST_F(FlightWindow, RecordsAndGoesBackToTheCameraItLeft) {
  session.scene().fly({{1, 2, 3}, 0, 0, 45});
  settle();
  EXPECT_EQ(session.status().camera, kFreeCamera);
  key(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(renderer->status.recording);
  EXPECT_TRUE(window.flightBar()->text().contains("Recording"));
  key(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(renderer->status.recording);
  key(Qt::Key_Backspace);
  EXPECT_EQ(renderer->status.camera, "still");
}

TEST_F(FlightWindow, ARecordedCameraIsRenamedAndDeletedAndUndoTakesItBack) {
  key(Qt::Key_Escape);
  const CameraTrack first{"Recorded 1", 0, {CameraPose{}, CameraPose{.yaw = 10.0f}}};
  const CameraTrack second{"Recorded 2", 0, {CameraPose{.yaw = 50.0f}}};
  session.scene().addCameraTrack(first);
  session.scene().addCameraTrack(second);
  settle();
  const auto names = [&] {
    std::vector<std::string> all;
    for (const CameraTrackHandle& track : renderer->status.tracks) all.push_back(track->name);
    return all;
  };
  using Names = std::vector<std::string>;
  window.activateWindow();
  key(Qt::Key_F2, Qt::ControlModifier);
  auto* prompt = window.findChild<Prompt*>();
  ASSERT_TRUE(prompt);
  auto* field = prompt->findChild<QLineEdit*>();
  EXPECT_EQ(field->text(), "Recorded 2");
  field->setText("Recorded 1");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(names(), (Names{"Recorded 1", "Recorded 2"})) << "that is taken";
  field->setText("By the wall");
  QTest::keyClick(field, Qt::Key_Return);
  settle();
  EXPECT_EQ(names(), (Names{"Recorded 1", "By the wall"}));
  EXPECT_EQ(renderer->status.camera, "By the wall");
  key(Qt::Key_Delete, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(names(), (Names{"Recorded 1"}));
  EXPECT_EQ(renderer->status.camera, "still") << "the scene's";
  session.scene().setCamera("Recorded 1");
  settle();
  const SessionFile file = session.file();
  const QJsonObject state = session.scene().state();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(renderer->status.camera, "still") << "which camera is looked through is a step, too";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(names(), (Names{"Recorded 1", "By the wall"}));
  EXPECT_EQ(renderer->status.camera, "By the wall");
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(names(), (Names{"Recorded 1", "Recorded 2"}));
  EXPECT_EQ(renderer->status.camera, "Recorded 2");
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(names(), (Names{"Recorded 1", "By the wall"}));
  session.restore(file);
  session.scene().setState(state);
  settle();
  EXPECT_EQ(names(), (Names{"Recorded 1"})) << "a session has those that were there";
  EXPECT_EQ(renderer->status.camera, "Recorded 1");
}

TEST(FlightMath, MovesAlongWhereItLooks) {
  CameraPose pose;
  pose.yaw = 90.0f; // +x
  const CameraPose ahead = moved(pose, {0, 0, 1}, 2.0f);
  EXPECT_NEAR(ahead.position.x, 2.0f, 1e-5f);
  EXPECT_NEAR(ahead.position.z, 0.0f, 1e-5f);
  const CameraPose right = moved(pose, {1, 0, 0}, 2.0f);
  EXPECT_NEAR(right.position.z, 2.0f, 1e-5f);
  const CameraPose both = moved(pose, {1, 1, 1}, 1.0f);
  EXPECT_NEAR(glm::length(both.position), 1.0f, 1e-5f) << "no faster askew";
  EXPECT_EQ(moved(pose, {}, 1.0f), pose);
  pose.pitch = 80.0f;
  EXPECT_EQ(turned(pose, 0.0, -1e5, 100.0).pitch, kMaxPitch);
  EXPECT_NEAR(turned(CameraPose{}, 1.0, 0.0, 1000.0).yaw, 0.04747f, 1e-4f);
  EXPECT_LE(std::abs(turned(pose, 1e6, 0.0, 100.0).yaw), 180.0f);
}

TEST_F(FakeWindow, SceneStateComesBack) {
  session.scene().fly({{1, 2, 3}, 40.0f, -5.5f, 30.0f});
  session.scene().setHidden("floor", true);
  session.scene().setIsolated({"fan"});
  session.scene().setMotionMode("floor", MotionMode::None);
  settle();
  const SessionFile file = session.file();
  const QJsonObject state = session.scene().state();
  session.open("builtin:text");
  settle();
  EXPECT_EQ(renderer->status.filter, ObjectFilter{});
  session.restore(file);
  session.scene().setState(state);
  settle();
  EXPECT_EQ(renderer->status.camera, kFreeCamera);
  EXPECT_EQ(renderer->status.pose, (CameraPose{{1, 2, 3}, 40.0f, -5.5f, 30.0f}));
  EXPECT_EQ(renderer->status.filter, (ObjectFilter{{"floor"}, {"fan"}}));
  EXPECT_EQ(session.scene().motionModes(), (std::vector<MotionOverride>{{"floor", MotionMode::None}}));
  session.scene().setState({{"tracks", 3}, {"camera", QJsonArray{}}});
  settle();
  EXPECT_EQ(renderer->status.camera, kFreeCamera) << "what cannot be read is left out";
}

} // namespace
} // namespace taa::app::test
