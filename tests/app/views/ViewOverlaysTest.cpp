// What lies over, below and above the picture of a view: overlays, legends, histogram, header.
#include "app/style/Numbers.h"
#include "app/views/MeasuredRegion.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"
#include "app/views/legend/LegendFlow.h"
#include "app/views/legend/RangeHistogram.h"
#include "app/views/legend/RegionCard.h"
#include "app/widgets/ChannelButtons.h"
#include "app/widgets/Chooser.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/Prompt.h"
#include "app/widgets/parameters/NumberField.h"
#include "tests/app/views/ViewsFixture.h"

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QPainter>

#include <set>
#include <string>

using namespace taa;
using namespace taa::app;

namespace {

using test::FakeRenderer;

class ViewOverlays : public test::FakeViews {};

} // namespace

TEST_F(ViewOverlays, KeysLayOverlaysOverTheActiveViewWhateverItShows) {
  key(Qt::Key_X, Qt::ShiftModifier);
  key(Qt::Key_J);
  key(Qt::Key_K, Qt::ControlModifier);
  key(Qt::Key_A, Qt::ShiftModifier);
  const ViewStyle& style = asked().style;
  EXPECT_TRUE(style.markClipped && style.markRejected && style.outlineObjects && style.arrows);
  EXPECT_FALSE(asked(1).style.markClipped);
  window.showIntermediate(IntermediateId::motion);
  settle();
  EXPECT_TRUE(asked().style.markClipped && asked().style.arrows);
  key(Qt::Key_J);
  EXPECT_FALSE(asked().style.markRejected);
}

TEST_F(ViewOverlays, ChannelsOfABoxAreNamedByTheSettings) {
  window.showIntermediate(IntermediateId::boxMin);
  const auto names = [&] {
    return view()->header()->findChild<ChannelButtons*>()->names().join(QLatin1Char(' '));
  };
  EXPECT_EQ(names(), "Y Co Cg");
  session.presets().setParameter("space.color", static_cast<double>(ColorSpace::Rgb));
  settle();
  EXPECT_EQ(names(), "R G B");
  EXPECT_EQ(viewport()->shownContent().space.color, ColorSpace::Rgb) << "of which the legend is made";
  view()->setComparison({OtherKind::Preset, {}, "balanced"});
  settle();
  EXPECT_EQ(viewport()->otherContent()->space.color, ColorSpace::YCoCg) << "the other side has its own";
}

TEST_F(ViewOverlays, TheGridCanBeSwitchedOff) {
  viewport()->setCamera({false, 24.0, {32.0, 18.0}});
  settle();
  const glm::dvec2 corner = screenFromPicture(viewport()->transform(), {30.0, 20.0});
  const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y) + 12;
  EXPECT_NE(grayAt(x, y), FakeRenderer::kGray);
  key(Qt::Key_G, Qt::ShiftModifier);
  EXPECT_EQ(grayAt(x, y), FakeRenderer::kGray);
}

TEST_F(ViewOverlays, TheHistogramCountsWhatIsVisibleAndItsHandlesSetTheRange) {
  EXPECT_FALSE(asked().withValues);
  key(Qt::Key_H);
  EXPECT_TRUE(asked().withValues);
  auto* histogram = view()->findChild<RangeHistogram*>();
  ASSERT_TRUE(histogram && histogram->isVisible());
  int counted = 0;
  for (const int count : histogram->counts()) counted += count;
  EXPECT_EQ(counted, 64 * 36 * 3) << "every channel of every pixel";
  const int low = static_cast<int>(histogram->position(0.0)),
            high = static_cast<int>(histogram->position(1.0));
  EXPECT_NEAR(low, high, 2) << "a range of 1 among thousands";
  EXPECT_EQ(histogram->rangeText(), QStringLiteral("▲ 0  △ 1"))
      << "its ends are not those of the axis, which stand beside them";
  QTest::mousePress(histogram, Qt::LeftButton, {}, {high + 40, 30});
  QTest::mouseRelease(histogram, Qt::LeftButton, {}, {high + 40, 30});
  settle();
  const ViewStyle& style = asked().style;
  EXPECT_NEAR(histogram->position(static_cast<double>(style.high)), high + 40, 1.0);
  EXPECT_EQ(style.low, 0.0f);
  key(Qt::Key_H);
  EXPECT_FALSE(asked().withValues);
  EXPECT_TRUE(histogram->isHidden());
}

TEST_F(ViewOverlays, ADragWithCtrlDescribesTheValuesOfARegion) {
  RegionCard* card = view()->measured()->card();
  EXPECT_FALSE(asked().measured || card->isVisible());
  const ViewCamera before = viewport()->camera();
  const auto drag = [&](glm::ivec2 from, glm::ivec2 to) {
    QTest::mousePress(viewport(), Qt::LeftButton, Qt::ControlModifier, placeOf(from));
    QTest::mouseMove(viewport(), placeOf(to));
    QTest::mouseRelease(viewport(), Qt::LeftButton, Qt::ControlModifier, placeOf(to));
    settle();
  };
  drag({12, 9}, {10, 7});
  EXPECT_EQ(asked().measured, (gl::Rect{10, 7, 3, 3}));
  EXPECT_EQ(viewport()->camera(), before) << "nothing is panned";
  ASSERT_TRUE(card->isVisible());
  // x + 100 y over 10 to 12 and 7 to 9.
  const auto says = [&](const char* line) { return card->text().simplified().contains(QLatin1String(line)); };
  for (const char* line : {"min 710 710 710", "median 811 811 811", "max 912 912 912", "NaN 0 0 0"})
    EXPECT_TRUE(says(line)) << line << " in\n" << card->text().toStdString();
  session.seek(5);
  settle();
  EXPECT_TRUE(says("min 715 715 715")) << "it follows the frame";
  window.setFocus();
  key(Qt::Key_I, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_TRUE(QApplication::clipboard()->text().startsWith("resolved 10,7 3x3\n"))
      << "exact, as taa-batch has it";
  drag({3, 3}, {3, 3});
  EXPECT_FALSE(asked().measured || card->isVisible()) << "a click removes it";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(asked().measured, (gl::Rect{10, 7, 3, 3}));
}

TEST_F(ViewOverlays, ARegionIsTypedAndRemovedByKeys) {
  key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
  auto* prompt = window.findChild<Prompt*>();
  ASSERT_TRUE(prompt);
  auto* field = prompt->findChild<QLineEdit*>();
  field->clear();
  QTest::keyClicks(field, "60, 30, 40x40");
  QTest::keyClick(field, Qt::Key_Return);
  settle();
  EXPECT_EQ(asked().measured, (gl::Rect{60, 30, 4, 6})) << "as far as there is a picture";
  key(Qt::Key_H, Qt::ShiftModifier);
  EXPECT_FALSE(asked().measured);
  key(Qt::Key_H, Qt::ShiftModifier);
  EXPECT_EQ(asked().measured, (gl::Rect{0, 0, 64, 36})) << "all that is visible";
}

TEST_F(ViewOverlays, AReasonIsNamedWithItsNumberAndShareWhereItIsThere) {
  ViewStyle style;
  style.markRejected = true;
  ReasonCounts counts{}, others{};
  counts[0] = 900;
  counts[4] = 99;
  counts[9] = 1;
  const Intermediate& row = intermediate(IntermediateId::resolved);
  LegendFlow flow;
  addOverlayLegend(flow, {row, style, false, {}, &counts}, nullptr, {}, darkColors());
  EXPECT_EQ(flow.plainText().toStdString(), "4 depth · 9.9 % 9 another velocity · 0.1 %");
  others[0] = 500;
  others[3] = 500;
  LegendFlow both;
  addOverlayLegend(both, {row, style, false, {}, &counts}, &others, {}, darkColors());
  EXPECT_EQ(both.plainText().toStdString(), "3 off screen · 0.0 % | 50 % 4 depth · 9.9 % | 0.0 % "
                                            "9 another velocity · 0.1 % | 0.0 %");
  others[3] = 0;
  LegendFlow kept;
  addOverlayLegend(kept, {row, style, false, {}, &others}, nullptr, {}, darkColors());
  EXPECT_EQ(kept.plainText().toStdString(), "nothing is rejected in this picture");
}

TEST_F(ViewOverlays, TheLegendOfArrowsSaysTheirScaleAndWhatADotMeans) {
  ViewStyle style = defaultStyle(intermediate(IntermediateId::motion));
  style.arrows = true;
  const ViewTransform transform{.zoom = 8.0f};
  LegendFlow flow;
  addOverlayLegend(flow, {intermediate(IntermediateId::motion), style}, nullptr, transform, darkColors());
  const std::string text = flow.plainText().toStdString();
  EXPECT_NE(text.find("px or more"), text.npos) << text;
  EXPECT_NE(text.find("= still: less than "), text.npos) << text;
  EXPECT_NE(text.find("where it moves to"), text.npos) << text;
}

TEST_F(ViewOverlays, ALegendFoldsWhereItWouldCoverALowPicture) {
  view()->setIntermediate(IntermediateId::motion);
  view()->setOverlay(Overlay::Arrows, true);
  view()->setOverlay(Overlay::Clipped, true);
  viewport()->resize(900, 700);
  EXPECT_TRUE(viewport()->shownLegend().sign.isEmpty()) << "there is room";
  const auto isWhole = [](const ShownLegend& legend) {
    const QString text = legend.flow.plainText();
    return text.contains("Motion") && text.contains("shorter in proportion") &&
           text.contains("above the range");
  };
  EXPECT_TRUE(isWhole(viewport()->shownLegend()));
  viewport()->resize(300, 160);
  const ShownLegend folded = viewport()->shownLegend();
  EXPECT_EQ(folded.place.height(), legendHeight());
  EXPECT_TRUE(folded.flow.plainText().contains("Motion")) << "scale and unit are always there";
  EXPECT_FALSE(isWhole(folded));
  ASSERT_TRUE(folded.place.contains(folded.sign));
  QTest::mouseMove(viewport(), folded.sign.center());
  const ShownLegend open = viewport()->shownLegend();
  EXPECT_TRUE(isWhole(open));
  EXPECT_TRUE(open.place.contains(folded.place)) << "it grows from where it was";
  EXPECT_GT(open.place.height(), 2 * legendHeight());
  QTest::mouseMove(viewport(), {150, open.place.top() + 2});
  EXPECT_TRUE(isWhole(viewport()->shownLegend())) << "the mouse reads it";
  QTest::mouseMove(viewport(), {150, open.place.top() - 4});
  EXPECT_EQ(viewport()->shownLegend().place, folded.place);
  key(Qt::Key_L, Qt::ShiftModifier);
  EXPECT_TRUE(isWhole(viewport()->shownLegend()));
  viewport()->resize(300, 160);
  EXPECT_TRUE(viewport()->shownLegend().sign.isEmpty());
  EXPECT_GT(viewport()->shownLegend().place.height(), 2 * legendHeight()) << "also where the picture is low";
}

TEST_F(ViewOverlays, ALegendOfManyCategoriesLeavesALowPictureItsPlace) {
  view()->setIntermediate(IntermediateId::geometryVerdict);
  viewport()->resize(220, 120);
  const ShownLegend folded = viewport()->shownLegend();
  EXPECT_EQ(folded.place.height(), legendHeight());
  EXPECT_EQ(folded.flow.plainText(), QStringLiteral("Geometry verdict ⋯"));
  QTest::mouseMove(viewport(), folded.sign.center());
  const ShownLegend open = viewport()->shownLegend();
  EXPECT_TRUE(open.flow.plainText().contains("wrong history let through"));
  EXPECT_TRUE(open.place.contains(folded.place));
  QTest::mouseMove(viewport(), {1, 1});
  viewport()->resize(900, 700);
  EXPECT_TRUE(viewport()->shownLegend().sign.isEmpty()) << "there is room";
}

TEST_F(ViewOverlays, AFoldedLegendKeepsItsScale) {
  window.setTextPercent(200);
  view()->setIntermediate(IntermediateId::historyLength);
  viewport()->resize(195, 216);
  const ShownLegend folded = viewport()->shownLegend();
  EXPECT_FALSE(folded.sign.isEmpty());
  const ViewStyle style = view()->style();
  EXPECT_EQ(folded.flow.plainText(),
            QStringLiteral("History length %1 %2 ⋯").arg(shortText(style.low), shortText(style.high)));
  EXPECT_EQ(folded.place.height(), 2 * legendHeight());
  EXPECT_LE(folded.flow.lastPlace(195).right(), 195);
  QTest::mouseMove(viewport(), folded.sign.center());
  EXPECT_EQ(viewport()->shownLegend().flow.plainText().count(QStringLiteral("⋯")), 0) << "all of it";
  QTest::mouseMove(viewport(), {1, 1});
  window.setTextPercent(100);
}

TEST_F(ViewOverlays, ALegendWrapsInsteadOfLeavingOut) {
  LegendFlow flow;
  LegendSide side{intermediate(IntermediateId::reference), {}};
  side.note = QStringLiteral("64 samples · RMSE 0.0125 · PSNR 38.3 dB");
  addRowLegend(flow, side, darkColors());
  EXPECT_EQ(flow.lines(1000), 1);
  EXPECT_GE(flow.lines(250), 2);
  QImage image(250, flow.lines(250) * legendHeight(), QImage::Format_RGB32);
  image.fill(Qt::black);
  QPainter painter(&image);
  flow.paint(painter, {0, 0}, 250, darkColors());
  painter.end();
  const QImage last = image.copy(0, image.height() - legendHeight(), 250, legendHeight());
  std::set<QRgb> colors;
  for (int y = 0; y < last.height(); ++y)
    for (int x = 0; x < last.width(); ++x) colors.insert(last.pixel(x, y));
  EXPECT_GT(colors.size(), 4u) << "the last line holds text";
}

TEST_F(ViewOverlays, WhatHasNoRoomInANarrowHeaderIsBehindAButton) {
  ViewHeader* header = view()->header();
  const auto shown = [&] {
    std::set<QWidget*> widgets;
    for (QWidget* child : header->findChildren<QWidget*>())
      if (child->isVisible() && (qobject_cast<QAbstractButton*>(child) || qobject_cast<NumberField*>(child)))
        widgets.insert(child);
    return widgets;
  };
  window.resize(1920, 1000);
  window.views()->setViewCount(1);
  settle();
  const std::set<QWidget*> wide = shown();
  window.resize(1280, 800);
  window.views()->setViewCount(4);
  settle();
  auto* more = header->findChild<IconButton*>(QStringLiteral("more"));
  ASSERT_TRUE(more && more->isVisible());
  const auto named = [&](const char* words) {
    for (QAbstractButton* button : view()->findChildren<QAbstractButton*>())
      if (button->accessibleName().startsWith(QLatin1String(words))) return button;
    return static_cast<QAbstractButton*>(nullptr);
  };
  QAbstractButton *compare = named("Compare with"), *overlays = named("What lies over");
  ASSERT_TRUE(compare && overlays);
  ASSERT_FALSE(compare->isVisible()) << "else this test shows nothing";
  QTest::mouseClick(more, Qt::LeftButton);
  settle();
  EXPECT_TRUE(compare->isVisible() && overlays->isVisible());
  for (QWidget* widget : wide) EXPECT_TRUE(widget->isVisible()) << widget->metaObject()->className();
  QTest::mouseClick(compare, Qt::LeftButton);
  settle();
  EXPECT_TRUE(window.findChild<Chooser*>());
  EXPECT_FALSE(compare->isVisible()) << "it went back";
  EXPECT_EQ(compare->parentWidget(), header);
  window.views()->setViewCount(1);
  window.resize(1920, 1000);
  settle();
  EXPECT_TRUE(compare->isVisible() && overlays->isVisible());
  EXPECT_FALSE(more->isVisible());
}

TEST(LegendFlow, WhatIsGluedIsPartedWhereALineIsTooNarrowForIt) {
  LegendFlow flow;
  flow.text(QStringLiteral("range 0 … 1"), QFont(), Qt::white);
  const int wide = flow.lastPlace(1000).width();
  flow.glue();
  flow.text(QStringLiteral("⋯"), QFont(), Qt::white);
  const int sign = flow.lastPlace(1000).width();
  EXPECT_EQ(flow.lines(1000), 1);
  const int narrow = wide + 4 * kUnit;
  EXPECT_EQ(flow.lines(narrow), 2);
  EXPECT_EQ(flow.lastPlace(narrow).width(), sign) << "it is whole";
}
