#include "app/widgets/parameters/Toggle.h"

#include "app/style/Theme.h"

#include <QKeyEvent>
#include <QPainter>

namespace taa::app {

Toggle::Toggle(QWidget* parent) : QAbstractButton(parent) {
  setCheckable(true);
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Toggle::setDimmed(bool dimmed) {
  dimmed_ = dimmed;
  update();
}

QSize Toggle::sizeHint() const {
  return {30, kRowHeight};
}

void Toggle::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF track(0.5, (height() - 13) / 2.0, 28, 13);
  const bool on = isChecked();
  painter.setPen(hasFocus() ? colors.text : on && !dimmed_ ? colors.accent : colors.secondary);
  painter.setBrush(on ? (dimmed_ ? colors.line : colors.accent) : underMouse() ? colors.hover : colors.field);
  painter.drawRoundedRect(track, 6.5, 6.5);
  const double x = on ? track.right() - 6.5 : track.left() + 6.5;
  painter.setPen(Qt::NoPen);
  painter.setBrush(on ? (dimmed_ ? colors.secondary : colors.onAccent) : colors.secondary);
  painter.drawEllipse(QPointF(x, track.center().y()), 4, 4);
}

void Toggle::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return click();
  QAbstractButton::keyPressEvent(event);
}

} // namespace taa::app
