// Frames on the import page: the frame, the one before as conventions move it, and their difference.
#include "tests/app/importing/ImportFixture.h"

#include <QSlider>

#include <filesystem>

namespace taa::app::test {

using small_frames::kHeight;
using small_frames::kWidth;

// The picture moves as motion says, so the warped frame before is the frame itself but at the left edge,
// where there was nothing.
TEST_F(ImportPageTest, TheFrameBeforeLiesOnTheFrameWhereConventionsAreRight) {
  FlickerCompare* flicker = page->frames()->flicker();
  const QImage current = shownColor();
  QTest::mouseClick(flicker->otherButton(), Qt::LeftButton);
  ASSERT_EQ(flicker->shown(), FlickerCompare::Shown::Warped);
  const QImage warped = shownColor();
  ASSERT_EQ(warped.size(), QSize(kWidth, kHeight));
  for (int x = 1; x < kWidth; ++x) EXPECT_EQ(warped.pixel(x, 3), current.pixel(x, 3)) << x;
  EXPECT_EQ(qAlpha(warped.pixel(0, 3)), 0);
  QTest::mouseClick(button("difference"), Qt::LeftButton);
  EXPECT_EQ(flicker->shown(), FlickerCompare::Shown::Difference);
  const QRgb none = shownColor().pixel(5, 3);
  chooseNext("motion.direction");
  EXPECT_TRUE(waitFor([&] { return shownColor().pixel(5, 3) != none; })) << "drawn again";
}

TEST_F(ImportPageTest, AlternatesUntilItIsStopped) {
  FlickerCompare* flicker = page->frames()->flicker();
  QTest::mouseClick(flicker->alternateButton(), Qt::LeftButton);
  ASSERT_TRUE(flicker->isAlternating());
  EXPECT_TRUE(waitFor([&] { return flicker->shown() == FlickerCompare::Shown::Warped; }));
  EXPECT_TRUE(waitFor([&] { return flicker->shown() == FlickerCompare::Shown::Current; }));
  QTest::mouseClick(flicker->alternateButton(), Qt::LeftButton);
  EXPECT_FALSE(flicker->isAlternating());
}

TEST_F(ImportPageTest, AnotherFrameIsDrawn) {
  const QString caption = page->frames()->flicker()->picture()->caption();
  EXPECT_EQ(page->frames()->slider()->value(), 1);
  key(page, Qt::Key_Right, Qt::AltModifier);
  EXPECT_EQ(page->frames()->slider()->value(), 2);
  EXPECT_TRUE(waitFor([&] { return page->frames()->flicker()->picture()->caption() != caption; }));
  EXPECT_TRUE(page->frames()->flicker()->picture()->caption().contains("12")) << "the engine's number";
  page->frames()->slider()->setValue(0);
  EXPECT_TRUE(waitFor([&] { return !page->frames()->flicker()->otherButton()->isEnabled(); }))
      << "there is none before the first";
}

TEST_F(ImportPageTest, FramesThatWereWrittenAgainAreReadAgain) {
  const QImage before = shownColor();
  std::filesystem::copy_file(path() / "color.0012.raw", path() / "color.0011.raw",
                             std::filesystem::copy_options::overwrite_existing);
  guessAgain();
  EXPECT_TRUE(waitFor([&] { return shownColor() != before; }));
}

TEST_F(ImportPageTest, WhatIsNotDrawnIsNotSaidToBeMissing) {
  ASSERT_FALSE(std::filesystem::remove_all(path() / "motion.0011.raw") == 0);
  page->openFolder(folder.path());
  ASSERT_TRUE(waitFor([&] { return !problem().isEmpty(); })) << "frame 11 cannot be read";
  for (const PictureBox* box : page->findChildren<PictureBox*>()) {
    EXPECT_TRUE(box->picture().isNull());
    EXPECT_FALSE(box->accessibleDescription().contains("There is no")) << box->caption().toStdString();
  }
}

TEST_F(ImportPageTest, AlternatingRestsWhereThereIsNoFrameBefore) {
  FlickerCompare* flicker = page->frames()->flicker();
  flicker->setAlternating(true);
  page->frames()->slider()->setValue(0);
  ASSERT_TRUE(waitFor([&] { return !flicker->otherButton()->isEnabled(); }));
  for (int i = 0; i < 4; ++i) {
    QTest::qWait(150);
    EXPECT_FALSE(shownColor().isNull()) << "the frame itself is there";
  }
}

} // namespace taa::app::test
