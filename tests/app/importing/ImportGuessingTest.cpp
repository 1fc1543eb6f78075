// What the import page asks the pixels, when, and with what it was told beside them.
#include "tests/app/importing/ImportFixture.h"

#include <QComboBox>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace taa::app::test {

TEST_F(ImportPageTest, AGuessThatArrivesLeavesWhatIsBeingTyped) {
  guessAgain();
  type("motion.scaleX", "-2");
  guesses.setLike("three");
  guessAgain(); // which takes what was typed
  type("motion.scaleX", "-3");
  ASSERT_TRUE(waitFor([&] { return page->manifest().like == "three"; }));
  EXPECT_EQ(page->manifest().conventions.motion.scale.x, -2.0);
  EXPECT_EQ(field("motion.scaleX")->text(), "-3");
  key(page, Qt::Key_R, Qt::ControlModifier);
  EXPECT_EQ(field("motion.scaleX")->text(), "-2") << "reset drops it";
}

TEST_F(ImportPageTest, WhatWasChangedIsNotQuestionedByAnyLaterGuess) {
  chooseNext("motion.unit");
  for (const std::size_t count : {2u, 3u}) {
    guessAgain();
    ASSERT_TRUE(waitFor([&] { return guesses.count() == count; }));
    EXPECT_EQ(guesses.last().assignments, std::vector<std::string>{"motion.unit=uv"});
    QTest::qWait(100);
  }
}

TEST_F(ImportPageTest, AChangeDuringAGuessBeginsItAgain) {
  guessAgain();
  chooseNext("motion.unit");
  EXPECT_TRUE(
      waitFor([&] { return guesses.last().assignments == std::vector<std::string>{"motion.unit=uv"}; }));
}

TEST_F(ImportPageTest, AnotherFolderIsNotBegunLikeTheOneBefore) {
  guesses.setLike("three");
  guessAgain();
  ASSERT_TRUE(waitFor([&] { return page->manifest().like == "three"; }));
  guessAgain();
  ASSERT_TRUE(waitFor([&] { return guesses.count() == 3; }));
  EXPECT_EQ(guesses.last().like, "") << "three.js was guessed, and nobody stated it";
  page->openFolder(folder.path());
  ASSERT_TRUE(waitFor([&] { return guesses.count() == 4; }));
  EXPECT_EQ(guesses.last().like, "");
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
  EXPECT_TRUE(waitFor([&] { return !page || !page->isVisible(); }));
  delete page;
}

// With the answers of the pixels themselves.
TEST(ImportPage, RealFramesAreGuessed) {
  const std::filesystem::path data = std::filesystem::path(TAA_SHARED_DATA) / "capture-blender";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << data << " is not there";
  const QPointer<ImportPage> page = new ImportPage(nullptr);
  page->show();
  page->openFolder(QString::fromStdString(std::filesystem::absolute(data).string()));
  EXPECT_TRUE(waitFor([&] { return !page->manifest().frames.empty(); }));
  EXPECT_TRUE(waitFor([&] { return !page->frames()->flicker()->picture()->picture().isNull(); }));
  EXPECT_GT(page->residuals()->questions()->count(), 0);
  delete page;
}

} // namespace taa::app::test
