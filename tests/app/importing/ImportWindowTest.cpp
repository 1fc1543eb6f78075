// Ways into the import page from the window, and past it.
#include "tests/app/importing/ImportFixture.h"

#include "app/importing/PlaneRow.h"
#include "app/panels/MessagesBar.h"
#include "app/window/Dialogs.h"
#include "core/base/Files.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QMimeData>
#include <QTabBar>
#include <QUrl>

#include <algorithm>
#include <filesystem>
#include <string>

namespace taa::app::test {

class ImportInWindow : public FakeWindow {
 protected:
  /// A folder that the fake renderer takes for a capture, which is one.
  static std::string captureIn(const QTemporaryDir& place) {
    const std::string folder = place.path().toStdString() + kFakeCapture;
    std::filesystem::create_directories(folder);
    small_frames::writeFrames(folder);
    writeFile(std::filesystem::path(folder) / capture::kManifestName,
              capture::manifestText(small_frames::manifestOfFrames()));
    return folder;
  }
  void drop(const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &event);
    settle();
  }
  /// As if chosen in the dialog of File ▸ Open capture.
  void openCapture(const QString& folder) {
    for (QAction* each : window.findChildren<QAction*>())
      if (each->text() == "Open &capture…") each->trigger();
    auto* dialog = window.findChild<QFileDialog*>();
    ASSERT_TRUE(dialog);
    EXPECT_EQ(dialog->fileMode(), QFileDialog::Directory);
    Q_EMIT dialog->fileSelected(folder);
    dialog->close();
    settle();
  }
};

TEST_F(ImportInWindow, ADroppedFolderOfFramesOpensThePage) {
  const QTemporaryDir folder;
  writeFile(std::filesystem::path(folder.path().toStdString()) / "notes.txt", "no frames");
  drop(folder.path());
  auto* page = window.findChild<ImportPage*>();
  ASSERT_TRUE(page && page->isVisible());
  EXPECT_FALSE(page->isModal()) << "the window can be used on";
  EXPECT_EQ(page->size(), page->sizeHint().boundedTo(window.size()));
  const auto* problem = page->findChild<QLabel*>(QStringLiteral("problem"));
  EXPECT_TRUE(waitFor([&] { return !problem->text().isEmpty(); })) << "there is nothing to import";
  page->close();
}

TEST_F(ImportInWindow, AtTwoHundredPercentThePageIsNoLargerThanTheWindow) {
  const QTemporaryDir folder;
  small_frames::writeFrames(folder.path().toStdString());
  window.setTextPercent(200);
  settle();
  drop(folder.path());
  auto* page = window.findChild<ImportPage*>();
  ASSERT_TRUE(page && page->isVisible());
  EXPECT_LE(page->width(), window.width());
  EXPECT_LE(page->height(), window.height());
  const auto* table = page->findChild<ConventionTable*>();
  EXPECT_GE(table->viewport()->width(), table->widget()->minimumSizeHint().width()) << "rows are whole";
  page->tabs()->setCurrentIndex(1);
  settle();
  for (const PlaneRow* row : page->findChildren<PlaneRow*>())
    EXPECT_GE(row->parentWidget()->parentWidget()->width(), row->x() + row->minimumSizeHint().width());
  EXPECT_LE(page->height(), window.height());
  page->close();
  window.setTextPercent(100);
}

TEST_F(ImportInWindow, VerdictsHaveTheColorsOfAnotherTheme) {
  const QTemporaryDir folder;
  small_frames::writeFrames(folder.path().toStdString());
  drop(folder.path());
  auto* page = window.findChild<ImportPage*>();
  ASSERT_TRUE(page && page->isVisible());
  const auto isOf = [&](const QColor& color) {
    const auto labels = page->findChild<ConventionRow*>()->findChildren<QLabel*>();
    return std::ranges::any_of(labels, [&](const QLabel* label) {
      return label->text().contains("not measured") && label->text().contains(color.name());
    });
  };
  EXPECT_TRUE(isOf(darkColors().secondary));
  window.setTheme(ThemeChoice::Light);
  settle();
  EXPECT_TRUE(isOf(lightColors().secondary));
  window.setTheme(ThemeChoice::Dark);
  page->close();
}

TEST_F(ImportInWindow, ADroppedCaptureOpensAtOnce) {
  const QTemporaryDir place;
  const std::string folder = captureIn(place);
  drop(QString::fromStdString(folder));
  EXPECT_FALSE(window.findChild<ImportPage*>());
  EXPECT_EQ(renderer->status.source, folder);
}

// What its pixels say is to be seen before anything is made of it.
TEST_F(ImportInWindow, OpenCaptureShowsThePageWhereThereIsNoManifest) {
  const QTemporaryDir folder;
  small_frames::writeFrames(folder.path().toStdString());
  openCapture(folder.path());
  auto* page = window.findChild<ImportPage*>();
  ASSERT_TRUE(page && page->isVisible());
  EXPECT_EQ(renderer->status.source, "builtin:fan") << "nothing is opened yet";
  page->close();
}

TEST_F(ImportInWindow, OpenCaptureOpensACaptureAtOnce) {
  const QTemporaryDir place;
  const std::string folder = captureIn(place);
  openCapture(QString::fromStdString(folder));
  EXPECT_FALSE(window.findChild<ImportPage*>());
  EXPECT_EQ(renderer->status.source, folder);
}

TEST_F(ImportInWindow, WarningsOfACaptureAreSentences) {
  renderer->status.warnings = {"conventions were guessed", "Written by hand."};
  const QTemporaryDir place;
  drop(QString::fromStdString(captureIn(place)));
  EXPECT_EQ(window.findChild<MessagesBar*>()->text(), "Conventions were guessed.\nWritten by hand.");
}

// As a picture of the window asks for it, which is taken when all is there.
TEST_F(ImportInWindow, IsOpenedByItsNameOnTheCaptureThatIsOpen) {
  const QTemporaryDir place;
  drop(QString::fromStdString(captureIn(place)));
  window.openDialog("import");
  auto* page = window.findChild<ImportPage*>();
  ASSERT_TRUE(page && page->isVisible());
  EXPECT_FALSE(areDialogsComplete()) << "the page has not looked at its frames yet";
  ASSERT_TRUE(waitFor([] { return areDialogsComplete(); }));
  EXPECT_EQ(page->manifest().frames.size(), small_frames::kFrames);
  EXPECT_FALSE(page->frames()->flicker()->picture()->picture().isNull());
  page->close();
}

TEST_F(ImportInWindow, IsOpenedByItsNameWithoutFramesWhereASceneIsOpen) {
  window.openDialog("import");
  auto* page = window.findChild<ImportPage*>();
  ASSERT_TRUE(page && page->isVisible());
  EXPECT_TRUE(areDialogsComplete());
  EXPECT_TRUE(page->manifest().frames.empty());
  page->close();
}

TEST_F(ImportInWindow, TheMenuAsksForAFolder) {
  key(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
  auto* dialog = window.findChild<QFileDialog*>();
  ASSERT_TRUE(dialog);
  EXPECT_EQ(dialog->fileMode(), QFileDialog::Directory);
  dialog->close();
}

} // namespace taa::app::test
