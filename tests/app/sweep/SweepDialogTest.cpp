// Settings compared by numbers in the window, on measurements that can be predicted.
#include "app/dialogs/SweepDialog.h"

#include "app/dialogs/SweepChoices.h"
#include "app/dialogs/SweepScenes.h"
#include "app/views/plots/CurveChart.h"
#include "app/views/plots/ScatterChart.h"
#include "core/base/Error.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Presets.h"
#include "tests/app/WindowFixture.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QRect>
#include <QSpinBox>
#include <QTreeWidget>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace taa::app::test {
namespace {

class SweepDialogTest : public FakeWindow {
 protected:
  void SetUp() override {
    FakeWindow::SetUp();
    session.post(request::SetReferenceSamples{16}); // the fake renderer begins with none
    settle();
    dialog_ = new SweepDialog(session, {}, &window,
                              [this](const ShotSweepRequest& request, const SettingsMeasured& measured,
                                     const Progress& progress) { measure(request, measured, progress); });
    dialog_->show();
  }
  void TearDown() override { delete dialog_; } // its thread uses what is below

  /// Flicker falls and everything else rises with the place of the entry, in hundredths.
  void measure(const ShotSweepRequest& request, const SettingsMeasured& measured, const Progress& progress) {
    {
      const std::lock_guard lock(mutex_);
      request_ = request;
    }
    const auto count = static_cast<int>(request.count());
    for (int index = 0; index < count; ++index) {
      do report(progress, "Measuring settings", index, count);
      while (isHeld_ && index == 2);
      if (index == fails_) throw Error("there is no reference");
      LaneMetrics frames;
      for (int number = request.metrics.first; number <= request.metrics.last; ++number) {
        frames.push_back({.frame = number, .values = {}});
        for (const Metric metric : request.metrics.wanted) frames.back().at(metric) = 0.01 * (index + 1);
        frames.back().at(Metric::Flicker) = 0.01 * (count - index);
      }
      measured(static_cast<std::size_t>(index), frames);
    }
  }
  QPushButton* button(const QString& text) const {
    for (QPushButton* each : dialog_->findChildren<QPushButton*>())
      if (each->text() == text) return each;
    return nullptr;
  }
  void measureAll() {
    QTest::mouseClick(button("Measure"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return button("Measure") != nullptr; }));
  }
  void tickOnly(const std::vector<std::string>& ids) {
    QListWidget* list = dialog_->choices()->presets();
    for (int line = 0; line < list->count(); ++line) {
      const std::string id = list->item(line)->data(Qt::UserRole).toString().toStdString();
      list->item(line)->setCheckState(std::ranges::count(ids, id) > 0 ? Qt::Checked : Qt::Unchecked);
    }
  }
  QListWidgetItem* scene(const QString& source) const {
    const QListWidget* list = dialog_->scenes();
    for (int line = 0; line < list->count(); ++line)
      if (list->item(line)->data(Qt::UserRole).toString() == source) return list->item(line);
    return nullptr;
  }
  QComboBox* box(const QString& name) const {
    for (QComboBox* each : dialog_->findChildren<QComboBox*>())
      if (each->accessibleName() == name) return each;
    return nullptr;
  }
  void chooseAxis(const char* path) {
    QComboBox* axis = dialog_->choices()->axis();
    ASSERT_GE(axis->findData(QString(path)), 0) << path;
    axis->setCurrentIndex(axis->findData(QString(path)));
  }
  ShotSweepRequest request() {
    const std::lock_guard lock(mutex_);
    return request_;
  }

  QPointer<SweepDialog> dialog_;
  std::atomic<bool> isHeld_ = false; ///< in its third settings
  std::atomic<int> fails_ = -1;

 private:
  std::mutex mutex_;
  ShotSweepRequest request_;
};

TEST_F(SweepDialogTest, MeasuresThePresetsThatAreTicked) {
  tickOnly({"", "fsr2", "minimal"});
  measureAll();
  const ShotSweepRequest asked = request();
  ASSERT_EQ(asked.settings.size(), 3u);
  EXPECT_TRUE(asked.settings[0].settings == session.presets().settings());
  ASSERT_EQ(asked.shots.size(), 1u);
  EXPECT_EQ(asked.shots[0].source, "builtin:fan");
  EXPECT_EQ(asked.shots[0].size, glm::ivec2(64, 36));
  EXPECT_EQ(asked.metrics.referenceSamples, 16);
  for (const SweepSettings& each : asked.settings) {
    if (each.name == asked.settings[0].name) continue;
    EXPECT_TRUE(each.settings == preset("fsr2").settings || each.settings == preset("minimal").settings);
  }
  EXPECT_EQ(dialog_->table()->topLevelItemCount(), 3);
  EXPECT_EQ(dialog_->scatter()->points().size(), 3u);
  EXPECT_EQ(dialog_->curves()->curves().size(), 3u);
}

TEST_F(SweepDialogTest, TicksWhatIsThereToCompareWith) {
  std::size_t ours = 0;
  for (const Preset& each : builtinPresets()) ours += each.group == "ours" && each.step == 0 ? 1 : 0;
  EXPECT_EQ(dialog_->choices()->chosen().size(), ours + 1);
}

TEST_F(SweepDialogTest, MeasuresAParameterFromOneEndToTheOther) {
  chooseAxis("weight.minimum");
  SweepChoices* choices = dialog_->choices();
  choices->from()->setValue(0.125);
  choices->to()->setValue(0.5);
  choices->steps()->setValue(3);
  choices->byFactor()->setChecked(true);
  measureAll();
  const ShotSweepRequest asked = request();
  ASSERT_EQ(asked.settings.size(), 3u);
  const float expected[] = {0.125f, 0.25f, 0.5f};
  for (std::size_t index = 0; index < 3; ++index) {
    Settings settings = session.presets().settings();
    settings.weight.minimum = expected[index];
    EXPECT_TRUE(asked.settings[index].settings == settings) << index;
  }
  EXPECT_EQ(asked.settings[1].name, "0.25");
}

TEST_F(SweepDialogTest, MeasuresEveryChoice) {
  chooseAxis("rectify.method");
  measureAll();
  EXPECT_EQ(request().settings.size(), parameter("rectify.method").choices.size());
}

TEST_F(SweepDialogTest, ShowsTheFrontOfTheChosenMetrics) {
  tickOnly({"", "fsr2", "minimal"});
  measureAll();
  for (const ScatterPoint& point : dialog_->scatter()->points()) EXPECT_TRUE(point.isOnFront);
  // With RMSE, which rises as well, only the first is.
  QComboBox* upwards = box("Metric upwards");
  ASSERT_NE(upwards, nullptr);
  upwards->setCurrentIndex(upwards->findData(static_cast<int>(Metric::Rmse)));
  EXPECT_EQ(std::ranges::count(dialog_->scatter()->points(), true, &ScatterPoint::isOnFront), 1);
  EXPECT_TRUE(dialog_->scatter()->points()[0].isOnFront);
}

TEST_F(SweepDialogTest, TakesUpWhatIsChosen) {
  tickOnly({"", "fsr2", "minimal"});
  measureAll();
  const ScatterPoint point = dialog_->scatter()->points()[1];
  QTest::mouseClick(dialog_->scatter(), Qt::LeftButton, {}, dialog_->scatter()->placeOf(point).toPoint());
  ASSERT_NE(dialog_->table()->currentItem(), nullptr);
  EXPECT_EQ(dialog_->table()->currentItem()->text(0), point.name);
  QTest::mouseClick(button("Apply"), Qt::LeftButton);
  settle();
  EXPECT_TRUE(session.presets().settings() == request().settings[point.index].settings);
  session.undo();
  EXPECT_TRUE(session.presets().settings() == request().settings[0].settings);
}

// Settings that changed meanwhile, or a file that went away, make no difference.
TEST_F(SweepDialogTest, TakesUpWhatWasMeasured) {
  chooseAxis("weight.minimum");
  measureAll();
  session.presets().setPreset(QStringLiteral("fsr2"));
  dialog_->table()->setCurrentItem(dialog_->table()->topLevelItem(1));
  QTest::mouseClick(button("Apply"), Qt::LeftButton);
  EXPECT_TRUE(session.presets().settings() == request().settings[1].settings);
  session.undo();
  EXPECT_TRUE(session.presets().settings() == preset("fsr2").settings);
}

TEST_F(SweepDialogTest, KeepsWhatWasTypedOfEachParameter) {
  SweepChoices* choices = dialog_->choices();
  chooseAxis("weight.minimum");
  choices->from()->setValue(0.125);
  choices->steps()->setValue(7);
  choices->byFactor()->setChecked(false);
  chooseAxis("rectify.method");
  chooseAxis("weight.minimum");
  EXPECT_EQ(choices->from()->value(), 0.125);
  EXPECT_EQ(choices->steps()->value(), 7);
  EXPECT_FALSE(choices->byFactor()->isChecked());
}

TEST_F(SweepDialogTest, KeepsEverythingWhenItIsClosed) {
  tickOnly({"fsr2", "minimal"});
  measureAll();
  chooseAxis("weight.minimum");
  dialog_->choices()->from()->setValue(0.125);
  QTest::keyClick(dialog_, Qt::Key_Escape);
  EXPECT_FALSE(dialog_->isVisible());
  SweepDialog::openAt(session, {}, &window);
  ASSERT_EQ(window.findChildren<SweepDialog*>().size(), 1);
  EXPECT_TRUE(dialog_->isVisible());
  EXPECT_EQ(dialog_->table()->topLevelItemCount(), 2);
  EXPECT_EQ(dialog_->choices()->axis()->currentData().toString(), "weight.minimum");
  EXPECT_EQ(dialog_->choices()->from()->value(), 0.125);
  dialog_->choices()->axis()->setCurrentIndex(0);
  EXPECT_EQ(dialog_->choices()->chosen().size(), 2u);
}

TEST_F(SweepDialogTest, EscapeEndsTheWorkFirst) {
  isHeld_ = true;
  tickOnly({"", "fsr2", "minimal"});
  QTest::mouseClick(button("Measure"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return dialog_->series().measuredCount() == 2; }));
  QTest::keyClick(dialog_, Qt::Key_Escape);
  EXPECT_NE(button("Measure"), nullptr);
  EXPECT_TRUE(dialog_->isVisible());
  EXPECT_EQ(dialog_->series().measuredCount(), 2u);
}

TEST_F(SweepDialogTest, OffersWhatIsOpenAndTheOtherBuiltInScenes) {
  const QListWidget* list = dialog_->scenes();
  ASSERT_EQ(list->count(), static_cast<int>(builtinScenes().size()));
  EXPECT_EQ(list->item(0)->text(), "Fan, as it is open");
  EXPECT_EQ(list->item(0)->checkState(), Qt::Checked);
  for (int line = 1; line < list->count(); ++line)
    EXPECT_EQ(list->item(line)->checkState(), Qt::Unchecked) << line;
  EXPECT_EQ(scene("builtin:fan"), nullptr) << "it is the first";
}

TEST_F(SweepDialogTest, MeasuresPresetsOnScenes) {
  tickOnly({"", "fsr2", "minimal"});
  EXPECT_TRUE(dialog_->table()->isColumnHidden(1));
  ASSERT_NE(scene("builtin:fence"), nullptr);
  // The switch at the left of the line: on this platform no dialog is active, and Space would be the
  // window's.
  dialog_->scenes()->scrollToItem(scene("builtin:fence"));
  const QRect fence = dialog_->scenes()->visualItemRect(scene("builtin:fence"));
  QTest::mouseClick(dialog_->scenes()->viewport(), Qt::LeftButton, {},
                    {fence.left() + fence.height() / 2, fence.center().y()});
  ASSERT_EQ(scene("builtin:fence")->checkState(), Qt::Checked);
  measureAll();
  const ShotSweepRequest asked = request();
  ASSERT_EQ(asked.shots.size(), 2u);
  EXPECT_EQ(asked.shots[0].source, "builtin:fan");
  EXPECT_EQ(asked.shots[1].source, "builtin:fence");
  EXPECT_EQ(asked.shots[1].size, glm::ivec2(64, 36));
  EXPECT_EQ(asked.count(), 6u);
  ASSERT_EQ(dialog_->table()->topLevelItemCount(), 6);
  EXPECT_FALSE(dialog_->table()->isColumnHidden(1));
  for (int line = 0; line < 6; ++line)
    EXPECT_EQ(dialog_->table()->topLevelItem(line)->text(1), line < 3 ? "Fan" : "Fence") << line;
  EXPECT_EQ(dialog_->windowTitle().section(u',', 0, 1), "Sweep: Fan, Fence");
  // Charts show all, or one scene.
  EXPECT_EQ(dialog_->scatter()->scenes().size(), 2u);
  EXPECT_EQ(dialog_->curves()->curves().size(), 6u);
  QComboBox* shown = box("Scene of the charts");
  ASSERT_NE(shown, nullptr);
  ASSERT_TRUE(shown->isVisible());
  shown->setCurrentIndex(shown->findText("Fence"));
  ASSERT_EQ(dialog_->scatter()->points().size(), 3u);
  EXPECT_EQ(dialog_->scatter()->points()[0].index, 3u);
  EXPECT_EQ(dialog_->curves()->curves().size(), 3u);
  EXPECT_EQ(dialog_->table()->topLevelItemCount(), 6) << "the table has all";
}

TEST_F(SweepDialogTest, TakesUpTheSettingsOfALineOfAnyScene) {
  tickOnly({"", "fsr2", "minimal"});
  scene("builtin:fence")->setCheckState(Qt::Checked);
  measureAll();
  dialog_->table()->setCurrentItem(dialog_->table()->topLevelItem(4));
  QTest::mouseClick(button("Apply"), Qt::LeftButton);
  EXPECT_TRUE(session.presets().settings() == request().settings[1].settings);
  EXPECT_EQ(session.status().source, "builtin:fan");
}

TEST_F(SweepDialogTest, StopsBetweenScenesAndKeepsWhatItHas) {
  isHeld_ = true;
  tickOnly({"", "fsr2"});
  scene("builtin:fence")->setCheckState(Qt::Checked);
  QTest::mouseClick(button("Measure"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return dialog_->series().measuredCount() == 2; }));
  QTest::keyClick(dialog_, Qt::Key_Escape);
  EXPECT_NE(button("Measure"), nullptr);
  EXPECT_EQ(dialog_->table()->topLevelItemCount(), 2);
}

TEST_F(SweepDialogTest, MeasuresSupersamplingWhenItIsTicked) {
  tickOnly({"fsr2"});
  measureAll();
  EXPECT_FALSE(request().hasSupersampling);
  auto* tick = dialog_->findChild<QCheckBox*>("supersampling");
  ASSERT_TRUE(tick && tick->isEnabled());
  QTest::keyClick(tick, Qt::Key_Space);
  measureAll();
  EXPECT_TRUE(request().hasSupersampling);
}

TEST_F(SweepDialogTest, NeedsAScene) {
  scene({})->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(button("Measure")->isEnabled());
  scene("builtin:thin")->setCheckState(Qt::Checked);
  EXPECT_TRUE(button("Measure")->isEnabled());
}

TEST_F(SweepDialogTest, ListsScenesAnewForAnotherThatIsOpened) {
  scene("builtin:thin")->setCheckState(Qt::Checked);
  window.openSource("builtin:fence");
  ASSERT_TRUE(waitFor([&] { return session.status().source == "builtin:fence"; }));
  settle();
  EXPECT_EQ(dialog_->scenes()->item(0)->text(), "Fence, as it is open");
  EXPECT_NE(scene("builtin:fan"), nullptr);
  EXPECT_EQ(scene("builtin:fence"), nullptr);
  EXPECT_EQ(scene("builtin:thin")->checkState(), Qt::Checked) << "what is ticked stays";
}

TEST_F(SweepDialogTest, SortsByNumbers) {
  chooseAxis("weight.minimum");
  dialog_->choices()->steps()->setValue(12);
  measureAll();
  int flicker = -1;
  for (int column = 0; column < dialog_->table()->columnCount(); ++column)
    if (dialog_->table()->headerItem()->text(column) == "Flicker") flicker = column;
  ASSERT_GE(flicker, 0);
  dialog_->table()->sortByColumn(flicker, Qt::AscendingOrder);
  for (int line = 0; line < 12; ++line)
    EXPECT_DOUBLE_EQ(dialog_->table()->topLevelItem(line)->text(flicker).toDouble(), 0.01 * (line + 1));
}

TEST_F(SweepDialogTest, StopsAndKeepsWhatItHas) {
  isHeld_ = true;
  tickOnly({"", "fsr2", "minimal"});
  QTest::mouseClick(button("Measure"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return dialog_->series().measuredCount() == 2; }));
  ASSERT_NE(button("Stop"), nullptr);
  QTest::mouseClick(button("Stop"), Qt::LeftButton);
  EXPECT_NE(button("Measure"), nullptr);
  settle();
  EXPECT_EQ(dialog_->table()->topLevelItemCount(), 2);
}

TEST_F(SweepDialogTest, SaysWhatWentWrong) {
  fails_ = 1;
  measureAll();
  bool isSaid = false;
  for (const QLabel* label : dialog_->findChildren<QLabel*>())
    isSaid |= label->text() == "there is no reference";
  EXPECT_TRUE(isSaid);
  EXPECT_EQ(dialog_->table()->topLevelItemCount(), 1);
}

TEST_F(SweepDialogTest, CopiesTheTable) {
  tickOnly({"fsr2"});
  measureAll();
  QTest::mouseClick(button("Copy as CSV"), Qt::LeftButton);
  const QString text = QApplication::clipboard()->text();
  EXPECT_EQ(text, dialog_->series().csv());
  EXPECT_EQ(text.count(u'\n'), 2);
}

TEST_F(SweepDialogTest, OpensOnceByItsCommand) {
  delete dialog_;
  for (int time = 0; time < 2; ++time) {
    key(Qt::Key_W, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(window.findChildren<SweepDialog*>().size(), 1);
    window.activateWindow();
    settle();
  }
}

} // namespace
} // namespace taa::app::test
