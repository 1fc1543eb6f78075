// A user's own presets: saved by a key, listed in the menu, opened again.
#include "app/UserPresets.h"

#include "app/panels/MessagesBar.h"
#include "app/widgets/Prompt.h"
#include "core/base/Error.h"
#include "core/settings/Presets.h"
#include "tests/app/WindowFixture.h"

#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QTemporaryDir>

using namespace taa;
using namespace taa::app;

namespace {

/// A window that keeps its settings in a folder of its own.
class UserPresetsTest : public test::FakeWindow {
 protected:
  QTemporaryDir folder;
  QSettings settings{folder.filePath("taa.ini"), QSettings::IniFormat};
  MainWindow own{session, &settings};

  void SetUp() override {
    FakeWindow::SetUp();
    own.show();
    own.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&own));
  }
  void saveAs(const QString& name) {
    QTest::keyClick(&own, Qt::Key_S, Qt::ControlModifier | Qt::AltModifier);
    auto* prompt = own.findChild<Prompt*>();
    ASSERT_TRUE(prompt);
    QTest::keyClicks(prompt->field(), name);
    QTest::keyClick(prompt->field(), Qt::Key_Return);
    settle();
    own.activateWindow(); // the prompt was a window of its own
    ASSERT_TRUE(QTest::qWaitForWindowActive(&own));
  }
};

TEST_F(UserPresetsTest, AreSavedByAKeyAndOpenAgain) {
  session.setParameter("weight.minimum", 0.25);
  saveAs("My calm one");
  const QString path = folder.filePath("presets/my-calm-one.json");
  EXPECT_EQ(preset(path.toStdString()).settings.weight.minimum, 0.25f);
  EXPECT_EQ(session.presetId(), "my-calm-one");
  EXPECT_FALSE(session.isPresetChanged());
  const std::vector<UserPreset> found = userPresets(own.presetFolder());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].label, "My calm one");
  session.setPreset("minimal");
  session.setPreset(found[0].path);
  EXPECT_EQ(session.settings().weight.minimum, 0.25f);
}

TEST_F(UserPresetsTest, AreGoneBackToLikeAnyOther) {
  session.setParameter("weight.minimum", 0.25);
  saveAs("Mine");
  session.setParameter("weight.minimum", 0.5);
  EXPECT_TRUE(session.isPresetChanged());
  QTest::keyClick(&own, Qt::Key_R, Qt::ControlModifier);
  EXPECT_EQ(session.settings().weight.minimum, 0.25f);
  EXPECT_FALSE(session.isPresetChanged());
  session.undo();
  EXPECT_EQ(session.settings().weight.minimum, 0.5f);
}

TEST_F(UserPresetsTest, ANameOfABuiltInOneIsRefusedAndNothingIsLost) {
  session.setParameter("weight.minimum", 0.25);
  QString said;
  QObject::connect(&session, &Session::errorOccurred, [&said](const QString& sentence) { said = sentence; });
  saveAs("Balanced");
  EXPECT_TRUE(said.contains("built-in")) << said.toStdString();
  EXPECT_TRUE(userPresets(own.presetFolder()).empty());
  EXPECT_EQ(session.settings().weight.minimum, 0.25f);
  EXPECT_THROW(saveUserPreset(own.presetFolder(), "…", {}), Error);
}

} // namespace
