// The stack of undo by itself, and the names of changes.
#include "app/undo/UndoStack.h"

#include "app/commands/EscapeKey.h"
#include "app/undo/DocumentChanges.h"

#include <QApplication>
#include <QJsonArray>
#include <QTest>
#include <QTimer>
#include <QWidget>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

using namespace taa::app;

namespace {

/// A number whose changes are undone.
class UndoStackTest : public testing::Test {
 protected:
  void set(int to, const char* what, const std::string& key = {}, bool ofScene = false) {
    UndoStep step = stepBackTo<int>(
        number, [this] { return number; }, [this](const int& before) { number = before; });
    step.what = QString::fromLatin1(what);
    step.key = key;
    step.ofScene = ofScene;
    number = to;
    stack.push(std::move(step));
  }
  void SetUp() override { stack.findChild<QTimer*>()->setInterval(kPauseMs); }

  static constexpr int kPauseMs = 100;
  int number = 0;
  UndoStack stack;
};

QJsonObject view(const char* id, double low, bool alwaysFits, double zoom = 1.0) {
  const QJsonObject style{{"low", low}, {"high", low + 1}, {"exposure", 0}, {"map", "viridis"}};
  return {{"intermediate", QString::fromLatin1(id)},
          {"styles", QJsonObject{{id, style}}},
          {"difference", style},
          {"alwaysFits", alwaysFits},
          {"comparedWith", "nothing"},
          {"divider", 0.5},
          {"camera", QJsonObject{{"zoom", zoom}}}};
}

QJsonObject views(const QJsonObject& a, const QJsonObject& b, int active = 0) {
  return {{"count", 2}, {"active", active}, {"linked", true}, {"views", QJsonArray{a, b}}};
}

QString nameOf(const QJsonObject& before, const QJsonObject& after) {
  const auto name = viewChange(documentOfViews(before), documentOfViews(after));
  return name ? name->what : QString();
}

} // namespace

TEST_F(UndoStackTest, GoesBackAndOnInOrderAndNamesEachStep) {
  set(1, "first");
  set(2, "second");
  EXPECT_EQ(stack.undoText(), "second");
  EXPECT_EQ(stack.redoText(), "");
  stack.undo();
  EXPECT_EQ(number, 1);
  EXPECT_EQ(stack.redoText(), "second");
  stack.undo();
  EXPECT_EQ(number, 0);
  EXPECT_FALSE(stack.canUndo());
  stack.redo();
  stack.redo();
  EXPECT_EQ(number, 2);
  EXPECT_FALSE(stack.canRedo());
  stack.undo();
  set(7, "third");
  EXPECT_FALSE(stack.canRedo()) << "something else was done";
  stack.undo();
  EXPECT_EQ(number, 1);
}

TEST_F(UndoStackTest, AGestureIsOneStep) {
  set(1, "drag", "slider");
  set(2, "drag", "slider");
  set(3, "drag", "slider");
  stack.endGesture();
  set(4, "drag", "slider");
  set(5, "press", {});
  set(6, "press", {});
  for (const int wanted : {5, 4, 3, 0}) {
    stack.undo();
    EXPECT_EQ(number, wanted);
  }
  EXPECT_FALSE(stack.canUndo());
}

TEST_F(UndoStackTest, KeysThatFollowSoonAreOneStepAndAPauseEndsIt) {
  set(1, "key", "slider");
  QTest::qWait(kPauseMs / 5);
  set(2, "key", "slider");
  QTest::qWait(2 * kPauseMs);
  set(3, "key", "slider");
  stack.undo();
  EXPECT_EQ(number, 2);
  stack.undo();
  EXPECT_EQ(number, 0);
}

TEST_F(UndoStackTest, APressOfTheMouseLastsUntilItsRelease) {
  QWidget widget;
  widget.show();
  QTest::mousePress(&widget, Qt::LeftButton);
  set(1, "drag", "slider");
  QTest::qWait(2 * kPauseMs); // the mouse rests
  set(2, "drag", "slider");
  QTest::mouseRelease(&widget, Qt::LeftButton);
  QTest::mousePress(&widget, Qt::LeftButton);
  set(3, "drag", "slider");
  QTest::mouseRelease(&widget, Qt::LeftButton);
  stack.undo();
  EXPECT_EQ(number, 2);
  stack.undo();
  EXPECT_EQ(number, 0);
}

TEST_F(UndoStackTest, AGestureOfNothingLeavesNoStepAndKeepsWhatCanBeDoneAgain) {
  set(5, "first");
  stack.undo();
  set(1, "drag", "slider");
  set(0, "drag", "slider");
  stack.endGesture();
  EXPECT_FALSE(stack.canUndo());
  ASSERT_TRUE(stack.canRedo());
  stack.redo();
  EXPECT_EQ(number, 5);
}

TEST_F(UndoStackTest, AnAbandonedGestureHasNeverBeen) {
  set(5, "first");
  set(6, "second");
  stack.undo();
  set(8, "drag", "slider");
  set(9, "drag", "slider");
  stack.abandonGesture();
  EXPECT_EQ(number, 5);
  EXPECT_EQ(stack.undoText(), "first");
  EXPECT_EQ(stack.redoText(), "second");
  stack.abandonGesture();
  EXPECT_EQ(number, 5) << "there is none under way";
}

TEST_F(UndoStackTest, StepsOfASceneGoWithIt) {
  set(1, "setting");
  set(2, "camera", {}, true);
  stack.forgetScene();
  EXPECT_EQ(stack.undoText(), "setting");
}

TEST_F(UndoStackTest, WhatIsQuietIsNotNoted) {
  {
    const UndoStack::Quiet quiet(stack);
    set(1, "file");
  }
  EXPECT_FALSE(stack.canUndo());
}

TEST(DocumentChanges, LeaveOutWhereOneLooks) {
  const QJsonObject before = views(view("alpha", 0, false), view("color", 0, false));
  const QJsonObject zoomed = views(view("alpha", 0, false, 8.0), view("color", 0, false), 1);
  EXPECT_EQ(documentOfViews(before), documentOfViews(zoomed));
  EXPECT_EQ(withPlacesOf(zoomed, documentOfViews(before)), zoomed);
}

TEST(DocumentChanges, AreNamedByWhatChanged) {
  const QJsonObject alpha = view("alpha", 0, false), color = view("color", 0, false);
  EXPECT_EQ(nameOf(views(alpha, color), views(alpha, alpha)), "change of what view B shows");
  EXPECT_EQ(nameOf(views(alpha, color), views(view("alpha", 2, false), color)),
            "change of the look of view A");
  QJsonObject four = views(alpha, color);
  four["count"] = 4;
  EXPECT_EQ(nameOf(views(alpha, color), four), "change of how the views lie");
  QJsonObject compared = alpha;
  compared["comparedWith"] = "color";
  EXPECT_EQ(nameOf(views(alpha, color), views(compared, color)), "change of what view A is compared with");
}

TEST(DocumentChanges, LeaveOutRangesThatFollowThePicture) {
  const QJsonObject still = view("color", 0, false), fits = view("alpha", 0, true);
  const QJsonObject later = view("alpha", 3, true);
  EXPECT_EQ(nameOf(views(fits, still), views(later, still)), "");
  EXPECT_EQ(nameOf(views(fits, still), views(later, view("motion", 0, false))),
            "change of what view B shows");
  EXPECT_EQ(nameOf(views(view("alpha", 0, false), still), views(fits, still)),
            "change of the look of view A");
}

TEST(EscapeKey, EndsTheInnermostOfWhatIsThere) {
  EscapeState state;
  EXPECT_FALSE(escapeTarget(state));
  const auto add = [&](bool EscapeState::*what, EscapeTarget target) {
    state.*what = true;
    EXPECT_EQ(escapeTarget(state), target);
  };
  add(&EscapeState::hasProbe, EscapeTarget::Probe);
  add(&EscapeState::isComparing, EscapeTarget::Comparison);
  add(&EscapeState::isFlying, EscapeTarget::Flight);
  add(&EscapeState::isWorking, EscapeTarget::Work);
  add(&EscapeState::isInSearch, EscapeTarget::SearchField);
  add(&EscapeState::hasSearchText, EscapeTarget::SearchText);
  add(&EscapeState::isDragging, EscapeTarget::Drag);
}
