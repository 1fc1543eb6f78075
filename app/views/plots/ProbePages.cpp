#include "app/views/plots/ProbePages.h"

#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/plots/ColorSpaceView.h"
#include "app/widgets/ValueTable.h"
#include "app/widgets/parameters/SegmentedButtons.h"
#include "core/picture/ColorMap.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <vector>

namespace taa::app {

namespace {

constexpr int kName = 0, kResolved = 1, kChange = 2, kAlpha = 3; ///< columns of "What if"
constexpr int kPageMargins = 3 * kUnit;                          ///< of a cell, both sides

QLabel* makeNote() {
  auto* note = new QLabel;
  note->setFont(secondaryFont());
  note->setForegroundRole(QPalette::PlaceholderText);
  note->setWordWrap(true);
  return note;
}

QColor encoded(const glm::vec3& linear) {
  const auto byte = [](float value) {
    return static_cast<int>(std::lround(255.0f * srgbEncoded(value > 0 ? std::min(value, 1.0f) : 0.0f)));
  };
  return {byte(linear.x), byte(linear.y), byte(linear.z)};
}

/// Three decimals a channel: what a narrow table has room for.
QString colorText(const glm::vec3& color) {
  QStringList channels;
  for (int channel = 0; channel < 3; ++channel) {
    const auto value = static_cast<double>(color[channel]);
    channels << (std::fabs(value) < 10 ? QString::number(value, 'f', 3) : shortText(value));
  }
  return channels.join(QLatin1Char(' '));
}

/// Of the channel that differs most.
float largest(const glm::vec3& difference) {
  float most = difference.x;
  for (const float channel : {difference.y, difference.z})
    if (std::fabs(channel) > std::fabs(most)) most = channel;
  return most;
}

std::vector<ValueTable::Row> rowsOf(const std::vector<WhatIfRow>& variants) {
  std::vector<ValueTable::Row> rows;
  for (const WhatIfRow& row : variants) {
    const bool isFirst = &row == variants.data() || (&row - 1)->group != row.group;
    if (isFirst) rows.push_back({{tableText(whatIfGroupLabel(row.group)), {}, {}, {}}, {}, true});
    const float difference = largest(row.difference);
    QString name = (row.isCurrent ? QStringLiteral("▸ ") : QString()) + tableText(row.label);
    if (!row.note.empty()) name += QStringLiteral(" *");
    QString tip = WhatIfPage::tr("%1: resolved %2").arg(tableText(row.label), colorText(row.resolved));
    if (!row.note.empty()) tip += QStringLiteral("\n* ") + QString::fromStdString(row.note);
    rows.push_back({{name, colorText(row.resolved),
                     difference == 0 ? WhatIfPage::tr("same") : shortText(static_cast<double>(difference), 2),
                     shortText(static_cast<double>(row.alpha), 3)},
                    encoded(row.resolved),
                    false,
                    tip});
  }
  return rows;
}

} // namespace

ColorSpacePage::ColorSpacePage(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kUnit);
  auto* line = new QHBoxLayout;
  line->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, 0);
  spaces_ = new SegmentedButtons({tr("RGB"), tr("YCoCg")});
  spaces_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  spaces_->setAccessibleName(tr("Axes of the color space plot"));
  note_ = makeNote();
  line->addWidget(spaces_);
  line->addWidget(note_, 1);
  column->addLayout(line);
  view_ = new ColorSpaceView;
  view_->setToolTip(tr("Drag to turn, double-click to turn back"));
  column->addWidget(view_, 1);
  connect(spaces_, &SegmentedButtons::chosen, this,
          [this](int index) { setSpace(static_cast<PlotSpace>(index)); });
  setSpace(chosen_);
}

void ColorSpacePage::setSpace(PlotSpace space) {
  chosen_ = space;
  spaces_->setCurrent(static_cast<int>(space));
  show();
}

void ColorSpacePage::setResult(const std::optional<ProbeResult>& result) {
  result_ = result;
  show();
}

void ColorSpacePage::show() {
  if (!result_ || !result_->details || result_->around.size() <= kProbedMiddle) return view_->setScene({});
  view_->setScene(colorScene(result_->around[kProbedMiddle], *result_->details, result_->settings, chosen_,
                             result_->whatIf));
  const bool isBounded = result_->settings.space.tone != ToneSpace::Linear;
  note_->setText(isBounded ? tr("highlights bounded, as the box has them") : tr("scene-linear"));
}

WhatIfPage::WhatIfPage(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  table_ = new ValueTable({tr("Instead"), tr("Resolved"), tr("Change"), tr("α")});
  table_->setAccessibleName(tr("The pixel under other choices"));
  table_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (int section = 1; section < 4; ++section)
    table_->header()->setSectionResizeMode(section, QHeaderView::ResizeToContents);
  table_->header()->setStretchLastSection(false);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // else columns change with the number of rows
  column->addWidget(table_, 1);
  note_ = makeNote();
  note_->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  note_->setText(
      tr("This frame again on the history it had, one choice replaced. ▸ is in force. * uses jitter "
         "and inputs as they are now, or misses what this history does not keep."));
  column->addWidget(note_);
}

void WhatIfPage::setResult(const std::optional<ProbeResult>& result) {
  table_->setRows(result ? rowsOf(result->whatIf) : std::vector<ValueTable::Row>());
  fitColumns();
}

// Where a name would be cut, the values of the resolved color make room: swatch and tip say them, too.
void WhatIfPage::fitColumns() {
  const QFontMetrics names(secondaryFont()), digits(numberFont());
  int name = 0;
  for (const ValueTable::Row& row : table_->rows())
    name = std::max(name, names.horizontalAdvance(row.cells.value(kName)));
  int room = table_->viewport()->width() - table_->iconSize().width();
  for (const int column : {kResolved, kChange, kAlpha}) {
    int width = names.horizontalAdvance(table_->headerItem()->text(column));
    for (const ValueTable::Row& row : table_->rows())
      width = std::max(width, digits.horizontalAdvance(row.cells.value(column)));
    room -= width + kPageMargins;
  }
  table_->setColumnHidden(kResolved, room < name + kPageMargins);
}

void WhatIfPage::resizeEvent(QResizeEvent*) {
  fitColumns();
}

QString WhatIfPage::text() const {
  return table_->text();
}

} // namespace taa::app
