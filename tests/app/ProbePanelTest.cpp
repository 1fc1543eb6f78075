// The probe table: every intermediate, exact values, words.
#include "app/panels/ProbePanel.h"
#include "app/docks/Workspace.h"
#include "app/models/ProbeModel.h"
#include "app/panels/StatusLine.h"
#include "app/style/Numbers.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewPanel.h"
#include "core/explanation/ProbeHeadline.h"
#include "core/scene/SceneOutline.h"
#include "core/taa/twin/Details.h"
#include "core/taa/twin/Traced.h"
#include "tests/app/WindowFixture.h"

#include <QClipboard>
#include <QDockWidget>
#include <QLabel>
#include <QStyle>
#include <QStyleOptionViewItem>
#include <QTest>
#include <QTreeView>

#include <map>
#include <memory>
#include <optional>
#include <string>

using namespace taa;
using namespace taa::app;
using ProbeTableTest = test::FakeWindow;

namespace {

QString cell(const ProbeModel* model, IntermediateId id, int column) {
  return model->data(model->indexOf(id, column), Qt::DisplayRole).toString();
}

twin::Texels filledWith(int channels) {
  Image plane(3, 3, channels);
  for (float& value : plane.pixels) value = 0.5f;
  return plane;
}

} // namespace

// As a session of a smaller window may have left it.
TEST_F(ProbeTableTest, AtItsNarrowestShowsUnitsWhole) {
  session.probes().setPixel(glm::ivec2(12, 7));
  auto* dock = window.findChild<QDockWidget*>("probe");
  ASSERT_TRUE(dock);
  window.workspace()->resizeDocks({dock}, {1}, Qt::Horizontal);
  settle();
  const QTreeView* table = nullptr;
  for (const auto* each : window.probe()->findChildren<QTreeView*>())
    if (each->isVisible()) table = each;
  ASSERT_TRUE(table && table->model()->inherits("taa::app::ProbeModel"));
  EXPECT_LT(table->width(), 380) << "it was made narrower";
  EXPECT_EQ(table->horizontalScrollBarPolicy(), Qt::ScrollBarAlwaysOff);
  const int unit = table->columnViewportPosition(ProbeModel::Unit) + table->columnWidth(ProbeModel::Unit);
  EXPECT_LE(unit, table->viewport()->width());
}

TEST(ProbeModel, HasEveryIntermediateOnceBelowItsStage) {
  ProbeModel model;
  std::size_t rows = 0;
  for (int branch = 0; branch < model.rowCount(); ++branch) {
    const QModelIndex stage = model.index(branch, 0);
    for (int row = 0; row < model.rowCount(stage); ++row, ++rows) {
      const QModelIndex index = model.index(row, ProbeModel::Name, stage);
      EXPECT_EQ(model.parent(index), stage);
      ASSERT_TRUE(model.idOf(index));
      EXPECT_EQ(model.indexOf(*model.idOf(index)), index);
    }
  }
  EXPECT_EQ(rows, kIntermediateCount);
}

TEST(ProbeModel, ValuesAreRoundedAndTheirToolTipsExact) {
  ProbeModel model;
  twin::PixelRecord record;
  record.fill(glm::vec4(0.1f, -1.0f / 3.0f, 12345.678f, 0));
  model.setRecord(record);
  const QStringList lines = cell(&model, IntermediateId::color, ProbeModel::Value).split('\n');
  ASSERT_EQ(lines.size(), 3);
  const char* const expected[] = {"0.1", "−0.33333", "12346"};
  for (int channel = 0; channel < 3; ++channel) // without the channel's letter
    EXPECT_EQ(lines[channel].mid(1).trimmed(), QString::fromUtf8(expected[channel]));
  const QModelIndex value = model.indexOf(IntermediateId::color, ProbeModel::Value);
  EXPECT_TRUE(
      model.data(value, Qt::ToolTipRole).toString().startsWith("exactly 0.1 -0.33333334 12345.678<br>"))
      << model.data(value, Qt::ToolTipRole).toString().toStdString();
}

TEST(ProbeModel, NamesOfRowsThatDecidedAreBold) {
  ProbeModel model;
  const auto isBold = [&](IntermediateId id) {
    return model.data(model.indexOf(id, ProbeModel::Name), Qt::FontRole).value<QFont>().bold();
  };
  model.setDecided({IntermediateId::clipAmount});
  EXPECT_TRUE(isBold(IntermediateId::clipAmount));
  EXPECT_FALSE(isBold(IntermediateId::alpha));
  model.setDecided({});
  EXPECT_FALSE(isBold(IntermediateId::clipAmount));
}

// A view asks for the size of every row whenever the pixel changes: laying out their texts for it took most
// of the time in which the window answered nothing.
TEST(ProbeModel, ARowIsAsHighAsItsChannelsWhateverTheirValues) {
  ProbeModel model;
  const auto height = [&](IntermediateId id) {
    return model.data(model.indexOf(id, ProbeModel::Value), Qt::SizeHintRole).toSize().height();
  };
  std::map<IntermediateId, int> before;
  for (const Intermediate& row : kIntermediates) before[row.id] = height(row.id);
  EXPECT_GT(before.at(IntermediateId::alpha), 0);
  EXPECT_GT(before.at(IntermediateId::motion), before.at(IntermediateId::alpha));
  twin::PixelRecord record;
  record.fill(glm::vec4(-1.0f / 3.0f));
  model.setRecord(record);
  for (const Intermediate& row : kIntermediates) EXPECT_EQ(height(row.id), before.at(row.id)) << row.label;
}

// What a box is made in depends on the settings of the values, and so do the names of its channels.
TEST(ProbeModel, NamesChannelsByTheSettingsOfTheValues) {
  ProbeModel model;
  ProbeResult result;
  result.around.resize(9);
  const auto names = [&](ColorSpace space) {
    result.settings.space.color = space;
    model.setPixel(result);
    QString text;
    for (const QString& line : cell(&model, IntermediateId::boxMin, ProbeModel::Value).split('\n'))
      text += line.section(QChar(QChar::Nbsp), 0, 0) + QLatin1Char(' ');
    return text.trimmed().toStdString();
  };
  EXPECT_EQ(names(ColorSpace::Rgb), "R G B");
  EXPECT_EQ(names(ColorSpace::YCoCg), "Y Co Cg");
  EXPECT_EQ(names(ColorSpace::YCbCr), "Y Cb Cr");
}

TEST(ProbeModel, SaysWhereThereIsNoHistoryYet) {
  ProbeModel model;
  twin::PixelRecord record{};
  twin::at(record, IntermediateId::rejectReason).x = 1.0f;
  model.setRecord(record);
  EXPECT_EQ(cell(&model, IntermediateId::historyRaw, ProbeModel::Value), "—");
  EXPECT_EQ(cell(&model, IntermediateId::historyRaw, ProbeModel::Meaning), "no history yet");
  EXPECT_NE(cell(&model, IntermediateId::resolved, ProbeModel::Value), "—");
}

// A narrow panel has no room for meanings.
TEST(ProbeModel, ADepthOfTheSkyIsNoLength) {
  ProbeModel model;
  twin::PixelRecord record{};
  model.setRecord(record);
  EXPECT_EQ(cell(&model, IntermediateId::depthView, ProbeModel::Unit), "sky");
  twin::at(record, IntermediateId::depthView).x = 2.0f;
  model.setRecord(record);
  EXPECT_EQ(cell(&model, IntermediateId::depthView, ProbeModel::Unit), "m");
}

TEST_F(ProbeTableTest, SaysWhatTheCoreSaysOfItsValues) {
  session.probes().setPixel(glm::ivec2(12, 7));
  settle();
  const ProbeResult& result = *session.probes().result();
  QString lines;
  for (const std::string& line : probeHeadline(result.around[4], result.settings, result.info))
    lines += (lines.isEmpty() ? QString() : QStringLiteral("\n")) + QString::fromStdString(line);
  EXPECT_EQ(window.probe()->summary(), lines);
}

// Tab goes to the links below the formula, Enter follows one.
TEST_F(ProbeTableTest, WritesAFormulaAsDeepAsAsked) {
  session.probes().setPixel(glm::ivec2(12, 7));
  settle();
  ProbeResult result = *session.probes().result();
  twin::Inputs inputs;
  inputs.color = filledWith(4);
  inputs.depth = inputs.previousDepth = inputs.objectId = filledWith(1);
  inputs.motion = inputs.historySurface = filledWith(2);
  inputs.normal = inputs.historyColor = filledWith(4);
  inputs.depthTerms = {0.0f, -0.1f, 1.0f, 0.0f};
  auto details = std::make_shared<twin::Details>();
  details->isFirst = false;
  details->trace = std::make_shared<const twin::Trace>(twin::traceOf(inputs, result.settings, {1, 1}));
  result.details = details;
  window.probe()->setResult(result);
  QTreeView* table = nullptr;
  for (auto* each : window.probe()->findChildren<QTreeView*>())
    if (each->isVisible() && each->model() == window.probe()->model()) table = each;
  ASSERT_TRUE(table);
  table->setCurrentIndex(window.probe()->model()->indexOf(IntermediateId::alpha));
  QLabel* description = nullptr;
  for (auto* each : window.probe()->findChildren<QLabel*>())
    if (each->text().contains("Formula down to")) description = each;
  ASSERT_TRUE(description);
  EXPECT_TRUE(description->text().contains("<b>other rows</b>")) << description->text().toStdString();
  const std::string before = description->text().toStdString();
  description->setFocus();
  QTest::keyClick(description, Qt::Key_Tab);
  QTest::keyClick(description, Qt::Key_Return);
  const QString after = description->text();
  EXPECT_TRUE(after.contains("<b>rows of other stages</b>")) << after.toStdString();
  EXPECT_TRUE(after.contains("1 / (")) << "1/(N + 1): " << after.toStdString();
  EXPECT_EQ(before.find("1 / ("), std::string::npos) << before;
}

TEST_F(ProbeTableTest, ShowsTheValuesAtTheProbe) {
  session.probes().setPixel(glm::ivec2(12, 7));
  settle();
  const QString value = cell(window.probe()->model(), IntermediateId::alpha, ProbeModel::Value).trimmed();
  EXPECT_EQ(value.toFloat(), test::FakeRenderer::valueAt(12, 7, 0));
  session.seek(5);
  settle();
  EXPECT_EQ(cell(window.probe()->model(), IntermediateId::alpha, ProbeModel::Value).trimmed().toFloat(),
            test::FakeRenderer::valueAt(12, 7, 5))
      << "the probe stays and follows the frame";
}

TEST_F(ProbeTableTest, CopiesTheExactValueOfTheActiveView) {
  session.probes().setPixel(glm::ivec2(3, 2));
  settle();
  key(Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text(), "203 203 203");
  key(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  const QString all = QApplication::clipboard()->text();
  for (const IntermediateId id : allRows()) {
    const Intermediate& row = intermediate(id);
    EXPECT_TRUE(all.contains(QString::fromStdString("\n" + std::string(row.name) + " "))) << row.name;
  }
}

// The object's number 2 is the value of that pixel.
TEST_F(ProbeTableTest, KeepsTheObjectsNameBeforeTheFrameWhereTheHeadHasLittleRoom) {
  session.seek(0);
  session.probes().setPixel(glm::ivec2(2, 0));
  settle();
  auto* place = window.probe()->head()->findChild<QLabel*>("place");
  ASSERT_TRUE(place);
  for (const char* text : {"(2, 0)  frame 0  rotor & hub", "(2, 0)  rotor & hub", "(2, 0)"}) {
    place->resize(place->fontMetrics().horizontalAdvance(text) + 4, place->height());
    EXPECT_EQ(place->text().toStdString(), text);
  }
}

TEST_F(ProbeTableTest, GoesAwayWithEscape) {
  session.probes().setPixel(glm::ivec2(3, 2));
  settle();
  EXPECT_TRUE(window.probe()->table()->isVisible());
  key(Qt::Key_Escape);
  EXPECT_FALSE(session.probes().pixel());
  EXPECT_TRUE(renderer->last<request::SetProbes>().all.empty());
  EXPECT_FALSE(window.probe()->table()->isVisible());
}

TEST_F(ProbeTableTest, GoesToTheNextWorstPixelByAKey) {
  session.probes().setPixel(std::nullopt);
  settle();
  window.views()->active()->setIntermediate(IntermediateId::errorGhost);
  key(Qt::Key_W, Qt::ShiftModifier);
  ASSERT_EQ(renderer->all<request::FindWorst>().size(), 1u);
  EXPECT_EQ(renderer->all<request::FindWorst>()[0].row, IntermediateId::errorGhost);
  EXPECT_FALSE(renderer->all<request::FindWorst>()[0].after) << "there is no probe";
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(1, 2));
  key(Qt::Key_W, Qt::ShiftModifier);
  ASSERT_EQ(renderer->all<request::FindWorst>().size(), 2u);
  EXPECT_EQ(renderer->all<request::FindWorst>()[1].after, glm::ivec2(1, 2));
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(2, 2));
  EXPECT_EQ(renderer->all<request::FindWorst>()[1].step, WorstStep::Pixel);
  EXPECT_EQ(window.statusLine()->hover().toStdString(),
            "Worst pixel 2 of 5 by History verdict: " +
                std::string(categoryText(IntermediateId::verdictMap, 2)));
  key(Qt::Key_W, Qt::AltModifier);
  ASSERT_EQ(renderer->all<request::FindWorst>().size(), 3u);
  EXPECT_EQ(renderer->all<request::FindWorst>()[2].step, WorstStep::Category);
}

TEST_F(ProbeTableTest, GoesToRejectedClippedAndNaNPixelsByKeys) {
  key(Qt::Key_J, Qt::AltModifier);
  key(Qt::Key_J, Qt::AltModifier | Qt::ShiftModifier);
  EXPECT_EQ(window.statusLine()->hover().toStdString(), "Clipped pixel 2 of 5, moved 50 % of the way");
  key(Qt::Key_X, Qt::AltModifier);
  ASSERT_EQ(renderer->all<request::FindWorst>().size(), 3u);
  EXPECT_EQ(renderer->all<request::FindWorst>()[0].step, WorstStep::Rejected);
  EXPECT_EQ(renderer->all<request::FindWorst>()[1].step, WorstStep::Clipped);
  EXPECT_EQ(renderer->all<request::FindWorst>()[2].step, WorstStep::NoNumber);
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(3, 2));
}

TEST_F(ProbeTableTest, RowsThatAreOffAreFoldedUnderALineThatUnfoldsThem) {
  session.probes().setPixel(glm::ivec2(3, 2));
  settle();
  QTreeView* table = window.probe()->table();
  const ProbeModel* model = window.probe()->model();
  const QModelIndex lock = model->indexOf(IntermediateId::lock);
  const QModelIndex line = model->foldOf(lock.parent());
  ASSERT_TRUE(line.isValid());
  EXPECT_TRUE(table->isRowHidden(lock.row(), lock.parent())) << "balanced has no locks";
  EXPECT_FALSE(table->isRowHidden(line.row(), line.parent()));
  EXPECT_TRUE(model->data(line, Qt::DisplayRole).toString().contains("Lock life"));
  table->scrollTo(line);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(line).center());
  EXPECT_FALSE(table->isRowHidden(lock.row(), lock.parent()));
  table->setCurrentIndex(line);
  QTest::keyClick(table, Qt::Key_Return);
  EXPECT_TRUE(table->isRowHidden(lock.row(), lock.parent()));
  session.presets().setParameter("rectify.locks", 1);
  settle();
  EXPECT_FALSE(table->isRowHidden(lock.row(), lock.parent())) << "they are on";
}

TEST(ProbeModel, ObjectsHaveTheirNames) {
  auto outline = std::make_shared<SceneOutline>();
  outline->nodes.resize(2);
  outline->nodes[1].key = "ball";
  outline->nodes[1].firstObject = 1;
  outline->nodes[1].objectCount = 2;
  outline->drawing = {1};
  ProbeModel model;
  model.setOutline(outline);
  twin::PixelRecord record{};
  twin::at(record, IntermediateId::objectId).x = 2.0f;
  model.setRecord(record);
  EXPECT_EQ(cell(&model, IntermediateId::objectId, ProbeModel::Meaning), "ball");
  EXPECT_EQ(cell(&model, IntermediateId::historyObjectId, ProbeModel::Meaning), "not kept") << "the sky's";
  EXPECT_EQ(model.objectName(3), "") << "there is no third";
}

// In a panel as wide as a window of 1600 pixels and more opens it, names and units are there to their last
// letter.
TEST_F(ProbeTableTest, HasRoomForNamesAndUnits) {
  ProbePanel panel;
  panel.resize(468, 800);
  panel.show();
  settle();
  const QTreeView* table = panel.table();
  const auto* model = dynamic_cast<const ProbeModel*>(table->model());
  ASSERT_NE(model, nullptr);
  EXPECT_FALSE(table->isColumnHidden(ProbeModel::Meaning));
  for (const Intermediate& row : kIntermediates)
    for (const int column : {ProbeModel::Name, ProbeModel::Unit}) {
      const QModelIndex index = model->indexOf(row.id, column);
      QStyleOptionViewItem option;
      option.initFrom(table);
      option.widget = table;
      option.font = model->data(index, Qt::FontRole).value<QFont>();
      option.fontMetrics = QFontMetrics(option.font);
      option.text = model->data(index, Qt::DisplayRole).toString();
      option.features = QStyleOptionViewItem::HasDisplay;
      const int indent = column == ProbeModel::Name ? table->indentation() : 0;
      option.rect = QRect(0, 0, table->columnWidth(column) - indent, 40);
      const int margins = 2 * (table->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, &option, table) + 1);
      const QRect room = table->style()->subElementRect(QStyle::SE_ItemViewItemText, &option, table);
      EXPECT_LE(QFontMetricsF(option.font).horizontalAdvance(option.text), room.width() - margins)
          << row.name << " " << column;
    }
}
