// Checking the driver from the window, by checks whose outcome is written by hand.
#include "app/dialogs/VerifyDialog.h"

#include "app/background/BackgroundBar.h"
#include "core/base/Error.h"
#include "tests/app/WindowFixture.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QPointer>
#include <QPushButton>
#include <QTreeWidget>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <string>

namespace taa::app::test {
namespace {

/// α is outside in one of a hundred values, N in none.
DriverCheck checkWithOneOutside() {
  DriverCheck check{"a driver, 4.5", {}};
  RowVerification right{.id = IntermediateId::historyLength, .values = 50, .equal = 50, .widestUlp = 6.0};
  RowVerification wrong{.id = IntermediateId::alpha, .values = 100, .equal = 99, .outside = 1};
  wrong.example = OutsideValue{{11, 6}, 0, 0.5f, {0.25f, 0.25f, 0.25f}};
  check.verification.rows = {right, wrong};
  return check;
}

class VerifyDialogTest : public FakeWindow {
 protected:
  void SetUp() override {
    FakeWindow::SetUp();
    dialog_ = new VerifyDialog(&window, [this](const Progress& progress) {
      if (fails_) throw Error("the driver is gone");
      while (isHeld_) report(progress, "Verifying presets", 3, 33);
      return checkWithOneOutside();
    });
    dialog_->show();
  }
  void TearDown() override { delete dialog_; } // its thread uses what is below

  QPushButton* button(const QString& text) const {
    for (QPushButton* each : dialog_->findChildren<QPushButton*>())
      if (each->text() == text) return each;
    return nullptr;
  }

  QPointer<VerifyDialog> dialog_;
  std::atomic<bool> fails_ = false, isHeld_ = false;
};

TEST_F(VerifyDialogTest, ShowsWhatIsOutsideFirstAndSaysIt) {
  EXPECT_FALSE(button("Copy")->isEnabled());
  QTest::mouseClick(button("Check"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return dialog_->rows()->topLevelItemCount() == 2; }));
  const QTreeWidgetItem* first = dialog_->rows()->topLevelItem(0);
  EXPECT_EQ(first->text(0), "alpha");
  EXPECT_EQ(first->text(3), "1");
  EXPECT_TRUE(first->toolTip(0).contains("pixel 11, 6: 0.5, allowed 0.25"))
      << first->toolTip(0).toStdString();
  ASSERT_TRUE(waitFor([&] { return dialog_->bar()->note().contains("1 of 150 values lie outside"); }));
}

TEST_F(VerifyDialogTest, CopiesWhatToSend) {
  QTest::mouseClick(button("Check"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return button("Copy")->isEnabled(); }));
  QTest::mouseClick(button("Copy"), Qt::LeftButton);
  const auto json = nlohmann::json::parse(QGuiApplication::clipboard()->text().toStdString());
  EXPECT_EQ(json.at("driver"), "a driver, 4.5");
  EXPECT_EQ(json.at("outside"), 1);
  EXPECT_EQ(json.at("rows").at(1).at("example").at("pixel").at(0), 11);
}

TEST_F(VerifyDialogTest, IsEndedByEscapeBeforeItCloses) {
  isHeld_ = true;
  QTest::mouseClick(button("Check"), Qt::LeftButton);
  ASSERT_NE(button("Stop"), nullptr);
  ASSERT_TRUE(waitFor([&] { return dialog_->bar()->note().contains(" of 3"); }));
  QTest::keyClick(dialog_.data(), Qt::Key_Escape);
  EXPECT_TRUE(dialog_->isVisible());
  ASSERT_TRUE(waitFor([&] { return dialog_->bar()->note().contains("ended before"); }));
  QTest::keyClick(dialog_.data(), Qt::Key_Escape);
  EXPECT_FALSE(dialog_->isVisible());
}

TEST_F(VerifyDialogTest, SaysWhyThereIsNothing) {
  fails_ = true;
  QTest::mouseClick(button("Check"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return dialog_->bar()->note().contains("the driver is gone"); }));
  EXPECT_TRUE(dialog_->text().isEmpty());
}

} // namespace
} // namespace taa::app::test
