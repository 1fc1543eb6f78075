#include "app/widgets/parameters/SegmentedButtons.h"

#include "app/style/Theme.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace taa::app {

namespace {
constexpr int kSegmentPadding = 7; ///< beside a label
} // namespace

SegmentedButtons::SegmentedButtons(const QStringList& labels, QWidget* parent)
    : QWidget(parent), labels_(labels) {
  setFont(secondaryFont());
  setFocusPolicy(Qt::TabFocus);
  setMouseTracking(true);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void SegmentedButtons::setCurrent(int index) {
  current_ = index;
  update();
}

void SegmentedButtons::setDimmed(bool dimmed) {
  dimmed_ = dimmed;
  update();
}

int SegmentedButtons::labelWidth(int index) const {
  return fontMetrics().horizontalAdvance(labels_[index]) + 2 * kSegmentPadding;
}

int SegmentedButtons::allLabels() const {
  int sum = 1;
  for (int index = 0; index < count(); ++index) sum += labelWidth(index);
  return sum;
}

int SegmentedButtons::columns(int width) const {
  if (width >= allLabels()) return count();
  int widest = 0;
  for (int index = 0; index < count(); ++index) widest = std::max(widest, labelWidth(index));
  return count() > 2 && width >= 2 * widest ? 2 : 1;
}

QSize SegmentedButtons::sizeHint() const {
  return {allLabels(), rowHeight()};
}

int SegmentedButtons::heightForWidth(int width) const {
  const int perRow = columns(width);
  return rowHeight() * ((count() + perRow - 1) / perRow);
}

QRect SegmentedButtons::segment(int index) const {
  const int perRow = columns(width());
  const int column = index % perRow, row = index / perRow, room = width() - 1;
  int left = column * room / perRow, right = (column + 1) * room / perRow;
  if (perRow == count()) {
    // In one row each is as wide as its label needs, and what is left is shared out.
    const int spare = width() - allLabels();
    left = column * spare / perRow;
    for (int before = 0; before < index; ++before) left += labelWidth(before);
    right = left + labelWidth(index) + (column + 1) * spare / perRow - column * spare / perRow;
  }
  return {left, row * rowHeight() + 1, right - left, rowHeight() - 3};
}

void SegmentedButtons::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  for (int index = 0; index < count(); ++index) {
    const QRect box = segment(index);
    const bool isCurrent = index == current_;
    const QColor fill = isCurrent ? (dimmed_ ? colors.line : colors.accent) : colors.field;
    painter.fillRect(box, index == hovered_ && !isCurrent ? colors.hover : fill);
    painter.setPen(hasFocus() && isCurrent ? colors.text : colors.line);
    painter.drawRect(box);
    painter.setPen(isCurrent ? (dimmed_ ? colors.text : colors.onAccent)
                             : (dimmed_ ? colors.secondary : colors.text));
    painter.drawText(box, Qt::AlignCenter, labels_[index]);
  }
}

int SegmentedButtons::indexAt(QPoint position) const {
  for (int index = 0; index < count(); ++index)
    if (segment(index).adjusted(0, -1, 1, 1).contains(position)) return index;
  return -1;
}

void SegmentedButtons::choose(int index) {
  if (index < 0 || index >= count() || index == current_) return;
  setCurrent(index);
  Q_EMIT chosen(index);
}

void SegmentedButtons::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) choose(indexAt(event->position().toPoint()));
}

void SegmentedButtons::mouseMoveEvent(QMouseEvent* event) {
  const int index = indexAt(event->position().toPoint());
  if (index == hovered_) return;
  hovered_ = index;
  update();
  if (index >= 0 && index != current_) Q_EMIT considered(index);
}

void SegmentedButtons::leaveEvent(QEvent*) {
  hovered_ = -1;
  update();
}

void SegmentedButtons::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Left) {
    choose(current_ - 1);
    return;
  }
  if (event->key() == Qt::Key_Right) {
    choose(current_ + 1);
    return;
  }
  QWidget::keyPressEvent(event);
}

bool SegmentedButtons::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const int index = indexAt(help->pos());
    if (index < 0 || index >= explanations_.size()) return QWidget::event(event);
    QToolTip::showText(help->globalPos(),
                       QStringLiteral("<b>%1</b>: %2").arg(labels_[index], explanations_[index]), this,
                       segment(index));
    return true;
  }
  return QWidget::event(event);
}

} // namespace taa::app
