#include "app/widgets/SectionHeader.h"

#include "app/Icons.h"
#include "app/Theme.h"

#include <QKeyEvent>
#include <QPainter>

namespace taa::app {

SectionHeader::SectionHeader(const QString& title, QWidget* parent) : QAbstractButton(parent) {
  setText(title);
  setCheckable(true);
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SectionHeader::setSummary(const QString& summary) {
  summary_ = summary;
  update();
}

QSize SectionHeader::sizeHint() const {
  return {120, kRowHeight + kUnit};
}

void SectionHeader::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  if (underMouse()) painter.fillRect(rect(), colors.hover);
  painter.fillRect(0, 0, width(), 1, colors.line);
  if (hasFocus()) {
    painter.setPen(colors.accent);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
  const QString chevron = isChecked() ? QStringLiteral("chevron-down") : QStringLiteral("chevron-right");
  painter.drawPixmap(kUnit, (height() - 12) / 2,
                     iconPixmap(chevron, colors.secondary, 12, devicePixelRatioF()));

  QFont bold = font();
  bold.setBold(true);
  const QRect inside = rect().adjusted(5 * kUnit, 0, -2 * kUnit, 0);
  painter.setFont(bold);
  painter.setPen(colors.text);
  painter.drawText(inside, Qt::AlignVCenter | Qt::AlignLeft, text());

  if (isChecked()) return; // the settings themselves are in sight
  const int used = QFontMetrics(bold).horizontalAdvance(text()) + 3 * kUnit;
  const QFontMetrics small(secondaryFont());
  painter.setFont(secondaryFont());
  painter.setPen(colors.secondary);
  painter.drawText(inside, Qt::AlignVCenter | Qt::AlignRight,
                   small.elidedText(summary_, Qt::ElideRight, inside.width() - used));
}

void SectionHeader::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
  QAbstractButton::keyPressEvent(event);
}

} // namespace taa::app
