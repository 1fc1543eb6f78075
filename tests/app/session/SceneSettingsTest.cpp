// Scenes are opened with the settings that show them, from wherever they are opened.
#include "core/inspect/SceneSettings.h"
#include "core/lessons/Lesson.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Parameters.h"
#include "tests/app/WindowFixture.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>

#include <string>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

constexpr const char* kGlass = "builtin:glass";

class SceneSettings : public test::FakeWindow {
 protected:
  const Settings& settings() const { return session.presets().settings(); }
  /// By keys, as the File menu lists it.
  void chooseScene(const QString& label) {
    QMenu* file = window.menuBar()->actions().front()->menu();
    file->popup(window.mapToGlobal(QPoint(10, 30)));
    for (QAction* action : file->actions())
      if (action->text() == label) file->setActiveAction(action);
    QTest::keyClick(file, Qt::Key_Return);
    settle();
  }
};

} // namespace

TEST(SceneTable, SettingsAreReadAndDifferFromTheDefault) {
  int wanted = 0;
  for (const BuiltinScene& scene : builtinScenes())
    for (const std::string& assignment : scene.settings) {
      Settings settings;
      applyAssignment(settings, assignment);
      EXPECT_FALSE(settings == Settings{}) << scene.id << ' ' << assignment;
      ++wanted;
    }
  EXPECT_GT(wanted, 0);
  ASSERT_TRUE(findBuiltinScene(kGlass));
  EXPECT_EQ(findBuiltinScene(kGlass)->id, "glass");
  EXPECT_FALSE(findBuiltinScene("glass"));
  EXPECT_FALSE(findBuiltinScene("builtin:none"));
}

TEST_F(SceneSettings, GlassIsOpenedSeenThroughAndLeftWithoutATrace) {
  const Settings first = settings();
  chooseScene("Glass");
  ASSERT_EQ(session.status().source, kGlass);
  EXPECT_EQ(differences(settings(), first),
            (std::vector<std::string>{"inputs.blended=before", "inputs.mask=autoReactive",
                                      "weight.mask=reactive"}));
  EXPECT_EQ(renderer->status.settings, settings()) << "the renderer draws with them";
  EXPECT_FALSE(session.undoStack().canUndo()) << "nobody has changed anything";
  chooseScene("Fan");
  EXPECT_EQ(settings(), first);
}

TEST_F(SceneSettings, WhatSomebodyChoseStays) {
  session.presets().assign({"inputs.blended=dithered", "weight.minimum=0.25"});
  chooseScene("Glass");
  EXPECT_EQ(settings().inputs.blended, BlendedAs::Dithered);
  EXPECT_EQ(settings().inputs.mask, MaskSource::AutoReactive);
  session.presets().assign({"inputs.mask=opacity"});
  chooseScene("Glass");
  EXPECT_EQ(settings().inputs.mask, MaskSource::Opacity) << "it is open already";
  chooseScene("Fan");
  EXPECT_EQ(settings().inputs.blended, BlendedAs::Dithered);
  EXPECT_EQ(settings().inputs.mask, MaskSource::Opacity);
  EXPECT_FLOAT_EQ(settings().weight.minimum, 0.25f);
}

TEST_F(SceneSettings, AStepOfUndoFromBeforeLeavesTheGlassSeenThrough) {
  session.presets().setParameter("weight.minimum", 0.25);
  chooseScene("Glass");
  session.undoStack().undo();
  settle();
  EXPECT_FLOAT_EQ(settings().weight.minimum, 0.1f);
  EXPECT_EQ(settings().inputs.blended, BlendedAs::Before);
}

TEST_F(SceneSettings, ASceneThatCannotBeOpenedChangesNothing) {
  chooseScene("Glass");
  const Settings before = settings();
  window.openSource("nowhere.gltf");
  settle();
  EXPECT_EQ(settings(), before);
}

TEST_F(SceneSettings, ALessonOpensItSeenThroughUnlessItNamesAPreset) {
  const auto shotOf = [](const std::string& lines) {
    return lessonFromText("# Panes\n\nText.\n\n## Look\n\n```state\n" + lines + "```\n\nText.\n", "own")
        .steps.front()
        .state.shot;
  };
  EXPECT_EQ(shotOf("scene: builtin:glass\n").settings.settings.inputs.blended, BlendedAs::Before);
  EXPECT_EQ(shotOf("scene: builtin:glass\npreset: balanced\n").settings.settings.inputs.blended,
            BlendedAs::Mask);
  EXPECT_EQ(shotOf("scene: builtin:glass\nset: inputs.blended=after\n").settings.settings.inputs.blended,
            BlendedAs::After);
  EXPECT_EQ(shotOf("scene: builtin:fan\n").settings.settings, Settings{});
}
