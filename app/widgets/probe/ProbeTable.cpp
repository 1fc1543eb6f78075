#include "app/widgets/probe/ProbeTable.h"

#include "app/models/ProbeModel.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"

#include "core/taa/Intermediates.h"

#include <QFontMetrics>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {

constexpr int kValueColumn = 15;  ///< characters
constexpr int kValueMargins = 14; ///< beside the text of a cell: 4 a side by the style sheet, 3 by Fusion

/// px that the columns take so that none of their texts is cut.
struct ValueColumns {
  int name, value, unit;
};

ValueColumns neededColumns(int indentation) {
  // A text that is a part of a pixel too long loses its last letters.
  const auto widthOf = [exact = QFontMetricsF(secondaryFont())](const QString& text) {
    return static_cast<int>(std::ceil(exact.horizontalAdvance(text)));
  };
  int name = 0, unit = 0;
  for (const Intermediate& row : kIntermediates) {
    name = std::max(name, widthOf(qtext(row.label)));
    unit = std::max(unit, widthOf(qtext(row.unit)));
  }
  const int value = QFontMetrics(numberFont()).horizontalAdvance(QString(kValueColumn, QLatin1Char('0')));
  return {name + indentation + kValueMargins, value + kValueMargins, unit + kValueMargins};
}

} // namespace

ProbeTable::ProbeTable(ProbeModel* model, QWidget* parent) : QTreeView(parent), model_(model) {
  setModel(model_);
  setRootIsDecorated(false);
  setItemsExpandable(true);
  setIndentation(3 * kUnit);
  setFrameShape(QFrame::NoFrame);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setAllColumnsShowFocus(true);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setTextElideMode(Qt::ElideRight);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  header()->setStretchLastSection(true);
  header()->setSectionsMovable(false);
  header()->setMinimumSectionSize(24);
  header()->setTextElideMode(Qt::ElideRight);
  expandAll();
  for (int row = 0; row < model_->rowCount(); ++row) setFirstColumnSpanned(row, {}, true);
  connect(model_, &ProbeModel::foldsChanged, this, &ProbeTable::showFolds);
  connect(this, &QTreeView::clicked, this, &ProbeTable::toggleFold);
}

int ProbeTable::neededWidth() const {
  const ValueColumns needed = neededColumns(indentation());
  const double columns = (needed.name + needed.value + needed.unit) / textScale();
  return static_cast<int>(std::ceil(columns)) + verticalScrollBar()->sizeHint().width();
}

void ProbeTable::fitColumns(int width) {
  const ValueColumns needed = neededColumns(indentation());
  const int whole = width - verticalScrollBar()->sizeHint().width();
  const int room = whole - needed.value - needed.unit;
  // Names are whole before units are: with letters that are large these are scrolled to.
  const int name = std::min(whole - needed.value, needed.name);
  setHorizontalScrollBarPolicy(name > room ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
  setColumnWidth(ProbeModel::Name, name);
  setColumnWidth(ProbeModel::Value, needed.value);
  setColumnWidth(ProbeModel::Unit, needed.unit);
  const int meaning =
      QFontMetrics(secondaryFont()).horizontalAdvance(QObject::tr("the pixel itself")) + kValueMargins;
  setColumnHidden(ProbeModel::Meaning, room - name < meaning);
}

QSize ProbeTable::sizeHint() const {
  return {380, 24 * app::rowHeight()};
}

QSize ProbeTable::minimumSizeHint() const {
  return {120, 3 * app::rowHeight()};
}

void ProbeTable::showFolds() {
  for (int place = 0; place < model_->rowCount(); ++place) {
    const QModelIndex branch = model_->index(place, 0);
    const bool isUnfolded = model_->isUnfolded(branch);
    for (int row = 0; row < model_->rowCount(branch); ++row) {
      const QModelIndex index = model_->index(row, 0, branch);
      setRowHidden(row, branch, model_->isOff(index) && !isUnfolded);
      setFirstColumnSpanned(row, branch, model_->isFold(index));
    }
  }
}

void ProbeTable::toggleFold(const QModelIndex& line) {
  const QModelIndex first = line.siblingAtColumn(ProbeModel::Name);
  if (model_->isFold(first)) model_->setUnfolded(first.parent(), !model_->isUnfolded(first.parent()));
}

void ProbeTable::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const bool isChosen = key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space;
  if (!isChosen || !model_->isFold(currentIndex())) {
    QTreeView::keyPressEvent(event);
    return;
  }
  toggleFold(currentIndex());
}

} // namespace taa::app
