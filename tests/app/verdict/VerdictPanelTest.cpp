// The verdict in the probe's panel: its sentence, what decided, what corrects the pixel.
#include "app/models/verdict/VerdictWords.h"
#include "app/panels/ProbePanel.h"
#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/ViewArea.h"
#include "app/widgets/SectionHeader.h"
#include "app/widgets/Swatches.h"
#include "app/widgets/areas/FittingArea.h"
#include "app/widgets/areas/YieldingColumn.h"
#include "app/widgets/probe/ErrorBars.h"
#include "app/widgets/probe/EvidenceRow.h"
#include "app/widgets/probe/RemedyButton.h"
#include "app/widgets/probe/VerdictDetails.h"
#include "app/widgets/probe/VerdictLine.h"
#include "core/verdict/pixel/BlindAgreement.h"
#include "tests/app/WindowFixture.h"
#include "tests/app/verdict/FakeVerdict.h"

#include <QApplication>
#include <QClipboard>
#include <QJsonObject>
#include <QLabel>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

class VerdictPanel : public taa::app::test::FakeWindow {
 protected:
  VerdictLine* line() const { return window.probe()->verdict(); }
  VerdictDetails* details() const { return window.probe()->verdictDetails(); }
  const Settings& settings() const { return session.presets().settings(); }
  void probe() {
    session.probes().setPixel(glm::ivec2(12, 7));
    settle();
  }
  std::ptrdiff_t shownRemedies() const {
    return std::ranges::count_if(details()->remedies(),
                                 [](const QWidget* each) { return each->isVisible(); });
  }
  void click(QWidget* widget) {
    QTest::mouseClick(widget, Qt::LeftButton);
    settle();
  }
};

/// What the tables call a change.
QString inWords(const char* path, const QString& value) {
  const Parameter& row = parameter(path);
  return qtext(stageInfo(row.stage).label) + QStringLiteral(" ▸ ") + qtext(row.label) + QStringLiteral(": ") +
         value;
}

} // namespace

TEST_F(VerdictPanel, StandsAboveTheNumbers) {
  probe();
  ASSERT_TRUE(line()->isVisible());
  EXPECT_EQ(line()->sentence().toStdString(), renderer->verdict.answer->sentence);
  EXPECT_EQ(line()->tone(), VerdictTone::Wrong);
  EXPECT_EQ(line()->work(), "");
  const auto top = [](const QWidget* widget) { return widget->mapToGlobal(QPoint()).y(); };
  EXPECT_LT(top(line()), top(details()));
  EXPECT_LT(top(details()), top(window.probe()->table()));
}

TEST(YieldingColumn, FirstTheRemarkGivesWayThenTheTableThenWhatIsSaid) {
  const ColumnHeights least{60, 60, 20}, wanted{300, 500, 100};
  const auto shared = [&](int room) {
    const auto wholePart = [](int most) { return most >= 200 ? 200 : most; }; // the last part is 100 high
    return sharedHeights(room, least, wanted, 120, wholePart);
  };
  EXPECT_EQ(shared(1000), (ColumnHeights{300, 600, 100}));
  EXPECT_EQ(shared(520), (ColumnHeights{300, 200, 20}));
  EXPECT_EQ(shared(450), (ColumnHeights{300, 130, 20}));
  EXPECT_EQ(shared(430), (ColumnHeights{200, 210, 20})) << "the last part would be cut";
  EXPECT_EQ(shared(300), (ColumnHeights{160, 120, 20}));
  EXPECT_EQ(shared(160), (ColumnHeights{60, 80, 20}));
}

TEST_F(VerdictPanel, ColorsBelowItAreWholeOrOutOfSight) {
  probe();
  const auto swatches = window.probe()->findChildren<Swatches*>();
  ASSERT_EQ(swatches.size(), 3);
  for (int height = 1000; height >= 600; height -= 20) {
    window.resize(1280, height);
    settle();
    for (const Swatches* each : swatches) {
      const int seen = each->visibleRegion().boundingRect().height();
      EXPECT_TRUE(seen == each->height() || (seen == 0 && height < 860)) << seen << " px at " << height;
    }
  }
}

// They scroll with the sentence above them, in one area: its end cuts none of them.
TEST_F(VerdictPanel, RemediesBelowItAreWholeOrOutOfSight) {
  renderer->verdict.remedies->best.assign(kMaxRemedies,
                                          taa::app::test::fakeRemedy({"rectify.method=clamp"}, 10.0));
  probe();
  window.resize(1280, 800);
  settle();
  ASSERT_EQ(shownRemedies(), 3);
  EXPECT_EQ(details()->header()->visibleRegion().boundingRect().height(), details()->header()->height())
      << "what decided can be unfolded";
  for (int height = 1000; height >= 600; height -= 20) {
    window.resize(1280, height);
    settle();
    for (const QWidget* each : details()->remedies()) {
      const int seen = each->visibleRegion().boundingRect().height();
      EXPECT_TRUE(seen == each->height() || (seen == 0 && height < 780)) << seen << " px at " << height;
    }
  }
}

// What is said of the pixel is cut between its lines, not before all of them.
TEST_F(VerdictPanel, SaysWhatFitsOfAPixelBelowAnOpenPage) {
  probe();
  window.resize(1280, 800);
  key(Qt::Key_F6);
  const auto labels = window.probe()->findChildren<QLabel*>();
  const auto summary = std::ranges::find_if(
      labels, [&](const QLabel* each) { return each->text() == window.probe()->summary(); });
  ASSERT_NE(summary, labels.end());
  const int whole = (*summary)->height() - (*summary)->contentsMargins().bottom();
  const int lines = whole / (*summary)->fontMetrics().lineSpacing();
  const int seen = (*summary)->visibleRegion().boundingRect().height();
  EXPECT_TRUE(seen >= whole || (seen > 0 && seen * lines % whole == 0)) << seen << " of " << whole << " px";
}

TEST_F(VerdictPanel, LeavesNoRoomToARowThatIsNotSelected) {
  probe();
  window.resize(1280, 1300);
  settle();
  QTreeView* table = window.probe()->table();
  const int high = table->height();
  const QModelIndex row = table->model()->index(0, 0, table->model()->index(0, 0));
  table->scrollTo(row);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(row).center());
  settle();
  EXPECT_LT(table->height(), high - 3 * rowHeight()) << "what is said of the row has its lines";
}

TEST_F(VerdictPanel, SaysThatAReasonIsLookedForUntilThereIsOne) {
  const VerdictDelivery found = std::exchange(renderer->verdict, {});
  probe();
  EXPECT_TRUE(line()->isVisible());
  EXPECT_EQ(line()->sentence(), "");
  EXPECT_EQ(line()->work(), "Looking for the reason…");
  EXPECT_FALSE(details()->header()->isVisible());
  renderer->verdict = found;
  renderer->verdict.remedies.reset();
  renderer->deliver();
  settle();
  EXPECT_EQ(line()->sentence().toStdString(), found.answer->sentence);
  EXPECT_EQ(line()->work(), "Looking for what mends it…") << "the sentence does not wait for it";
  EXPECT_EQ(shownRemedies(), 0);
  renderer->verdict = found;
  renderer->deliver();
  settle();
  EXPECT_EQ(line()->work(), "");
  EXPECT_EQ(shownRemedies(), 2);
}

TEST_F(VerdictPanel, SaysThatNothingIsWrong) {
  renderer->verdict.answer->verdict.kind = VerdictKind::None;
  renderer->verdict.answer->sentence = "Nothing is wrong: it is near the reference.";
  renderer->verdict.remedies.reset();
  probe();
  EXPECT_EQ(line()->tone(), VerdictTone::Right);
  EXPECT_EQ(line()->sentence(), "Nothing is wrong: it is near the reference.");
  EXPECT_EQ(line()->work(), "");
  EXPECT_EQ(shownRemedies(), 0);
}

TEST_F(VerdictPanel, SaysWhyThereIsNone) {
  renderer->verdict = {};
  renderer->verdict.whyNot = "this capture has no reference";
  probe();
  EXPECT_EQ(line()->sentence(), "No verdict: this capture has no reference");
  EXPECT_EQ(line()->tone(), VerdictTone::Neutral);
  EXPECT_EQ(line()->work(), "");
  EXPECT_FALSE(details()->isVisible());
}

TEST_F(VerdictPanel, IsOfThePixelAndTheFrameOnShowOnly) {
  probe();
  const auto told = [&](int frame, glm::ivec2 pixel, std::uint64_t shotVersion) {
    VerdictDelivery delivery = renderer->verdict;
    delivery.frame = frame;
    delivery.pixel = pixel;
    delivery.shotVersion = shotVersion;
    renderer->tell(delivery);
    settle();
    return !line()->sentence().isEmpty();
  };
  const std::uint64_t version = renderer->status.shotVersion;
  const int frame = renderer->status.info.frame;
  EXPECT_TRUE(told(frame, {12, 7}, version));
  EXPECT_FALSE(told(frame + 1, {12, 7}, version));
  EXPECT_FALSE(told(frame, {13, 7}, version));
  EXPECT_FALSE(told(frame, {12, 7}, version - 1)) << "by other settings";
  EXPECT_TRUE(told(frame, {12, 7}, version));
}

TEST_F(VerdictPanel, IsNotShownOnceTheSettingsAreOthers) {
  probe();
  ASSERT_NE(line()->sentence(), "");
  renderer->holdsBack = true;
  session.presets().assign({"rectify.method=clamp"});
  settle();
  EXPECT_EQ(line()->sentence(), "");
  EXPECT_TRUE(session.verdicts().remedies().empty());
  renderer->holdsBack = false;
  renderer->deliver();
  settle();
  EXPECT_NE(line()->sentence(), "");
}

TEST_F(VerdictPanel, NamesRemediesAsTheTablesDo) {
  probe();
  ASSERT_EQ(shownRemedies(), 2);
  const auto clamp = static_cast<std::size_t>(RectifyMethod::Clamp);
  const QString method = inWords("rectify.method", qtext(parameter("rectify.method").choices[clamp].label));
  const RemedyButton* first = details()->remedies()[0];
  EXPECT_EQ(first->text(), inWords("validate.object", QStringLiteral("on")) + QLatin1Char('\n') + method);
  EXPECT_EQ(details()->remedies()[1]->text(), method);
  EXPECT_EQ(first->effects(),
            "This pixel, last 4 frames: off by 40 → 5 of 255\n"
            "Picture: error 4 → 3, ghost 2 → 0.5, flicker 1 → 1.5 (worse), sharpness 90 % → 95 %");
}

// The setting that the verdict names is told in more lines, and the picture's come later.
TEST_F(VerdictPanel, GivesEachRemedyTheHeightOfItsLines) {
  const taa::VerdictDelivery measured = renderer->verdict;
  taa::TriedRemedy named = taa::app::test::fakeRemedy({"validate.class=on"}, 200.0);
  named.isNamed = true;
  renderer->verdict.remedies->best = {taa::app::test::fakeRemedy({"rectify.method=clamp"}, 10.0),
                                      taa::app::test::fakeRemedy({"rectify.method=clipToFiltered"}, 10.0),
                                      named};
  const taa::RemedyAnswer whole = *renderer->verdict.remedies;
  for (taa::TriedRemedy& each : renderer->verdict.remedies->best) each.picture.reset();
  renderer->verdict.remedies->picture.reset();
  window.resize(1280, 1000);
  probe();
  ASSERT_EQ(shownRemedies(), 3);
  renderer->verdict.remedies = whole;
  renderer->deliver();
  settle();
  for (const RemedyButton* each : details()->remedies())
    EXPECT_EQ(each->height(), each->layout()->heightForWidth(each->width())) << each->effects().toStdString();
}

TEST_F(VerdictPanel, ShowsRemediesBeforeWhatTheyCost) {
  const VerdictDelivery measured = renderer->verdict;
  renderer->verdict.remedies->picture.reset();
  probe();
  ASSERT_EQ(shownRemedies(), 2);
  const RemedyButton* first = details()->remedies()[0];
  EXPECT_EQ(first->effects(), "This pixel, last 4 frames: off by 40 → 5 of 255\nPicture: being measured");
  EXPECT_FALSE(session.verdicts().isComplete());
  renderer->verdict = measured;
  renderer->deliver();
  settle();
  EXPECT_TRUE(first->effects().contains(QStringLiteral("Picture: error 4 → 3")));
  EXPECT_TRUE(session.verdicts().isComplete());
}

TEST_F(VerdictPanel, ARemedyIsOneStepOfUndo) {
  probe();
  const Settings before = settings();
  Settings expected = before;
  for (const char* change : {"validate.object=on", "rectify.method=clamp"}) applyAssignment(expected, change);
  ASSERT_FALSE(before == expected);
  const auto sent = renderer->all<request::SetSettings>().size();
  click(details()->remedies()[0]);
  EXPECT_TRUE(settings() == expected);
  EXPECT_TRUE(renderer->status.settings == expected);
  EXPECT_EQ(renderer->all<request::SetSettings>().size(), sent + 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(settings() == before);
}

TEST_F(VerdictPanel, AKeyTriesTheFirstRemedyAndButtonsTakeTheFocus) {
  probe();
  const Settings before = settings();
  key(Qt::Key_T, Qt::ControlModifier);
  EXPECT_TRUE(isOn(settings().validate.object));
  EXPECT_EQ(settings().rectify.method, RectifyMethod::Clamp);
  session.undo();
  settle();
  ASSERT_TRUE(settings() == before);
  RemedyButton* second = details()->remedies()[1];
  second->setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(second->hasFocus());
  QTest::keyClick(second, Qt::Key_Return);
  settle();
  Settings expected = before;
  applyAssignment(expected, "rectify.method=clamp");
  EXPECT_TRUE(settings() == expected);
}

TEST_F(VerdictPanel, EachRemedyHasAKey) {
  probe();
  const Settings before = settings();
  key(Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
  Settings expected = before;
  applyAssignment(expected, "rectify.method=clamp");
  EXPECT_TRUE(settings() == expected);
  session.undo();
  settle();
  key(Qt::Key_T, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_TRUE(settings() == before) << "there is no third one";
}

TEST_F(VerdictPanel, IsReadAloudAndCopied) {
  probe();
  const QString sentence = line()->sentence();
  const auto labels = line()->findChildren<QLabel*>();
  const auto label = std::ranges::find(labels, sentence, &QLabel::text);
  ASSERT_NE(label, labels.end());
  EXPECT_EQ((*label)->accessibleName(), QStringLiteral("Verdict: ") + sentence);
  EXPECT_EQ((*label)->focusPolicy(), Qt::TabFocus);
  EXPECT_TRUE((*label)->textInteractionFlags().testFlag(Qt::TextSelectableByKeyboard));
  key(Qt::Key_V, Qt::ControlModifier | Qt::AltModifier);
  const QString copied = QApplication::clipboard()->text();
  EXPECT_TRUE(copied.startsWith(sentence + QLatin1Char('\n'))) << copied.toStdString();
  EXPECT_TRUE(copied.contains(QStringLiteral("depthMismatch 0.5 in frame 9 at 11,7; the limit is 0.125")));
  EXPECT_TRUE(copied.contains(QStringLiteral("validate.object=on rectify.method=clamp\n    pixel: error ")));
}

TEST_F(VerdictPanel, SaysThatNothingMendsIt) {
  renderer->verdict.remedies->best.clear();
  probe();
  EXPECT_EQ(shownRemedies(), 0);
  EXPECT_EQ(details()->note(), "None of 9 changes that were tried mends it.");
  const Settings before = settings();
  key(Qt::Key_T, Qt::ControlModifier);
  EXPECT_TRUE(settings() == before);
}

TEST_F(VerdictPanel, UnfoldsWhatDecidedAndGoesThere) {
  probe();
  const auto& rows = details()->rows();
  EXPECT_FALSE(rows[0]->isVisible());
  key(Qt::Key_F2, Qt::ShiftModifier);
  EXPECT_TRUE(details()->isUnfolded());
  key(Qt::Key_F2, Qt::ShiftModifier);
  EXPECT_FALSE(details()->isUnfolded());
  click(details()->header());
  EXPECT_TRUE(details()->isUnfolded());
  ASSERT_TRUE(rows[3]->isVisible());
  EXPECT_FALSE(rows[4]->isVisible()) << "there are four";
  EXPECT_EQ(rows[1]->text(), qtext(intermediate(IntermediateId::depthMismatch).label));
  EXPECT_EQ(rows[1]->value(), "0.5, limit 0.125");
  EXPECT_EQ(rows[0]->value(), "0.0625");
  EXPECT_TRUE(details()->agreement()->isVisible());
  EXPECT_EQ(details()->agreement()->text().toStdString(), agreementText(VerdictKind::Ghost));
  click(rows[1]);
  EXPECT_EQ(window.views()->active()->id(), IntermediateId::depthMismatch);
  EXPECT_EQ(session.status().info.frame, 9);
}

TEST_F(VerdictPanel, DrawsThePartsOfTheErrorAndTheirSum) {
  probe();
  const std::vector<ErrorBars::Bar>& bars = details()->bars()->bars();
  ASSERT_EQ(bars.size(), kErrorParts + 1);
  double sum = 0.0;
  for (std::size_t part = 0; part < kErrorParts; ++part) sum += bars[part].value;
  EXPECT_FLOAT_EQ(static_cast<float>(bars[static_cast<std::size_t>(ErrorPart::Ghost)].value), 0.25f);
  EXPECT_FLOAT_EQ(static_cast<float>(bars[static_cast<std::size_t>(ErrorPart::Lag)].value), -0.125f);
  EXPECT_FLOAT_EQ(static_cast<float>(sum), 0.125f);
  EXPECT_FLOAT_EQ(static_cast<float>(bars.back().value), 0.125f) << "0.625 less 0.5";
}

TEST_F(VerdictPanel, IsWantedWhereItIsSeenAndNotWhileItPlays) {
  probe();
  EXPECT_TRUE(renderer->last<request::SetVerdicts>().on);
  key(Qt::Key_F3);
  EXPECT_FALSE(renderer->last<request::SetVerdicts>().on) << "another page of the probe is open";
  key(Qt::Key_F2);
  EXPECT_TRUE(renderer->last<request::SetVerdicts>().on);
  key(Qt::Key_F10);
  EXPECT_FALSE(renderer->last<request::SetVerdicts>().on) << "the panel is closed";
  key(Qt::Key_F10);
  session.post(request::SetPlaying{true});
  settle();
  EXPECT_FALSE(line()->isVisible());
  EXPECT_FALSE(details()->isVisible());
  session.post(request::SetPlaying{false});
  settle();
  EXPECT_TRUE(line()->isVisible());
}

TEST_F(VerdictPanel, IsSwitchedOffAndStaysSo) {
  probe();
  key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(renderer->last<request::SetVerdicts>().on);
  EXPECT_FALSE(line()->isVisible());
  EXPECT_FALSE(details()->isVisible());
  const QJsonObject state = window.state();
  EXPECT_EQ(state[QStringLiteral("verdicts")], QJsonValue(false));
  key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(line()->isVisible());
  EXPECT_EQ(window.state()[QStringLiteral("verdicts")], QJsonValue(true));
}

TEST_F(VerdictPanel, KeepsItsRoomWhileTheNextFrameIsJudged) {
  probe();
  const int top = window.probe()->table()->mapToGlobal(QPoint()).y();
  renderer->verdict = {};
  session.seek(5);
  settle();
  EXPECT_EQ(line()->sentence(), "");
  EXPECT_EQ(window.probe()->table()->mapToGlobal(QPoint()).y(), top);
  renderer->verdict = taa::app::test::fakeVerdict();
  renderer->verdict.remedies.reset();
  renderer->deliver();
  settle();
  EXPECT_NE(line()->sentence(), "");
  EXPECT_EQ(shownRemedies(), 0);
  EXPECT_GE(window.probe()->table()->mapToGlobal(QPoint()).y(), top) << "remedies are still to come";
}

// With a bar at its side it has less than what is widest in it asks for: texts wrap all the same.
TEST(FittingAreaTest, ShowsNothingBeyondItsSide) {
  FittingArea area(20);
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  auto* sentence =
      new QLabel(QStringLiteral("a sentence that is long enough for some lines of its own here"));
  sentence->setWordWrap(true);
  auto* wide = new QWidget;
  wide->setMinimumWidth(600);
  column->addWidget(sentence);
  column->addWidget(wide);
  area.setWidget(content);
  area.resize(300, 40);
  area.show();
  QTest::qWait(1);
  EXPECT_LE(sentence->geometry().right(), area.viewport()->width());
}
