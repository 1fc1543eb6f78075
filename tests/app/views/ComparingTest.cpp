// Views with two sides, by mouse and keys.
#include "app/commands/ViewChoices.h"
#include "app/panels/StatusLine.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/views/Wipe.h"
#include "app/widgets/Chooser.h"
#include "app/widgets/Prompt.h"
#include "core/base/Error.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "tests/app/views/ViewsFixture.h"

#include <QFontMetrics>
#include <QJsonArray>
#include <QJsonObject>
#include <QLineEdit>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

using test::FakeRenderer, test::kRow, test::kSharp;

class ComparingTest : public test::FakeViews {};

} // namespace

TEST(ComparisonTest, TextsAndMeaningsBelongTogether) {
  const std::pair<Comparison, std::string> pairs[] = {
      {{}, "nothing"},
      {kRow, "color"},
      {kSharp, "preset:sharp"},
      {{OtherKind::Frame, {}, {}, 12}, "frame:12"},
      {{OtherKind::FramesBefore, {}, {}, 3}, "frame:-3"},
      {{OtherKind::AlongMotion}, "motion:-1"},
  };
  for (const auto& [comparison, text] : pairs) {
    EXPECT_EQ(comparisonText(comparison), text);
    EXPECT_EQ(parseComparison(text), comparison) << text;
  }
  EXPECT_EQ(parseComparison("row:color"), kRow);
  for (const char* wrong : {"", "row:", "row:preset:sharp", "colour", "preset:", "frame:", "frame:x",
                            "frame:1.5", "frame:99999999999"})
    EXPECT_THROW(parseComparison(wrong), Error) << wrong;
  for (const Showing showing : {Showing::First, Showing::Other, Showing::Difference, Showing::Wipe})
    EXPECT_EQ(showingNamed(showingName(showing)), showing);
  EXPECT_THROW(showingNamed("sideways"), Error);
}

TEST_F(ComparingTest, VShowsOneTwoOrFourViewsAndHiddenOnesCostNothing) {
  EXPECT_EQ(renderer->last<request::SetViews>().views.size(), 2u);
  key(Qt::Key_V);
  ASSERT_EQ(renderer->last<request::SetViews>().views.size(), 4u);
  for (std::size_t index = 0; index < 4; ++index) EXPECT_GT(asked(index).width, 0) << index;
  EXPECT_EQ(view(2)->mapTo(&window, QPoint()).x(), view(0)->mapTo(&window, QPoint()).x());
  EXPECT_GT(view(2)->mapTo(&window, QPoint()).y(), view(0)->mapTo(&window, QPoint()).y());
  EXPECT_EQ(view(3)->mapTo(&window, QPoint()).x(), view(1)->mapTo(&window, QPoint()).x());
  key(Qt::Key_V);
  EXPECT_EQ(renderer->last<request::SetViews>().views.size(), 1u);
  key(Qt::Key_V);
  EXPECT_EQ(renderer->last<request::SetViews>().views.size(), 2u);
  key(Qt::Key_4, Qt::ControlModifier);
  EXPECT_EQ(window.views()->viewCount(), 4) << "a view that is not there comes with its key";
  EXPECT_EQ(window.views()->activeIndex(), 3);
  key(Qt::Key_E);
  EXPECT_EQ(window.views()->activeIndex(), 3);
}

TEST_F(ComparingTest, AllLinkedViewsMoveTogetherAndFreeOnesAlone) {
  key(Qt::Key_V);
  key(Qt::Key_1);
  for (int index = 0; index < 4; ++index) EXPECT_EQ(view(index)->viewport()->zoom(), 1.0) << index;
  key(Qt::Key_L);
  key(Qt::Key_Plus);
  EXPECT_GT(view(0)->viewport()->zoom(), 1.0);
  for (int index = 1; index < 4; ++index) EXPECT_EQ(view(index)->viewport()->zoom(), 1.0) << index;
  key(Qt::Key_L);
  EXPECT_EQ(view(3)->viewport()->zoom(), view(0)->viewport()->zoom());
}

TEST(SideTexts, SayInANarrowViewWhatDiffers) {
  const QFontMetrics metrics(secondaryFont());
  const SideTexts whole{"Resolved · balanced · frame 60", "Resolved · unrectified · frame 60"};
  const auto shown = [&](const SideTexts& texts, int room) {
    const SideTexts fitting = fittingTexts(texts, metrics, room);
    return fitting.first + " | " + fitting.other;
  };
  const int needed = metrics.horizontalAdvance(whole.other);
  EXPECT_EQ(shown(whole, needed), whole.first + " | " + whole.other);
  EXPECT_EQ(shown(whole, needed - 1), "balanced | unrectified");
  EXPECT_EQ(shown({"Color · frame 1", "Resolved · frame 1"}, 10), "Color | Resolved");
  EXPECT_EQ(shown({"Color · frame 1", "Color · frame 1"}, 10), "Color · frame 1 | Color · frame 1");
}

TEST_F(ComparingTest, ADividerSeparatesBothSidesAndCanBeDragged) {
  compareWith(kRow);
  EXPECT_EQ(view()->showing(), Showing::Wipe);
  ASSERT_TRUE(asked().other);
  EXPECT_EQ(asked().other->id, IntermediateId::color);
  const int width = viewport()->width(), middle = wipePosition(0.5, width);
  // The labels and legends lie elsewhere; both sides are asked for in one picture each.
  EXPECT_EQ(grayAt(middle - 12, middleY()), FakeRenderer::kGray);
  EXPECT_EQ(grayAt(middle + 12, middleY()), FakeRenderer::kOtherGray);
  const int target = middle - width / 6;
  QTest::mousePress(viewport(), Qt::LeftButton, {}, {middle, middleY()});
  QTest::mouseMove(viewport(), {target, middleY()});
  QTest::mouseRelease(viewport(), Qt::LeftButton, {}, {target, middleY()});
  EXPECT_NEAR(viewport()->divider(), static_cast<double>(target) / width, 1e-9);
  EXPECT_TRUE(viewport()->camera().fit) << "the picture stays where it is";
  EXPECT_EQ(grayAt(middle - 12, middleY()), FakeRenderer::kOtherGray);
  EXPECT_EQ(grayAt(target - 12, middleY()), FakeRenderer::kGray);
  QTest::mouseDClick(viewport(), Qt::LeftButton, {}, {target, middleY()});
  EXPECT_EQ(viewport()->divider(), 0.5);
  key(Qt::Key_Left, Qt::AltModifier);
  EXPECT_NEAR(viewport()->divider(), 0.45, 1e-9);
  key(Qt::Key_Down, Qt::AltModifier);
  EXPECT_EQ(viewport()->divider(), 0.5);
}

TEST_F(ComparingTest, ADoubleClickMaximizesAView) {
  key(Qt::Key_V);
  ASSERT_EQ(window.views()->viewCount(), kViewCount);
  const int width = view(2)->width();
  QTest::mouseClick(view(2)->viewport(), Qt::LeftButton, {}, {40, 60});
  QTest::mouseDClick(view(2)->viewport(), Qt::LeftButton, {}, {40, 60});
  settle();
  for (int index = 0; index < kViewCount; ++index) EXPECT_EQ(view(index)->isVisible(), index == 2) << index;
  EXPECT_GT(view(2)->width(), 3 * width / 2);
  EXPECT_GT(asked(2).width, 0);
  EXPECT_EQ(asked(0).width, 0) << "hidden views cost nothing";
  key(Qt::Key_2, Qt::ControlModifier);
  EXPECT_TRUE(view(1)->isVisible()) << "the keys' view is the one that is seen";
  key(Qt::Key_M, Qt::ControlModifier);
  for (int index = 0; index < kViewCount; ++index) EXPECT_TRUE(view(index)->isVisible()) << index;
}

TEST_F(ComparingTest, AwayFromTheDividerADragPans) {
  compareWith(kRow);
  const int middle = wipePosition(0.5, viewport()->width());
  QTest::mousePress(viewport(), Qt::LeftButton, {}, {middle - 40, middleY()});
  QTest::mouseMove(viewport(), {middle - 60, middleY()});
  QTest::mouseRelease(viewport(), Qt::LeftButton, {}, {middle - 60, middleY()});
  EXPECT_EQ(viewport()->divider(), 0.5);
  EXPECT_FALSE(viewport()->camera().fit);
}

TEST_F(ComparingTest, ShiftShowsTheOtherSideWhileItIsHeld) {
  compareWith(kRow);
  key(Qt::Key_O);
  EXPECT_EQ(view()->showing(), Showing::First);
  const QPoint place(viewport()->width() / 2, middleY());
  EXPECT_EQ(grayAt(place.x(), place.y()), FakeRenderer::kGray);
  QTest::keyPress(&window, Qt::Key_Shift);
  EXPECT_EQ(viewport()->shown(), Showing::Other);
  EXPECT_EQ(grayAt(place.x(), place.y()), FakeRenderer::kOtherGray);
  QTest::keyRelease(&window, Qt::Key_Shift);
  EXPECT_EQ(grayAt(place.x(), place.y()), FakeRenderer::kGray);
}

TEST_F(ComparingTest, OCyclesThisSideTheOtherAndTheDifference) {
  compareWith(kSharp);
  const QPoint place(viewport()->width() / 2, middleY());
  const std::pair<Showing, int> turns[] = {{Showing::First, FakeRenderer::kGray},
                                           {Showing::Other, FakeRenderer::kOtherGray},
                                           {Showing::Difference, FakeRenderer::kDifferenceGray},
                                           {Showing::First, FakeRenderer::kGray}};
  for (const auto& [showing, gray] : turns) {
    key(Qt::Key_O);
    EXPECT_EQ(view()->showing(), showing);
    EXPECT_EQ(asked().asDifference, showing == Showing::Difference);
    EXPECT_EQ(grayAt(place.x(), place.y()), gray);
  }
}

TEST_F(ComparingTest, ADifferenceHasAStyleOfItsOwn) {
  compareWith(kSharp);
  view()->setShowing(Showing::Difference);
  settle();
  EXPECT_EQ(asked().style.map, ColorMap::Diverging);
  EXPECT_EQ(asked().style.low, -0.25f);
  EXPECT_EQ(asked().style.high, 0.25f);
  key(Qt::Key_N);
  // Fitted to the values that came, the same distance both ways.
  EXPECT_EQ(asked().style.high, FakeRenderer::valueAt(40, 35, 0)) << "the 2281st of 2304: 99 %";
  EXPECT_EQ(asked().style.low, -FakeRenderer::valueAt(40, 35, 0));
  key(Qt::Key_O);
  EXPECT_EQ(asked().style.map, ColorMap::Gray);
  EXPECT_EQ(asked().style.high, 1.0f) << "the picture keeps its own";
}

TEST_F(ComparingTest, RowsOfOtherChannelCountsHaveNoDifference) {
  compareWith({OtherKind::Row, IntermediateId::alpha});
  EXPECT_FALSE(view()->hasDifference());
  key(Qt::Key_O);
  key(Qt::Key_O);
  key(Qt::Key_O);
  EXPECT_EQ(view()->showing(), Showing::First) << "it is left out";
  EXPECT_FALSE(asked().asDifference);
}

TEST_F(ComparingTest, EachOfFourViewsHasAPresetOfItsOwnToCompareWith) {
  window.views()->setViewCount(4);
  const QStringList presets{"sharp", "stable", "minimal", "fsr2"};
  for (int index = 0; index < 4; ++index)
    view(index)->setComparison({OtherKind::Preset, {}, presets[index].toStdString()});
  settle();
  ASSERT_EQ(renderer->last<request::SetOtherLanes>().lanes.size(), 4u);
  const std::vector<ViewRequest> requests = window.views()->requests();
  for (int index = 0; index < 4; ++index) {
    EXPECT_TRUE(renderer->last<request::SetOtherLanes>().lanes[static_cast<std::size_t>(index)] ==
                preset(presets[index].toStdString()).settings);
    ASSERT_TRUE(requests[static_cast<std::size_t>(index)].other) << index;
    EXPECT_EQ(requests[static_cast<std::size_t>(index)].other->lane, index + 1);
  }
}

TEST_F(ComparingTest, APresetIsALaneBesideTheSettings) {
  compareWith(kSharp);
  ASSERT_EQ(renderer->last<request::SetOtherLanes>().lanes.size(), 1u);
  EXPECT_TRUE(renderer->last<request::SetOtherLanes>().lanes[0] == preset("sharp").settings);
  EXPECT_EQ(asked().other->lane, 1);
  view(1)->setComparison({OtherKind::Preset, {}, "stable"});
  settle();
  EXPECT_EQ(renderer->last<request::SetOtherLanes>().lanes.size(), 2u);
  EXPECT_EQ(asked(1).other->lane, 2);
  compareWith({});
  EXPECT_EQ(renderer->last<request::SetOtherLanes>().lanes.size(), 1u) << "a lane nobody looks at is not run";
  EXPECT_EQ(asked(1).other->lane, 1);
}

TEST_F(ComparingTest, AnotherFrameIsAskedForByItsNumberOrItsDistance) {
  session.seek(20);
  compareWith({OtherKind::Frame, {}, {}, 7});
  EXPECT_EQ(asked().other->frame, 7);
  EXPECT_TRUE(viewport()->label(true).contains("frame 7")) << viewport()->label(true).toStdString();
  EXPECT_TRUE(viewport()->label(false).contains("frame 20")) << viewport()->label(false).toStdString();
  key(Qt::Key_C, Qt::ShiftModifier);
  EXPECT_EQ(asked().other->frame, std::nullopt);
  EXPECT_EQ(asked().other->framesBefore, 1);
  EXPECT_TRUE(viewport()->label(true).contains("frame 19")) << viewport()->label(true).toStdString();
}

TEST_F(ComparingTest, WhilePlayingTheFrameBeforeStaysAndSaysSo) {
  session.seek(20);
  key(Qt::Key_C, Qt::ShiftModifier);
  const int right = viewport()->width() - 12;
  ASSERT_EQ(grayAt(right, middleY()), FakeRenderer::kOtherGray);
  session.post(request::SetPlaying{true});
  session.seek(24);
  settle();
  EXPECT_EQ(viewport()->label(true).toStdString(),
            "Resolved · balanced · frame 19 · stays until it is paused");
  EXPECT_EQ(viewport()->label(false).toStdString(), "Resolved · balanced · frame 24");
  EXPECT_EQ(grayAt(right, middleY()), FakeRenderer::kOtherGray) << "not an empty half";
  EXPECT_TRUE(viewport()->picture(false).isNull()) << "no file shows a pair that is none";
  compareWith({OtherKind::FramesBefore, {}, {}, 3});
  EXPECT_EQ(viewport()->label(true).toStdString(), "Resolved · balanced · comes when it is paused");
  session.post(request::SetPlaying{false});
  settle();
  EXPECT_EQ(viewport()->label(true).toStdString(), "Resolved · balanced · frame 21");
}

TEST_F(ComparingTest, TheReferenceOfAnotherFrameSaysWhyItIsNotThere) {
  view()->setIntermediate(IntermediateId::reference);
  compareWith({OtherKind::Frame, {}, {}, 7});
  EXPECT_TRUE(viewport()->label(true).contains("only the frame on show has a reference: go to"))
      << viewport()->label(true).toStdString();
}

TEST_F(ComparingTest, LabelsSayWhichRowWhichSettingsAndWhichFrame) {
  compareWith(kSharp);
  EXPECT_EQ(viewport()->label(false).toStdString(), "Resolved · balanced · frame 0");
  EXPECT_EQ(viewport()->label(true).toStdString(), "Resolved · sharp · frame 0");
}

TEST_F(ComparingTest, TheListOffersPresetsFramesAndIntermediates) {
  key(Qt::Key_C);
  auto* chooser = window.findChild<Chooser*>();
  ASSERT_TRUE(chooser);
  chooser->search(QStringLiteral("the frame before"));
  QTest::keyClick(chooser->findChild<QLineEdit*>(), Qt::Key_Return);
  settle();
  EXPECT_EQ(view()->comparison().kind, OtherKind::FramesBefore);
  ASSERT_TRUE(test::waitFor([&] { return !window.findChild<Chooser*>(); }));
  window.choices()->chooseComparison(0);
  chooser = window.findChild<Chooser*>();
  ASSERT_TRUE(chooser);
  chooser->search(QStringLiteral("another frame…"));
  QTest::keyClick(chooser->findChild<QLineEdit*>(), Qt::Key_Return);
  ASSERT_TRUE(test::waitFor([&] { return window.findChild<Prompt*>() != nullptr; })); // behind the chooser
  auto* prompt = window.findChild<Prompt*>();
  prompt->field()->setText(QStringLiteral("33"));
  QTest::keyClick(prompt->field(), Qt::Key_Return);
  settle();
  EXPECT_EQ(view()->comparison(), (Comparison{OtherKind::Frame, {}, {}, 33}));
}

TEST_F(ComparingTest, HoverShowsTheValuesOfBothSides) {
  compareWith(kSharp);
  QTest::mouseMove(viewport(), placeOf({10, 3}));
  settle();
  EXPECT_EQ(window.statusLine()->hover().toStdString(),
            "A (10, 3)  (310, 310, 310)  other (10310, 10310, 10310)");
}

TEST_F(ComparingTest, AStateIsRestoredAsItWas) {
  key(Qt::Key_V);
  view(2)->setIntermediate(IntermediateId::motion);
  view(2)->setOverlay(Overlay::Arrows, true);
  view(2)->setOverlay(Overlay::Grid, false);
  view(3)->setComparison(kSharp);
  view(3)->setShowing(Showing::Difference);
  view(3)->viewport()->setDivider(0.25);
  key(Qt::Key_E);
  window.views()->setLinked(false);
  view(1)->viewport()->setCamera({false, 8.0, {10.0, 12.0}});
  settle();
  const QJsonObject state = window.views()->state();
  const std::vector<ViewRequest> before = renderer->last<request::SetViews>().views;
  for (int index = 0; index < 4; ++index) {
    view(index)->setComparison({});
    view(index)->resetStyle();
    view(index)->viewport()->setCamera({});
  }
  view(2)->setIntermediate(IntermediateId::lock);
  window.views()->setViewCount(1);
  settle();
  ASSERT_NE(renderer->last<request::SetViews>().views, before);
  window.views()->setState(state);
  settle();
  EXPECT_EQ(renderer->last<request::SetViews>().views, before);
  EXPECT_EQ(window.views()->state(), state);
  EXPECT_FALSE(window.views()->areLinked());
  EXPECT_EQ(view(3)->viewport()->divider(), 0.25);
}

TEST_F(ComparingTest, AStateThatMakesNoSenseFallsBack) {
  QJsonObject panel = view()->state();
  panel["intermediate"] = "nonsense";
  panel["comparedWith"] = "preset:";
  panel["shows"] = 7;
  panel["divider"] = "left";
  panel["camera"] = QJsonObject{{"fit", false}, {"zoom", -1.0}};
  window.views()->setState({{"count", 9}, {"active", 77}, {"views", QJsonArray{panel, 5}}});
  settle();
  EXPECT_EQ(window.views()->viewCount(), 2);
  EXPECT_EQ(window.views()->activeIndex(), 1);
  EXPECT_EQ(view()->id(), IntermediateId::resolved);
  EXPECT_EQ(view()->comparison(), Comparison{});
  EXPECT_EQ(viewport()->divider(), 0.5);
  EXPECT_TRUE(viewport()->camera().fit);
}
