// The pixel under other choices: which come first, what a click does, what is measured of whole pictures.
#include "app/views/plots/WhatIfPage.h"

#include "app/models/alternatives/WhatIfEntries.h"
#include "app/panels/ProbePanel.h"
#include "app/widgets/ValueTable.h"
#include "core/settings/Presets.h"
#include "tests/app/WindowFixture.h"

#include <QLabel>
#include <QPushButton>
#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace taa::app::test {
namespace {

constexpr int kErrorCell = 1, kGhostCell = 5, kFlickerCell = 6, kSharpCell = 7;

/// Every variant of the first preset; resolved is white but where `set` says something else.
ProbeResult resultWith(float reference, const std::vector<std::pair<std::string, float>>& set) {
  ProbeResult result;
  result.frame = 20;
  result.settings = preset("balanced").settings;
  PixelRecord record;
  record.fill(glm::vec4(reference));
  result.around.assign(9, record);
  for (const Variant& variant : variantsOf(result.settings)) {
    WhatIfRow row{.group = variant.group, .id = variant.id, .label = variant.label, .note = variant.note};
    row.isCurrent = variant.isCurrent;
    row.resolved = glm::vec3(1.0f);
    for (const auto& [id, value] : set)
      if (id == variant.id && variant.group == WhatIfGroup::Rectify) row.resolved = glm::vec3(value);
    result.whatIf.push_back(row);
  }
  return result;
}

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// The same ghost energy, flicker and sharpness of all settings.
void measureNumbers(const ShotSweepRequest& request, const SettingsMeasured& measured, const Progress&) {
  for (std::size_t index = 0; index < request.settings.size(); ++index) {
    FrameMetrics frame{.frame = request.metrics.first, .values = {}};
    frame.at(Metric::GhostEnergy) = 0.75;
    frame.at(Metric::Flicker) = 0.25;
    frame.at(Metric::Sharpness) = 0.5;
    measured(index, {frame});
  }
}

} // namespace

// Black is 1 from white in each channel; sRGB puts 0.0031308 · 12.92 = 0.04045 above it.
TEST(WhatIfEntries, AreOrderedByTheirDistanceFromTheReference) {
  const ProbeResult result = resultWith(0.0f, {{"clipToCenter", 0.0f}, {"clamp", 0.0031308f}});
  const std::vector<WhatIfEntry> entries = whatIfEntries(result);
  ASSERT_EQ(entries.size(), result.whatIf.size());
  EXPECT_EQ(result.whatIf[entries[0].row].id, "clipToCenter");
  EXPECT_EQ(entries[0].error, 0.0);
  EXPECT_EQ(result.whatIf[entries[1].row].id, "clamp");
  EXPECT_NEAR(*entries[1].error, 0.04045, 1e-5);
  EXPECT_NEAR(*entries.back().error, 1.0, 1e-6);
  for (std::size_t place = 3; place < entries.size(); ++place)
    EXPECT_LT(entries[place - 1].row, entries[place].row) << "what is as near keeps its order";
}

TEST(WhatIfEntries, KeepTheirOrderWithoutAReference) {
  const std::vector<WhatIfEntry> entries = whatIfEntries(resultWith(kUnknown, {{"clipToCenter", 0.0f}}));
  for (std::size_t place = 0; place < entries.size(); ++place)
    EXPECT_EQ(entries[place], (WhatIfEntry{place, {}}));
}

TEST(PictureNumbers, AreThoseOfTheSettings) {
  PictureNumbers numbers;
  EXPECT_TRUE(numbers.isEmpty());
  FrameMetrics one, other;
  one.at(Metric::Flicker) = 0.25;
  other.at(Metric::Flicker) = 0.75;
  numbers.add(preset("fsr2").settings, {one, other});
  ASSERT_NE(numbers.find(preset("fsr2").settings), nullptr);
  EXPECT_EQ((*numbers.find(preset("fsr2").settings))[1], 0.5) << "the mean over the frames";
  EXPECT_FALSE((*numbers.find(preset("fsr2").settings))[0]);
  EXPECT_EQ(numbers.find(preset("balanced").settings), nullptr);
}

TEST(WhatIfPage, HasHeadingsWhereThereIsNoReference) {
  WhatIfPage page;
  const ProbeResult result = resultWith(kUnknown, {});
  page.setResult(result);
  EXPECT_EQ(page.table()->rows().size(), result.whatIf.size() + 4);
  EXPECT_TRUE(page.table()->rows()[0].isSum);
  EXPECT_TRUE(page.table()->isColumnHidden(kErrorCell));
}

TEST(WhatIfPage, AClickTriesARow) {
  WhatIfPage page;
  page.resize(500, 400);
  const ProbeResult result = resultWith(0.0f, {{"clipToCenter", 0.0f}});
  page.setResult(result);
  page.QWidget::show();
  Settings tried;
  int times = 0;
  QObject::connect(&page, &WhatIfPage::tried, [&](const Variant& variant) {
    tried = variant.settings;
    ++times;
  });
  const QRect place = page.table()->visualItemRect(page.table()->topLevelItem(0));
  QTest::mouseClick(page.table()->viewport(), Qt::LeftButton, {}, place.center());
  ASSERT_EQ(times, 1);
  Settings expected = result.settings;
  applyAssignment(expected, "rectify.method=clipToCenter");
  EXPECT_TRUE(tried == expected);
}

TEST(WhatIfPage, MeasuresWholePicturesUpToTheFrame) {
  std::mutex mutex;
  std::vector<ShotSweepRequest> requests;
  WhatIfPage page(
      [&](const ShotSweepRequest& request, const SettingsMeasured& measured, const Progress& progress) {
        {
          const std::lock_guard lock(mutex);
          requests.push_back(request);
        }
        measureNumbers(request, measured, progress);
      });
  page.setResult(resultWith(0.0f, {}));
  EXPECT_TRUE(page.table()->isColumnHidden(kGhostCell));
  SessionFile shot;
  shot.source = "builtin:fan";
  page.measure(shot, 16);
  auto* button = page.findChild<QPushButton*>();
  ASSERT_TRUE(waitFor([&] { return button->text() == "Measure pictures"; }));
  for (const ValueTable::Row& row : page.table()->rows()) {
    EXPECT_EQ(row.cells[kGhostCell].toDouble(), 0.75) << row.cells[0].toStdString();
    EXPECT_EQ(row.cells[kFlickerCell].toDouble(), 0.25);
    EXPECT_EQ(row.cells[kSharpCell].toDouble(), 0.5);
  }
  EXPECT_FALSE(page.table()->isColumnHidden(kGhostCell));
  const std::lock_guard lock(mutex);
  ASSERT_EQ(requests.size(), 1u);
  EXPECT_EQ(requests[0].metrics.first, 13);
  EXPECT_EQ(requests[0].metrics.last, 20);
  EXPECT_EQ(requests[0].metrics.referenceSamples, 16);
  const std::vector<SweepSettings>& all = requests[0].settings;
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_FALSE(all[a].settings == all[b].settings) << "the same settings are measured once";
}

TEST(WhatIfPage, ForgetsNumbersOfAnotherShot) {
  WhatIfPage page(measureNumbers);
  page.setResult(resultWith(0.0f, {}));
  SessionFile shot;
  shot.source = "builtin:fan";
  page.measure(shot, 16);
  ASSERT_TRUE(waitFor([&] { return page.hasNumbers(); }));
  shot.frame = 7;
  shot.settings.settings = preset("fsr2").settings;
  page.setShot(shot);
  EXPECT_TRUE(page.hasNumbers()) << "neither settings nor the frame on show are the shot";
  shot.restarts = {3};
  page.setShot(shot);
  EXPECT_FALSE(page.hasNumbers());
}

TEST(WhatIfPage, SaysThatThereIsNoReference) {
  WhatIfPage page(measureNumbers);
  page.setResult(resultWith(kUnknown, {}));
  page.measure({}, 0);
  EXPECT_FALSE(page.hasNumbers());
  bool isSaid = false;
  for (const QLabel* label : page.findChildren<QLabel*>())
    isSaid |= label->text().startsWith("There is no reference");
  EXPECT_TRUE(isSaid);
}

using WhatIfInTheWindow = FakeWindow;

TEST_F(WhatIfInTheWindow, TriesAsOneStepOfUndo) {
  session.probes().setPixel(glm::ivec2(12, 7));
  settle();
  key(Qt::Key_F4);
  const Settings before = session.presets().settings();
  Settings wanted = before;
  applyAssignment(wanted, "rectify.method=clipToCenter");
  ASSERT_FALSE(wanted == before);
  for (const Variant& variant : variantsOf(before))
    if (variant.group == WhatIfGroup::Rectify && variant.id == "clipToCenter")
      Q_EMIT window.probe()->whatIf()->tried(variant);
  EXPECT_TRUE(session.presets().settings() == wanted);
  session.undo();
  EXPECT_TRUE(session.presets().settings() == before);
}

} // namespace taa::app::test
