// Every row of the parameter table has a control that sends settings; every intermediate can be reached.
#include "app/panels/PipelinePanel.h"
#include "app/views/ViewArea.h"
#include "app/widgets/IntermediateRow.h"
#include "app/widgets/SearchField.h"
#include "app/widgets/SectionHeader.h"
#include "app/widgets/parameters/ChoiceButton.h"
#include "app/widgets/parameters/ChoiceWords.h"
#include "app/widgets/parameters/NumberField.h"
#include "app/widgets/parameters/ParameterLabel.h"
#include "app/widgets/parameters/ParameterRow.h"
#include "app/widgets/parameters/SegmentedButtons.h"
#include "app/widgets/parameters/Toggle.h"
#include "core/settings/Presets.h"
#include "tests/app/WindowFixture.h"

#include <QLineEdit>
#include <QMenu>

#include <algorithm>
#include <string_view>
#include <vector>

using namespace taa;
using namespace taa::app;
using ParameterPanel = test::FakeWindow;
using IntermediateList = test::FakeWindow;

namespace {

/// Changes the value of a row with real events.
void change(ParameterRow& row) {
  QWidget* editor = row.editor();
  if (auto* buttons = qobject_cast<SegmentedButtons*>(editor)) {
    const int wanted = buttons->current() == 0 ? 1 : 0;
    QTest::mouseClick(buttons, Qt::LeftButton, {}, buttons->segment(wanted).center());
  } else if (qobject_cast<Toggle*>(editor)) {
    QTest::mouseClick(editor, Qt::LeftButton);
  } else if (auto* choices = qobject_cast<ChoiceButton*>(editor)) {
    QTest::keyClick(choices, choices->current() == 0 ? Qt::Key_Down : Qt::Key_Up);
  } else {
    const double middle = (row.row().minimum + row.row().maximum) / 2;
    QTest::mouseClick(editor, Qt::LeftButton);
    auto* line = editor->findChild<QLineEdit*>();
    ASSERT_TRUE(line);
    line->clear();
    QTest::keyClicks(line, QString::number(middle == row.value() ? row.row().maximum : middle));
    QTest::keyClick(line, Qt::Key_Return);
  }
}

ParameterRow* rowOf(PipelinePanel* panel, const QString& path) {
  for (ParameterRow* row : panel->parameterRows())
    if (row->path() == path) return row;
  return nullptr;
}

} // namespace

TEST_F(ParameterPanel, HasOneControlForEveryRowOfTheTable) {
  std::vector<std::string_view> paths;
  for (const ParameterRow* row : window.pipeline()->parameterRows()) {
    ASSERT_TRUE(row->editor()) << row->path().toStdString();
    paths.push_back(row->row().path);
  }
  ASSERT_EQ(paths.size(), parameters().size());
  for (const Parameter& row : parameters()) EXPECT_EQ(std::ranges::count(paths, row.path), 1) << row.path;
}

TEST_F(ParameterPanel, EditingAnyControlSendsExactlyThatSetting) {
  window.pipeline()->setAllExpanded(true);
  for (ParameterRow* row : window.pipeline()->parameterRows()) {
    const Settings before = session.presets().settings();
    const auto sent = renderer->all<request::SetSettings>().size();
    change(*row);
    EXPECT_EQ(renderer->all<request::SetSettings>().size(), sent + 1) << row->path().toStdString();
    for (const Parameter& parameter : parameters()) {
      const bool isEdited = parameter.path == row->row().path;
      EXPECT_EQ(parameter.get(renderer->status.settings) != parameter.get(before), isEdited)
          << parameter.path << " after an edit of " << row->path().toStdString();
    }
  }
}

TEST_F(ParameterPanel, AChangedRowHasADotAndADoubleClickOnItsLabelResetsIt) {
  window.pipeline()->setAllExpanded(true);
  ParameterRow* row = rowOf(window.pipeline(), "neighborhood.gamma");
  EXPECT_FALSE(row->isChanged());
  change(*row);
  EXPECT_TRUE(row->isChanged());
  EXPECT_TRUE(session.presets().isPresetChanged());
  QTest::mouseDClick(row->findChild<ParameterLabel*>(), Qt::LeftButton);
  EXPECT_FALSE(row->isChanged());
  EXPECT_FALSE(session.presets().isPresetChanged());
  EXPECT_EQ(row->value(), 1.0);
}

TEST_F(ParameterPanel, RowsWithoutEffectAreDimmed) {
  EXPECT_TRUE(rowOf(window.pipeline(), "weight.alpha")->isDimmed());
  session.presets().setParameter("weight.source", 0);
  EXPECT_FALSE(rowOf(window.pipeline(), "weight.alpha")->isDimmed());
  EXPECT_TRUE(rowOf(window.pipeline(), "weight.sourceMax")->isDimmed());
}

TEST_F(ParameterPanel, ToolTipsTellSentenceFormulaSourceRangeAndDefault) {
  const Parameter& gamma = parameter("neighborhood.gamma");
  const QString tip = parameterToolTip(gamma);
  for (const std::string_view part : {gamma.tooltip, gamma.formula, gamma.source}) {
    const QString text = QString::fromUtf8(part.data(), static_cast<qsizetype>(part.size()));
    EXPECT_TRUE(tip.contains(withoutManual(text).toHtmlEscaped())) << part;
  }
  EXPECT_FALSE(tip.contains("manual")) << tip.toStdString();
  EXPECT_TRUE(tip.contains("range 0 to 4")) << tip.toStdString();
  EXPECT_TRUE(tip.contains("default 1")) << tip.toStdString();
}

TEST(ChoiceWords, LeaveOutTheRowsOfTheManualAndKeepOtherSources) {
  EXPECT_EQ(withoutManual("Nearest point of the box (manual 11.1)."), "Nearest point of the box.");
  EXPECT_EQ(withoutManual("Cut off there (manual 9.6, 15.5, Donut)."), "Cut off there (Donut).");
  EXPECT_EQ(withoutManual("Never brighter than white (manual §26, D7)."), "Never brighter than white.");
  EXPECT_EQ(withoutManual("Motion in the wrong unit (D5, D6), mended."), "Motion in the wrong unit, mended.");
  EXPECT_EQ(withoutManual("manual 13.1, Yang et al. 2020"), "Yang et al. 2020");
  EXPECT_EQ(withoutManual("Lightens; 3D and so on."), "Lightens; 3D and so on.");
  EXPECT_EQ(briefly("Clip towards the middle (manual 11.2, Playdead)."), "Clip towards the middle");
  for (const Parameter& row : parameters())
    for (const Choice& choice : row.choices) {
      const QString text =
          QString::fromUtf8(choice.explanation.data(), static_cast<qsizetype>(choice.explanation.size()));
      EXPECT_FALSE(withoutManual(text).contains("manual")) << choice.explanation;
      EXPECT_FALSE(withoutManual(text).contains("()")) << choice.explanation;
      EXPECT_LE(briefly(text).size(), 76) << choice.explanation;
      EXPECT_FALSE(briefly(text).isEmpty()) << choice.explanation;
    }
}

TEST_F(ParameterPanel, ALongListOfChoicesSaysWhatEachIsAndHasThoseWithADefectInAGroup) {
  window.pipeline()->setAllExpanded(true);
  ParameterRow* row = rowOf(window.pipeline(), "space.color");
  auto* button = qobject_cast<ChoiceButton*>(row->editor());
  ASSERT_TRUE(button);
  button->click();
  auto* menu = button->findChild<QMenu*>(QString(), Qt::FindDirectChildrenOnly);
  ASSERT_TRUE(menu);
  QStringList texts;
  for (const QAction* action : menu->actions()) texts << action->text();
  EXPECT_TRUE(texts[0].startsWith("RGB\tBox in red, green, blue")) << texts[0].toStdString();
  EXPECT_EQ(texts.last().toStdString(), "As shipped, with the defect");
  QMenu* shipped = menu->actions().last()->menu();
  ASSERT_TRUE(shipped);
  ASSERT_EQ(shipped->actions().size(), 1);
  shipped->actions()[0]->trigger();
  settle();
  EXPECT_EQ(renderer->status.settings.space.color, ColorSpace::YCoCgAsPrinted);
  menu->close();
}

TEST_F(ParameterPanel, NumbersAreDraggedSteppedAndScrolled) {
  window.pipeline()->setAllExpanded(true);
  auto* field = qobject_cast<NumberField*>(rowOf(window.pipeline(), "neighborhood.gamma")->editor());
  QTest::mousePress(field, Qt::LeftButton, {}, {20, 10});
  QTest::mouseMove(field, {45, 10});
  QTest::mouseRelease(field, Qt::LeftButton, {}, {45, 10});
  EXPECT_NEAR(session.presets().settings().neighborhood.gamma, 1.4f,
              0.021f); // 25 px of 250 across 0…4, one step of rounding
  const float dragged = session.presets().settings().neighborhood.gamma;
  field->setFocus();
  QTest::keyClick(field, Qt::Key_Up);
  EXPECT_GT(session.presets().settings().neighborhood.gamma, dragged);
  session.undo();
  EXPECT_EQ(session.presets().settings().neighborhood.gamma, dragged) << "a step of the keys after the drag";
  session.undo();
  EXPECT_EQ(session.presets().settings().neighborhood.gamma, 1.0f) << "a drag is one change";
}

TEST_F(ParameterPanel, PresetsReplaceAllSettings) {
  session.presets().setPreset("minimal");
  settle();
  EXPECT_EQ(renderer->status.settings.rectify.method, RectifyMethod::Clamp);
  EXPECT_TRUE(window.windowTitle().contains("minimal")) << window.windowTitle().toStdString();
  EXPECT_FALSE(window.windowTitle().contains('*'));
  session.presets().setParameter("rectify.method", 0);
  EXPECT_TRUE(window.windowTitle().contains("minimal*"));
}

TEST_F(ParameterPanel, SearchFindsSettingsInFoldedStages) {
  window.pipeline()->setAllExpanded(false);
  ParameterRow* row = rowOf(window.pipeline(), "jitter.period");
  EXPECT_FALSE(row->isVisible());
  QTest::keyClicks(window.pipeline()->searchField(), "period");
  EXPECT_TRUE(row->isVisible());
  EXPECT_FALSE(rowOf(window.pipeline(), "rectify.method")->isVisible());
}

TEST_F(IntermediateList, EveryRowIsReachedByAClick) {
  window.pipeline()->setAllExpanded(true);
  ASSERT_EQ(window.pipeline()->intermediateRows().size(), kIntermediateCount);
  for (IntermediateRow* row : window.pipeline()->intermediateRows()) {
    QTest::mouseClick(row, Qt::LeftButton);
    EXPECT_EQ(window.views()->view(0)->id(), row->id());
    EXPECT_TRUE(row->shownIn().contains('A'));
    EXPECT_EQ(renderer->last<request::SetViews>().views.at(0).id, row->id());
  }
}

TEST_F(IntermediateList, AControlClickShowsItInTheOtherView) {
  window.pipeline()->setAllExpanded(true);
  IntermediateRow* row = window.pipeline()->intermediateRows().front();
  QTest::mouseClick(row, Qt::LeftButton, Qt::ControlModifier);
  EXPECT_EQ(window.views()->view(0)->id(), IntermediateId::resolved);
  EXPECT_EQ(window.views()->view(1)->id(), row->id());
  EXPECT_EQ(row->shownIn(), "B");
}

TEST_F(ParameterPanel, PreparesAChoiceTheMouseStaysOn) {
  window.resize(1280, 1600);
  auto* buttons =
      qobject_cast<SegmentedButtons*>(rowOf(window.pipeline(), QStringLiteral("neighborhood.box"))->editor());
  ASSERT_TRUE(buttons);
  const int other = buttons->current() == 0 ? 1 : 0;
  Settings expected = session.presets().settings();
  parameter("neighborhood.box").set(expected, other);
  QTest::mouseMove(buttons, buttons->segment(other).center());
  ASSERT_TRUE(test::waitFor([&] { return !renderer->all<request::Prepare>().empty(); }));
  EXPECT_EQ(renderer->last<request::Prepare>().settings, expected);
  EXPECT_TRUE(renderer->all<request::SetSettings>().empty());
}

TEST_F(ParameterPanel, PreparesAChoiceOfAMenuAndAPreset) {
  auto* presets = window.pipeline()->findChild<ChoiceButton*>(QStringLiteral("presets"));
  ASSERT_TRUE(presets);
  QTest::mouseClick(presets, Qt::LeftButton);
  auto* menu = presets->findChild<QMenu*>();
  ASSERT_TRUE(menu);
  const int other = presets->current() == 1 ? 2 : 1;
  QList<QAction*> choices;
  for (QAction* action : menu->actions())
    if (!action->isSeparator()) choices << action;
  menu->setActiveAction(choices[other]);
  ASSERT_TRUE(test::waitFor([&] { return !renderer->all<request::Prepare>().empty(); }));
  EXPECT_EQ(renderer->last<request::Prepare>().settings,
            builtinPresets()[static_cast<std::size_t>(other)].settings);
  menu->close();
}

TEST_F(ParameterPanel, HeadingsSayWhatStagesDidToTheFrame) {
  const auto note = [&](const char* stage) {
    return window.pipeline()->findChild<SectionHeader*>(QStringLiteral("stage.") + stage)->note();
  };
  session.seek(7);
  settle();
  EXPECT_EQ(note("dilate_motion"), "changed nothing");
  EXPECT_EQ(note("validate_history"), "7.0 % rejected");
  EXPECT_EQ(note("blend"), "") << "nothing can be said of it";
  session.seek(0);
  settle();
  EXPECT_EQ(note("validate_history"), "no history yet");
  session.post(request::SetPlaying{true});
  settle();
  EXPECT_EQ(note("validate_history"), "") << "it was true of another frame";
}

TEST_F(ParameterPanel, HeadingsSayTheFirstChoiceThatHasAnEffect) {
  const auto summary = [&](const char* stage) {
    return window.pipeline()->findChild<SectionHeader*>(QStringLiteral("stage.") + stage)->summary();
  };
  session.presets().setPreset("hdrp-high");
  settle();
  EXPECT_EQ(summary("filter_current"), "Gaussian");
  session.presets().setPreset("hdrp-taau"); // drawn smaller: the filter has no say
  settle();
  EXPECT_EQ(summary("filter_current"), "HDRP");
}
