// The import page on small frames, with answers that are known.
#pragma once

#include "app/importing/ConventionRow.h"
#include "app/importing/ConventionTable.h"
#include "app/importing/FlickerCompare.h"
#include "app/importing/FramePanel.h"
#include "app/importing/ImportPage.h"
#include "app/importing/ResidualTable.h"
#include "app/widgets/PictureBox.h"
#include "tests/app/WindowFixture.h"
#include "tests/app/importing/KnownAnswers.h"
#include "tests/app/importing/SmallFrames.h"

#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QString>
#include <QTemporaryDir>
#include <QTreeWidget>

#include <filesystem>
#include <string_view>

namespace taa::app::test {

class ImportPageTest : public testing::Test {
 protected:
  QTemporaryDir folder;
  GuessLog guesses;
  QPointer<ImportPage> page = new ImportPage(nullptr, knownAnswers(guesses));
  QSignalSpy opened{page, &ImportPage::openRequested};

  void SetUp() override {
    applyTheme(*qApp, ThemeChoice::Dark);
    small_frames::writeFrames(path());
    page->resize(1024, 600);
    page->show();
    page->openFolder(folder.path());
    page->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(page));
    ASSERT_TRUE(waitFor([&] { return !shownColor().isNull(); }));
  }
  void TearDown() override { delete page; }

  std::filesystem::path path() const { return folder.path().toStdString(); }
  std::filesystem::path manifestFile() const { return path() / capture::kManifestName; }
  ConventionRow* row(std::string_view name) const { return page->table()->row(name); }
  QTreeWidget* residuals() const { return page->residuals()->table(); }
  QString residual(int line) const { return residuals()->topLevelItem(line)->text(1); }
  QImage shownColor() const { return page->frames()->flicker()->picture()->picture(); }
  QPushButton* button(const char* name) const {
    return page->findChild<QPushButton*>(QString::fromLatin1(name));
  }
  QString problem() const { return page->findChild<QLabel*>(QStringLiteral("problem"))->text(); }
  void key(QWidget* to, Qt::Key pressed, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(to, pressed, modifiers);
  }
  QLineEdit* field(std::string_view name) const { return qobject_cast<QLineEdit*>(row(name)->editor()); }
  /// In the place of what is there, and leaves the field as it is.
  void type(std::string_view name, const QString& text) {
    field(name)->setFocus();
    field(name)->selectAll();
    QTest::keyClicks(field(name), text);
  }
  void guessAgain() { button("again")->click(); }
  /// By the keys, as somebody without a mouse does.
  void chooseNext(std::string_view name) {
    row(name)->editor()->setFocus();
    key(row(name)->editor(), Qt::Key_Down);
  }
};

} // namespace taa::app::test
