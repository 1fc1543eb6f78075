// Undo and Esc in the window, by the keys and the mouse, wherever the focus is.
#include "app/commands/Flight.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ScenePanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/views/timeline/Timeline.h"
#include "app/widgets/Prompt.h"
#include "app/widgets/SearchField.h"
#include "app/widgets/parameters/NumberField.h"
#include "app/widgets/parameters/ParameterRow.h"
#include "tests/app/views/ViewsFixture.h"

#include <QAction>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>

#include <algorithm>
#include <string>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

class UndoTest : public test::FakeViews {
 protected:
  void SetUp() override {
    FakeViews::SetUp();
    session.probes().set({{.pixel = {10, 5}}}, 0);
    session.undoStack().clear();
    viewport()->setFocus();
    settle();
  }
  /// Where the keys go, as a keyboard's do.
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWidget* focus = QApplication::focusWidget();
    QTest::keyClick(focus ? focus : &window, key, modifiers);
    settle();
  }
  void undo() { press(Qt::Key_Z, Qt::ControlModifier); }
  void redo() { press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }
  NumberField* gamma() {
    window.pipeline()->setAllExpanded(true);
    for (ParameterRow* row : window.pipeline()->parameterRows())
      if (row->path() == "neighborhood.gamma") return qobject_cast<NumberField*>(row->editor());
    return nullptr;
  }
  float gammaValue() { return renderer->status.settings.neighborhood.gamma; }
  QAction* command(const QString& begin) {
    for (QAction* menu : window.menuBar()->actions())
      for (QAction* action : menu->menu()->actions())
        if (action->text().remove(u'&').startsWith(begin)) return action;
    return nullptr;
  }
  std::vector<glm::ivec2> pixels() {
    std::vector<glm::ivec2> all;
    for (const Probe& probe : renderer->last<request::SetProbes>().all) all.push_back(probe.pixel);
    return all;
  }
  using Pixels = std::vector<glm::ivec2>;
};

} // namespace

TEST_F(UndoTest, ASearchDoesNotKeepItFromTheSetting) {
  session.presets().setParameter("rectify.method", 0);
  press(Qt::Key_F, Qt::ControlModifier);
  QTest::keyClicks(QApplication::focusWidget(), "gamma");
  undo();
  EXPECT_EQ(renderer->status.settings.rectify.method, RectifyMethod::ClipToFiltered);
  EXPECT_EQ(window.pipeline()->searchField()->text(), "gamma");
  EXPECT_TRUE(window.pipeline()->searchField()->hasFocus());
  redo();
  EXPECT_EQ(renderer->status.settings.rectify.method, RectifyMethod::None);
  press(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(window.scene()->filterField()->hasFocus());
  QTest::keyClicks(QApplication::focusWidget(), "floor");
  undo();
  EXPECT_EQ(renderer->status.settings.rectify.method, RectifyMethod::ClipToFiltered);
}

TEST_F(UndoTest, ATypedNumberIsTakenBackOnceItIsSet) {
  NumberField* field = gamma();
  QTest::mouseClick(field, Qt::LeftButton);
  QTest::keyClicks(QApplication::focusWidget(), "2.5");
  press(Qt::Key_Return);
  ASSERT_EQ(gammaValue(), 2.5f);
  undo();
  EXPECT_EQ(gammaValue(), 1.0f);
  EXPECT_EQ(field->value(), 1.0);
  redo();
  EXPECT_EQ(gammaValue(), 2.5f);
}

TEST_F(UndoTest, WhatIsBeingTypedIsTakenBackFirst) {
  session.presets().setParameter("rectify.method", 0);
  session.presets().setParameter("neighborhood.gamma", 2.5);
  NumberField* field = gamma();
  field->setFocus();
  press(Qt::Key_3);
  auto* editor = field->findChild<QLineEdit*>();
  ASSERT_TRUE(editor && editor->isVisible());
  undo();
  EXPECT_FALSE(editor->isVisible()) << "only the typing";
  EXPECT_EQ(gammaValue(), 2.5f);
  press(Qt::Key_Return); // opens the editor, with nothing typed yet
  ASSERT_TRUE(editor->isVisible());
  undo();
  EXPECT_FALSE(editor->isVisible());
  EXPECT_EQ(gammaValue(), 1.0f);
  undo();
  EXPECT_EQ(renderer->status.settings.rectify.method, RectifyMethod::ClipToFiltered);
}

TEST_F(UndoTest, APresetComesBackWithItsNameAndIsGoneBackTo) {
  const Settings balanced = session.presets().settings();
  session.presets().setPreset("minimal");
  EXPECT_EQ(command("Undo")->text().remove(u'&'), "Undo: choice of preset Minimal");
  undo();
  EXPECT_EQ(session.presets().presetId(), "balanced");
  EXPECT_TRUE(window.windowTitle().contains("balanced")) << window.windowTitle().toStdString();
  EXPECT_FALSE(session.presets().isPresetChanged());
  session.presets().setPreset("balanced");
  EXPECT_FALSE(session.undoStack().canUndo()) << "it is chosen already";
  EXPECT_EQ(session.undoStack().redoText(), "choice of preset Minimal");
  session.presets().setParameter("weight.minimum", 0.25);
  press(Qt::Key_R, Qt::ControlModifier);
  EXPECT_EQ(renderer->status.settings, balanced);
  undo();
  EXPECT_EQ(renderer->status.settings.weight.minimum, 0.25f);
  session.presets().setPreset("balanced");
  EXPECT_EQ(renderer->status.settings, balanced) << "the same preset, without the change";
  undo();
  EXPECT_EQ(renderer->status.settings.weight.minimum, 0.25f);
}

TEST_F(UndoTest, ProbesComeBack) {
  QTest::mousePress(viewport(), Qt::RightButton, {}, placeOf({20, 6}));
  for (const int x : {22, 25, 30}) QTest::mouseMove(viewport(), placeOf({x, 6}));
  QTest::mouseRelease(viewport(), Qt::RightButton, {}, placeOf({30, 6}));
  settle();
  ASSERT_EQ(pixels(), (Pixels{{30, 6}}));
  QTest::mouseClick(viewport(), Qt::RightButton, Qt::ShiftModifier, placeOf({40, 9}));
  press(Qt::Key_F, Qt::ControlModifier | Qt::AltModifier);
  press(Qt::Key_Delete);
  ASSERT_EQ(pixels(), (Pixels{{30, 6}}));
  press(Qt::Key_Escape, Qt::ShiftModifier);
  ASSERT_TRUE(renderer->last<request::SetProbes>().all.empty());
  EXPECT_EQ(command("Undo")->text().remove(u'&'), "Undo: removal of all probes");
  undo();
  EXPECT_EQ(pixels(), (Pixels{{30, 6}}));
  undo();
  ASSERT_EQ(renderer->last<request::SetProbes>().all.size(), 2u);
  EXPECT_EQ(renderer->last<request::SetProbes>().all[1].follow, Follow::Surface);
  EXPECT_EQ(session.probes().active(), 1);
  undo();
  EXPECT_EQ(renderer->last<request::SetProbes>().all[1].follow, Follow::Screen);
  undo();
  EXPECT_EQ(pixels(), (Pixels{{30, 6}}));
  undo();
  EXPECT_EQ(pixels(), (Pixels{{10, 5}})) << "a drag is one step";
  EXPECT_FALSE(command("Undo")->isEnabled());
  for (int step = 0; step < 3; ++step) redo();
  EXPECT_EQ(renderer->last<request::SetProbes>().all[1].follow, Follow::Surface);
}

TEST_F(UndoTest, ViewsComeBack) {
  viewport()->setCamera({false, 8.0, {20, 10}});
  view()->setIntermediate(IntermediateId::alpha);
  press(Qt::Key_C, Qt::ShiftModifier);
  ASSERT_TRUE(view()->comparison());
  for (int step = 0; step < 2; ++step) press(Qt::Key_Right, Qt::AltModifier);
  press(Qt::Key_O, Qt::ShiftModifier); // without the divider
  press(Qt::Key_X, Qt::ShiftModifier);
  press(Qt::Key_M);
  press(Qt::Key_V);
  ASSERT_EQ(renderer->last<request::SetViews>().views.size(), 4u);
  undo();
  EXPECT_EQ(renderer->last<request::SetViews>().views.size(), 2u);
  undo();
  EXPECT_EQ(view()->style().map, defaultStyle(intermediate(IntermediateId::alpha)).map);
  EXPECT_TRUE(view()->shows(Overlay::Clipped));
  undo();
  EXPECT_FALSE(view()->shows(Overlay::Clipped));
  EXPECT_EQ(view()->showing(), Showing::First);
  undo();
  EXPECT_EQ(view()->showing(), Showing::Wipe);
  EXPECT_NEAR(viewport()->divider(), 0.6, 1e-9);
  undo();
  EXPECT_NEAR(viewport()->divider(), 0.5, 1e-9) << "both turns of the key were one";
  undo();
  EXPECT_FALSE(view()->comparison());
  EXPECT_EQ(view()->id(), IntermediateId::alpha);
  undo();
  EXPECT_EQ(view()->id(), IntermediateId::resolved);
  EXPECT_EQ(viewport()->camera(), (ViewCamera{false, 8.0, {20, 10}})) << "where one looks stays";
  EXPECT_FALSE(session.undoStack().canUndo());
}

TEST_F(UndoTest, MarksAndWhatIsRepeatedComeBack) {
  session.seek(12);
  settle();
  press(Qt::Key_K, Qt::ShiftModifier);
  auto* prompt = window.findChild<Prompt*>();
  ASSERT_TRUE(prompt);
  QTest::keyClicks(prompt->field(), "ghost");
  QTest::keyClick(prompt->field(), Qt::Key_Return);
  settle();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  press(Qt::Key_BracketLeft);
  press(Qt::Key_BracketLeft, Qt::ControlModifier);
  press(Qt::Key_K);
  ASSERT_FALSE(window.timeline()->marks().has(12));
  EXPECT_EQ(session.undoStack().undoText(), "removal of a mark");
  undo();
  EXPECT_EQ(window.timeline()->marks().nameOf(12), "ghost");
  EXPECT_EQ(renderer->status.playback.speed, 0.5);
  undo();
  EXPECT_EQ(renderer->status.playback.speed, 1.0);
  ASSERT_TRUE(renderer->status.playback.range);
  undo();
  EXPECT_FALSE(renderer->status.playback.range);
  undo();
  EXPECT_TRUE(window.timeline()->marks().all().empty());
  EXPECT_EQ(renderer->status.info.frame, 12) << "time is nothing to undo";
}

TEST_F(UndoTest, FlightsCamerasAndObjectsComeBack) {
  press(Qt::Key_F, Qt::ShiftModifier);
  const QPoint middle = viewport()->rect().center();
  QTest::mousePress(viewport(), Qt::LeftButton, {}, middle);
  for (const int x : {10, 20, 30}) {
    QTest::mouseMove(viewport(), middle + QPoint(x, 0));
    settle();
  }
  QTest::mouseRelease(viewport(), Qt::LeftButton, {}, middle + QPoint(30, 0));
  settle();
  ASSERT_EQ(renderer->status.camera, kFreeCamera);
  press(Qt::Key_Escape);
  session.scene().setCamera("pan");
  settle();
  session.scene().setHidden("floor", true);
  settle();
  ASSERT_EQ(renderer->status.filter.hidden, std::vector<std::string>{"floor"});
  session.scene().setMotionMode("floor", MotionMode::None);
  settle();
  undo();
  EXPECT_TRUE(renderer->status.motionModes.empty());
  undo();
  EXPECT_TRUE(renderer->status.filter.hidden.empty());
  undo();
  EXPECT_EQ(renderer->status.camera, kFreeCamera);
  EXPECT_EQ(session.undoStack().undoText(), "flight");
  undo();
  EXPECT_EQ(renderer->status.camera, "still") << "a drag is one step";
  EXPECT_TRUE(renderer->status.tracks.empty());
  EXPECT_FALSE(session.undoStack().canUndo());
  redo();
  EXPECT_EQ(renderer->status.camera, kFreeCamera);
}

TEST_F(UndoTest, AnotherSceneForgetsWhatIsOfTheFirst) {
  session.presets().setParameter("rectify.method", 0);
  session.scene().setCamera("pan");
  settle();
  window.openSource("builtin:fence");
  settle();
  EXPECT_TRUE(session.undoStack().undoText().startsWith("change of "));
  undo();
  EXPECT_EQ(renderer->status.settings.rectify.method, RectifyMethod::ClipToFiltered);
  EXPECT_FALSE(session.undoStack().canUndo());
}

TEST_F(UndoTest, EscapeTakesADragBack) {
  session.presets().setParameter("neighborhood.gamma", 2.0);
  undo();
  NumberField* field = gamma();
  QTest::mousePress(field, Qt::LeftButton, {}, {20, 10});
  QTest::mouseMove(field, {45, 10});
  ASSERT_GT(gammaValue(), 1.2f);
  press(Qt::Key_Escape);
  EXPECT_EQ(gammaValue(), 1.0f);
  QTest::mouseMove(field, {70, 10});
  QTest::mouseRelease(field, Qt::LeftButton, {}, {70, 10});
  settle();
  EXPECT_EQ(gammaValue(), 1.0f) << "until the release nothing moves";
  EXPECT_FALSE(session.undoStack().canUndo());
  EXPECT_TRUE(session.undoStack().canRedo()) << "as if there had been no drag";

  viewport()->setFocus();
  QTest::mousePress(viewport(), Qt::RightButton, {}, placeOf({20, 6}));
  QTest::mouseMove(viewport(), placeOf({30, 6}));
  press(Qt::Key_Escape);
  QTest::mouseMove(viewport(), placeOf({40, 6}));
  QTest::mouseRelease(viewport(), Qt::RightButton, {}, placeOf({40, 6}));
  settle();
  EXPECT_EQ(pixels(), (Pixels{{10, 5}}));

  const ViewCamera camera = viewport()->camera();
  const QPoint middle = viewport()->rect().center();
  QTest::mousePress(viewport(), Qt::LeftButton, {}, middle);
  QTest::mouseMove(viewport(), middle + QPoint(30, 10));
  ASSERT_FALSE(viewport()->camera() == camera);
  press(Qt::Key_Escape);
  QTest::mouseRelease(viewport(), Qt::LeftButton, {}, middle);
  EXPECT_EQ(viewport()->camera(), camera);

  Timeline* timeline = window.timeline()->timeline();
  const auto at = [&](int frame) { return QPointF(timeline->scale().position(frame), 20).toPoint(); };
  QTest::mousePress(timeline, Qt::LeftButton, {}, at(100));
  settle();
  ASSERT_NEAR(renderer->status.info.frame, 100, 1);
  press(Qt::Key_Escape);
  QTest::mouseRelease(timeline, Qt::LeftButton, {}, at(120));
  settle();
  EXPECT_EQ(renderer->status.info.frame, 0);
  EXPECT_EQ(pixels(), (Pixels{{10, 5}})) << "nothing else was ended";
}

TEST_F(UndoTest, EscapeInTheSearchFieldEndsTheSearchOnly) {
  press(Qt::Key_F, Qt::ControlModifier);
  SearchField* field = window.pipeline()->searchField();
  QTest::keyClicks(field, "gamma");
  press(Qt::Key_Escape);
  EXPECT_EQ(field->text(), "");
  EXPECT_TRUE(field->hasFocus());
  press(Qt::Key_Escape);
  EXPECT_TRUE(viewport()->hasFocus());
  EXPECT_EQ(pixels(), (Pixels{{10, 5}}));
  press(Qt::Key_Escape);
  EXPECT_TRUE(renderer->last<request::SetProbes>().all.empty());
  undo();
  EXPECT_EQ(pixels(), (Pixels{{10, 5}}));
}

TEST_F(UndoTest, EscapeStopsWorkAndLeavesTheProbe) {
  renderer->tell(Work{WorkKind::Replay, "Going to frame 200", 3, 200});
  settle();
  press(Qt::Key_Escape);
  EXPECT_EQ(renderer->all<request::Cancel>().size(), 1u);
  renderer->tell(Work{});
  settle();
  press(Qt::Key_Escape); // a moment too late
  EXPECT_EQ(pixels(), (Pixels{{10, 5}}));
  QTest::qWait(450);
  renderer->status.goal = 200; // no word of how far it is yet
  session.seek(0);
  settle();
  press(Qt::Key_Escape);
  EXPECT_EQ(renderer->all<request::Cancel>().size(), 3u);
  EXPECT_EQ(pixels(), (Pixels{{10, 5}}));
  renderer->status.goal.reset();
  session.seek(0);
  settle();
  press(Qt::Key_Escape);
  EXPECT_TRUE(renderer->last<request::SetProbes>().all.empty());
}

TEST_F(UndoTest, EscapeEndsFlightThenComparisonThenProbe) {
  compareWith(test::kRow);
  press(Qt::Key_F, Qt::ShiftModifier);
  ASSERT_TRUE(window.flight()->isOn());
  press(Qt::Key_Escape);
  EXPECT_FALSE(window.flight()->isOn());
  EXPECT_TRUE(view()->comparison());
  press(Qt::Key_Escape);
  EXPECT_FALSE(view()->comparison());
  EXPECT_EQ(pixels(), (Pixels{{10, 5}}));
  press(Qt::Key_Escape);
  EXPECT_TRUE(renderer->last<request::SetProbes>().all.empty());
  press(Qt::Key_Escape);
  undo();
  undo();
  EXPECT_TRUE(view()->comparison());
}
