#include "app/views/plots/WhatIfPage.h"

#include "app/background/BackgroundBar.h"
#include "app/style/Numbers.h"
#include "app/style/PictureImage.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/Note.h"
#include "app/widgets/ValueTable.h"
#include "core/picture/ColorMap.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStringList>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace taa::app {

namespace {

enum WhatIfColumn { NameColumn, ErrorColumn, ResolvedColumn, ChangeColumn, AlphaColumn, FirstPictureColumn };
constexpr int kWhatIfColumns = FirstPictureColumn + static_cast<int>(kPictureMetrics.size());
/// Those that make room first where a name would be cut: swatch and tip say them, too. What rows are sorted
/// by stays longest.
constexpr std::array<int, 3> kGivingWay{ResolvedColumn, ChangeColumn, AlphaColumn};
constexpr std::array<int, 3> kGivingWayByChange{ResolvedColumn, AlphaColumn, ChangeColumn};
constexpr int kLowestWithNote = 12;     ///< rows
constexpr int kCellMargins = 3 * kUnit; ///< both sides
constexpr int kPictureFrames = 8;       ///< up to the probed one

/// Three decimals a channel: what a narrow table has room for.
QString channelsText(const glm::vec3& color) {
  QStringList channels;
  for (int channel = 0; channel < 3; ++channel) {
    const auto value = static_cast<double>(color[channel]);
    channels << (std::fabs(value) < 10 ? fixedText(value, 3) : shortText(value));
  }
  return channels.join(QLatin1Char(' '));
}

QString tipOf(const WhatIfRow& row, const WhatIfEntry& entry, const PictureNumbers::Means* means) {
  QStringList lines{WhatIfPage::tr("%1: %2").arg(qtext(whatIfGroupLabel(row.group)), qtext(row.label)),
                    WhatIfPage::tr("resolved %1").arg(channelsText(row.resolved)),
                    WhatIfPage::tr("changed by %1").arg(channelsText(row.difference))};
  if (entry.error)
    lines << WhatIfPage::tr("from the reference, as shown: %1").arg(shortText(*entry.error, 3));
  for (std::size_t place = 0; means && place < means->size(); ++place)
    if ((*means)[place])
      lines << WhatIfPage::tr("picture, %1: %2")
                   .arg(qtext(metricInfo(kPictureMetrics[place]).label), shortText(*(*means)[place], 4));
  if (!row.note.empty()) lines << QStringLiteral("* ") + QString::fromStdString(row.note);
  if (!row.isCurrent) lines << WhatIfPage::tr("A click or Enter tries it; Ctrl+Z takes it back");
  return lines.join(QLatin1Char('\n'));
}

ValueTable::Row lineOf(const WhatIfRow& row, const WhatIfEntry& entry, const PictureNumbers::Means* means) {
  QString name = (row.isCurrent ? QStringLiteral("▸ ") : QString()) + qtext(row.label);
  if (!row.note.empty()) name += QStringLiteral(" *");
  QStringList cells{name, entry.error ? shortText(*entry.error, 2) : QString(), channelsText(row.resolved),
                    entry.change == 0 ? WhatIfPage::tr("same") : shortText(entry.change, 2),
                    shortText(static_cast<double>(row.alpha), 3)};
  for (std::size_t place = 0; place < kPictureMetrics.size(); ++place)
    cells << (means && (*means)[place] ? shortText(*(*means)[place], 2) : QString());
  return {cells, shownColor(row.resolved), false, tipOf(row, entry, means)};
}

/// The same whatever settings it is drawn with, and whichever frame is on show.
bool isSameShot(const SessionFile& a, const SessionFile& b) {
  return a.source == b.source && a.camera == b.camera && a.choice == b.choice && a.size == b.size &&
         a.track == b.track && a.filter == b.filter && a.motionModes == b.motionModes &&
         a.objectClasses == b.objectClasses && a.restarts == b.restarts;
}

} // namespace

WhatIfPage::WhatIfPage(SweepWork::Sweep sweep, QWidget* parent)
    : QWidget(parent), work_(std::move(sweep)), order_(new QLabel), note_(new QLabel) {
  table_ = new ValueTable({tr("Instead"), tr("Error"), tr("Resolved"), tr("Change"), tr("α"), tr("Ghost"),
                           tr("Flicker"), tr("Sharp")});
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setAllColumnsShowFocus(true);
  table_->setFocusPolicy(Qt::StrongFocus);
  table_->installEventFilter(this);
  bar_ = new BackgroundBar(work_, tr("Measure pictures"), NotePlace::Below);
  draw_ = bar_->addButton(tr("Draw the reference"), tr("Draw the reference that rows are sorted by"));
  table_->setAccessibleName(tr("The pixel under other choices"));
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // else columns change with the number of rows
  table_->headerItem()->setToolTip(ErrorColumn, tr("How far the pixel is from the reference, as shown"));
  table_->headerItem()->setToolTip(ChangeColumn, tr("How far it moves the pixel, as shown"));
  for (std::size_t place = 0; place < kPictureMetrics.size(); ++place)
    table_->headerItem()->setToolTip(FirstPictureColumn + static_cast<int>(place),
                                     qtext(metricInfo(kPictureMetrics[place]).description));
  note_->setText(
      tr("This frame again on the history it had, one choice replaced. ▸ is in force, a click or Enter tries "
         "another. * uses jitter and inputs as they are now, or misses what this history does not keep."));
  table_->setToolTip(note_->text());
  layOut();
  connect(table_, &QTreeWidget::currentItemChanged, this,
          [this](QTreeWidgetItem* item) { chosen_ = keyOf(table_->indexOfTopLevelItem(item)); });
  connect(draw_, &QPushButton::clicked, this, &WhatIfPage::referenceRequested);
  connect(table_, &QTreeWidget::itemClicked, this,
          [this](QTreeWidgetItem* item) { tryLine(table_->indexOfTopLevelItem(item)); });
  connect(bar_, &BackgroundBar::startRequested, this, &WhatIfPage::measuringRequested);
  connect(&work_, &SweepWork::measured, this, [this](std::size_t index, const LaneMetrics& frames) {
    numbers_.add(measuring_[index], frames);
    show();
  });
  connect(&work_, &SweepWork::ended, this, [this](const QString& error) {
    refresh();
    if (!error.isEmpty()) bar_->setNote(error);
  });
  show();
}

void WhatIfPage::layOut() {
  for (QLabel* label : {order_, note_}) {
    setSecondary(*label);
    label->setWordWrap(true);
    label->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  }
  bar_->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(order_);
  column->addWidget(table_, 1);
  column->addWidget(note_);
  column->addWidget(bar_);
}

void WhatIfPage::setResult(const std::optional<ProbeResult>& result) {
  result_ = result;
  show();
}

void WhatIfPage::setPlaying(bool playing) {
  if (playing == isPlaying_) return;
  isPlaying_ = playing;
  show();
}

void WhatIfPage::show() {
  std::vector<ValueTable::Row> rows;
  const std::vector<WhatIfEntry> entries =
      result_ ? whatIfEntries(*result_, !isPlaying_) : std::vector<WhatIfEntry>();
  const std::vector<Variant> variants =
      entries.empty() ? std::vector<Variant>() : variantsOf(result_->settings);
  lines_.clear();
  for (const WhatIfEntry& entry : entries) {
    const WhatIfRow& row = result_->whatIf[entry.row];
    const auto variant = std::ranges::find_if(
        variants, [&](const Variant& each) { return each.group == row.group && each.id == row.id; });
    rows.push_back(
        lineOf(row, entry, variant == variants.end() ? nullptr : numbers_.find(variant->settings)));
    lines_.push_back(entry.row);
  }
  {
    const QSignalBlocker quiet(table_);
    table_->setRows(rows);
    chooseAgain();
  }
  showOrder(!entries.empty() && entries.front().error);
  for (int place = FirstPictureColumn; place < kWhatIfColumns; ++place)
    table_->setColumnHidden(place, numbers_.isEmpty());
  fitColumns();
  refresh();
}

void WhatIfPage::showOrder(bool hasReference) {
  const bool hasRows = !lines_.empty();
  table_->setColumnHidden(ErrorColumn, !hasReference);
  order_->setText(!hasRows       ? QString()
                  : hasReference ? tr("Sorted by the error to the reference, the nearest first.")
                  : isPlaying_   ? tr("In their own order while it plays.")
                                 : tr("There is no reference of this frame yet: sorted by how much each "
                                        "changes the pixel, the most first."));
  draw_->setVisible(hasRows && !hasReference);
}

QString WhatIfPage::order() const {
  return order_->text();
}

std::optional<WhatIfPage::VariantKey> WhatIfPage::keyOf(int line) const {
  if (line < 0 || line >= static_cast<int>(lines_.size()) || !result_) return {};
  const WhatIfRow& row = result_->whatIf[lines_[static_cast<std::size_t>(line)]];
  return VariantKey(row.group, row.id);
}

void WhatIfPage::chooseAgain() {
  for (int line = 0; chosen_ && line < table_->topLevelItemCount(); ++line)
    if (keyOf(line) == chosen_) table_->setCurrentItem(table_->topLevelItem(line));
}

void WhatIfPage::fitColumns() {
  for (const int column : kGivingWay) table_->setColumnHidden(column, false);
  const QFontMetrics names(secondaryFont()), digits(numberFont());
  std::array<int, kWhatIfColumns> widths{};
  int room = table_->viewport()->width() - table_->iconSize().width();
  for (int column = 0; column < kWhatIfColumns; ++column) {
    int& width = widths[static_cast<std::size_t>(column)];
    if (column != NameColumn) width = names.horizontalAdvance(table_->headerItem()->text(column));
    for (const ValueTable::Row& row : table_->rows())
      width =
          std::max(width, (column == NameColumn ? names : digits).horizontalAdvance(row.cells.value(column)));
    width += kCellMargins;
    if (!table_->isColumnHidden(column)) room -= width;
  }
  for (const int column : table_->isColumnHidden(ErrorColumn) ? kGivingWayByChange : kGivingWay) {
    if (room >= 0) break;
    table_->setColumnHidden(column, true);
    room += widths[static_cast<std::size_t>(column)];
  }
}

void WhatIfPage::tryLine(int line) {
  if (line < 0 || line >= static_cast<int>(lines_.size()) || !result_) return;
  const WhatIfRow& row = result_->whatIf[lines_[static_cast<std::size_t>(line)]];
  if (row.isCurrent) return;
  if (const auto variant = variantOf(result_->settings, row)) Q_EMIT tried(*variant);
}

bool WhatIfPage::eventFilter(QObject* watched, QEvent* event) {
  if (watched != table_ || event->type() != QEvent::KeyPress) return false;
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key != Qt::Key_Return && key != Qt::Key_Enter) return false;
  tryLine(table_->indexOfTopLevelItem(table_->currentItem()));
  return true;
}

void WhatIfPage::setShot(const SessionFile& shot) {
  if (!measured_ || isSameShot(*measured_, shot)) return;
  work_.cancel();
  measured_.reset();
  numbers_.clear();
  show();
}

void WhatIfPage::measure(const SessionFile& shot, int referenceSamples) {
  if (!result_) return;
  if (referenceSamples == 0) {
    bar_->setNote(tr("There is no reference to measure against."));
    return;
  }
  const int last = result_->frame, first = std::max(0, last - kPictureFrames + 1);
  if (!measured_ || !isSameShot(*measured_, shot) || first != first_ || last != last_) numbers_.clear();
  measured_ = shot;
  first_ = first;
  last_ = last;
  ShotSweepRequest request{
      {shot}, {}, {first, last, {kPictureMetrics.begin(), kPictureMetrics.end()}, referenceSamples}};
  measuring_.clear();
  for (const Variant& variant : variantsOf(result_->settings)) {
    if (numbers_.find(variant.settings) ||
        std::ranges::find(measuring_, variant.settings) != measuring_.end())
      continue;
    measuring_.push_back(variant.settings);
    request.settings.push_back({variant.label, variant.settings});
  }
  work_.begin(request);
  show();
}

void WhatIfPage::refresh() {
  const bool canStart = result_ && !result_->whatIf.empty();
  bar_->setReady(canStart, numbers_.isEmpty() ? tr("Ghost, flicker and sharpness of the whole picture")
                                              : tr("Pictures are of frames %1 to %2").arg(first_).arg(last_));
}

void WhatIfPage::resizeEvent(QResizeEvent*) {
  fitColumns();
  note_->setVisible(height() >= kLowestWithNote * rowHeight()); // the table's tip says it, too
}

QString WhatIfPage::text() const {
  return table_->text();
}

} // namespace taa::app
