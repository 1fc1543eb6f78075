// The page Learn: lessons by keys and buttons, what a step sets, and how far the reader got.
#include "app/background/LessonWork.h"
#include "app/learn/LearnPanel.h"
#include "app/learn/Learning.h"
#include "app/learn/LessonText.h"
#include "app/learn/PartFrame.h"
#include "app/menus/FaultsMenu.h"
#include "app/models/ProbeModel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/StatusLine.h"
#include "app/style/Text.h"
#include "app/widgets/SectionHeader.h"
#include "app/widgets/parameters/ChoiceButton.h"
#include "core/lessons/Lesson.h"
#include "core/lessons/LessonNumbers.h"
#include "core/settings/Faults.h"
#include "tests/app/WindowFixture.h"

#include <QAction>
#include <QFont>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
#include <QStringList>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QTextDocumentFragment>
#include <QTreeView>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace taa::app;
using namespace taa::app::test;

namespace {

const taa::Lesson& tour() {
  return taa::builtinLessons().front();
}

} // namespace

class LearnTest : public FakeWindow {
 protected:
  /// Letters are the application's, not the window's.
  void TearDown() override { window.setTextPercent(100); }
  LearnPanel* panel() { return window.findChild<LearnPanel*>(); }
  Learning* learning() { return window.findChild<Learning*>(); }
  PartFrame* frame() { return window.findChild<PartFrame*>(); }
  void press(const QString& text) {
    for (QPushButton* button : panel()->findChildren<QPushButton*>())
      if (button->text() == text && button->isVisible()) {
        button->click();
        return;
      }
    ADD_FAILURE() << "there is no button " << text.toStdString();
  }
  void click(const QString& text) {
    for (QPushButton* button : panel()->findChildren<QPushButton*>())
      if (button->text() == text && button->isVisible()) {
        QTest::mouseClick(button, Qt::LeftButton);
        settle();
        return;
      }
    ADD_FAILURE() << "there is no button " << text.toStdString();
  }
  bool says(const QString& text) {
    for (const QLabel* label : panel()->findChildren<QLabel*>())
      if (label->isVisible() && QTextDocumentFragment::fromHtml(label->text()).toPlainText().contains(text))
        return true;
    return false;
  }
};

TEST_F(LearnTest, F12OpensTheTourWhichSetsItsSceneFrameAndSettings) {
  EXPECT_TRUE(panel()->isHidden());
  key(Qt::Key_F12);
  ASSERT_TRUE(panel()->isVisible());
  const taa::LessonState& state = tour().steps.front().state;
  ASSERT_TRUE(waitFor([&] { return session.status().source == state.shot.source; }));
  EXPECT_TRUE(waitFor([&] { return session.status().info.frame == state.shot.frame; }));
  EXPECT_EQ(glm::ivec2(session.status().width, session.status().height), state.shot.size);
  EXPECT_TRUE(session.presets().settings() == state.shot.settings.settings);
  EXPECT_TRUE(panel()->findChild<LessonText*>()->toPlainText().contains(QStringLiteral("ghost")));
  key(Qt::Key_F12);
  EXPECT_TRUE(panel()->isHidden());
}

TEST_F(LearnTest, StepsGoOnAndBackAndSurroundWhatTheySpeakOf) {
  key(Qt::Key_F12);
  EXPECT_EQ(static_cast<QWidget*>(frame()->part()), reinterpret_cast<QWidget*>(window.views()));
  press(QStringLiteral("Next"));
  press(QStringLiteral("Next"));
  EXPECT_EQ(learning()->step(), 2);
  EXPECT_EQ(static_cast<QWidget*>(frame()->part()), reinterpret_cast<QWidget*>(window.probe()));
  ASSERT_TRUE(waitFor([&] { return session.probes().pixel().has_value(); }));
  EXPECT_EQ(*session.probes().pixel(), tour().steps[2].state.probes.front());
  press(QStringLiteral("Back"));
  EXPECT_EQ(learning()->step(), 1);
  key(Qt::Key_F12);
  EXPECT_FALSE(frame()->isVisible());
}

TEST_F(LearnTest, AStepUnfoldsItsStageInThePipelineAndScrollsToIt) {
  key(Qt::Key_F12);
  const auto changes = std::ranges::find(tour().steps, "Change one thing", &taa::LessonStep::title);
  ASSERT_NE(changes, tour().steps.end());
  const taa::Stage stage = taa::Stage::RectifyHistory;
  ASSERT_EQ(changes->state.stages, std::vector<taa::Stage>{stage});
  learning()->openStep(QStringLiteral("first-ghost"), static_cast<int>(changes - tour().steps.begin()) + 1);
  SectionHeader* header = nullptr;
  for (SectionHeader* found : window.findChildren<SectionHeader*>())
    if (found->text() == qtext(taa::stageInfo(stage).label)) header = found;
  ASSERT_TRUE(header);
  EXPECT_TRUE(header->isChecked());
  EXPECT_TRUE(waitFor([&] { return header->visibleRegion().boundingRect() == header->rect(); }));
}

TEST_F(LearnTest, TheValuesThatAStepSpeaksOfAreInSight) {
  key(Qt::Key_F12);
  const auto reads = std::ranges::find(tour().steps, "Read what happened", &taa::LessonStep::title);
  ASSERT_NE(reads, tour().steps.end());
  ASSERT_FALSE(reads->state.values.empty());
  learning()->openStep(QStringLiteral("first-ghost"), static_cast<int>(reads - tour().steps.begin()) + 1);
  const QTreeView* table = window.probe()->table();
  const QModelIndex first = window.probe()->model()->indexOf(reads->state.values.front());
  EXPECT_TRUE(waitFor([&] {
    const QRect row = table->visualRect(first);
    return row.isValid() && table->viewport()->rect().contains(row) && row.top() < 2 * row.height();
  })) << table->visualRect(first).top();
}

TEST_F(LearnTest, APlotOfTheProbeHasRoomBesideALesson) {
  learning()->openStep(QStringLiteral("box"), 1);
  ASSERT_EQ(window.probe()->tab(), ProbeTab::ColorSpace);
  const QWidget* probe = window.probe();
  EXPECT_TRUE(waitFor([&] { return probe->height() >= 260; })) << probe->height();
}

TEST_F(LearnTest, HasTheRoomOfAProbeThatHasNoPixel) {
  const QWidget* probe = window.probe()->parentWidget();
  session.probes().removeAll();
  key(Qt::Key_F12);
  EXPECT_TRUE(waitFor([&] { return probe->height() < 100; }));
  session.probes().setPixel(glm::ivec2(20, 10));
  EXPECT_TRUE(waitFor([&] { return probe->height() >= 200; }));
  session.probes().removeAll();
  EXPECT_TRUE(waitFor([&] { return probe->height() < 100; }));
}

TEST_F(LearnTest, ReturnBringsBackWhatWasChanged) {
  key(Qt::Key_F12);
  settle();
  session.presets().setParameter("weight.alpha", 0.5);
  EXPECT_EQ(session.presets().settings().weight.alpha, 0.5f);
  press(QStringLiteral("Reset"));
  EXPECT_TRUE(session.presets().settings() == tour().steps.front().state.shot.settings.settings);
}

TEST_F(LearnTest, HintsComeOneByOneAndTheSolutionLast) {
  key(Qt::Key_F12);
  press(QStringLiteral("Next"));
  const taa::Task& task = *tour().steps[1].task;
  EXPECT_FALSE(says(QStringLiteral("Hint:")));
  press(QStringLiteral("Hint"));
  EXPECT_TRUE(says(QString::fromStdString(task.hints.front())));
  for (std::size_t hint = 1; hint < task.hints.size(); ++hint) press(QStringLiteral("Hint"));
  // Hints are Markdown: its marks are not shown.
  ASSERT_NE(task.hints.back().find("`Ctrl+G`"), std::string::npos);
  EXPECT_TRUE(says(QStringLiteral(": Ctrl+G goes")));
  press(QStringLiteral("Show the solution"));
  ASSERT_TRUE(waitFor([&] { return session.probes().pixel().has_value(); }));
  EXPECT_EQ(*session.probes().pixel(), task.solution.probes.front());
}

TEST_F(LearnTest, ATaskIsStillReadWhenItHasBeenAnswered) {
  window.setTextPercent(200);
  settle();
  learning()->openStep(QStringLiteral("first-ghost"), 6);
  settle();
  const auto* text = panel()->findChild<LessonText*>();
  const QScrollBar* bar = text->verticalScrollBar();
  ASSERT_GT(bar->maximum(), 0) << "it does not fit";
  EXPECT_EQ(bar->value(), 0) << "who begins reads from the top";
  for (const QString& name : {QStringLiteral("Hint"), QStringLiteral("Check")}) {
    click(name);
    EXPECT_EQ(bar->value(), bar->maximum()) << name.toStdString();
  }
  Q_EMIT learning()->work()->checked({{tour().steps[5].task->conditions.front(), 0.0, 1.0, true}});
  settle();
  EXPECT_TRUE(says(QStringLiteral("Solved.")));
  EXPECT_EQ(bar->value(), bar->maximum());
  EXPECT_TRUE(text->document()->lastBlock().text().startsWith(QStringLiteral("Try it:")));
  click(QStringLiteral("Next"));
  EXPECT_EQ(learning()->step(), 6);
  EXPECT_EQ(bar->value(), 0);
}

// The size may change before it is said that another text is read from its top.
TEST(LessonTextTest, AnotherTextIsReadFromItsTop) {
  LessonText text;
  text.resize(300, 60);
  text.show();
  const auto paragraphs = [](const QString& word) {
    return QString(word + QStringLiteral("\n\n")).repeated(30);
  };
  text.setText(paragraphs(QStringLiteral("one")));
  text.setKeepsEnd(true);
  ASSERT_GT(text.verticalScrollBar()->value(), 0);
  text.setText(paragraphs(QStringLiteral("two")));
  text.resize(300, 80);
  EXPECT_EQ(text.verticalScrollBar()->value(), 0);
}

TEST_F(LearnTest, WhatATaskIsCheckedByIsRightBelowItsText) {
  session.probes().removeAll();
  learning()->openStep(QStringLiteral("jitter"), 5);
  settle();
  const auto* text = panel()->findChild<LessonText*>();
  const auto button = [&](const QString& name) -> const QPushButton* {
    for (const QPushButton* each : panel()->findChildren<QPushButton*>())
      if (each->text() == name && each->isVisible()) return each;
    return nullptr;
  };
  ASSERT_TRUE(button(QStringLiteral("Check")) && button(QStringLiteral("Hint")));
  ASSERT_GT(panel()->height(), 2 * text->sizeHint().height()) << "there is room for more";
  EXPECT_EQ(text->verticalScrollBar()->maximum(), 0) << "it is read as a whole";
  EXPECT_TRUE(waitFor([&] { return button(QStringLiteral("Check"))->y() - text->geometry().bottom() < 16; }));
  const QPoint place = button(QStringLiteral("Hint"))->pos();
  click(QStringLiteral("Hint"));
  EXPECT_EQ(button(QStringLiteral("Hint"))->pos(), place) << "it is pressed again without looking for it";
}

TEST_F(LearnTest, WhoClicksOnFindsNextWhereItWas) {
  key(Qt::Key_F12);
  settle();
  const QWidget* next = nullptr;
  for (const QPushButton* button : panel()->findChildren<QPushButton*>())
    if (button->text() == QStringLiteral("Next")) next = button;
  ASSERT_TRUE(next);
  const QPoint place = next->mapTo(&window, QPoint());
  for (int step = 1; step < 4; ++step) {
    click(QStringLiteral("Next"));
    EXPECT_EQ(next->mapTo(&window, QPoint()), place) << "in step " << step + 1;
  }
  EXPECT_EQ(learning()->step(), 3);
}

TEST_F(LearnTest, AnotherLessonIsChosenWithTheMouse) {
  key(Qt::Key_F12);
  auto* const lessons = panel()->head()->findChild<ChoiceButton*>();
  ASSERT_TRUE(lessons && lessons->isVisible());
  QTest::mouseClick(lessons, Qt::LeftButton);
  auto* const menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_TRUE(menu);
  ASSERT_EQ(menu->actions().size(), static_cast<qsizetype>(taa::builtinLessons().size()));
  QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(menu->actions()[2]).center());
  settle();
  EXPECT_EQ(learning()->lesson(), 2);
  EXPECT_EQ(learning()->step(), 0);
}

TEST_F(LearnTest, AFaultThatATaskAsksForIsNotNamed) {
  const auto* line = window.findChild<StatusLine*>();
  const auto hunt = std::ranges::find(taa::builtinLessons(), "bughunt", &taa::Lesson::id);
  ASSERT_NE(hunt, taa::builtinLessons().end());
  for (std::size_t step = 0; step < hunt->steps.size(); ++step) {
    const taa::LessonState& state = hunt->steps[step].state;
    if (!taa::isFaulty(state.shot.settings.settings)) continue;
    ASSERT_TRUE(hunt->steps[step].task) << step;
    learning()->openStep(QStringLiteral("bughunt"), static_cast<int>(step) + 1);
    const auto badgeHas = [&](const char* words) {
      return waitFor([&] { return line->badge().contains(QLatin1String(words)); }, 2000);
    };
    EXPECT_TRUE(badgeHas("fault injected: find it")) << line->badge().toStdString();
    EXPECT_FALSE(line->badge().contains(QLatin1String("fault.")));
    session.probes().setPixel(glm::ivec2(20, 10));
    settle();
    for (const QLabel* label : window.probe()->findChildren<QLabel*>())
      EXPECT_FALSE(label->text().contains(QLatin1String("fault."))) << label->text().toStdString();
    for (const QAction* action : window.findChild<FaultsMenu*>()->findChildren<QAction*>())
      EXPECT_FALSE(action->isChecked()) << action->text().toStdString();
  }
  // Where it is the lesson that names it, the line names it, too.
  learning()->openStep(QStringLiteral("reprojection"), 6);
  EXPECT_TRUE(waitFor([&] { return line->badge().contains(QLatin1String("fault.motionJitter")); }, 2000));
}

TEST_F(LearnTest, SaysWhatATaskLacksAndThatItIsSolved) {
  key(Qt::Key_F12);
  press(QStringLiteral("Next"));
  taa::CheckedCondition checked{tour().steps[1].task->conditions.front(), 0.0, 1.0, false};
  Q_EMIT learning()->work()->checked({checked});
  EXPECT_TRUE(says(QStringLiteral("Not yet. Verdict \"Ghost\" at the probe: no, asked for: yes.")));
  checked.condition = taa::conditionFrom("metric rejected < 2");
  checked.left = 3.25;
  checked.right = 2.0;
  Q_EMIT learning()->work()->checked({checked});
  EXPECT_TRUE(says(QStringLiteral("Not yet. Rejected, %: 3.25, asked for: less than 2.")));
  checked.holds = true;
  Q_EMIT learning()->work()->checked({checked});
  EXPECT_TRUE(says(QStringLiteral("Solved.")));
}

TEST_F(LearnTest, TellsTheNumbersOfAStepAndWhatTheyAreComparedWith) {
  const auto vanished = std::ranges::find(tour().steps, "See it vanish", &taa::LessonStep::title);
  ASSERT_NE(vanished, tour().steps.end());
  ASSERT_EQ(vanished->state.lanes.size(), 1u);
  key(Qt::Key_F12);
  learning()->openStep(QStringLiteral("first-ghost"), static_cast<int>(vanished - tour().steps.begin()) + 1);
  Q_EMIT learning()->work()->measured({{"Ghost energy", {0.0123456, 0.25}}, {"PSNR, dB", {31.5, NAN}}});
  const auto text = [&] { return panel()->findChild<LessonText*>()->toPlainText(); };
  for (const char* line :
       {"Ghost energy\n0.01235\n0.25\n", "PSNR, dB\n31.5\n–\n", "before: Rectify history ▸ Method: None"})
    EXPECT_TRUE(text().contains(QString::fromUtf8(line))) << text().toStdString();
  press(QStringLiteral("Next"));
  EXPECT_FALSE(text().contains(QStringLiteral("PSNR"))) << "they are of another step";
}

// Others of its numbers could tell what it asks for: the bug of a bug hunt, say.
TEST_F(LearnTest, AStepWithATaskTellsNoNumbersButThoseOfItsCheck) {
  const auto hasMeasure = [&] {
    return std::ranges::any_of(panel()->findChildren<QPushButton*>(), [](const QPushButton* button) {
      return button->text() == QStringLiteral("Measure") && button->isVisible();
    });
  };
  const taa::Lesson& hunt = taa::builtinLessons().back();
  ASSERT_EQ(hunt.id, "bughunt");
  for (std::size_t step = 0; step < hunt.steps.size(); ++step) {
    learning()->openStep(QStringLiteral("bughunt"), static_cast<int>(step) + 1);
    const bool hasNumbers = !taa::measuredQuantities(hunt.steps[step].claims).empty();
    EXPECT_EQ(hasMeasure(), hasNumbers && !hunt.steps[step].task) << step + 1;
  }
}

TEST_F(LearnTest, ASceneThatStillLoadsLeavesTheProbesOfTheStepAlone) {
  renderer->holdsBack = true;
  session.open(QStringLiteral("builtin:fence"));
  const taa::Status late = renderer->status; // smaller than the pictures of lessons
  key(Qt::Key_F12);
  press(QStringLiteral("Next"));
  press(QStringLiteral("Next"));
  const taa::Status asked = renderer->status;
  renderer->holdsBack = false;
  for (const taa::Status& arriving : {late, asked}) {
    renderer->status = arriving;
    renderer->deliver();
    settle();
  }
  EXPECT_EQ(session.status().source, tour().steps[2].state.shot.source);
  ASSERT_TRUE(session.probes().pixel());
  EXPECT_EQ(*session.probes().pixel(), tour().steps[2].state.probes.front());
}

TEST_F(LearnTest, FramesThatAStepRecordsAreOpenedWhenTheyAreThere) {
  key(Qt::Key_F12);
  taa::LessonState state = tour().steps.front().state;
  state.shot.source = kFakeCapture;
  Q_EMIT learning()->work()->recorded(state);
  EXPECT_TRUE(waitFor([&] { return session.status().source == kFakeCapture; }));
}

// The bar at its side takes no room from lines that were broken without it.
TEST(LessonTextTest, IsNeverWiderThanItsPlace) {
  LessonText text;
  QFont large = text.font();
  large.setPointSizeF(20.0);
  text.setFont(large);
  text.show();
  for (const taa::Lesson& lesson : taa::builtinLessons())
    for (const taa::LessonStep& step : lesson.steps)
      for (const int height : {120, 400}) {
        if (!step.ladder.empty()) continue; // a table is as wide as its words
        text.resize(430, height);
        text.setText(QString::fromStdString(step.text));
        EXPECT_EQ(text.horizontalScrollBar()->maximum(), 0) << lesson.id << ", " << step.title;
      }
}

// Only who goes on from a step has read it; who opens another lesson in its middle has not.
TEST(LearnProgress, IsOfStepsThatWereLeftForward) {
  QTemporaryDir folder;
  QSettings settings(folder.filePath(QStringLiteral("taa.ini")), QSettings::IniFormat);
  Session session([](taa::Listener listener) { return std::make_unique<FakeRenderer>(std::move(listener)); });
  TestWindow window(session, &settings);
  auto* const learning = window.findChild<Learning*>();
  const auto doneOf = [&](const taa::Lesson& lesson) {
    settings.beginGroup(QStringLiteral("lessons/done/") + QString::fromStdString(lesson.id));
    const QStringList steps = settings.childKeys();
    settings.endGroup();
    return steps;
  };
  const taa::Lesson* other = nullptr;
  for (const taa::Lesson& lesson : taa::builtinLessons())
    if (&lesson != &tour() && lesson.steps.size() >= 4 && !lesson.steps[0].task && !lesson.steps[1].task)
      other = &lesson;
  ASSERT_TRUE(other);
  learning->openTour();
  learning->openStep(QString::fromStdString(other->id), 4);
  EXPECT_EQ(learning->step(), 3);
  EXPECT_TRUE(doneOf(*other).isEmpty()) << doneOf(*other).join(QLatin1Char(' ')).toStdString();
  learning->openStep(QString::fromStdString(other->id), 1);
  learning->stepBy(1);
  EXPECT_EQ(doneOf(*other), QStringList{QStringLiteral("0")});
  EXPECT_TRUE(doneOf(tour()).isEmpty());
}
