#include "app/room/PointerLabel.h"

#include "app/style/Theme.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPen>

#include <utility>

namespace taa::app {

namespace {

constexpr int kRingRadius = 14, kRingWidth = 3; ///< px where text has its own size

} // namespace

PointerLabel::PointerLabel(QWidget* window) : QWidget(window) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  hide();
}

void PointerLabel::pointAt(QPoint place, const QString& text) {
  place_ = place;
  text_ = text;
  setVisible(!text_.isEmpty());
  if (!isVisible()) return;
  setGeometry(ring().united(words()));
  raise();
  update();
}

QRect PointerLabel::ring() const {
  const int reach = scaled(kRingRadius) + scaled(kRingWidth);
  return {place_.x() - reach, place_.y() - reach, 2 * reach + 1, 2 * reach + 1};
}

// Below and to the right of the ring; where the window ends, on the other side of it.
QRect PointerLabel::words() const {
  const QFontMetrics metrics(numberFont(12));
  const QSize size(metrics.horizontalAdvance(text_) + 4 * kUnit, metrics.height() + 2 * kUnit);
  const QRect around = ring(), window = parentWidget()->rect();
  QRect words(QPoint(around.right() + kUnit, around.bottom() - around.height() / 4), size);
  if (words.right() > window.right()) words.moveRight(around.left() - kUnit);
  if (words.left() < window.left()) words.moveLeft(window.left());
  if (words.bottom() > window.bottom()) words.moveBottom(around.top() - kUnit);
  return words;
}

void PointerLabel::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.translate(-pos());
  painter.setRenderHint(QPainter::Antialiasing);
  // A dark outline on both sides, so that it is seen on any picture.
  for (const auto& [color, width] :
       {std::pair(QColor(Qt::black), scaled(kRingWidth) + 2), {colors.accent, scaled(kRingWidth)}}) {
    painter.setPen(QPen(color, width));
    painter.drawEllipse(QPointF(place_), scaled(kRingRadius), scaled(kRingRadius));
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.fillRect(words(), colors.panel);
  painter.setPen(colors.line);
  painter.drawRect(words().adjusted(0, 0, -1, -1));
  painter.setPen(colors.text);
  painter.setFont(numberFont(12));
  painter.drawText(words(), Qt::AlignCenter, text_);
}

} // namespace taa::app
