#include "app/widgets/parameters/ParameterLabel.h"

#include "app/style/Theme.h"

#include <QMouseEvent>
#include <QPainter>

namespace taa::app {

namespace {
constexpr int kDotSpace = 12;
} // namespace

ParameterLabel::ParameterLabel(const QString& text, QWidget* parent) : QWidget(parent), text_(text) {}

void ParameterLabel::setState(bool changed, bool dimmed) {
  if (changed == changed_ && dimmed == dimmed_) return;
  changed_ = changed;
  dimmed_ = dimmed;
  update();
}

QSize ParameterLabel::sizeHint() const {
  return {scaled(kDotSpace) + fontMetrics().horizontalAdvance(text_) + kUnit, rowHeight()};
}

void ParameterLabel::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  if (changed_) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors.accent);
    painter.drawEllipse(QPointF(scaled(kDotSpace) / 2.0 - 1, rowHeight() / 2.0), 2.5, 2.5);
  }
  painter.setPen(dimmed_ ? colors.secondary : colors.text);
  const QRect place(scaled(kDotSpace), 0, width() - scaled(kDotSpace), rowHeight());
  painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft,
                   fontMetrics().elidedText(text_, Qt::ElideRight, place.width()));
}

void ParameterLabel::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) Q_EMIT resetRequested();
}

} // namespace taa::app
