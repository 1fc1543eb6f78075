#include "app/widgets/Swatches.h"

#include "app/Theme.h"

#include "core/inspect/ColorMap.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {
constexpr int kCell = 16;
} // namespace

Swatches::Swatches(const QString& caption, QWidget* parent) : QWidget(parent), caption_(caption) {
  setFont(secondaryFont());
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void Swatches::setColors(const std::array<std::array<float, 3>, 9>& linear) {
  const auto byte = [](float value) {
    return static_cast<int>(std::lround(255.0f * srgbEncoded(value > 0 ? std::min(value, 1.0f) : 0.0f)));
  };
  for (std::size_t i = 0; i < linear.size(); ++i)
    colors_[i] = QColor(byte(linear[i][0]), byte(linear[i][1]), byte(linear[i][2]));
  update();
}

QSize Swatches::sizeHint() const {
  return {std::max(3 * kCell + 1, fontMetrics().horizontalAdvance(caption_)),
          3 * kCell + 1 + fontMetrics().height() + 2};
}

void Swatches::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  for (int i = 0; i < 9; ++i)
    painter.fillRect(QRect(i % 3 * kCell, i / 3 * kCell, kCell, kCell), colors_[static_cast<std::size_t>(i)]);
  painter.setPen(colors.line);
  painter.drawRect(0, 0, 3 * kCell, 3 * kCell);
  painter.setPen(colors.accent);
  painter.drawRect(kCell, kCell, kCell, kCell);
  painter.setPen(colors.secondary);
  painter.drawText(QRect(0, 3 * kCell + 2, width(), fontMetrics().height()), Qt::AlignLeft | Qt::AlignVCenter,
                   caption_);
}

} // namespace taa::app
