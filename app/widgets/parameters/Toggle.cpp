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
  return {scaled(30), rowHeight()};
}

void Toggle::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double high = scaled(13.0), half = high / 2;
  const QRectF track(0.5, (height() - high) / 2, scaled(28.0), high);
  const bool on = isChecked();
  painter.setPen(hasFocus() ? colors.text : on && !dimmed_ ? colors.accent : colors.secondary);
  painter.setBrush(on ? (dimmed_ ? colors.line : colors.accent) : underMouse() ? colors.hover : colors.field);
  painter.drawRoundedRect(track, half, half);
  const double x = on ? track.right() - half : track.left() + half;
  painter.setPen(Qt::NoPen);
  painter.setBrush(on ? (dimmed_ ? colors.secondary : colors.onAccent) : colors.secondary);
  painter.drawEllipse(QPointF(x, track.center().y()), scaled(4.0), scaled(4.0));
}

void Toggle::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    click();
    return;
  }
  QAbstractButton::keyPressEvent(event);
}

} // namespace taa::app
