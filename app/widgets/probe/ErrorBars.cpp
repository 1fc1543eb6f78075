#include "app/widgets/probe/ErrorBars.h"

#include "app/models/verdict/VerdictWords.h"
#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "core/verdict/parts/PartsRows.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace taa::app {

namespace {
constexpr int kBarRow = 18; ///< px a line
constexpr int kBarHigh = 8; ///< px
} // namespace

ErrorBars::ErrorBars(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setToolTip(
      tr("Luma of each part of the error to the reference, scene-linear; the parts sum up to the error"));
}

void ErrorBars::setError(const PixelError& error) {
  bars_.clear();
  const auto add = [this](const QString& label, const glm::dvec3& color) {
    const double value = partLuma(color);
    bars_.push_back({label, shortText(value, 3), value});
  };
  for (std::size_t part = 0; part < kErrorParts; ++part)
    add(qtext(intermediate(rowOfPart(static_cast<ErrorPart>(part))).label), error.sum[part]);
  add(tr("Error"), error.error());
  QStringList said;
  for (const Bar& bar : bars_) said << bar.label + QLatin1Char(' ') + bar.text;
  setAccessibleDescription(said.join(QStringLiteral(", ")));
  updateGeometry();
  update();
}

QSize ErrorBars::sizeHint() const {
  return {120, scaled(kBarRow) * static_cast<int>(bars_.size()) + kUnit};
}

void ErrorBars::paintEvent(QPaintEvent*) {
  double largest = 0.0;
  for (const Bar& bar : bars_) largest = std::max(largest, std::fabs(bar.value));
  QPainter painter(this);
  QRect line(5 * kUnit, 0, width() - 7 * kUnit, scaled(kBarRow));
  for (const Bar& bar : bars_) {
    paintBar(painter, bar, line, largest);
    line.translate(0, scaled(kBarRow));
  }
}

void ErrorBars::paintBar(QPainter& painter, const Bar& bar, const QRect& line, double largest) const {
  const ThemeColors& colors = themeColors(this);
  const QFontMetrics words(secondaryFont()), numbers(numberFont());
  const int label = line.width() / 3, value = numbers.horizontalAdvance(QString(9, QLatin1Char('0')));
  painter.setFont(secondaryFont());
  painter.setPen(colors.text);
  painter.drawText(line, Qt::AlignVCenter | Qt::AlignLeft,
                   words.elidedText(bar.label, Qt::ElideRight, label - kUnit));
  painter.setFont(numberFont());
  painter.drawText(line, Qt::AlignVCenter | Qt::AlignRight, bar.text);
  const QRectF room(line.left() + label, line.top() + (line.height() - scaled(kBarHigh)) / 2.0,
                    std::max(0, line.width() - label - value), scaled(kBarHigh));
  const double middle = room.center().x();
  const double length = largest > 0.0 ? bar.value / largest * room.width() / 2.0 : 0.0;
  painter.fillRect(QRectF(std::min(middle, middle + length), room.top(), std::fabs(length), room.height()),
                   colors.secondary);
  painter.fillRect(QRectF(middle, room.top() - 2.0, 1.0, room.height() + 4.0), colors.line);
}

} // namespace taa::app
