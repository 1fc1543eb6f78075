#include "app/widgets/probe/EvidenceRow.h"

#include "app/models/verdict/VerdictWords.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/IntermediateRow.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>

namespace taa::app {

EvidenceRow::EvidenceRow(QWidget* parent) : QAbstractButton(parent) {
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  setAccessibleName(tr("Evidence"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void EvidenceRow::setRow(const VerdictRow& row) {
  row_ = row;
  const Intermediate& of = intermediate(row.id);
  setText(qtext(of.label));
  value_ = rowValueText(row);
  frame_ = tr("frame %1").arg(row.frame);
  setToolTip(tr("%1<br><br>Enter shows it in the active view, in frame %2.")
                 .arg(intermediateToolTip(of))
                 .arg(row.frame));
  setAccessibleName(tr("%1 %2, %3").arg(text(), value_, frame_));
  update();
}

QSize EvidenceRow::sizeHint() const {
  return {120, rowHeight()};
}

void EvidenceRow::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  if (underMouse()) painter.fillRect(rect(), colors.hover);
  if (hasFocus()) {
    painter.setPen(colors.accent);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
  QRect inside = rect().adjusted(5 * kUnit, 0, -2 * kUnit, 0);
  painter.setFont(secondaryFont());
  painter.setPen(colors.secondary);
  painter.drawText(inside, Qt::AlignVCenter | Qt::AlignRight, frame_);
  inside.setRight(inside.right() - QFontMetrics(secondaryFont()).horizontalAdvance(frame_) - 3 * kUnit);
  painter.setFont(numberFont());
  painter.setPen(colors.text);
  const QFontMetrics numbers(numberFont());
  const QString value = numbers.elidedText(value_, Qt::ElideRight, inside.width() * 2 / 3);
  painter.drawText(inside, Qt::AlignVCenter | Qt::AlignRight, value);
  inside.setRight(std::max(inside.left(), inside.right() - numbers.horizontalAdvance(value) - 2 * kUnit));
  painter.setFont(secondaryFont());
  painter.drawText(inside, Qt::AlignVCenter | Qt::AlignLeft,
                   QFontMetrics(secondaryFont()).elidedText(text(), Qt::ElideRight, inside.width()));
}

void EvidenceRow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    click();
    return;
  }
  QAbstractButton::keyPressEvent(event);
}

} // namespace taa::app
