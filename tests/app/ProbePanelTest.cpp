// The probe table: every intermediate, exact values, words.
#include "app/panels/ProbePanel.h"
#include "app/Numbers.h"
#include "app/models/ProbeModel.h"
#include "app/models/ProbeWords.h"
#include "tests/app/WindowFixture.h"

#include <QClipboard>
#include <QStyle>
#include <QStyleOptionViewItem>
#include <QTreeView>

#include <map>
#include <string>

using namespace taa;
using namespace taa::app;
using ProbeTable = test::FakeWindow;

namespace {

QString cell(const ProbeModel* model, IntermediateId id, int column) {
  return model->data(model->indexOf(id, column), Qt::DisplayRole).toString();
}

} // namespace

TEST(ProbeWords, SayWhyHistoryWasRejected) {
  const Intermediate& row = intermediate(IntermediateId::rejectReason);
  EXPECT_EQ(valueWords(row, glm::vec4(0)).toStdString(), rejectReasonText(0));
  EXPECT_EQ(valueWords(row, glm::vec4(3)).toStdString(), rejectReasonText(3));
  EXPECT_EQ(valueWords(intermediate(IntermediateId::depth), glm::vec4(0)), "sky");
  EXPECT_EQ(valueWords(intermediate(IntermediateId::motion), glm::vec4(65504)), "no previous");
}

TEST(ProbeWords, TellHowAlphaCameAbout) {
  reference::PixelRecord record;
  record.fill(glm::vec4(0));
  for (const IntermediateId calm : {IntermediateId::alphaLumaFlicker, IntermediateId::alphaNearClamp,
                                    IntermediateId::alphaHistoryContrast, IntermediateId::alphaRelax,
                                    IntermediateId::alphaSampleDistance})
    reference::at(record, calm).x = 1.0f;
  reference::at(record, IntermediateId::historyKeptLength).x = 7;
  reference::at(record, IntermediateId::alphaBase).x = 0.125f;
  reference::at(record, IntermediateId::alphaFloor).x = 0.1f;
  reference::at(record, IntermediateId::alpha).x = 0.125f;
  const QString lines = probeSummary(record, {}).join('\n');
  EXPECT_TRUE(lines.contains(QStringLiteral("N = 7 → α = max(1/(7 + 1), 0.1) = 0.125")))
      << lines.toStdString();
  reference::at(record, IntermediateId::rejectReason).x = 4;
  EXPECT_TRUE(
      probeSummary(record, {}).join('\n').contains(QString::fromStdString(std::string(rejectReasonText(4)))));
}

// The sentence is that of the source chosen, with every term that took part.
TEST(ProbeWords, TellOfTheSourceThatWasChosen) {
  reference::PixelRecord record;
  record.fill(glm::vec4(0));
  const auto set = [&](IntermediateId id, float value) { reference::at(record, id).x = value; };
  Settings settings;
  const auto line = [&] { return probeSummary(record, settings).at(1); };
  for (const IntermediateId calm : {IntermediateId::alphaLumaFlicker, IntermediateId::alphaNearClamp,
                                    IntermediateId::alphaHistoryContrast, IntermediateId::alphaRelax,
                                    IntermediateId::alphaSampleDistance})
    set(calm, 1.0f);
  set(IntermediateId::historyKeptLength, 1.3f);
  set(IntermediateId::alphaBase, 0.0625f);
  set(IntermediateId::alphaFloor, 0.0625f);
  set(IntermediateId::alpha, 0.0625f);
  settings.weight.source = AlphaSource::LumaDifference;
  EXPECT_EQ(line(), QStringLiteral("α = luma difference 0.0625"));
  settings.weight.source = AlphaSource::Constant;
  EXPECT_EQ(line(), QStringLiteral("α = constant 0.0625"));
  set(IntermediateId::alphaBase, 1.0f);
  set(IntermediateId::alphaLumaFlicker, 0.5f);
  set(IntermediateId::alpha, 0.5f);
  EXPECT_EQ(line(), QStringLiteral("α = constant 1 × 0.5 = 0.5")) << "a product that ends like its value";
  set(IntermediateId::alphaBase, 0.0625f);
  set(IntermediateId::alphaFloor, 0.04f);
  set(IntermediateId::alpha, 0.04f);
  EXPECT_EQ(line(), QStringLiteral("α = max(constant 0.0625 × 0.5, 0.04) = 0.04"));
  set(IntermediateId::alphaFloor, 0.0f);
  set(IntermediateId::alphaMotion, 0.25f);
  set(IntermediateId::alpha, 0.2734375f);
  EXPECT_EQ(line(), QStringLiteral("α = constant 0.0625 × 0.5 and 0.25 by motion = 0.2734"));
  set(IntermediateId::alphaMask, 0.5f);
  set(IntermediateId::alpha, 0.5f);
  EXPECT_EQ(line(), QStringLiteral("α = max(constant 0.0625 × 0.5 and 0.25 by motion, 0.5 by mask) = 0.5"));
  set(IntermediateId::alphaMask, 0.0f);
  set(IntermediateId::alphaSampleDistance, 0.25f);
  set(IntermediateId::alpha, 0.5f);
  settings.weight.frameRate = Switch::On;
  EXPECT_EQ(line(),
            QStringLiteral("α = constant 0.0625 × 0.5 × 0.25 and 0.25 by motion by the frame's time = 0.5"));
  settings.weight.frameRate = Switch::Off;
  set(IntermediateId::alphaSampleDistance, 1.0f);
  set(IntermediateId::alphaMotion, 0.0f);
  settings.inputs.renderScale = 0.5f;
  set(IntermediateId::alphaLumaFlicker, 1.0f);
  set(IntermediateId::sampleConfidence, 0.5f);
  set(IntermediateId::alpha, 0.03125f);
  EXPECT_EQ(line(), QStringLiteral("α = κ 0.5 × (constant 0.0625) = 0.03125"));
  settings.inputs.renderScale = 1.0f;
  set(IntermediateId::alphaLumaFlicker, 0.5f);
  set(IntermediateId::alphaDivergence, 0.25f);
  set(IntermediateId::alpha, 0.2734375f);
  EXPECT_EQ(line(), QStringLiteral("α = constant 0.0625 × 0.5 and 0.25 by divergence = 0.2734"));
  set(IntermediateId::alphaDivergence, 0.0f);
  settings.weight.source = AlphaSource::ContrastPerChannel;
  reference::at(record, IntermediateId::alphaChannels) = {0.5f, 0.25f, 0.125f, 0.0f};
  EXPECT_TRUE(line().contains(QStringLiteral("= 0.2734, of channels "))) << line().toStdString();
}

// Soft rejection leaves history its part; hard rejection does not.
TEST(ProbeWords, TellHowMuchARejectionTakes) {
  reference::PixelRecord record;
  record.fill(glm::vec4(0));
  const auto set = [&](IntermediateId id, float value) { reference::at(record, id).x = value; };
  for (const IntermediateId calm : {IntermediateId::alphaLumaFlicker, IntermediateId::alphaNearClamp,
                                    IntermediateId::alphaHistoryContrast, IntermediateId::alphaRelax,
                                    IntermediateId::alphaSampleDistance})
    set(calm, 1.0f);
  Settings settings;
  settings.weight.source = AlphaSource::Constant;
  set(IntermediateId::alphaBase, 0.125f);
  set(IntermediateId::rejectReason, 6.0f);
  set(IntermediateId::alphaInvalid, 0.5f);
  set(IntermediateId::alpha, 0.5f);
  EXPECT_TRUE(probeSummary(record, settings).at(0).contains(QStringLiteral("counts less: another object")));
  EXPECT_EQ(probeSummary(record, settings).at(1),
            QStringLiteral("α = constant 0.125, at least 0.5 when rejected = 0.5"));
  set(IntermediateId::alphaInvalid, 1.0f);
  EXPECT_TRUE(probeSummary(record, settings).at(0).contains(QStringLiteral("rejected: another object")));
  EXPECT_EQ(valueWords(intermediate(IntermediateId::objectClass), glm::vec4(3)), "deforms");
}

TEST(ProbeWords, SayWhatIsShownInsteadOfTheResolvedColor) {
  reference::PixelRecord record{};
  Settings settings;
  EXPECT_EQ(probeSummary(record, settings).size(), 3);
  settings.output.sharpen = Sharpen::Laplacian;
  settings.output.motionBlur = Switch::On;
  reference::at(record, IntermediateId::blurTrust).x = 1.0f;
  EXPECT_EQ(probeSummary(record, settings).size(), 3) << "neither changes anything here";
  reference::at(record, IntermediateId::sharpenDetail).x = -0.25f;
  EXPECT_EQ(probeSummary(record, settings).last(), QStringLiteral("Shown sharpened: 0.25 darker"));
  reference::at(record, IntermediateId::blurTrust).x = 0.6f;
  EXPECT_EQ(probeSummary(record, settings).last(),
            QStringLiteral("Shown sharpened: 0.25 darker, 40 % motion blur"));
  reference::at(record, IntermediateId::overlayAlpha).x = 0.5f;
  EXPECT_EQ(probeSummary(record, {}).last(), QStringLiteral("Shown 50 % hidden by the overlay"));
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

TEST(ProbeModel, ValuesReadBackAsTheSameFloats) {
  ProbeModel model;
  reference::PixelRecord record;
  record.fill(glm::vec4(0.1f, -1.0f / 3.0f, 12345.678f, 0));
  model.setRecord(record);
  const QStringList lines = cell(&model, IntermediateId::color, ProbeModel::Value).split('\n');
  ASSERT_EQ(lines.size(), 3);
  for (int channel = 0; channel < 3; ++channel) {
    QString number = lines[channel].mid(1).trimmed(); // without the channel's letter
    number.replace(QChar(0x2212), '-');
    EXPECT_EQ(number.toFloat(), record[0][channel]) << lines[channel].toStdString();
  }
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
  reference::PixelRecord record;
  record.fill(glm::vec4(-1.0f / 3.0f));
  model.setRecord(record);
  for (const Intermediate& row : kIntermediates) EXPECT_EQ(height(row.id), before.at(row.id)) << row.label;
}

TEST_F(ProbeTable, ShowsTheValuesAtThePick) {
  session.setPick(glm::ivec2(12, 7));
  settle();
  const QString value = cell(window.probe()->model(), IntermediateId::alpha, ProbeModel::Value).trimmed();
  EXPECT_EQ(value.toFloat(), test::FakeRenderer::valueAt(12, 7, 0));
  session.seek(5);
  settle();
  EXPECT_EQ(cell(window.probe()->model(), IntermediateId::alpha, ProbeModel::Value).trimmed().toFloat(),
            test::FakeRenderer::valueAt(12, 7, 5))
      << "the pick stays and follows the frame";
}

TEST_F(ProbeTable, CopiesTheExactValueOfTheActiveView) {
  session.setPick(glm::ivec2(3, 2));
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

TEST_F(ProbeTable, GoesAwayWithEscape) {
  session.setPick(glm::ivec2(3, 2));
  settle();
  EXPECT_TRUE(window.probe()->table()->isVisible());
  key(Qt::Key_Escape);
  EXPECT_FALSE(session.pick());
  EXPECT_TRUE(renderer->pins.empty());
  EXPECT_FALSE(window.probe()->table()->isVisible());
}

// In a panel as wide as a window of 1600 pixels and more opens it, names and units are there to their last
// letter.
TEST_F(ProbeTable, HasRoomForNamesAndUnits) {
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
