// The rungs of a source's ladder by keys and by clicks on its table, and what is said of each.
#include "core/lessons/Ladder.h"
#include "app/background/LessonWork.h"
#include "app/commands/LadderSteps.h"
#include "app/learn/LearnPanel.h"
#include "app/learn/Learning.h"
#include "app/learn/LessonText.h"
#include "app/panels/MessagesBar.h"
#include "core/lessons/Lesson.h"
#include "core/settings/Presets.h"
#include "tests/app/WindowFixture.h"

#include <QTextBlock>
#include <QTextTable>

#include <cmath>
#include <string>

using namespace taa::app;
using namespace taa::app::test;

namespace {

constexpr auto kControl = Qt::ControlModifier;

} // namespace

class LadderWindow : public FakeWindow {
 protected:
  std::string presetId() const { return session.presets().presetId(); }
  LadderSteps* ladder() { return window.findChild<LadderSteps*>(); }
  QString said() { return window.findChild<MessagesBar*>()->history().value(0); }
};

TEST_F(LadderWindow, CtrlPageKeysGoToTheNextRungAndThePreviousOne) {
  session.presets().setPreset(QStringLiteral("source000-10"));
  settle();
  key(Qt::Key_PageDown, kControl);
  EXPECT_EQ(presetId(), "source000-11");
  EXPECT_TRUE(session.presets().settings() == taa::preset("source000-11").settings);
  EXPECT_TRUE(said().contains(QStringLiteral("texture fetches of a pixel 20 → 24"))) << said().toStdString();
  EXPECT_TRUE(said().contains(QStringLiteral("Catmull-Rom 5"))) << said().toStdString();
  key(Qt::Key_PageUp, kControl);
  EXPECT_EQ(presetId(), "source000-10");
  EXPECT_TRUE(said().contains(QStringLiteral("24 → 20"))) << said().toStdString();
  session.undoStack().undo();
  EXPECT_EQ(presetId(), "source000-11") << "a rung is a step of undo";
}

TEST_F(LadderWindow, KeysEndWithTheLadder) {
  session.presets().setPreset(QStringLiteral("source000-1"));
  settle();
  key(Qt::Key_PageUp, kControl);
  EXPECT_EQ(presetId(), "source000-1");
  EXPECT_EQ(ladder()->whyNot(1), QString());
  session.presets().setPreset(QStringLiteral("source000"));
  settle();
  key(Qt::Key_PageDown, kControl);
  EXPECT_EQ(presetId(), "source000");
  session.presets().setPreset(QStringLiteral("ue4"));
  settle();
  key(Qt::Key_PageDown, kControl);
  EXPECT_EQ(presetId(), "ue4");
  EXPECT_FALSE(ladder()->whyNot(1).isEmpty());
}

TEST_F(LadderWindow, WhatWasMeasuredIsSaidBehindWhatChanged) {
  session.presets().setPreset(QStringLiteral("source004-7"));
  key(Qt::Key_PageDown, kControl);
  EXPECT_EQ(presetId(), "source004");
  ladder()->work()->cancel();
  Q_EMIT ladder()->work()->measured({{"PSNR, dB", {26.16, 26.16}},
                                     {"Flicker", {0.0102, NAN}},
                                     {"Changed", {0.0, 0.0}},
                                     {"Time", {1.0, 1.25}}});
  for (const char* part :
       {"PSNR 26.16 → 26.16 dB", "flicker 0.0102 → –", "0.00 % of the pixels changed", "× 1.25"})
    EXPECT_TRUE(said().contains(QString::fromUtf8(part))) << said().toStdString();
}

TEST_F(LadderWindow, EachRowOfTheTableLeadsToItsRung) {
  auto* learning = window.findChild<Learning*>();
  learning->openStep(QStringLiteral("ladders"), 1);
  settle();
  auto* text = window.findChild<LearnPanel*>()->findChild<LessonText*>();
  QTextTable* table = nullptr;
  for (QTextFrame* frame : text->document()->rootFrame()->childFrames())
    if (auto* found = qobject_cast<QTextTable*>(frame)) table = found;
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows(), 15) << "a head and fourteen rungs";
  for (const int column : {0, 3}) { // the link itself, and a number beside it
    const int row = 5 + column;
    QTextCursor cursor = table->cellAt(row, column).firstCursorPosition();
    text->setTextCursor(cursor);
    text->ensureCursorVisible();
    cursor.movePosition(QTextCursor::NextCharacter);
    QTest::mouseClick(text->viewport(), Qt::LeftButton, {}, text->cursorRect(cursor).center());
    settle();
    EXPECT_EQ(presetId(), "source000-" + std::to_string(row)) << column;
  }
  // A link of somebody's text to what is no rung leads nowhere.
  Q_EMIT text->rungChosen(QStringLiteral("balanced"));
  EXPECT_EQ(presetId(), "source000-8");
}
