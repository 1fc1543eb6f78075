#include "app/views/legend/LegendFlow.h"

#include "app/style/Theme.h"

#include <QFontMetrics>
#include <QPainter>
#include <QStringList>

#include <algorithm>
#include <utility>

namespace taa::app {

namespace {

constexpr int kLeft = 2 * kUnit, kRight = kUnit, kFlowGap = 2 * kUnit, kGluedGap = kUnit + 2;

} // namespace

void LegendFlow::startLine() {
  startsLine_ = true;
}

void LegendFlow::add(Item item) {
  item.startsLine = std::exchange(startsLine_, false) && !items_.empty();
  item.isGlued = std::exchange(glues_, false) && !item.startsLine && !items_.empty();
  items_.push_back(std::move(item));
}

void LegendFlow::text(const QString& text, const QFont& font, const QColor& color) {
  if (text.isEmpty()) return;
  const QFontMetrics metrics(font);
  add({text, font, color, {metrics.horizontalAdvance(text) + 1, legendHeight()}, {}});
}

void LegendFlow::icon(QSize size, PaintIcon paint) {
  add({{}, {}, {}, size, std::move(paint)});
}

// What is glued together moves to the next line together, and is parted where a line is too narrow for all of
// it; one item that is wider than a line is cut to it.
std::vector<LegendFlow::Place> LegendFlow::places(int width) const {
  std::vector<Place> places(items_.size());
  const int end = std::max(width - kRight, kLeft + 1);
  int line = 0, left = kLeft;
  for (std::size_t first = 0; first < items_.size();) {
    std::size_t last = first + 1;
    int needed = items_[first].size.width();
    for (; last < items_.size() && items_[last].isGlued; ++last)
      needed += kGluedGap + items_[last].size.width();
    const bool isAtStart = left == kLeft;
    if (items_[first].startsLine || (!isAtStart && left + needed > end)) {
      ++line;
      left = kLeft;
    }
    for (std::size_t index = first; index < last; ++index) {
      const int wide = items_[index].size.width();
      if (left > kLeft && left + wide > end) {
        ++line;
        left = kLeft;
      }
      places[index] = {line, left, std::min(wide, end - left)};
      left += places[index].width + (index + 1 < last ? kGluedGap : kFlowGap);
    }
    first = last;
  }
  return places;
}

int LegendFlow::lines(int width) const {
  return isEmpty() ? 0 : places(width).back().line + 1;
}

QRect LegendFlow::lastPlace(int width) const {
  if (isEmpty()) return {};
  const Place last = places(width).back();
  return {last.left, last.line * legendHeight(), last.width, legendHeight()};
}

void LegendFlow::paint(QPainter& painter, QPoint corner, int width, const ThemeColors& colors) const {
  QColor ground = colors.panel;
  ground.setAlpha(232);
  painter.fillRect(QRect(corner, QSize(width, lines(width) * legendHeight())), ground);
  const std::vector<Place> at = places(width);
  for (std::size_t index = 0; index < items_.size(); ++index) {
    const Item& item = items_[index];
    const QRect place(corner.x() + at[index].left, corner.y() + at[index].line * legendHeight(),
                      at[index].width, legendHeight());
    if (item.paint) {
      const int top = place.center().y() - item.size.height() / 2 + 1;
      item.paint(painter, QRect(place.left(), top, place.width(), item.size.height()));
      continue;
    }
    painter.setFont(item.font);
    painter.setPen(item.color);
    painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft,
                     QFontMetrics(item.font).elidedText(item.text, Qt::ElideRight, place.width()));
  }
}

QString LegendFlow::plainText() const {
  QStringList texts;
  for (const Item& item : items_)
    if (!item.text.isEmpty()) texts << item.text;
  return texts.join(QLatin1Char(' '));
}

} // namespace taa::app
