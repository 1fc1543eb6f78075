// Where a number of the settings matters, in the window, by maps that are made by hand.
#include "app/dialogs/MapDialog.h"

#include "app/background/BackgroundBar.h"
#include "app/session/ProbeChoices.h"
#include "app/widgets/PictureBox.h"
#include "core/base/Error.h"
#include "tests/app/WindowFixture.h"

#include <QComboBox>
#include <QPointer>
#include <QPushButton>
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <string>

namespace taa::app::test {
namespace {

/// Two pixels: the right one gets brighter by 0.5.
SensitivityMap mapOf(const std::string& path) {
  static const std::string kGamma = "neighborhood.gamma";
  SensitivityMap map{{.to = SensitivityTo::Parameter, .path = kGamma, .value = 1.0}, Image(2, 1, 3)};
  EXPECT_EQ(path, kGamma);
  for (int channel = 0; channel < 3; ++channel) map.change.at(1, 0)[channel] = 0.5f;
  map.share = map.largest = 0.5;
  map.mean = 0.25;
  map.largestAt = {1, 0};
  return map;
}

class MapDialogTest : public FakeWindow {
 protected:
  void SetUp() override {
    FakeWindow::SetUp();
    dialog_ = new MapDialog(session, &window, [this](const MapRequest& request, const Progress& progress) {
      {
        const std::lock_guard lock(mutex_);
        request_ = request;
      }
      while (isHeld_) report(progress, "Following the number", 1, 3);
      return mapOf(request.path);
    });
    dialog_->show();
    choose("neighborhood.gamma");
  }
  void TearDown() override { delete dialog_; } // its thread uses what is below

  void choose(const char* path) {
    const int index = dialog_->numbers()->findData(QString::fromLatin1(path));
    ASSERT_GE(index, 0) << path;
    dialog_->numbers()->setCurrentIndex(index);
  }
  QPushButton* button(const QString& text) const {
    for (QPushButton* each : dialog_->findChildren<QPushButton*>())
      if (each->text() == text) return each;
    return nullptr;
  }

  QPointer<MapDialog> dialog_;
  std::atomic<bool> isHeld_ = false;
  MapRequest request_;
  std::mutex mutex_;
};

TEST_F(MapDialogTest, OffersNumbersThatHaveAnEffect) {
  QComboBox* numbers = dialog_->numbers();
  EXPECT_GE(numbers->findData("weight.minimum"), 0);
  EXPECT_LT(numbers->findData("neighborhood.gammaMoving"), 0) << "motion does not change γ";
  EXPECT_LT(numbers->findData("jitter.scale"), 0) << "what is drawn has no slope";
}

TEST_F(MapDialogTest, DrawsTheFrameOnShowAndSaysWhatMoves) {
  session.seek(3);
  settle();
  QTest::mouseClick(button("Draw"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return dialog_->bar()->note().contains("in 50 % of the pixels"); }));
  EXPECT_EQ(request_.shot.source, "builtin:fan");
  EXPECT_EQ(request_.shot.frame, 3);
  const QImage& drawn = dialog_->picture()->picture();
  ASSERT_EQ(drawn.size(), QSize(2, 1));
  EXPECT_EQ(qRed(drawn.pixel(0, 0)), qBlue(drawn.pixel(0, 0))) << "gray: it stays";
  EXPECT_GT(qRed(drawn.pixel(1, 0)), qBlue(drawn.pixel(1, 0))) << "orange: brighter";
  EXPECT_TRUE(dialog_->picture()->caption().startsWith("Frame 3."))
      << dialog_->picture()->caption().toStdString();
}

TEST_F(MapDialogTest, ProbesThePixelThatMovesMost) {
  EXPECT_FALSE(button("Probe")->isEnabled());
  QTest::mouseClick(button("Draw"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return button("Probe")->isEnabled(); }));
  QTest::mouseClick(button("Probe"), Qt::LeftButton);
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(1, 0));
}

TEST_F(MapDialogTest, IsEndedByEscapeBeforeItCloses) {
  isHeld_ = true;
  QTest::mouseClick(button("Draw"), Qt::LeftButton);
  ASSERT_NE(button("Stop"), nullptr);
  ASSERT_TRUE(waitFor([&] { return dialog_->bar()->note().contains(" of 3"); }));
  QTest::keyClick(dialog_.data(), Qt::Key_Escape);
  EXPECT_TRUE(dialog_->isVisible());
  ASSERT_TRUE(waitFor([&] { return dialog_->bar()->note().contains("ended before"); }));
  QTest::keyClick(dialog_.data(), Qt::Key_Escape);
  EXPECT_FALSE(dialog_->isVisible());
}

} // namespace
} // namespace taa::app::test
