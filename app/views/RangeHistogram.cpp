#include "app/views/RangeHistogram.h"

#include "app/Numbers.h"
#include "app/Theme.h"

#include <QFontMetrics>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {

constexpr int kSide = 8, kFoot = 20, kHead = 6; // px around the columns
constexpr int kColumn = 2;
constexpr int kBins = (RangeHistogram::kWidth - 2 * kSide) / kColumn;

} // namespace

RangeHistogram::RangeHistogram(QWidget* parent) : QWidget(parent) {
  setFixedSize(kWidth, kHeight);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::SizeHorCursor);
  setAccessibleName(tr("Histogram of the visible values and the range they are drawn in"));
  setToolTip(
      tr("Visible values, counted on a logarithmic scale. Drag an end of the range; Left and Right move "
         "the low end, with Shift the high end."));
}

void RangeHistogram::setValues(const Image& values, const Intermediate& row, const ViewStyle& style) {
  if (drags_) return; // the scale stays under the mouse
  const auto found = autoRange(values, row, style);
  values_ = found.value_or(range_);
  fitScale();
  counts_ = histogram(values, row, style, scale_, kBins);
  update();
}

void RangeHistogram::setRange(ValueRange range) {
  if (range == range_) return;
  range_ = range;
  update();
}

// All values and the range, with a little room beside them to move the ends outwards.
void RangeHistogram::fitScale() {
  const float low = std::min({values_.low, range_.low, range_.high});
  const float high = std::max({values_.high, range_.low, range_.high});
  const float room = 0.05f * std::max(high - low, 1e-6f);
  scale_ = {low - room, high + room};
}

double RangeHistogram::position(double value) const {
  const double span = static_cast<double>(scale_.high) - static_cast<double>(scale_.low);
  return kSide + (value - static_cast<double>(scale_.low)) / span * (kBins * kColumn);
}

double RangeHistogram::valueAt(double x) const {
  const double span = static_cast<double>(scale_.high) - static_cast<double>(scale_.low);
  return static_cast<double>(scale_.low) + (x - kSide) / (kBins * kColumn) * span;
}

void RangeHistogram::moveEnd(bool high, double value) {
  (high ? range_.high : range_.low) = static_cast<float>(value);
  update();
  Q_EMIT rangeEdited(range_);
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
  if (direction == 0) return QWidget::keyPressEvent(event);
  const bool high = event->modifiers().testFlag(Qt::ShiftModifier);
  const double step = (static_cast<double>(scale_.high) - static_cast<double>(scale_.low)) / 100;
  moveEnd(high, static_cast<double>(high ? range_.high : range_.low) + direction * step);
}

void RangeHistogram::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.fillRect(rect(), colors.panel);
  painter.setPen(colors.line);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
  const int foot = height() - kFoot, tallest = foot - kHead;
  const int most = counts_.empty() ? 0 : *std::ranges::max_element(counts_);
  for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
    if (counts_[bin] == 0) continue;
    // One pixel already for a single value: what is rare is what one looks for.
    const double share = std::log1p(counts_[bin]) / std::log1p(most);
    const int tall = std::max(1, static_cast<int>(std::lround(share * tallest)));
    painter.fillRect(kSide + static_cast<int>(bin) * kColumn, foot - tall, kColumn, tall, colors.secondary);
  }
  painter.fillRect(kSide, foot, kBins * kColumn, 1, colors.line);
  painter.setFont(numberFont());
  for (const bool high : {false, true}) {
    const auto value = static_cast<double>(high ? range_.high : range_.low);
    const int x = static_cast<int>(std::lround(position(value)));
    painter.fillRect(x, kHead, 1, foot - kHead, colors.accent);
    // Which is which by its shape: the low end is a full triangle, the high one an empty one.
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(colors.accent);
    painter.setBrush(high ? QBrush(colors.panel) : QBrush(colors.accent));
    painter.drawPolygon(QPolygonF({{x + 0.5, foot - 1.0}, {x - 4.5, foot + 5.0}, {x + 5.5, foot + 5.0}}));
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(colors.text);
    painter.drawText(QRect(kSide, foot + 5, kWidth - 2 * kSide, kFoot - 5),
                     Qt::AlignVCenter | (high ? Qt::AlignRight : Qt::AlignLeft), shortText(value));
  }
}

} // namespace taa::app
