#include "app/widgets/ValueTable.h"

#include "app/style/Theme.h"

#include <QEvent>
#include <QHeaderView>
#include <QList>
#include <QPixmap>
#include <QScrollBar>
#include <QSignalBlocker>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace taa::app {

namespace {

constexpr int kWidestName = 240; ///< px, of what a table asks to have room for

QString quoted(QString field) {
  if (!field.contains(QLatin1Char(',')) && !field.contains(QLatin1Char('"'))) return field;
  return QLatin1Char('"') + field.replace(QLatin1String("\""), QLatin1String("\"\"")) + QLatin1Char('"');
}

} // namespace

ValueTable::ValueTable(const QStringList& header, QWidget* parent) : QTreeWidget(parent), header_(header) {
  setColumnCount(static_cast<int>(header.size()));
  setHeaderLabels(header);
  setAccessibleName(tr("Table: %1").arg(header.join(QStringLiteral(", "))));
  setRootIsDecorated(false);
  setIndentation(0);
  setUniformRowHeights(true);
  setFrameShape(QFrame::NoFrame);
  setSelectionMode(QAbstractItemView::NoSelection);
  setFocusPolicy(Qt::NoFocus);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setIconSize({10, 10});
  this->header()->setStretchLastSection(false);
  this->header()->setMinimumSectionSize(24);
  this->header()->setSectionsMovable(false);
  for (int column = 0; column < columnCount(); ++column) {
    this->header()->setSectionResizeMode(column,
                                         column == 0 ? QHeaderView::Stretch : QHeaderView::ResizeToContents);
    headerItem()->setTextAlignment(column, Qt::AlignVCenter | (column == 0 ? Qt::AlignLeft : Qt::AlignRight));
  }
}

void ValueTable::setRows(const std::vector<Row>& rows) {
  if (rows == rows_) return;
  rows_ = rows;
  const int count = static_cast<int>(rows.size());
  while (topLevelItemCount() > count) delete takeTopLevelItem(count);
  QList<QTreeWidgetItem*> added;
  while (topLevelItemCount() + added.size() < count) added << new QTreeWidgetItem;
  addTopLevelItems(added);
  if (count > 0) fillRows();
  const int needed = neededWidth();
  if (needed <= widest_) return;
  widest_ = needed; // never less: the columns beside it would jump
  updateGeometry();
}

// Told once: with each word that changes the header asks for the widths of all others, by which a thousand
// rows of jitter stopped the window for a minute.
void ValueTable::fillRows() {
  {
    const QSignalBlocker quiet(model());
    for (std::size_t index = 0; index < rows_.size(); ++index)
      fillRow(rows_[index], *topLevelItem(static_cast<int>(index)));
  }
  const QModelIndex first = model()->index(0, 0);
  Q_EMIT model()->dataChanged(first, model()->index(model()->rowCount() - 1, columnCount() - 1));
}

void ValueTable::fillRow(const Row& row, QTreeWidgetItem& item) const {
  for (int column = 0; column < columnCount(); ++column) {
    QFont font = column == 0 ? secondaryFont() : numberFont();
    font.setBold(row.isSum);
    item.setFont(column, font);
    item.setText(column, row.cells.value(column));
    item.setToolTip(column, row.tip.isEmpty() ? row.cells.value(column) : row.tip);
    item.setTextAlignment(column, Qt::AlignVCenter | (column == 0 ? Qt::AlignLeft : Qt::AlignRight));
  }
  QPixmap swatch(iconSize());
  swatch.fill(row.swatch);
  item.setIcon(0, row.swatch.isValid() ? QIcon(swatch) : QIcon());
}

int ValueTable::neededWidth() const {
  int width = std::max(std::min(scaled(kWidestName), sizeHintForColumn(0)), header()->sectionSizeHint(0));
  for (int column = 1; column < columnCount(); ++column)
    width += std::max(sizeHintForColumn(column), header()->sectionSizeHint(column));
  return width + verticalScrollBar()->sizeHint().width();
}

// Cells have fonts of their own.
void ValueTable::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange) return;
  widest_ = kFirstWidth;
  setRows(std::exchange(rows_, {}));
}

std::vector<QStringList> ValueTable::lines() const {
  std::vector<QStringList> lines{header_};
  for (const Row& row : rows_) lines.push_back(row.cells);
  return lines;
}

QString ValueTable::csv() const {
  QString text;
  for (const QStringList& line : lines()) {
    QStringList fields;
    for (const QString& field : line) fields << quoted(field.trimmed());
    text += fields.join(QLatin1Char(',')) + QLatin1Char('\n');
  }
  return text;
}

QString ValueTable::text() const {
  std::vector<qsizetype> widths(static_cast<std::size_t>(columnCount()), 0);
  for (const QStringList& line : lines())
    for (qsizetype column = 0; column < line.size(); ++column)
      widths[static_cast<std::size_t>(column)] =
          std::max(widths[static_cast<std::size_t>(column)], line[column].size());
  QString text;
  for (const QStringList& line : lines()) {
    QStringList fields;
    for (qsizetype column = 0; column < line.size(); ++column) {
      const auto width = static_cast<int>(widths[static_cast<std::size_t>(column)]);
      fields << (column == 0 ? line[column].leftJustified(width) : line[column].rightJustified(width));
    }
    text += fields.join(QLatin1String("  ")) + QLatin1Char('\n');
  }
  return text;
}

} // namespace taa::app
