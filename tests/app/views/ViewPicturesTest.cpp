// Pictures of views for files.
#include "app/commands/Exports.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/views/Wipe.h"
#include "tests/app/views/ViewsFixture.h"

#include <cmath>
#include <memory>
#include <optional>

using namespace taa;
using namespace taa::app;

namespace {

using test::FakeRenderer, test::kSharp;

class ViewPictures : public test::FakeViews {};

} // namespace

TEST_F(ViewPictures, APictureForAFileIsWhatBothSidesShow) {
  compareWith(kSharp);
  viewport()->setCamera({false, 40.0, {32.0, 18.0}}); // nothing but picture is in view
  viewport()->setDivider(0.25);
  settle();
  const auto grayOf = [&](const QImage& image, int x) { return qRed(image.pixel(x, middleY())); };
  const int line = viewport()->dividerColumn();
  EXPECT_EQ(line, wipePosition(0.25, viewport()->width()));
  const QImage wipe = viewport()->picture(false);
  ASSERT_EQ(wipe.size(), viewport()->size());
  EXPECT_EQ(grayOf(wipe, line - 1), FakeRenderer::kGray);
  EXPECT_EQ(grayOf(wipe, line), FakeRenderer::kOtherGray);
  view()->setShowing(Showing::Other);
  settle();
  EXPECT_EQ(grayOf(viewport()->picture(false), 5), FakeRenderer::kOtherGray);
  view()->setShowing(Showing::Difference);
  settle();
  EXPECT_EQ(grayOf(viewport()->picture(false), 5), FakeRenderer::kDifferenceGray);
  viewport()->setPeeking(true);
  EXPECT_EQ(grayOf(viewport()->picture(false), 5), FakeRenderer::kDifferenceGray) << "not what is held";
  viewport()->setPeeking(false);
  view()->setShowing(Showing::Wipe); // the difference is still what was delivered last
  auto late = std::make_shared<ViewResult>(*viewport()->result());
  late->other.reset();
  viewport()->setResult(late);
  EXPECT_TRUE(viewport()->picture(false).isNull()) << "a side is missing";
}

// What few pixels show of settings to come is said to be that, says no values, and goes into no file.
TEST_F(ViewPictures, APreviewIsNoPictureForAFile) {
  settle();
  ASSERT_FALSE(viewport()->picture(false).isNull());
  auto preview = std::make_shared<ViewResult>(*viewport()->result());
  preview->isPreview = true;
  preview->values = {};
  preview->region = {};
  const QImage before = viewport()->grab().toImage();
  viewport()->setResult(preview);
  EXPECT_TRUE(viewport()->picture(false).isNull());
  EXPECT_FALSE(viewport()->valueAt({3, 3}));
  EXPECT_NE(viewport()->grab().toImage(), before) << "its legend says so";
  preview = std::make_shared<ViewResult>(*preview);
  preview->isPreview = false;
  viewport()->setResult(preview);
  EXPECT_EQ(viewport()->grab().toImage(), before) << "nothing else differs";
}

TEST_F(ViewPictures, TheLegendOfAPictureLiesBelowWhatTheScreenShows) {
  view()->setIntermediate(IntermediateId::motion);
  view()->setOverlay(Overlay::Arrows, true);
  view()->setOverlay(Overlay::Rejected, true);
  viewport()->setCamera({false, 40.0, {32.0, 18.0}});
  compareWith(kSharp);
  const QImage file = viewport()->picture(true);
  const QImage screen = viewport()->grab().toImage().convertToFormat(QImage::Format_RGBA8888);
  const int strips = file.height() - screen.height();
  ASSERT_GE(strips, 3 * legendHeight()) << "arrows, reasons, the row";
  EXPECT_EQ(strips % legendHeight(), 0);
  const QRect seen(0, 0, screen.width(), screen.height() - strips);
  EXPECT_EQ(file.copy(seen), screen.copy(seen)) << "the divider and the names of both sides, too";
  const QRect strip(0, screen.height(), screen.width(), strips);
  // On the screen the strip lets the picture through.
  EXPECT_NE(file.copy(strip), file.copy(strip.translated(0, -strips)));
}

TEST_F(ViewPictures, APictureForAFileEndsWhereThePictureDoes) {
  session.probes().setPixel(std::nullopt);
  settle();
  const ViewTransform now = viewport()->transform();
  const auto wholePixels = [&](float texels) { // less what single floats round
    return static_cast<int>(std::ceil(texels * now.zoom - 0.01f));
  };
  const QSize part(wholePixels(64), wholePixels(36));
  ASSERT_LT(part.height(), viewport()->height()) << "fitted, a view has more room than the picture needs";
  const QImage plain = viewport()->picture(false);
  EXPECT_EQ(plain.size(), part);
  EXPECT_EQ(qRed(plain.pixel(0, 0)), FakeRenderer::kGray);
  EXPECT_EQ(qRed(plain.pixel(part.width() - 1, part.height() - 1)), FakeRenderer::kGray);
  const QImage figure = viewport()->picture(true);
  const int strips = figure.height() - part.height();
  EXPECT_GT(strips, 0);
  EXPECT_EQ(figure.copy(0, 0, part.width(), part.height()), plain) << "the legend follows below it";
}

TEST_F(ViewPictures, PicturesOfARangeAreAskedForWithBothSides) {
  compareWith(kSharp);
  viewport()->setDivider(0.25);
  const QStringList presets = window.views()->comparedPresets();
  PictureRequest picture = view()->pictureRequest(presets, PictureExtent::Viewport);
  EXPECT_EQ(picture.showing, Showing::Wipe);
  ASSERT_TRUE(picture.other);
  EXPECT_EQ(picture.other->lane, 1);
  EXPECT_EQ(picture.width, viewport()->width()) << "drawn whole";
  const double left = std::round(screenFromPicture(viewport()->transform(), {0.0, 0.0}).x);
  EXPECT_EQ(picture.part.x, left) << "and cut: nothing around the picture";
  EXPECT_EQ(picture.part.width, std::ceil(64 * viewport()->zoom() - 0.01));
  EXPECT_EQ(picture.divider, viewport()->dividerColumn() - left);
  picture = view()->pictureRequest(presets, PictureExtent::Whole);
  EXPECT_EQ(picture.width, 64);
  const glm::dvec2 there = screenFromPicture(viewport()->transform(), {picture.divider, 0.0});
  EXPECT_NEAR(there.x, viewport()->dividerColumn(), 0.51 * viewport()->zoom()) << "at the same place of it";
  view()->setOverlay(Overlay::Outlines, true);
  EXPECT_TRUE(view()->pictureRequest(presets, PictureExtent::Whole).style.outlineObjects);
  EXPECT_TRUE(
      window.exports()->commandLine().contains(" --compare preset:sharp --compare-as wipe --divider "));
  compareWith({});
  EXPECT_EQ(view()->pictureRequest({}, PictureExtent::Whole).showing, Showing::First);
}
