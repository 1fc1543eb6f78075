// What the import page writes, and what it asks before that.
#include "tests/app/importing/ImportFixture.h"

#include "core/base/Files.h"
#include "core/capture/planes/Planes.h"

#include <QFileDialog>
#include <QMessageBox>

#include <filesystem>

namespace taa::app::test {

TEST_F(ImportPageTest, OpenWritesWhatIsShown) {
  chooseNext("motion.unit");
  key(page, Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return opened.count() == 1; }));
  EXPECT_EQ(opened[0][0].toString(), folder.path());
  EXPECT_EQ(capture::readManifest(path()).conventions.motion.unit, capture::ScreenUnit::Uv);
  EXPECT_TRUE(waitFor([&] { return !page || !page->isVisible(); }));
}

TEST_F(ImportPageTest, WhatIsStillBeingTypedIsWritten) {
  type("motion.scaleX", "-2");
  key(field("motion.scaleX"), Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return opened.count() == 1; }));
  const capture::Manifest written = capture::readManifest(path());
  EXPECT_EQ(written.conventions.motion.scale.x, -2.0);
  ASSERT_FALSE(written.notes.empty());
  EXPECT_EQ(written.notes.back(), "set by hand after that: motion.scaleX=-2");
}

TEST_F(ImportPageTest, WhatIsStillBeingTypedAndIsNoNumberIsNotOpened) {
  type("motion.scaleX", "many");
  key(field("motion.scaleX"), Qt::Key_Return, Qt::ControlModifier);
  EXPECT_TRUE(problem().contains("motion.scaleX")) << problem().toStdString();
  QTest::qWait(50);
  EXPECT_EQ(opened.count(), 0);
  EXPECT_FALSE(std::filesystem::exists(manifestFile()));
}

TEST_F(ImportPageTest, AManifestThatIsThereIsReplacedOnlyWhenTheUserSaysSo) {
  writeFile(manifestFile(), "mine");
  const auto answer = [&](QMessageBox::ButtonRole role) {
    auto* box = page->findChild<QMessageBox*>();
    ASSERT_TRUE(box && box->isVisible());
    EXPECT_TRUE(box->text().contains("capture.json")) << box->text().toStdString();
    for (QAbstractButton* each : box->buttons())
      if (box->buttonRole(each) == role) return QTest::mouseClick(each, Qt::LeftButton);
    FAIL();
  };
  QTest::mouseClick(button("open"), Qt::LeftButton);
  answer(QMessageBox::RejectRole);
  QTest::qWait(50);
  EXPECT_EQ(readFile(manifestFile()), "mine");
  EXPECT_EQ(opened.count(), 0);
  QTest::mouseClick(button("open"), Qt::LeftButton);
  answer(QMessageBox::DestructiveRole);
  ASSERT_TRUE(waitFor([&] { return opened.count() == 1; }));
  EXPECT_EQ(capture::readManifest(path()).name, "small");
}

TEST_F(ImportPageTest, TheFramesComeAlongIntoAnotherFolder) {
  const QTemporaryDir other;
  key(page, Qt::Key_S, Qt::ControlModifier);
  auto* dialog = page->findChild<QFileDialog*>();
  ASSERT_TRUE(dialog);
  Q_EMIT dialog->fileSelected(other.path());
  dialog->close();
  ASSERT_TRUE(waitFor([&] { return opened.count() == 1; }));
  EXPECT_EQ(opened[0][0].toString(), other.path());
  const std::filesystem::path there = other.path().toStdString();
  const capture::Manifest manifest = capture::readManifest(there);
  EXPECT_EQ(capture::readPlanes(there, manifest, manifest.frames[2]).size(), 3u);
  EXPECT_FALSE(std::filesystem::exists(manifestFile())) << "nothing is written beside the frames";
}

} // namespace taa::app::test
