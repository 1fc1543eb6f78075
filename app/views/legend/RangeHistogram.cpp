#include "app/views/legend/RangeHistogram.h"

#include "app/style/Numbers.h"
#include "app/style/TextSize.h"
#include "app/style/Theme.h"

#include <QFontMetrics>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {

constexpr int kFoot = 20, kRoomAbove = 6; // px below and above the columns

} // namespace

RangeHistogram::RangeHistogram(QWidget* parent) : QWidget(parent) {
  setProperty(kKeepsLimits, true);
  if (parent) parent->installEventFilter(this);
  setFixedSize(scaled(kWidth), scaled(kHeight));
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::SizeHorCursor);
  setAccessibleName(tr("Histogram of the visible values and the range they are drawn in"));
  setToolTip(
      tr("Visible values; heights are logarithms of how many there are, and so is the axis where values are "
         "spread wide. Drag an end of the range; Left and Right move "
         "the low end, with Shift the high end."));
}

// A view may be narrower than it would like to be.
void RangeHistogram::fit() {
  const int room = parentWidget() ? parentWidget()->width() - 4 * kUnit : QWIDGETSIZE_MAX;
  setFixedSize(std::clamp(room, kBins + 2 * kSide, scaled(kWidth)), scaled(kHeight));
}

void RangeHistogram::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  fit();
}

bool RangeHistogram::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) fit();
  return QWidget::eventFilter(watched, event);
}

void RangeHistogram::setDistribution(const Distribution& found) {
  if (drags_) return;
  axis_ = found.axis;
  counts_ = found.counts;
  update();
}

void RangeHistogram::setRange(ValueRange range) {
  if (range == range_) return;
  range_ = range;
  update();
}

double RangeHistogram::position(double value) const {
  return kSide + axis_.placeOf(value) * (width() - 2 * kSide);
}

double RangeHistogram::valueAt(double x) const {
  return axis_.valueAt((x - kSide) / (width() - 2 * kSide));
}

void RangeHistogram::moveEnd(bool high, double value) {
  (high ? range_.high : range_.low) = static_cast<float>(value);
  update();
  Q_EMIT rangeEdited(range_);
}

QString RangeHistogram::rangeText() const {
  return QStringLiteral("▲ %1  △ %2")
      .arg(shortText(static_cast<double>(range_.low)), shortText(static_cast<double>(range_.high)));
}

QString RangeHistogram::leftText() const {
  const QString low = shortText(static_cast<double>(axis_.low));
  return axis_.isLogarithmic ? QStringLiteral("≤ ") + low : low;
}

void RangeHistogram::mousePressEvent(QMouseEvent* event) {
  const double x = event->position().x();
  const double toLow = std::abs(x - position(static_cast<double>(range_.low)));
  const double toHigh = std::abs(x - position(static_cast<double>(range_.high)));
  movesHigh_ = toHigh < toLow;
  drags_ = true;
  moveEnd(movesHigh_, valueAt(x));
}

void RangeHistogram::mouseMoveEvent(QMouseEvent* event) {
  if (drags_) moveEnd(movesHigh_, valueAt(event->position().x()));
}

void RangeHistogram::mouseReleaseEvent(QMouseEvent*) {
  drags_ = false;
}

void RangeHistogram::keyPressEvent(QKeyEvent* event) {
  const int direction = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
  if (direction == 0) {
    QWidget::keyPressEvent(event);
    return;
  }
  const bool high = event->modifiers().testFlag(Qt::ShiftModifier);
  const double place = axis_.placeOf(static_cast<double>(high ? range_.high : range_.low));
  moveEnd(high, axis_.valueAt(place + direction / 100.0));
}

void RangeHistogram::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.fillRect(rect(), colors.panel);
  painter.setPen(colors.line);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
  if (counts_.empty()) {
    painter.setPen(colors.secondary);
    painter.drawText(rect(), Qt::AlignCenter, tr("The visible values are being counted"));
    return;
  }
  paintColumns(painter, colors);
  paintRange(painter, colors);
}

void RangeHistogram::paintColumns(QPainter& painter, const ThemeColors& colors) const {
  const int foot = height() - scaled(kFoot), tallest = foot - kRoomAbove;
  const double column = (width() - 2.0 * kSide) / kBins;
  const int most = *std::ranges::max_element(counts_);
  for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
    if (counts_[bin] == 0) continue;
    // One pixel already for a single value: what is rare is what one looks for.
    const double share = std::log1p(counts_[bin]) / std::log1p(most);
    const int tall = std::max(1, static_cast<int>(std::lround(share * tallest)));
    painter.fillRect(QRectF(kSide + static_cast<double>(bin) * column, foot - tall, column, tall),
                     colors.secondary);
  }
  painter.fillRect(kSide, foot, width() - 2 * kSide, 1, colors.line);
}

void RangeHistogram::paintRange(QPainter& painter, const ThemeColors& colors) const {
  const int foot = height() - scaled(kFoot);
  painter.setFont(numberFont());
  for (const bool high : {false, true}) {
    const auto value = static_cast<double>(high ? range_.high : range_.low);
    const int x = static_cast<int>(std::lround(position(value)));
    painter.fillRect(x, kRoomAbove, 1, foot - kRoomAbove, colors.accent);
    // Which is which by its shape: the low end is a full triangle, the high one an empty one.
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(colors.accent);
    painter.setBrush(high ? QBrush(colors.panel) : QBrush(colors.accent));
    painter.drawPolygon(QPolygonF({{x + 0.5, foot - 1.0}, {x - 4.5, foot + 5.0}, {x + 5.5, foot + 5.0}}));
    painter.setRenderHint(QPainter::Antialiasing, false);
  }
  // Below the ends of the axis what they are; the range between them, since its ends may lie close together.
  const QRect texts(kSide, foot + 5, width() - 2 * kSide, scaled(kFoot) - 5);
  const QString right = shortText(axis_.valueAt(1.0));
  const auto wide = [&](const QString& text) { return painter.fontMetrics().horizontalAdvance(text); };
  painter.setPen(colors.secondary);
  if (wide(rangeText()) + 2 * (std::max(wide(leftText()), wide(right)) + kUnit) <= texts.width()) {
    painter.drawText(texts, Qt::AlignVCenter | Qt::AlignLeft, leftText());
    painter.drawText(texts, Qt::AlignVCenter | Qt::AlignRight, right);
  }
  if (axis_.isLogarithmic) {
    const QRect room = rect().adjusted(kSide, 2, -kSide, 0);
    constexpr int kCorner = Qt::AlignTop | Qt::AlignRight;
    painter.fillRect(painter.boundingRect(room, kCorner, tr("logarithmic")),
                     colors.panel); // over an end's line
    painter.drawText(room, kCorner, tr("logarithmic"));
  }
  painter.setPen(colors.text);
  painter.drawText(texts, Qt::AlignCenter, rangeText());
}

} // namespace taa::app
