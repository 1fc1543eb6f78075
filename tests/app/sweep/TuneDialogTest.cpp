// Tuning in the window, by a search whose way is written by hand.
#include "app/dialogs/TuneDialog.h"

#include "app/dialogs/TuneChoices.h"
#include "app/models/verdict/VerdictWords.h"
#include "app/views/plots/CurveChart.h"
#include "core/base/Error.h"
#include "core/settings/Parameters.h"
#include "tests/app/WindowFixture.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

namespace taa::app::test {
namespace {

class TuneDialogTest : public FakeWindow {
 protected:
  void SetUp() override {
    FakeWindow::SetUp();
    session.post(request::SetReferenceSamples{16}); // the fake renderer begins with none
    settle();
    dialog_ = new TuneDialog(session,
                             {[this](const Settings& found) { saved_.push_back(found); },
                              [this](const Settings& found) { exported_.push_back(found); }},
                             &window,
                             [this](const ShotTuneRequest& request, const TuneTold& told,
                                    const Progress& progress) { tune(request, told, progress); });
    dialog_->show();
  }
  void TearDown() override { delete dialog_; } // its thread uses what is below

  /// Two changes are kept, at the third and the fifth of six evaluations: flicker goes from 0.04 to 0.01.
  void tune(const ShotTuneRequest& request, const TuneTold& told, const Progress& progress) {
    {
      const std::lock_guard lock(mutex_);
      request_ = request;
    }
    if (fails_) throw Error("there is no such frame");
    TuneWay way{{request.start, 4.0, 4.0, 1, {}, false}, {}, {}};
    way.start.means[static_cast<std::size_t>(Metric::Flicker)] = 0.04;
    way.best = way.start;
    told(way);
    keep(way, 3, 2.0, "weight.minimum=0.5");
    told(way);
    while (isHeld_) report(progress, "Tuning", 3, 100);
    keep(way, 5, 1.0, "rectify.method=clipToCenter");
    way.best.means[static_cast<std::size_t>(Metric::Flicker)] = 0.01;
    way.result.evaluations = 6;
    way.result.isComplete = true;
    told(way);
  }
  static void keep(TuneWay& way, int evaluation, double goal, const std::string& change) {
    way.result.steps.push_back({evaluation, goal, change});
    way.result.evaluations = evaluation;
    way.result.goal = goal;
    applyAssignment(way.result.settings, change);
  }
  Settings changed(const std::vector<std::string>& changes) const {
    Settings settings = request_.start;
    for (const std::string& change : changes) applyAssignment(settings, change);
    return settings;
  }
  QPushButton* button(const QString& text) const {
    for (QPushButton* each : dialog_->findChildren<QPushButton*>())
      if (each->text() == text) return each;
    return nullptr;
  }
  void tuneAll() {
    QTest::mouseClick(button("Tune"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return button("Tune") != nullptr; }));
  }
  bool isSaid(const QString& text) const {
    for (const QLabel* label : dialog_->findChildren<QLabel*>())
      if (label->text().contains(text)) return true;
    return false;
  }

  QPointer<TuneDialog> dialog_;
  std::vector<Settings> saved_, exported_;
  std::atomic<bool> isHeld_ = false; ///< after its first change
  std::atomic<bool> fails_ = false;
  ShotTuneRequest request_; ///< of the last search, once it has ended
  std::mutex mutex_;
};

TEST_F(TuneDialogTest, AsksForTheGoalAsItIsWeighted) {
  for (const char* id : {"ghostEnergy", "sharpness", "rmse"}) dialog_->choices()->weight(id)->setValue(0.0);
  dialog_->choices()->weight("flicker")->setValue(2.5);
  dialog_->choices()->weight("cost")->setValue(0.5);
  dialog_->choices()->evaluations()->setValue(12);
  QListWidget* stages = dialog_->choices()->stages();
  for (int line = 0; line < stages->count(); ++line)
    stages->item(line)->setCheckState(
        stages->item(line)->data(Qt::UserRole).toString() == "rectify" ? Qt::Checked : Qt::Unchecked);
  tuneAll();
  EXPECT_EQ(request_.tuning.goal, "flicker=2.5,cost=0.5");
  EXPECT_EQ(request_.tuning.varied, std::vector<std::string>{"rectify"});
  EXPECT_EQ(request_.tuning.evaluations, 12);
  EXPECT_EQ(request_.tuning.metrics.referenceSamples, 16);
  EXPECT_TRUE(request_.start == session.presets().settings());
  EXPECT_EQ(request_.shot.source, "builtin:fan");
}

TEST_F(TuneDialogTest, BeginsWithWeightsOfGhostFlickerBlurAndError) {
  tuneAll();
  EXPECT_EQ(request_.tuning.goal, "ghostEnergy=1,flicker=1,sharpness=1,rmse=1");
  EXPECT_EQ(tunableRows(request_.tuning.varied).size(), tunableRows().size()) << "all stages are ticked";
}

TEST_F(TuneDialogTest, SaysWhyThereIsNothingToTune) {
  for (const char* id : {"ghostEnergy", "sharpness", "rmse", "flicker"})
    dialog_->choices()->weight(id)->setValue(0.0);
  EXPECT_FALSE(button("Tune")->isEnabled());
  EXPECT_TRUE(isSaid("No weight is above 0"));
  dialog_->choices()->weight("cost")->setValue(1.0);
  EXPECT_TRUE(button("Tune")->isEnabled());
}

TEST_F(TuneDialogTest, ShowsTheWayItWent) {
  for (const char* id : {"ghostEnergy", "sharpness", "rmse"}) dialog_->choices()->weight(id)->setValue(0.0);
  tuneAll();
  ASSERT_EQ(dialog_->steps()->topLevelItemCount(), 2);
  EXPECT_EQ(dialog_->steps()->topLevelItem(0)->text(0), "3");
  EXPECT_EQ(dialog_->steps()->topLevelItem(1)->text(2), changeText("rectify.method=clipToCenter"));
  ASSERT_EQ(dialog_->numbers()->topLevelItemCount(), 2) << "flicker, and all together";
  EXPECT_EQ(dialog_->numbers()->topLevelItem(0)->text(2).toDouble(), 0.04);
  EXPECT_EQ(dialog_->numbers()->topLevelItem(0)->text(3).toDouble(), 0.01);
  EXPECT_EQ(dialog_->numbers()->topLevelItem(1)->text(3).toDouble(), 1.0);
  ASSERT_EQ(dialog_->chart()->curves().size(), 1u);
  EXPECT_EQ(dialog_->chart()->curves()[0].points,
            (std::vector<QPointF>{{1, 4}, {3, 4}, {3, 2}, {5, 2}, {5, 1}, {6, 1}}));
  EXPECT_TRUE(isSaid("Settings measured: 6"));
}

TEST_F(TuneDialogTest, TakesAllOfItUpAsOneStep) {
  const Settings before = session.presets().settings();
  EXPECT_FALSE(button("Apply")->isEnabled());
  tuneAll();
  session.presets().setParameter(QStringLiteral("weight.minimum"), 0.75);
  const Settings meanwhile = session.presets().settings();
  QTest::mouseClick(button("Apply"), Qt::LeftButton);
  EXPECT_TRUE(session.presets().settings() == changed({"weight.minimum=0.5", "rectify.method=clipToCenter"}));
  session.undo();
  EXPECT_TRUE(session.presets().settings() == meanwhile);
  EXPECT_FALSE(before == meanwhile);
}

TEST_F(TuneDialogTest, HandsOutWhatWasFound) {
  tuneAll();
  QTest::mouseClick(button("Save as preset…"), Qt::LeftButton);
  QTest::mouseClick(button("Export GLSL…"), Qt::LeftButton);
  const Settings found = changed({"weight.minimum=0.5", "rectify.method=clipToCenter"});
  ASSERT_EQ(saved_.size(), 1u);
  ASSERT_EQ(exported_.size(), 1u);
  EXPECT_TRUE(saved_[0] == found);
  EXPECT_TRUE(exported_[0] == found);
}

TEST_F(TuneDialogTest, KeepsTheBestWhenItIsStopped) {
  isHeld_ = true;
  QTest::mouseClick(button("Tune"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return dialog_->steps()->topLevelItemCount() == 1; }));
  QTest::keyClick(dialog_, Qt::Key_Escape);
  EXPECT_TRUE(dialog_->isVisible());
  ASSERT_NE(button("Tune"), nullptr);
  QTest::mouseClick(button("Apply"), Qt::LeftButton);
  EXPECT_EQ(session.presets().settings().weight.minimum, 0.5f);
  QTest::keyClick(dialog_, Qt::Key_Escape);
  EXPECT_FALSE(dialog_->isVisible());
  TuneDialog::openAt(session, {}, &window);
  EXPECT_EQ(window.findChildren<TuneDialog*>().size(), 1);
  EXPECT_EQ(dialog_->steps()->topLevelItemCount(), 1) << "is there again";
}

TEST_F(TuneDialogTest, SaysWhatWentWrong) {
  fails_ = true;
  tuneAll();
  EXPECT_TRUE(isSaid("there is no such frame"));
  EXPECT_FALSE(button("Apply")->isEnabled());
}

TEST_F(TuneDialogTest, OpensOnceByItsCommand) {
  delete dialog_;
  for (int time = 0; time < 2; ++time) {
    key(Qt::Key_U, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(window.findChildren<TuneDialog*>().size(), 1);
    window.activateWindow();
    settle();
  }
}

} // namespace
} // namespace taa::app::test
