// Which pictures hold which plane, as the import page asks and takes it: with real guesses on small pictures.
#include "app/importing/FoundPictures.h"
#include "app/importing/PlaneRow.h"
#include "app/importing/PlaneTable.h"
#include "app/widgets/parameters/ParameterLabel.h"
#include "tests/app/PaintedTexts.h"
#include "tests/app/importing/ImportFixture.h"

#include "core/io/PictureFile.h"

#include <QAbstractItemModel>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QTabBar>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace taa::app::test {

using capture::PlaneKind;

namespace {

constexpr int kSide = 32, kPictures = 3;

/// Frames of a pattern that moves a pixel to the right a frame, without a name that says more than `name`.
void writePictures(const QTemporaryDir& folder, const std::string& name) {
  for (int frame = 0; frame < kPictures; ++frame) {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const auto value = static_cast<std::uint8_t>(((x - frame + kSide) * 37 + y * 91) % 251);
        rgba.insert(rgba.end(), {value, static_cast<std::uint8_t>(value / 2), 128, 255});
      }
    writePng(std::filesystem::path(folder.path().toStdString()) /
                 (name + "_000" + std::to_string(frame + 1) + ".png"),
             kSide, kSide, rgba);
  }
}

class ImportPlanesTest : public testing::Test {
 protected:
  QTemporaryDir folder;
  QPointer<ImportPage> page = new ImportPage(nullptr);

  void TearDown() override { delete page; }

  void open(const std::vector<std::string>& names) {
    applyTheme(*qApp, ThemeChoice::Dark);
    for (const std::string& name : names) writePictures(folder, name);
    page->resize(1180, 760);
    page->show();
    page->openFolder(folder.path());
    page->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(page));
    settle();
    page->tabs()->setCurrentIndex(1);
  }
  void settle() {
    ASSERT_TRUE(waitFor([&] { return page->isComplete(); }));
  }
  QComboBox* box(PlaneKind kind) const { return page->planes()->row(kind)->box(); }
  FoundPictures* pictures() const { return page->planes()->pictures(); }
  /// Of a line of the pictures.
  QString taken(int line) const { return pictures()->topLevelItem(line)->text(0); }
  QPushButton* button(const char* name) const {
    return page->findChild<QPushButton*>(QString::fromLatin1(name));
  }
  QString problem() const { return page->findChild<QLabel*>(QStringLiteral("problem"))->text(); }
  std::string place(PlaneKind kind) const {
    const auto at = page->manifest().planes.find(kind);
    return at == page->manifest().planes.end() ? "" : at->second.file;
  }
  void press(QWidget* to, Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(to, key, modifiers);
    settle();
  }
  void type(PlaneKind kind, const QString& text) {
    box(kind)->setFocus();
    QTest::keyClick(box(kind), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(box(kind), text);
    press(box(kind), Qt::Key_Return);
  }
  /// Returns whether the row takes it.
  bool drop(const QMimeData& data, PlaneKind kind) {
    PlaneRow* row = page->planes()->row(kind);
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(row, &enter);
    if (!enter.isAccepted()) return false;
    QDropEvent event({5.0, 5.0}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(row, &event);
    settle();
    return true;
  }
};

} // namespace

TEST_F(ImportPlanesTest, AllPicturesAreListedWithWhatTheyAreTakenFor) {
  open({"rgb", "dmv"});
  ASSERT_EQ(pictures()->topLevelItemCount(), 2);
  EXPECT_EQ(taken(0), "not used");
  EXPECT_EQ(pictures()->topLevelItem(0)->text(1), "dmv_{frame:4}.png");
  EXPECT_EQ(pictures()->topLevelItem(0)->text(2), "R G B A");
  EXPECT_EQ(pictures()->topLevelItem(0)->text(3), "3");
  EXPECT_EQ(taken(1), "color");
  EXPECT_EQ(box(PlaneKind::Color)->currentText(), "rgb_{frame:4}.png:R,G,B,A");
  EXPECT_EQ(box(PlaneKind::Motion)->currentText(), "");
  EXPECT_EQ(box(PlaneKind::Motion)->itemText(0), "As found: no pictures");
  EXPECT_EQ(box(PlaneKind::Color)->findText("None of these"), -1) << "there is no capture without color";
  EXPECT_GE(box(PlaneKind::Motion)->findText("None of these"), 0);
}

TEST_F(ImportPlanesTest, KeysStateAPlaneAndUndoTakesItBackInOneStep) {
  open({"rgb", "dmv"});
  box(PlaneKind::Motion)->setFocus();
  press(box(PlaneKind::Motion), Qt::Key_Down);
  EXPECT_EQ(place(PlaneKind::Motion), "dmv_{frame:4}.png") << problem().toStdString();
  EXPECT_EQ(box(PlaneKind::Motion)->currentText(), "dmv_{frame:4}.png:R,G");
  EXPECT_TRUE(page->planes()->row(PlaneKind::Motion)->isStated());
  EXPECT_EQ(taken(0), "motion");
  const capture::Conventions ofMotion = page->manifest().conventions;
  press(box(PlaneKind::Motion), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(place(PlaneKind::Motion), "");
  EXPECT_EQ(box(PlaneKind::Motion)->currentText(), "");
  EXPECT_EQ(taken(0), "not used");
  press(page, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(place(PlaneKind::Motion), "dmv_{frame:4}.png");
  EXPECT_EQ(page->manifest().conventions, ofMotion);
  press(page, Qt::Key_R, Qt::ControlModifier);
  EXPECT_EQ(place(PlaneKind::Motion), "") << "the guess of all planes is without it";
  EXPECT_FALSE(page->planes()->row(PlaneKind::Motion)->isStated());
}

TEST_F(ImportPlanesTest, PicturesAreDraggedOntoAPlane) {
  open({"rgb", "dmv"});
  const QAbstractItemModel* model = pictures()->model();
  EXPECT_TRUE(pictures()->dragEnabled());
  const std::unique_ptr<QMimeData> dmv(model->mimeData({model->index(0, 0)}));
  EXPECT_TRUE(drop(*dmv, PlaneKind::Depth));
  EXPECT_EQ(place(PlaneKind::Depth), "dmv_{frame:4}.png") << problem().toStdString();
  EXPECT_EQ(box(PlaneKind::Depth)->currentText(), "dmv_{frame:4}.png:R");
  QMimeData other;
  other.setText("dmv_{frame:4}.png:R");
  EXPECT_FALSE(drop(other, PlaneKind::Motion)) << "a text is no picture";
}

TEST_F(ImportPlanesTest, WhatTheFilesLackIsSaidAndNothingIsLost) {
  open({"rgb", "dmv"});
  type(PlaneKind::Motion, "dmv_{frame:4}.png:G,Q");
  EXPECT_TRUE(problem().contains("has no channels for motion")) << problem().toStdString();
  EXPECT_EQ(box(PlaneKind::Motion)->currentText(), "dmv_{frame:4}.png:G,Q") << "to be mended";
  EXPECT_EQ(place(PlaneKind::Color), "rgb_{frame:4}.png") << "the guess before it stays";
  EXPECT_EQ(pictures()->topLevelItemCount(), 2);
  EXPECT_FALSE(button("open")->isEnabled()) << "what would be written is not what is stated";
  type(PlaneKind::Motion, "dmv_{frame:4}.png:G,B");
  EXPECT_EQ(problem(), "");
  EXPECT_TRUE(button("open")->isEnabled());
  EXPECT_EQ(page->manifest().planes.at(PlaneKind::Motion).channels, (std::vector<std::string>{"G", "B"}));
  press(page, Qt::Key_Z, Qt::ControlModifier);
  press(page, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(place(PlaneKind::Motion), "");
  EXPECT_TRUE(button("open")->isEnabled());
}

TEST_F(ImportPlanesTest, WhatIsStillBeingTypedIsStatedBeforeAnythingIsWritten) {
  open({"rgb", "dmv"});
  box(PlaneKind::Motion)->setFocus();
  QTest::keyClicks(box(PlaneKind::Motion), "dmv_{frame:4}.png:G,B");
  press(box(PlaneKind::Motion), Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(place(PlaneKind::Motion), "dmv_{frame:4}.png");
  EXPECT_TRUE(page && page->isVisible()) << "the guess of it is looked at first";
}

TEST_F(ImportPlanesTest, WithoutColorThePicturesAreThereToBeChosenFrom) {
  open({"velocity", "depth"});
  EXPECT_TRUE(page->manifest().frames.empty());
  EXPECT_TRUE(problem().contains("no pictures of color")) << problem().toStdString();
  EXPECT_EQ(page->tabs()->currentIndex(), 1);
  EXPECT_EQ(pictures()->topLevelItemCount(), 2);
  EXPECT_FALSE(button("open")->isEnabled());
  box(PlaneKind::Color)->setFocus();
  press(box(PlaneKind::Color), Qt::Key_Down);
  EXPECT_EQ(place(PlaneKind::Color), "depth_{frame:4}.png") << problem().toStdString();
  EXPECT_EQ(place(PlaneKind::Motion), "velocity_{frame:4}.png");
  EXPECT_TRUE(button("open")->isEnabled());
}

TEST_F(ImportPlanesTest, APlaneThatIsFoundCanBeTakenAway) {
  open({"rgb", "velocity"});
  ASSERT_EQ(place(PlaneKind::Motion), "velocity_{frame:4}.png");
  type(PlaneKind::Motion, "None of these");
  EXPECT_EQ(place(PlaneKind::Motion), "") << problem().toStdString();
  EXPECT_EQ(box(PlaneKind::Motion)->currentText(), "None of these");
  auto* label = page->planes()->row(PlaneKind::Motion)->findChild<ParameterLabel*>();
  QTest::mouseDClick(label, Qt::LeftButton);
  settle();
  EXPECT_EQ(place(PlaneKind::Motion), "velocity_{frame:4}.png") << "as it was found";
}

TEST_F(ImportPlanesTest, CutsNothingOfThePlanes) {
  open({"rgb", "dmv"});
  for (const QSize size : kWindowSizes) {
    SCOPED_TRACE(size.width());
    page->resize(size);
    QTest::qWait(100);
    EXPECT_EQ(page->size(), size);
    expectWholeTexts(*page);
    EXPECT_GE(pictures()->viewport()->height(), pictures()->sizeHintForRow(0)) << "a line is seen";
  }
}

TEST_F(ImportPlanesTest, OpensAnotherFolderWithoutWhatWasStatedOfThisOne) {
  open({"rgb", "dmv"});
  type(PlaneKind::Motion, "dmv_{frame:4}.png:G,B");
  const QTemporaryDir other;
  writePictures(other, "rgb");
  page->openFolder(other.path());
  settle();
  EXPECT_EQ(place(PlaneKind::Color), "rgb_{frame:4}.png");
  EXPECT_EQ(place(PlaneKind::Motion), "");
  EXPECT_FALSE(page->planes()->row(PlaneKind::Motion)->isStated());
  EXPECT_EQ(problem(), "");
}

} // namespace taa::app::test
