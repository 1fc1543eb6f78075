// The window's switches of the first steps: TAA off, history restarted, classes of objects, presets by
// groups.
#include "app/models/SceneTreeModel.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ScenePanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/views/timeline/Timeline.h"
#include "app/widgets/parameters/ChoiceButton.h"
#include "core/settings/Presets.h"
#include "tests/app/WindowFixture.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>

#include <cstddef>
#include <string>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

class FirstStepsWindow : public test::FakeWindow {
 protected:
  Timeline* timeline() const { return window.timeline()->timeline(); }
};

constexpr auto kShift = Qt::ShiftModifier;
constexpr auto kControl = Qt::ControlModifier;

} // namespace

TEST_F(FirstStepsWindow, OneKeyTurnsTaaOffAndOnAndUndoTakesItBack) {
  ASSERT_TRUE(isTaaOn(renderer->status.settings));
  key(Qt::Key_T, kShift);
  EXPECT_FALSE(isTaaOn(renderer->status.settings));
  Settings expected;
  expected.jitter.taa = Switch::Off;
  EXPECT_TRUE(renderer->status.settings == expected) << "nothing else changes";
  key(Qt::Key_T, kShift);
  EXPECT_TRUE(renderer->status.settings == Settings{});
  key(Qt::Key_Z, kControl);
  EXPECT_FALSE(isTaaOn(renderer->status.settings));
}

TEST_F(FirstStepsWindow, HistoryIsRestartedHereByAKeyAndShownOnTheTimeline) {
  using Frames = std::vector<int>;
  session.seek(30);
  settle();
  key(Qt::Key_R, kShift);
  EXPECT_EQ(renderer->status.restarts, Frames{30});
  EXPECT_TRUE(timeline()->textAt(30).contains("history is restarted"))
      << timeline()->textAt(30).toStdString();
  EXPECT_FALSE(timeline()->textAt(31).contains("restarted"));
  session.seek(12);
  settle();
  key(Qt::Key_R, kShift);
  EXPECT_EQ(renderer->status.restarts, (Frames{12, 30}));
  key(Qt::Key_PageDown);
  EXPECT_EQ(renderer->status.info.frame, 30) << "visited as cuts are";
  key(Qt::Key_R, kShift);
  EXPECT_EQ(renderer->status.restarts, Frames{12}) << "again: no longer";
  key(Qt::Key_Z, kControl);
  EXPECT_EQ(renderer->status.restarts, (Frames{12, 30}));
  key(Qt::Key_Z, kControl);
  EXPECT_EQ(renderer->status.restarts, Frames{30});
  key(Qt::Key_Z, kControl | kShift);
  EXPECT_EQ(renderer->status.restarts, (Frames{12, 30}));
  const SessionFile file = session.file();
  EXPECT_EQ(file.restarts, (Frames{12, 30}));
  session.open("builtin:text");
  settle();
  EXPECT_TRUE(renderer->status.restarts.empty());
  for (int times = 0; times < 2; ++times) { // also over itself
    session.restore(file);
    settle();
    EXPECT_EQ(renderer->status.restarts, (Frames{12, 30}));
  }
}

TEST_F(FirstStepsWindow, TheSelectedObjectIsGivenAClass) {
  key(Qt::Key_F8);
  SceneTreeModel* model = window.scene()->model();
  window.scene()->selectObject(1);
  settle();
  const int node = window.scene()->selected();
  ASSERT_GE(node, 0);
  const std::string name = model->outline()->nodes[static_cast<std::size_t>(node)].key;
  key(Qt::Key_8, kControl | kShift);
  EXPECT_EQ(renderer->status.objectClasses, (std::vector<ClassOverride>{{name, ObjectClass::Character}}));
  EXPECT_EQ(model->ownClassOf(node), ObjectClass::Character);
  EXPECT_TRUE(model->indexOf(node).data().toString().contains("Character"));
  const SessionFile file = session.file();
  EXPECT_EQ(file.objectClasses, renderer->status.objectClasses);
  key(Qt::Key_4, kControl | kShift);
  EXPECT_TRUE(renderer->status.objectClasses.empty()) << "by what moves it";
  session.restore(file);
  settle();
  EXPECT_EQ(renderer->status.objectClasses, file.objectClasses);
}

// All presets are in the menu, those of a source in a submenu of its own; the first nine have keys.
TEST_F(FirstStepsWindow, PresetsStandInTheMenusOfTheirGroups) {
  const QMenu* presets = nullptr;
  for (const QAction* entry : window.menuBar()->actions())
    for (const QAction* action : entry->menu()->actions())
      if (action->menu() && action->text() == "&Preset") presets = action->menu();
  ASSERT_TRUE(presets);
  std::size_t listed = 0, keys = 0;
  QStringList titles;
  const auto count = [&](const QMenu* menu) {
    for (const QAction* action : menu->actions()) {
      listed += action->menu() ? 0 : 1;
      keys += action->shortcut().isEmpty() ? 0 : 1;
    }
  };
  count(presets);
  for (const QAction* action : presets->actions())
    if (action->menu()) titles << action->text(), count(action->menu());
  EXPECT_EQ(listed, builtinPresets().size());
  EXPECT_EQ(keys, 9u);
  QStringList expected;
  for (std::size_t i = 1; i < kPresetGroups.size(); ++i)
    expected << QString::fromUtf8(kPresetGroups[i].label.data(),
                                  static_cast<qsizetype>(kPresetGroups[i].label.size()));
  EXPECT_EQ(titles, expected);
  key(Qt::Key_7, kControl | Qt::AltModifier);
  EXPECT_EQ(session.presets().presetId(), "off");
}

// The list beside the stages has the same parts; a step is chosen by real clicks.
TEST_F(FirstStepsWindow, AStepOfALadderIsChosenInTheListBesideTheStages) {
  auto* button = window.pipeline()->findChild<ChoiceButton*>(QStringLiteral("presets"));
  ASSERT_TRUE(button);
  QTest::mouseClick(button, Qt::LeftButton);
  settle();
  auto* menu = button->findChild<QMenu*>(QString(), Qt::FindDirectChildrenOnly);
  ASSERT_TRUE(menu);
  QAction* wanted = nullptr;
  QMenu* ladder = nullptr;
  for (QAction* action : menu->actions())
    if (action->menu() && action->text().startsWith("Blog on TAA in Unity")) ladder = action->menu();
  ASSERT_TRUE(ladder);
  for (QAction* action : ladder->actions())
    if (action->text().contains("step 2")) wanted = action;
  ASSERT_TRUE(wanted);
  menu->setActiveAction(ladder->menuAction());
  ladder->popup(menu->pos());
  settle();
  QTest::mouseClick(ladder, Qt::LeftButton, {}, ladder->actionGeometry(wanted).center());
  settle();
  EXPECT_EQ(session.presets().presetId(), "source000-2");
  EXPECT_TRUE(renderer->status.settings == preset("source000-2").settings);
}
