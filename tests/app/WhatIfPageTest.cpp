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

QPushButton* buttonOf(const QWidget& page, const QString& text) {
  for (QPushButton* each : page.findChildren<QPushButton*>())
    if (each->text() == text) return each;
  return nullptr;
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

// Rows say how far they are from what is resolved now: here white.
TEST(WhatIfEntries, AreOrderedByWhatTheyChangeWithoutAReference) {
  ProbeResult result = resultWith(kUnknown, {{"clipToCenter", 0.0f}, {"clamp", 0.0031308f}});
  for (WhatIfRow& row : result.whatIf) row.difference = row.resolved - glm::vec3(1.0f);
  const std::vector<WhatIfEntry> entries = whatIfEntries(result);
  ASSERT_EQ(entries.size(), result.whatIf.size());
  EXPECT_EQ(result.whatIf[entries[0].row].id, "clipToCenter");
  EXPECT_FALSE(entries[0].error);
  EXPECT_NEAR(entries[0].change, 1.0, 1e-6);
  EXPECT_EQ(result.whatIf[entries[1].row].id, "clamp");
  EXPECT_NEAR(entries[1].change, 1.0 - 0.04045, 1e-5);
  EXPECT_EQ(entries.back().change, 0.0);
  for (std::size_t place = 3; place < entries.size(); ++place)
    EXPECT_LT(entries[place - 1].row, entries[place].row) << "what changes as much keeps its order";
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

TEST(WhatIfPage, SaysWhatItIsSortedByAndOffersTheReferenceThatIsMissing) {
  WhatIfPage page;
  int asked = 0;
  QObject::connect(&page, &WhatIfPage::referenceRequested, [&] { ++asked; });
  EXPECT_EQ(page.order(), "");
  const ProbeResult result = resultWith(kUnknown, {});
  page.setResult(result);
  page.QWidget::show();
  EXPECT_EQ(page.table()->rows().size(), result.whatIf.size());
  EXPECT_TRUE(page.table()->isColumnHidden(kErrorCell));
  EXPECT_EQ(page.order(),
            "There is no reference of this frame yet: sorted by how much each changes the pixel, "
            "the most first.");
  QPushButton* draw = buttonOf(page, "Draw the reference");
  ASSERT_NE(draw, nullptr);
  ASSERT_TRUE(draw->isVisible());
  QTest::mouseClick(draw, Qt::LeftButton);
  EXPECT_EQ(asked, 1);
  page.setResult(resultWith(0.0f, {}));
  EXPECT_FALSE(draw->isVisible());
  EXPECT_FALSE(page.table()->isColumnHidden(kErrorCell));
  EXPECT_EQ(page.order(), "Sorted by the error to the reference, the nearest first.");
}

// The last column that gives way is the one by which rows are in their order.
TEST(WhatIfPage, ShowsWhatItIsSortedByWhereNotAllFits) {
  constexpr int kChangeCell = 3, kAlphaCell = 4;
  WhatIfPage page;
  page.setResult(resultWith(kUnknown, {}));
  page.QWidget::show();
  for (int width = 700; width > 250; width -= 10) {
    page.resize(width, 400);
    const auto isHidden = [&](int column) { return page.table()->isColumnHidden(column); };
    EXPECT_TRUE(isHidden(kAlphaCell) || !isHidden(kChangeCell)) << width;
  }
}

TEST(WhatIfPage, CutsNoButtonHoweverNarrowItIs) {
  WhatIfPage page;
  page.setResult(resultWith(kUnknown, {}));
  page.QWidget::show();
  for (const int width : {700, 200}) {
    page.resize(width, 400);
    QTest::qWait(1);
    for (const char* text : {"Measure pictures", "Draw the reference"}) {
      const QPushButton* button = buttonOf(page, text);
      ASSERT_NE(button, nullptr);
      EXPECT_GE(button->width(), button->sizeHint().width()) << text << " at " << width;
      EXPECT_LE(button->geometry().right(), width) << text << " at " << width;
    }
  }
}

// Of a narrow probe the text beside two buttons would be a word wide.
TEST(WhatIfPage, ItsNoteStandsBelowTheButtons) {
  WhatIfPage page;
  page.setResult(resultWith(kUnknown, {}));
  page.QWidget::show();
  const QPushButton* measure = buttonOf(page, QStringLiteral("Measure pictures"));
  const auto note = [&] {
    for (QLabel* label : page.findChildren<QLabel*>())
      if (label->text().startsWith(QStringLiteral("Ghost, flicker"))) return label;
    return static_cast<QLabel*>(nullptr);
  };
  ASSERT_NE(measure, nullptr);
  for (const int width : {340, 1000}) {
    page.resize(width, 500);
    for (int layouts = 0; layouts < 3; ++layouts) QCoreApplication::processEvents();
    ASSERT_NE(note(), nullptr);
    const QPoint place = note()->mapTo(&page, QPoint(0, 0)), button = measure->mapTo(&page, QPoint(0, 0));
    EXPECT_GE(place.y(), button.y() + measure->height()) << width;
    EXPECT_LE(note()->heightForWidth(note()->width()), 3 * note()->fontMetrics().lineSpacing()) << width;
  }
}

TEST(WhatIfPage, StaysAsItIsWhileItPlaysWithoutAReference) {
  WhatIfPage page;
  ProbeResult result = resultWith(kUnknown, {});
  page.setResult(result);
  page.setPlaying(true);
  const QString first = page.table()->rows()[0].cells[0];
  result.whatIf.back().difference = glm::vec3(1.0f); // it changes most
  page.setResult(result);
  EXPECT_EQ(page.table()->rows()[0].cells[0], first);
  EXPECT_EQ(page.order(), "In their own order while it plays.");
  page.setPlaying(false);
  EXPECT_NE(page.table()->rows()[0].cells[0], first);
}

TEST(WhatIfPage, ArrowsChooseARowAndEnterTriesIt) {
  WhatIfPage page;
  page.resize(500, 400);
  ProbeResult result = resultWith(0.0f, {{"clipToCenter", 0.0f}, {"clamp", 0.0031308f}});
  page.setResult(result);
  page.QWidget::show();
  page.activateWindow();
  page.table()->setFocus();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
  std::vector<std::string> tried;
  QObject::connect(&page, &WhatIfPage::tried, [&](const Variant& variant) { tried.push_back(variant.id); });
  page.table()->setCurrentItem(page.table()->topLevelItem(0));
  QTest::keyClick(page.table(), Qt::Key_Down);
  QTest::keyClick(page.table(), Qt::Key_Return);
  EXPECT_EQ(tried, (std::vector<std::string>{"clamp"}));
  // It comes first now: what is chosen is the row, not its place.
  for (WhatIfRow& row : result.whatIf)
    if (row.group == WhatIfGroup::Rectify)
      row.resolved = glm::vec3(row.id == "clamp" ? 0.0f : row.id == "clipToCenter" ? 0.0031308f : 1.0f);
  page.setResult(result);
  EXPECT_EQ(page.table()->currentItem(), page.table()->topLevelItem(0));
  QTest::keyClick(page.table(), Qt::Key_Down);
  QTest::keyClick(page.table(), Qt::Key_Enter);
  EXPECT_EQ(tried, (std::vector<std::string>{"clamp", "clipToCenter"}));
}

TEST(WhatIfPage, EnterDoesNotTryWhatIsInForce) {
  WhatIfPage page;
  page.setResult(resultWith(0.0f, {}));
  int times = 0;
  QObject::connect(&page, &WhatIfPage::tried, [&] { ++times; });
  QTest::keyClick(page.table(), Qt::Key_Return); // no row is chosen
  for (int line = 0; line < page.table()->topLevelItemCount(); ++line) {
    if (!page.table()->topLevelItem(line)->text(0).startsWith(QStringLiteral("▸"))) continue;
    page.table()->setCurrentItem(page.table()->topLevelItem(line));
    QTest::keyClick(page.table(), Qt::Key_Return);
  }
  EXPECT_EQ(times, 0);
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
  ASSERT_TRUE(waitFor([&] { return buttonOf(page, "Measure pictures") != nullptr; }));
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

TEST_F(WhatIfInTheWindow, KeysOpenItChooseARowAndTryIt) {
  session.probes().setPixel(glm::ivec2(12, 7));
  settle();
  key(Qt::Key_F4);
  ValueTable* table = window.probe()->whatIf()->table();
  EXPECT_TRUE(table->hasFocus());
  const Settings before = session.presets().settings();
  const auto isInForce = [&] {
    return !table->currentItem() || table->currentItem()->text(0).startsWith(QStringLiteral("▸"));
  };
  do QTest::keyClick(table, Qt::Key_Down);
  while (isInForce());
  QTest::keyClick(table, Qt::Key_Return);
  settle();
  EXPECT_FALSE(session.presets().settings() == before);
  session.undo();
  EXPECT_TRUE(session.presets().settings() == before);
}

TEST_F(WhatIfInTheWindow, HasTheReferenceDrawnByAKeyWhileThePageIsOpen) {
  session.probes().setPixel(glm::ivec2(12, 7));
  settle();
  EXPECT_FALSE(renderer->last<request::SetProbes>().reference);
  key(Qt::Key_F4, Qt::ShiftModifier);
  EXPECT_EQ(window.probe()->tab(), ProbeTab::WhatIf);
  EXPECT_TRUE(renderer->last<request::SetProbes>().reference);
  key(Qt::Key_F2);
  EXPECT_FALSE(renderer->last<request::SetProbes>().reference);
}

} // namespace taa::app::test
