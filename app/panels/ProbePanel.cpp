#include "app/panels/ProbePanel.h"

#include "app/Text.h"
#include "app/Theme.h"
#include "app/models/ProbeModel.h"
#include "app/models/ProbeWords.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/Line.h"
#include "app/widgets/Swatches.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>

namespace taa::app {

namespace {

constexpr IntermediateId kNeighbors[] = {IntermediateId::color, IntermediateId::historyRectified,
                                         IntermediateId::resolved};
constexpr std::size_t kMiddle = 4; ///< of the 3×3 records
constexpr int kValueColumn = 19;   ///< characters

} // namespace

ProbePanel::ProbePanel(QWidget* parent) : QWidget(parent), model_(new ProbeModel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeTop());

  invitation_ = new QLabel(tr("Right-click a pixel to see every value at it."));
  invitation_->setWordWrap(true);
  invitation_->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
  invitation_->setContentsMargins(3 * kUnit, 8 * kUnit, 3 * kUnit, 0);
  invitation_->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(invitation_, 1);

  content_ = new QWidget;
  auto* column = new QVBoxLayout(content_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  summary_ = new QLabel;
  summary_->setWordWrap(true);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  summary_->setContentsMargins(2 * kUnit, 0, 2 * kUnit, 2 * kUnit);
  column->addWidget(summary_);
  column->addWidget(makeNeighbors());
  makeTable();
  column->addWidget(table_, 1);
  description_ = new QLabel;
  description_->setFont(secondaryFont());
  description_->setForegroundRole(QPalette::PlaceholderText);
  description_->setWordWrap(true);
  description_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  description_->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  description_->setFixedHeight(3 * QFontMetrics(secondaryFont()).lineSpacing() + 2 * kUnit);
  column->addWidget(new Line);
  column->addWidget(description_);
  layout->addWidget(content_, 1);
  setMinimumWidth(300);
  setPick({});
}

QWidget* ProbePanel::makeTop() {
  auto* top = new QWidget;
  auto* line = new QHBoxLayout(top);
  line->setContentsMargins(2 * kUnit, 2 * kUnit, kUnit, 2 * kUnit);
  line->setSpacing(2 * kUnit);
  auto* title = new QLabel(tr("Probe"));
  title->setFont(titleFont());
  place_ = new QLabel;
  place_->setFont(numberFont(10));
  place_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  copy_ = new IconButton(QStringLiteral("copy"), tr("Copy every value, exact (Ctrl+Shift+C)"));
  remove_ = new IconButton(QStringLiteral("close"), tr("Remove the probe (Esc)"));
  line->addWidget(title);
  line->addWidget(place_, 1);
  line->addWidget(copy_);
  line->addWidget(remove_);
  connect(copy_, &IconButton::clicked, this, &ProbePanel::copyRequested);
  connect(remove_, &IconButton::clicked, this, &ProbePanel::removeRequested);
  return top;
}

QWidget* ProbePanel::makeNeighbors() {
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(2 * kUnit, 0, 2 * kUnit, 2 * kUnit);
  line->setSpacing(4 * kUnit);
  const QString captions[] = {tr("current"), tr("history"), tr("resolved")};
  for (std::size_t i = 0; i < swatches_.size(); ++i) {
    swatches_[i] = new Swatches(captions[i]);
    swatches_[i]->setToolTip(
        tr("The pixel and its neighbors: %1").arg(qtext(intermediate(kNeighbors[i]).label)));
    line->addWidget(swatches_[i]);
  }
  line->addStretch(1);
  return row;
}

void ProbePanel::makeTable() {
  table_ = new QTreeView;
  table_->setModel(model_);
  table_->setRootIsDecorated(false);
  table_->setItemsExpandable(true);
  table_->setIndentation(3 * kUnit);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setAllColumnsShowFocus(true);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setTextElideMode(Qt::ElideRight);
  table_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->header()->setStretchLastSection(true);
  table_->header()->setSectionsMovable(false);
  table_->header()->setMinimumSectionSize(24);
  table_->expandAll();
  for (int row = 0; row < model_->rowCount(); ++row) table_->setFirstColumnSpanned(row, {}, true);
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          &ProbePanel::describeCurrentRow);
  connect(table_, &QTreeView::activated, this, [this](const QModelIndex& index) {
    if (const auto id = model_->idOf(index)) Q_EMIT intermediateChosen(*id);
  });
}

void ProbePanel::fitColumns() {
  const QFontMetrics small(secondaryFont()), digits(numberFont());
  int name = 0;
  for (const Intermediate& row : kIntermediates)
    name = std::max(name, small.horizontalAdvance(qtext(row.label)));
  const int valueWidth = digits.horizontalAdvance(QString(kValueColumn, QLatin1Char('0'))) + 2 * kUnit;
  const int unitWidth = small.horizontalAdvance(QStringLiteral("frames")) + 2 * kUnit;
  const int room = width() - table_->verticalScrollBar()->sizeHint().width() - valueWidth - unitWidth;
  const int nameWidth = std::min(room, name + table_->indentation() + 3 * kUnit);
  table_->setColumnWidth(ProbeModel::Name, nameWidth);
  table_->setColumnWidth(ProbeModel::Value, valueWidth);
  table_->setColumnWidth(ProbeModel::Unit, unitWidth);
  table_->setColumnHidden(ProbeModel::Meaning,
                          room - nameWidth <
                              small.horizontalAdvance(QStringLiteral("the pixel itself")) + 2 * kUnit);
}

void ProbePanel::resizeEvent(QResizeEvent*) {

  fitColumns();
}

void ProbePanel::setPick(std::optional<glm::ivec2> pixel) {
  content_->setVisible(pixel.has_value());
  invitation_->setVisible(!pixel);
  copy_->setVisible(pixel.has_value());
  remove_->setVisible(pixel.has_value());
  if (!pixel) {
    result_.reset();
    place_->clear();
    model_->setRecord({});
    return;
  }
  place_->setText(QStringLiteral("(%1, %2)").arg(pixel->x).arg(pixel->y));
}

void ProbePanel::setResult(const ProbeResult& result, const Settings& settings) {
  if (result.around.size() <= kMiddle) return;
  result_ = result;
  const PixelRecord& record = result.around[kMiddle];
  place_->setText(tr("(%1, %2)  frame %3").arg(result.x).arg(result.y).arg(result.frame));
  summary_->setText(probeSummary(record, settings).join(QLatin1Char('\n')));
  model_->setRecord(record);
  for (std::size_t i = 0; i < swatches_.size(); ++i) {
    std::array<std::array<float, 3>, 9> colors{};
    for (std::size_t pixel = 0; pixel < std::min(colors.size(), result.around.size()); ++pixel) {
      const glm::vec4 value = reference::at(result.around[pixel], kNeighbors[i]);
      colors[pixel] = {value.x, value.y, value.z};
    }
    swatches_[i]->setColors(colors);
  }
  describeCurrentRow();
}

void ProbePanel::describeCurrentRow() {
  const auto id = model_->idOf(table_->currentIndex());
  description_->setText(
      id ? QStringLiteral("%1: %2").arg(qtext(intermediate(*id).label), qtext(intermediate(*id).description))
         : tr("Select a row to read what it means; Enter shows it in the active view."));
}

QString ProbePanel::valueText(IntermediateId fallback) const {
  if (!result_) return {};
  const auto selected = table_->hasFocus() ? model_->idOf(table_->currentIndex()) : std::nullopt;
  const IntermediateId id = selected.value_or(fallback);
  return rowText(intermediate(id), reference::at(result_->around[kMiddle], id));
}

QString ProbePanel::allText() const {
  if (!result_) return {};
  return tr("pixel %1 %2 frame %3\n").arg(result_->x).arg(result_->y).arg(result_->frame) +
         probeText(result_->around[kMiddle]);
}

QString ProbePanel::summary() const {
  return summary_->text();
}

} // namespace taa::app
