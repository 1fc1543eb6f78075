#include "app/widgets/IntermediateRow.h"

#include "app/style/Icons.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"

#include "core/taa/ChannelNames.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <string>

namespace taa::app {

namespace {

constexpr int kIcon = 12;
constexpr int kRowLetter = 14;

} // namespace

QString intermediateToolTip(const Intermediate& row) {
  const QString unit = row.unit.empty() ? QString() : QStringLiteral(" · ") + qtext(row.unit).toHtmlEscaped();
  const QString names =
      row.channels > 1 ? QStringLiteral(" · ") + QString::fromStdString(channelNamesText(row)) : QString();
  return QStringLiteral("<b>%1</b>%2%3<br>%4<br><br><code>%5</code>")
      .arg(qtext(row.label), unit, names, qtext(row.description).toHtmlEscaped(), qtext(row.name));
}

void paintViewLetter(QPainter& painter, const QRect& box, QChar letter, bool active,
                     const ThemeColors& colors) {
  painter.save();
  painter.setFont(secondaryFont());
  painter.setPen(active ? colors.accent : colors.secondary);
  painter.setBrush(active ? QBrush(colors.accent) : QBrush(Qt::NoBrush));
  painter.drawRect(box.adjusted(0, 0, -1, -1));
  painter.setPen(active ? colors.onAccent : colors.text);
  painter.drawText(box, Qt::AlignCenter, letter);
  painter.restore();
}

IntermediateRow::IntermediateRow(const Intermediate& row, QWidget* parent)
    : QAbstractButton(parent), row_(row), searched_(searchedRow(row)) {
  setText(qtext(row.label));
  setObjectName(qtext(row.name));
  setToolTip(intermediateToolTip(row));
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void IntermediateRow::setShownIn(const QString& letters, QChar active) {
  if (letters == letters_ && active == active_) return;
  letters_ = letters;
  active_ = active;
  update();
}

void IntermediateRow::setFound(const QString& why) {
  if (why == found_) return;
  found_ = why;
  update();
}

QSize IntermediateRow::sizeHint() const {
  return {120, rowHeight()};
}

void IntermediateRow::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  if (underMouse() || !letters_.isEmpty()) painter.fillRect(rect(), colors.hover);
  if (hasFocus()) {
    painter.setPen(colors.accent);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
  const int left = 3 * kUnit;
  painter.drawPixmap(
      left, (height() - scaled(kIcon)) / 2,
      iconPixmap(QStringLiteral("picture"), colors.secondary, scaled(kIcon), devicePixelRatioF()));
  QRect inside = rect().adjusted(left + scaled(kIcon) + 2 * kUnit, 0, -2 * kUnit, 0);
  for (qsizetype i = letters_.size() - 1; i >= 0; --i) {
    const QRect box(inside.right() - scaled(kRowLetter) + 1, (height() - scaled(kRowLetter)) / 2,
                    scaled(kRowLetter), scaled(kRowLetter));
    paintViewLetter(painter, box, letters_[i], letters_[i] == active_, colors);
    inside.setRight(box.left() - kUnit);
  }
  if (!found_.isEmpty()) {
    painter.setFont(secondaryFont());
    painter.setPen(colors.secondary);
    painter.drawText(inside, Qt::AlignVCenter | Qt::AlignRight, found_);
    inside.setRight(inside.right() - painter.fontMetrics().horizontalAdvance(found_) - 2 * kUnit);
    painter.setFont(font());
  }
  painter.setPen(colors.text);
  painter.drawText(inside, Qt::AlignVCenter | Qt::AlignLeft,
                   fontMetrics().elidedText(text(), Qt::ElideRight, inside.width()));
}

void IntermediateRow::mouseReleaseEvent(QMouseEvent* event) {
  setDown(false);
  if (!rect().contains(event->position().toPoint())) return;
  const bool other = event->button() != Qt::LeftButton || event->modifiers().testFlag(Qt::ControlModifier);
  Q_EMIT chosen(row_.id, other);
}

void IntermediateRow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
    Q_EMIT chosen(row_.id, event->modifiers().testFlag(Qt::ControlModifier));
  else
    QAbstractButton::keyPressEvent(event);
}

} // namespace taa::app
