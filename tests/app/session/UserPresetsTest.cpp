// A user's own presets: saved by a key, listed in the menu, opened again.
#include "app/session/UserPresets.h"
#include "app/commands/OwnPresets.h"

#include "app/dialogs/PresetsDialog.h"
#include "app/panels/MessagesBar.h"
#include "app/widgets/Prompt.h"
#include "app/widgets/parameters/ChoiceWords.h"
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/settings/Presets.h"
#include "tests/app/WindowFixture.h"

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTemporaryDir>
#include <QTreeWidget>

#include <algorithm>
#include <string>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

/// A window that keeps its settings in a folder of its own.
class UserPresetsTest : public test::FakeWindow {
 protected:
  QTemporaryDir folder;
  QSettings settings{folder.filePath("taa.ini"), QSettings::IniFormat};
  app::test::TestWindow own{session, &settings};

  void SetUp() override {
    FakeWindow::SetUp();
    own.show();
    own.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&own));
  }
  void ask(const QString& name) {
    own.activateWindow(); // a prompt is a window of its own
    ASSERT_TRUE(QTest::qWaitForWindowActive(&own));
    QTest::keyClick(&own, Qt::Key_S, Qt::ControlModifier | Qt::AltModifier);
    auto* prompt = own.findChild<Prompt*>();
    ASSERT_TRUE(prompt);
    QTest::keyClicks(prompt->field(), name);
    QTest::keyClick(prompt->field(), Qt::Key_Return);
    settle();
  }
  void saveAs(const QString& name) {
    ask(name);
    own.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&own));
  }
};

TEST_F(UserPresetsTest, AreSavedByAKeyAndOpenAgain) {
  session.presets().setParameter("weight.minimum", 0.25);
  saveAs("My calm one");
  const QString path = folder.filePath("presets/my-calm-one.json");
  EXPECT_EQ(preset(path.toStdString()).settings.weight.minimum, 0.25f);
  EXPECT_EQ(session.presets().presetId(), "my-calm-one");
  EXPECT_FALSE(session.presets().isPresetChanged());
  const std::vector<UserPreset> found = userPresets(own.presets()->folder());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].label, "My calm one");
  session.presets().setPreset("minimal");
  session.presets().setPreset(found[0].path);
  EXPECT_EQ(session.presets().settings().weight.minimum, 0.25f);
}

TEST_F(UserPresetsTest, OfTheVersionBeforeSayWhatHasAnotherName) {
  std::vector<QString> sentences;
  QObject::connect(&session.presets(), &PresetChoices::said, &own,
                   [&](const QString& sentence) { sentences.push_back(sentence); });
  const QString path = folder.filePath("old.json");
  writeFile(
      path.toStdString(),
      R"({"format": 1, "id": "a", "label": "A", "settings": {"weight": {"most": 0.5, "least": 0.25}}})");
  const QString expected =
      "The preset is of an earlier version: weight.least is called weight.sourceMin now; "
      "weight.most is called weight.sourceMax now.";
  session.presets().setPreset(path);
  EXPECT_EQ(session.presets().settings().weight.sourceMax, 0.5f);
  EXPECT_EQ(sentences, std::vector<QString>{expected});
  EXPECT_TRUE(own.messages()->text().contains(expected)) << own.messages()->text().toStdString();
  session.presets().setOtherPresets({"balanced", path, path});
  EXPECT_EQ(sentences, (std::vector<QString>{expected, expected})) << "one note for all of them";
  session.presets().setPreset("minimal");
  EXPECT_EQ(sentences.size(), 2u);
}

TEST_F(UserPresetsTest, OneOfTheSameNameIsReplacedOnlyWhenTheUserSaysSo) {
  session.presets().setParameter("weight.minimum", 0.25);
  saveAs("Mine");
  const std::string path = folder.filePath("presets/mine.json").toStdString();
  session.presets().setParameter("weight.minimum", 0.5);
  const auto answer = [&](const QString& text) {
    auto* box = own.findChild<QMessageBox*>();
    ASSERT_TRUE(box && box->isVisible());
    EXPECT_TRUE(box->text().contains("mine.json")) << box->text().toStdString();
    for (QAbstractButton* button : box->buttons())
      if (button->text().remove('&') == text) return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << text.toStdString();
  };
  ask("mine");
  answer("Cancel");
  settle();
  EXPECT_EQ(preset(path).settings.weight.minimum, 0.25f);
  EXPECT_TRUE(session.presets().isPresetChanged());
  ask("mine");
  answer("Replace");
  settle();
  EXPECT_EQ(preset(path).settings.weight.minimum, 0.5f);
  EXPECT_FALSE(session.presets().isPresetChanged());
}

TEST_F(UserPresetsTest, AreGoneBackToLikeAnyOther) {
  session.presets().setParameter("weight.minimum", 0.25);
  saveAs("Mine");
  session.presets().setParameter("weight.minimum", 0.5);
  EXPECT_TRUE(session.presets().isPresetChanged());
  QTest::keyClick(&own, Qt::Key_R, Qt::ControlModifier);
  EXPECT_EQ(session.presets().settings().weight.minimum, 0.25f);
  EXPECT_FALSE(session.presets().isPresetChanged());
  session.undo();
  EXPECT_EQ(session.presets().settings().weight.minimum, 0.5f);
}

TEST_F(UserPresetsTest, ANameOfABuiltInOneIsRefusedAndNothingIsLost) {
  session.presets().setParameter("weight.minimum", 0.25);
  QString said;
  QObject::connect(&session, &Session::errorOccurred, [&said](const QString& sentence) { said = sentence; });
  saveAs("Balanced");
  EXPECT_TRUE(said.contains("built-in")) << said.toStdString();
  EXPECT_TRUE(userPresets(own.presets()->folder()).empty());
  EXPECT_EQ(session.presets().settings().weight.minimum, 0.25f);
  EXPECT_THROW(saveUserPreset(own.presets()->folder(), "…", {}), Error);
}

TEST_F(UserPresetsTest, RowsBeginAtTheSamePlaceChosenOrNot) {
  QTest::keyClick(&own, Qt::Key_D, Qt::ControlModifier);
  auto* dialog = own.findChild<PresetsDialog*>();
  ASSERT_TRUE(dialog);
  QListWidget* list = dialog->list();
  list->setCurrentRow(1);
  list->scrollToTop();
  const QImage seen = list->viewport()->grab().toImage();
  const auto textBegin = [&](int row) { // the first column that is not of one color
    const QRect place = list->visualItemRect(list->item(row));
    for (int x = place.left(); x < place.right(); ++x)
      for (int y = place.top() + 1; y < place.bottom(); ++y)
        if (seen.pixel(x, y) != seen.pixel(x, place.top() + 1)) return x;
    return -1;
  };
  ASSERT_GT(textBegin(1), 0);
  for (const int row : {0, 2, 3}) EXPECT_NEAR(textBegin(row), textBegin(1), 2) << "letters begin unlike";
}

TEST_F(UserPresetsTest, AreComparedInAsMuchRoomAsTheWindowHas) {
  for (const QSize& size : {QSize(1024, 600), QSize(1280, 800)}) {
    own.resize(size);
    QTest::keyClick(&own, Qt::Key_D, Qt::ControlModifier);
    auto* dialog = own.findChild<PresetsDialog*>();
    ASSERT_TRUE(dialog);
    EXPECT_LE(dialog->height(), size.height());
    EXPECT_GE(dialog->height(), std::min(680, size.height() - 16)) << size.height();
    delete dialog;
  }
}

TEST_F(UserPresetsTest, WhatAPresetIsStandsAboveWhatDiffers) {
  own.resize(1024, 600);
  QTest::keyClick(&own, Qt::Key_D, Qt::ControlModifier);
  auto* dialog = own.findChild<PresetsDialog*>();
  ASSERT_TRUE(dialog);
  const auto labelOf = [&](const QString& text) {
    for (const QLabel* label : dialog->findChildren<QLabel*>())
      if (label->text() == text) return label;
    return static_cast<const QLabel*>(nullptr);
  };
  const auto choose = [&](const char* id) {
    const QString name = QString::fromStdString(preset(id).label);
    dialog->list()->setCurrentItem(dialog->list()->findItems(name, Qt::MatchExactly).value(0));
    settle();
    return labelOf(withoutManual(QString::fromStdString(preset(id).description)));
  };
  ASSERT_TRUE(choose("balanced"));
  EXPECT_FALSE(dialog->table()->isVisible()) << "an empty table says nothing";
  const QLabel* longest = choose("godot");
  ASSERT_TRUE(longest);
  EXPECT_TRUE(dialog->table()->isVisible());
  EXPECT_GE(dialog->table()->viewport()->height(),
            4 * dialog->table()->visualItemRect(dialog->table()->topLevelItem(0)).height());
  auto* area = qobject_cast<QScrollArea*>(longest->parentWidget()->parentWidget());
  ASSERT_TRUE(area);
  EXPECT_EQ(area->horizontalScrollBar()->maximum(), 0);
  const QLabel* citing = choose("bevy");
  ASSERT_TRUE(citing);
  EXPECT_FALSE(citing->text().contains("D15")) << "nothing opens that";
  choose("godot");
  dialog->resize(dialog->width(), 0);
  settle();
  ASSERT_GT(area->verticalScrollBar()->maximum(), 0);
  area->setFocus();
  QTest::keyClick(dialog->focusWidget(), Qt::Key_Down);
  EXPECT_GT(area->verticalScrollBar()->value(), 0) << "keys scroll it";
}

TEST_F(UserPresetsTest, AreComparedRenamedAndDeleted) {
  saveAs("Mine");
  session.presets().setParameter("weight.minimum", 0.25);
  session.presets().setParameter("rectify.method", 0);
  QTest::keyClick(&own, Qt::Key_D, Qt::ControlModifier);
  auto* dialog = own.findChild<PresetsDialog*>();
  ASSERT_TRUE(dialog);
  EXPECT_EQ(dialog->list()->currentItem()->text(), "Mine (mine)");
  ASSERT_EQ(dialog->table()->topLevelItemCount(), 2);
  const QTreeWidgetItem* row = dialog->table()->topLevelItem(1);
  EXPECT_EQ(row->text(2).left(4), "0.25") << row->text(1).toStdString();
  EXPECT_EQ(row->text(3).left(3), "0.1");
  const auto press = [&](const QString& text) {
    for (auto* button : dialog->findChildren<QPushButton*>())
      if (button->text() == text) return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << text.toStdString();
  };
  dialog->table()->setCurrentItem(dialog->table()->topLevelItem(1));
  press("Apply this value");
  EXPECT_EQ(session.presets().settings().weight.minimum, 0.1f);
  EXPECT_EQ(dialog->table()->topLevelItemCount(), 1) << "the other one still differs";
  press("Apply preset");
  EXPECT_EQ(dialog->table()->topLevelItemCount(), 0);
  press("Rename…");
  auto* prompt = dialog->findChild<Prompt*>();
  ASSERT_TRUE(prompt);
  prompt->field()->setText("Yours");
  QTest::keyClick(prompt->field(), Qt::Key_Return);
  settle();
  ASSERT_EQ(userPresets(own.presets()->folder()).size(), 1u);
  EXPECT_EQ(userPresets(own.presets()->folder())[0].label, "Yours");
  press("Delete…");
  auto* box = dialog->findChild<QMessageBox*>();
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->text().contains("Yours"));
  for (QAbstractButton* button : box->buttons())
    if (button->text() == "Delete") button->click();
  settle();
  EXPECT_TRUE(userPresets(own.presets()->folder()).empty());
}

TEST_F(UserPresetsTest, AnotherOnesNameIsNotTaken) {
  saveUserPreset(folder.path(), "One", {});
  const QString two = saveUserPreset(folder.path(), "Two", {});
  EXPECT_THROW(renameUserPreset(two, "one"), Error);
  EXPECT_THROW(renameUserPreset(two, "Balanced"), Error);
  EXPECT_EQ(userPresets(folder.path()).size(), 2u);
  EXPECT_EQ(preset(renameUserPreset(two, "TWO").toStdString()).label, "TWO") << "the same file";
  EXPECT_EQ(userPresets(folder.path()).size(), 2u);
  EXPECT_THROW(deleteUserPreset(folder.filePath("three.json")), Error);
}

} // namespace
