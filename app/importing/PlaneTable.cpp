#include "app/importing/PlaneTable.h"

#include "app/importing/FoundPictures.h"
#include "app/importing/PlaneRow.h"
#include "app/style/Theme.h"
#include "app/widgets/areas/FittingArea.h"
#include "core/capture/import/StatedPlanes.h"

#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>

namespace taa::app {

namespace {
constexpr int kMinPictures = 40; ///< px, of texts of 100 %
} // namespace

PlaneTable::PlaneTable(QWidget* parent) : QWidget(parent), pictures_(new FoundPictures) {
  setAccessibleName(tr("Planes"));
  auto* parts = new QSplitter(Qt::Vertical);
  parts->setHandleWidth(2 * kUnit);
  parts->setChildrenCollapsible(false);
  parts->addWidget(makeRows());
  parts->addWidget(makePictures());
  parts->setStretchFactor(0, 3);
  parts->setStretchFactor(1, 2);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(parts);
}

QWidget* PlaneTable::makeRows() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, kUnit, 2 * kUnit, 0);
  column->setSpacing(2);
  for (std::size_t kind = 0; kind < capture::kPlaneKinds; ++kind) {
    auto* made = new PlaneRow(static_cast<capture::PlaneKind>(kind));
    connect(made, &PlaneRow::stated, this, &PlaneTable::stated);
    column->addWidget(made);
    rows_.push_back(made);
  }
  const auto widest = std::ranges::max(rows_, {}, &PlaneRow::labelHint);
  for (PlaneRow* row : rows_) row->setLabelWidth(widest->labelHint());
  column->addStretch(1);
  QScrollArea* area = scrolled(content);
  area->setAccessibleName(tr("Planes"));
  // Nothing scrolls sideways: rows are whole at any size of the letters.
  area->setMinimumWidth(content->minimumSizeHint().width() + area->verticalScrollBar()->sizeHint().width());
  return area;
}

QWidget* PlaneTable::makePictures() {
  auto* part = new QWidget;
  auto* label = new QLabel(tr("Pictures fou&nd: drag them onto the plane that they hold"));
  label->setWordWrap(true);
  label->setBuddy(pictures_);
  pictures_->setMinimumHeight(scaled(kMinPictures));
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kUnit);
  column->addWidget(label);
  column->addWidget(pictures_, 1);
  return part;
}

void PlaneTable::setSequences(const std::vector<capture::PictureSequence>& sequences) {
  pictures_->setSequences(sequences);
  for (PlaneRow* row : rows_) row->setSequences(sequences);
}

void PlaneTable::setPlanes(const std::map<capture::PlaneKind, capture::PlaneSource>& planes,
                           const Stated& stated) {
  pictures_->showPlanes(planes);
  for (const PlaneRow* row : rows_) {
    if (stated.contains(row->kind())) continue;
    const auto found = planes.find(row->kind());
    found_[row->kind()] =
        found == planes.end() ? QString() : QString::fromStdString(capture::statedText(found->second));
  }
}

void PlaneTable::display(const Stated& stated) {
  for (PlaneRow* row : rows_) {
    const auto at = stated.find(row->kind());
    row->display(found_[row->kind()], at == stated.end() ? QString() : QString::fromStdString(at->second));
  }
}

void PlaneTable::clear() {
  dropTyped();
  found_.clear();
  setSequences({});
  display({});
}

std::optional<std::pair<capture::PlaneKind, QString>> PlaneTable::takeTyped() {
  for (PlaneRow* row : rows_)
    if (std::optional<QString> typed = row->takeTyped()) return std::pair(row->kind(), std::move(*typed));
  return {};
}

void PlaneTable::dropTyped() {
  for (PlaneRow* row : rows_) row->takeTyped();
}

} // namespace taa::app
