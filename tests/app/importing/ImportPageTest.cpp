// The page through which frames of other engines come in: what it shows, changes and writes.
#include "app/importing/ImportPage.h"

#include "app/importing/ConventionRow.h"
#include "app/importing/ConventionTable.h"
#include "app/importing/FlickerCompare.h"
#include "app/importing/FramePanel.h"
#include "app/importing/PictureBox.h"
#include "app/importing/ResidualTable.h"
#include "app/window/Dialogs.h"
#include "core/base/Files.h"
#include "core/capture/planes/Planes.h"
#include "tests/app/WindowFixture.h"

#include <QAbstractScrollArea>
#include <QAccessible>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QUrl>

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

constexpr int kWidth = 16, kHeight = 8, kFrames = 3;

/// A picture without repetition within its width that moves one pixel to the right a frame.
float valueAt(int x, int frame) {
  const int place = x - frame + kFrames;
  return static_cast<float>((place * place * 7) % 19) / 19.0f;
}

capture::Manifest manifestOfFrames() {
  capture::Manifest manifest;
  manifest.name = "small";
  manifest.sizePx = {kWidth, kHeight};
  const auto set = [&](capture::PlaneKind kind, const std::string& file, capture::RawFormat raw) {
    manifest.planes[kind].file = file;
    manifest.planes[kind].raw = raw;
  };
  set(capture::PlaneKind::Color, "color.{frame:4}.raw", capture::RawFormat::RGBA32F);
  set(capture::PlaneKind::Motion, "motion.{frame:4}.raw", capture::RawFormat::RG32F);
  set(capture::PlaneKind::Depth, "depth.{frame:4}.raw", capture::RawFormat::R32F);
  manifest.frames.resize(kFrames);
  for (int frame = 0; frame < kFrames; ++frame)
    manifest.frames[static_cast<std::size_t>(frame)].number = frame + 10;
  return manifest;
}

capture::PlaneData planeOf(int channels) {
  capture::PlaneData plane;
  plane.width = kWidth;
  plane.height = kHeight;
  plane.image = Image(kWidth, kHeight, channels);
  return plane;
}

void writeFrames(const std::filesystem::path& folder) {
  const capture::Manifest manifest = manifestOfFrames();
  for (int frame = 0; frame < kFrames; ++frame) {
    capture::PlaneData color = planeOf(4), motion = planeOf(2), depth = planeOf(1);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        for (int channel = 0; channel < 3; ++channel) color.image.at(x, y)[channel] = valueAt(x, frame);
        color.image.at(x, y)[3] = 1.0f;
        motion.image.at(x, y)[0] = 1.0f;
        depth.image.at(x, y)[0] = 0.1f + 0.05f * static_cast<float>(y);
      }
    const auto write = [&](capture::PlaneKind kind, const capture::PlaneData& plane) {
      const capture::PlaneSource& source = manifest.planes.at(kind);
      capture::writeRawPlane(folder / capture::planeFile(source, frame + 10), plane, *source.raw);
    };
    write(capture::PlaneKind::Color, color);
    write(capture::PlaneKind::Motion, motion);
    write(capture::PlaneKind::Depth, depth);
  }
}

capture::Finding findingOn(const std::string& path, const std::string& question, bool isSure,
                           const std::vector<std::pair<std::string, double>>& answers) {
  capture::Finding finding;
  finding.question = question;
  finding.path = path;
  finding.isSure = isSure;
  finding.reason = "as the residuals say";
  for (const auto& [choice, residual] : answers) {
    capture::Hypothesis hypothesis;
    hypothesis.text = choice;
    hypothesis.assignments = {path + "=" + choice};
    hypothesis.residual = residual;
    finding.hypotheses.push_back(hypothesis);
  }
  return finding;
}

/// Residuals by what is stated, so that each change can be told by them.
std::vector<capture::Finding> findingsOf(const capture::Conventions& stated) {
  const double more = stated.motion.unit == capture::ScreenUnit::Pixels ? 0.0 : 5.0;
  return {findingOn("motion.direction", "Direction of motion", true,
                    {{"currentMinusPrevious", 10.0 + more}, {"previousMinusCurrent", 70.0 + more}}),
          findingOn("jitter.meaning", "Meaning of jitter", false, {{"content", 10.0}, {"sample", 10.1}})};
}

/// With what a guess was begun.
struct AskedGuess {
  std::string like;
  std::vector<std::string> assignments;
};

/// What the thread of the guesses is told and asks.
class GuessLog {
 public:
  void add(const AskedGuess& guess) {
    const std::lock_guard lock(mutex_);
    asked_.push_back(guess);
  }
  std::size_t count() const {
    const std::lock_guard lock(mutex_);
    return asked_.size();
  }
  /// Expects that there is one.
  AskedGuess last() const {
    const std::lock_guard lock(mutex_);
    return asked_.back();
  }
  /// What is guessed where no starting point is stated.
  void setLike(const std::string& id) {
    const std::lock_guard lock(mutex_);
    like_ = id;
  }
  std::string like() const {
    const std::lock_guard lock(mutex_);
    return like_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<AskedGuess> asked_;
  std::string like_;
};

ImportFunctions knownAnswers(GuessLog& log) {
  ImportFunctions functions;
  functions.guess = [&log](const std::filesystem::path&, const std::string& like,
                           const std::vector<std::string>& assignments, const Progress& progress) {
    log.add({like, assignments});
    report(progress, "Guessing", 0, 1);
    capture::Guess guess;
    guess.manifest = manifestOfFrames();
    guess.manifest.like = like.empty() ? log.like() : like;
    for (const std::string& assignment : assignments)
      capture::applyAssignment(guess.manifest.conventions, assignment);
    guess.findings = findingsOf(guess.manifest.conventions);
    guess.sure = {"motion points forward"};
    guess.unsure = {"what jitter means"};
    guess.missing = {"no matrices"};
    return guess;
  };
  functions.measure = [](const std::filesystem::path&, const capture::Manifest& manifest, const Progress&) {
    return findingsOf(manifest.conventions);
  };
  return functions;
}

class ImportPageTest : public testing::Test {
 protected:
  QTemporaryDir folder;
  GuessLog guesses;
  QPointer<ImportPage> page = new ImportPage(nullptr, knownAnswers(guesses));
  QSignalSpy opened{page, &ImportPage::openRequested};

  void SetUp() override {
    applyTheme(*qApp, ThemeChoice::Dark);
    writeFrames(path());
    page->resize(1024, 600);
    page->show();
    page->openFolder(folder.path());
    page->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(page));
    ASSERT_TRUE(test::waitFor([&] { return !shownColor().isNull(); }));
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

} // namespace

TEST_F(ImportPageTest, ShowsWhatIsSureAndWhatIsNot) {
  EXPECT_EQ(row("motion.direction")->verdict(), Verdict::Sure);
  EXPECT_EQ(row("jitter.meaning")->verdict(), Verdict::NotSure);
  EXPECT_EQ(row("depth.kind")->verdict(), Verdict::NotMeasured);
  ASSERT_EQ(residuals()->topLevelItemCount(), 2);
  EXPECT_EQ(residual(0), "10");
  EXPECT_EQ(residual(1), "70");
  EXPECT_FALSE(residuals()->topLevelItem(0)->text(2).isEmpty()) << "what is stated is marked";
  EXPECT_TRUE(residuals()->topLevelItem(1)->text(2).isEmpty());
  const auto* sentences = page->findChild<QListWidget*>(QStringLiteral("sentences"));
  ASSERT_EQ(sentences->count(), 3);
  EXPECT_TRUE(sentences->item(0)->text().contains("what jitter means"));
  EXPECT_TRUE(sentences->item(1)->text().contains("no matrices"));
  EXPECT_FALSE(row("motion.direction")->isChanged());
  EXPECT_EQ(problem(), "");
}

TEST_F(ImportPageTest, AChangeByKeysIsMeasuredAgainAndCanBeUndone) {
  chooseNext("motion.unit");
  EXPECT_EQ(page->manifest().conventions.motion.unit, capture::ScreenUnit::Uv);
  EXPECT_TRUE(row("motion.unit")->isChanged());
  EXPECT_TRUE(test::waitFor([&] { return residual(0) == "15"; })) << residual(0).toStdString();
  key(page, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(page->manifest().conventions.motion.unit, capture::ScreenUnit::Pixels);
  EXPECT_FALSE(row("motion.unit")->isChanged());
  EXPECT_TRUE(test::waitFor([&] { return residual(0) == "10"; }));
  key(page, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(page->manifest().conventions.motion.unit, capture::ScreenUnit::Uv);
  key(page, Qt::Key_R, Qt::ControlModifier);
  EXPECT_EQ(page->manifest().conventions, capture::Conventions{});
}

TEST_F(ImportPageTest, TheQuestionOfTheRowIsShown) {
  row("jitter.meaning")->editor()->setFocus();
  EXPECT_EQ(page->residuals()->questions()->currentText(), "Meaning of jitter");
  EXPECT_EQ(residual(1), "10.1");
}

TEST_F(ImportPageTest, AHypothesisIsTakenByEnter) {
  residuals()->setFocus();
  residuals()->setCurrentItem(residuals()->topLevelItem(1));
  key(residuals(), Qt::Key_Return);
  EXPECT_EQ(page->manifest().conventions.motion.direction, capture::MotionDirection::PreviousMinusCurrent);
  EXPECT_EQ(row("motion.direction")->verdict(), Verdict::Contradicted) << "the pixels say otherwise";
  EXPECT_FALSE(residuals()->topLevelItem(1)->text(2).isEmpty());
}

TEST_F(ImportPageTest, AnotherStartingPointIsAChangeLikeAnyOther) {
  auto* like = page->findChild<QComboBox*>(QStringLiteral("like"));
  like->setFocus();
  key(like, Qt::Key_Down);
  key(like, Qt::Key_Down);
  const std::string id = like->currentData().toString().toStdString();
  EXPECT_EQ(page->manifest().conventions, capture::startingPoint(id).conventions);
  EXPECT_EQ(page->manifest().like, id);
  key(page, Qt::Key_R, Qt::ControlModifier);
  EXPECT_EQ(page->manifest().conventions, capture::Conventions{});
  EXPECT_EQ(like->currentIndex(), 0);
}

TEST_F(ImportPageTest, ATextThatIsNoNumberIsSaidAndNothingChanges) {
  auto* field = qobject_cast<QLineEdit*>(row("motion.scaleX")->editor());
  ASSERT_TRUE(field);
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "many");
  key(field, Qt::Key_Return);
  EXPECT_TRUE(problem().contains("motion.scaleX")) << problem().toStdString();
  EXPECT_EQ(field->text(), "1");
  EXPECT_EQ(page->manifest().conventions, capture::Conventions{});
  field->selectAll();
  QTest::keyClicks(field, "-2");
  key(field, Qt::Key_Return);
  EXPECT_EQ(page->manifest().conventions.motion.scale.x, -2.0);
  EXPECT_EQ(problem(), "");
}

TEST_F(ImportPageTest, WhatCannotBeIsSaidAndCannotBeOpened) {
  auto* field = qobject_cast<QLineEdit*>(row("motion.scaleX")->editor());
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, "0");
  key(field, Qt::Key_Return);
  EXPECT_TRUE(problem().contains("motion.scaleX")) << problem().toStdString();
  EXPECT_FALSE(button("open")->isEnabled());
  key(page, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(button("open")->isEnabled());
}

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
  EXPECT_TRUE(test::waitFor([&] { return shownColor().pixel(5, 3) != none; })) << "drawn again";
}

TEST_F(ImportPageTest, AlternatesUntilItIsStopped) {
  FlickerCompare* flicker = page->frames()->flicker();
  QTest::mouseClick(flicker->alternateButton(), Qt::LeftButton);
  ASSERT_TRUE(flicker->isAlternating());
  EXPECT_TRUE(test::waitFor([&] { return flicker->shown() == FlickerCompare::Shown::Warped; }));
  EXPECT_TRUE(test::waitFor([&] { return flicker->shown() == FlickerCompare::Shown::Current; }));
  QTest::mouseClick(flicker->alternateButton(), Qt::LeftButton);
  EXPECT_FALSE(flicker->isAlternating());
}

TEST_F(ImportPageTest, AnotherFrameIsDrawn) {
  const QString caption = page->frames()->flicker()->picture()->caption();
  EXPECT_EQ(page->frames()->slider()->value(), 1);
  key(page, Qt::Key_Right, Qt::AltModifier);
  EXPECT_EQ(page->frames()->slider()->value(), 2);
  EXPECT_TRUE(test::waitFor([&] { return page->frames()->flicker()->picture()->caption() != caption; }));
  EXPECT_TRUE(page->frames()->flicker()->picture()->caption().contains("12")) << "the engine's number";
  page->frames()->slider()->setValue(0);
  EXPECT_TRUE(test::waitFor([&] { return !page->frames()->flicker()->otherButton()->isEnabled(); }))
      << "there is none before the first";
}

TEST_F(ImportPageTest, OpenWritesWhatIsShown) {
  chooseNext("motion.unit");
  key(page, Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(test::waitFor([&] { return opened.count() == 1; }));
  EXPECT_EQ(opened[0][0].toString(), folder.path());
  EXPECT_EQ(capture::readManifest(path()).conventions.motion.unit, capture::ScreenUnit::Uv);
  EXPECT_TRUE(test::waitFor([&] { return !page || !page->isVisible(); }));
}

TEST_F(ImportPageTest, WhatIsStillBeingTypedIsWritten) {
  type("motion.scaleX", "-2");
  key(field("motion.scaleX"), Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(test::waitFor([&] { return opened.count() == 1; }));
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

TEST_F(ImportPageTest, AGuessThatArrivesLeavesWhatIsBeingTyped) {
  guessAgain();
  type("motion.scaleX", "-2");
  guesses.setLike("three");
  guessAgain(); // which takes what was typed
  type("motion.scaleX", "-3");
  ASSERT_TRUE(test::waitFor([&] { return page->manifest().like == "three"; }));
  EXPECT_EQ(page->manifest().conventions.motion.scale.x, -2.0);
  EXPECT_EQ(field("motion.scaleX")->text(), "-3");
  key(page, Qt::Key_R, Qt::ControlModifier);
  EXPECT_EQ(field("motion.scaleX")->text(), "-2") << "reset drops it";
}

TEST_F(ImportPageTest, WhatWasChangedIsNotQuestionedByAnyLaterGuess) {
  chooseNext("motion.unit");
  for (const std::size_t count : {2u, 3u}) {
    guessAgain();
    ASSERT_TRUE(test::waitFor([&] { return guesses.count() == count; }));
    EXPECT_EQ(guesses.last().assignments, std::vector<std::string>{"motion.unit=uv"});
    QTest::qWait(100);
  }
}

TEST_F(ImportPageTest, AChangeDuringAGuessBeginsItAgain) {
  guessAgain();
  chooseNext("motion.unit");
  EXPECT_TRUE(test::waitFor(
      [&] { return guesses.last().assignments == std::vector<std::string>{"motion.unit=uv"}; }));
}

TEST_F(ImportPageTest, AnotherFolderIsNotBegunLikeTheOneBefore) {
  guesses.setLike("three");
  guessAgain();
  ASSERT_TRUE(test::waitFor([&] { return page->manifest().like == "three"; }));
  guessAgain();
  ASSERT_TRUE(test::waitFor([&] { return guesses.count() == 3; }));
  EXPECT_EQ(guesses.last().like, "") << "three.js was guessed, and nobody stated it";
  page->openFolder(folder.path());
  ASSERT_TRUE(test::waitFor([&] { return guesses.count() == 4; }));
  EXPECT_EQ(guesses.last().like, "");
}

TEST_F(ImportPageTest, FramesThatWereWrittenAgainAreReadAgain) {
  const QImage before = shownColor();
  std::filesystem::copy_file(path() / "color.0012.raw", path() / "color.0011.raw",
                             std::filesystem::copy_options::overwrite_existing);
  guessAgain();
  EXPECT_TRUE(test::waitFor([&] { return shownColor() != before; }));
}

TEST_F(ImportPageTest, WhatIsNotDrawnIsNotSaidToBeMissing) {
  ASSERT_FALSE(std::filesystem::remove_all(path() / "motion.0011.raw") == 0);
  page->openFolder(folder.path());
  ASSERT_TRUE(test::waitFor([&] { return !problem().isEmpty(); })) << "frame 11 cannot be read";
  for (const PictureBox* box : page->findChildren<PictureBox*>()) {
    EXPECT_TRUE(box->picture().isNull());
    EXPECT_FALSE(box->accessibleDescription().contains("There is no")) << box->caption().toStdString();
  }
}

TEST_F(ImportPageTest, AlternatingRestsWhereThereIsNoFrameBefore) {
  FlickerCompare* flicker = page->frames()->flicker();
  flicker->setAlternating(true);
  page->frames()->slider()->setValue(0);
  ASSERT_TRUE(test::waitFor([&] { return !flicker->otherButton()->isEnabled(); }));
  for (int i = 0; i < 4; ++i) {
    QTest::qWait(150);
    EXPECT_FALSE(shownColor().isNull()) << "the frame itself is there";
  }
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
  ASSERT_TRUE(test::waitFor([&] { return opened.count() == 1; }));
  EXPECT_EQ(capture::readManifest(path()).name, "small");
}

TEST_F(ImportPageTest, TheFramesComeAlongIntoAnotherFolder) {
  const QTemporaryDir other;
  key(page, Qt::Key_S, Qt::ControlModifier);
  auto* dialog = page->findChild<QFileDialog*>();
  ASSERT_TRUE(dialog);
  Q_EMIT dialog->fileSelected(other.path());
  dialog->close();
  ASSERT_TRUE(test::waitFor([&] { return opened.count() == 1; }));
  EXPECT_EQ(opened[0][0].toString(), other.path());
  const std::filesystem::path there = other.path().toStdString();
  const capture::Manifest manifest = capture::readManifest(there);
  EXPECT_EQ(capture::readPlanes(there, manifest, manifest.frames[2]).size(), 3u);
  EXPECT_FALSE(std::filesystem::exists(manifestFile())) << "nothing is written beside the frames";
}

TEST_F(ImportPageTest, EveryControlHasAName) {
  for (const QWidget* widget : page->findChildren<QWidget*>()) {
    const auto* area = qobject_cast<const QAbstractScrollArea*>(widget->parentWidget());
    const bool isInside = area && area->viewport() == widget;
    if (isInside || (widget->focusPolicy() & Qt::TabFocus) == 0 || widget->focusProxy() || widget->isWindow())
      continue;
    const QAccessibleInterface* voice = QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
    ASSERT_NE(voice, nullptr);
    EXPECT_FALSE(voice->text(QAccessible::Name).trimmed().isEmpty())
        << widget->metaObject()->className() << " " << widget->objectName().toStdString();
  }
}

TEST_F(ImportPageTest, FitsIntoASmallScreen) {
  page->resize(1024, 600);
  QTest::qWait(30);
  EXPECT_EQ(page->size(), QSize(1024, 600));
  const QRect inside = page->rect();
  for (const char* name : {"open", "save", "cancel", "reset", "applyHypothesis", "alternate", "difference"}) {
    const QPushButton* each = button(name);
    ASSERT_TRUE(each) << name;
    EXPECT_TRUE(inside.contains(QRect(each->mapTo(page, QPoint(0, 0)), each->size()))) << name;
    EXPECT_GE(each->width(), each->minimumSizeHint().width()) << name;
  }
}

TEST(ImportPage, EscStopsAGuessBeforeItClosesThePage) {
  const QTemporaryDir folder;
  GuessLog guesses;
  ImportFunctions functions = knownAnswers(guesses);
  functions.guess = [](const std::filesystem::path&, const std::string&, const std::vector<std::string>&,
                       const Progress& progress) -> capture::Guess {
    while (true) report(progress, "Guessing", 0, 1);
  };
  const QPointer<ImportPage> page = new ImportPage(nullptr, functions);
  page->show();
  page->openFolder(folder.path());
  page->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(page));
  QTest::qWait(100);
  QTest::keyClick(page, Qt::Key_Escape);
  EXPECT_TRUE(page->isVisible());
  EXPECT_FALSE(page->findChild<QLabel*>(QStringLiteral("problem"))->text().isEmpty());
  QTest::keyClick(page, Qt::Key_Escape);
  EXPECT_TRUE(test::waitFor([&] { return !page || !page->isVisible(); }));
  delete page;
}

// With the answers of the pixels themselves.
TEST(ImportPage, RealFramesAreGuessed) {
  const std::filesystem::path data = std::filesystem::path(TAA_SHARED_DATA) / "capture-blender";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << data << " is not there";
  const QPointer<ImportPage> page = new ImportPage(nullptr);
  page->show();
  page->openFolder(QString::fromStdString(std::filesystem::absolute(data).string()));
  EXPECT_TRUE(test::waitFor([&] { return !page->manifest().frames.empty(); }));
  EXPECT_TRUE(test::waitFor([&] { return !page->frames()->flicker()->picture()->picture().isNull(); }));
  EXPECT_GT(page->residuals()->questions()->count(), 0);
  delete page;
}

class ImportInWindow : public test::FakeWindow {
 protected:
  /// A folder that the fake renderer takes for a capture, which is one.
  static std::string captureIn(const QTemporaryDir& place) {
    const std::string folder = place.path().toStdString() + test::kFakeCapture;
    std::filesystem::create_directories(folder);
    writeFrames(folder);
    writeFile(std::filesystem::path(folder) / capture::kManifestName,
              capture::manifestText(manifestOfFrames()));
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
  EXPECT_TRUE(test::waitFor([&] { return !problem->text().isEmpty(); })) << "there is nothing to import";
  page->close();
}

TEST_F(ImportInWindow, ADroppedCaptureOpensAtOnce) {
  const QTemporaryDir place;
  const std::string folder = captureIn(place);
  drop(QString::fromStdString(folder));
  EXPECT_FALSE(window.findChild<ImportPage*>());
  EXPECT_EQ(renderer->status.source, folder);
}

// As a picture of the window asks for it, which is taken when all is there.
TEST_F(ImportInWindow, IsOpenedByItsNameOnTheCaptureThatIsOpen) {
  const QTemporaryDir place;
  drop(QString::fromStdString(captureIn(place)));
  window.openDialog("import");
  auto* page = window.findChild<ImportPage*>();
  ASSERT_TRUE(page && page->isVisible());
  EXPECT_FALSE(areDialogsComplete()) << "the page has not looked at its frames yet";
  ASSERT_TRUE(test::waitFor([] { return areDialogsComplete(); }));
  EXPECT_EQ(page->manifest().frames.size(), kFrames);
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
