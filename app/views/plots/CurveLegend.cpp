#include "app/views/plots/CurveLegend.h"

#include "app/style/Numbers.h"
#include "app/style/Theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace taa::app {

namespace {

constexpr double kLineHeight = 18.0, kFirstBaseline = 13.0;
constexpr double kLegendMargin = 2.0 * kUnit, kTitleGap = 4.0 * kUnit;
constexpr double kLongSample = 26.0, kShortSample = 16.0; ///< of the dashes

QFontMetricsF metrics() {
  return QFontMetricsF(secondaryFont());
}

} // namespace

const QString& CurveLegend::nameOf(const Curve& curve) const {
  return isShortened_ && !curve.shortName.isEmpty() ? curve.shortName : curve.name;
}

std::vector<double> CurveLegend::widthsOf(const std::vector<Curve>& curves) const {
  const double sample = isShortened_ ? kShortSample : kLongSample;
  const double value = metrics().horizontalAdvance(QStringLiteral("−0.00000"));
  std::vector<double> widths;
  for (const Curve& curve : curves)
    widths.push_back(sample + kUnit + metrics().horizontalAdvance(nameOf(curve)) + kUnit + value +
                     2.0 * kUnit);
  return widths;
}

void CurveLegend::layOut(const QString& title, const std::vector<Curve>& curves, double width,
                         double placeWidth) {
  width_ = width - 2.0 * kLegendMargin;
  const double start = metrics().horizontalAdvance(title) + kTitleGap, firstEnd = width_ - placeWidth;
  for (const bool isShortened : {false, true}) {
    isShortened_ = isShortened;
    places_ = placeLegend(widthsOf(curves), start, firstEnd, width_);
    lines_ = places_.empty() ? 1 : places_.back().line + 1;
    if (lines_ == 1) return;
  }
}

double CurveLegend::height() const {
  return lines_ * kLineHeight;
}

void CurveLegend::paint(QPainter& painter, const ThemeColors& colors, const QString& title,
                        const std::vector<Curve>& curves, std::optional<double> x,
                        const QString& place) const {
  painter.setFont(secondaryFont());
  painter.setPen(colors.text);
  painter.drawText(QPointF(kLegendMargin, kFirstBaseline), title);
  const std::vector<double> widths = widthsOf(curves);
  double firstEnd = metrics().horizontalAdvance(title) + kTitleGap;
  const double sample = isShortened_ ? kShortSample : kLongSample;
  for (std::size_t index = 0; index < std::min(curves.size(), places_.size()); ++index) {
    const Curve& curve = curves[index];
    const double baseline = kFirstBaseline + places_[index].line * kLineHeight;
    double left = kLegendMargin + places_[index].left;
    if (places_[index].line == 0) firstEnd = places_[index].left + widths[index];
    painter.setPen(QPen(curve.color, 1.5, curve.dash, Qt::FlatCap));
    painter.drawLine(QPointF(left, baseline - 4.0), QPointF(left + sample, baseline - 4.0));
    left += sample + kUnit;
    painter.setPen(colors.secondary);
    painter.drawText(QPointF(left, baseline), nameOf(curve));
    left += metrics().horizontalAdvance(nameOf(curve)) + kUnit;
    painter.setPen(colors.text);
    if (const auto value = x ? valueAt(curve.points, *x) : std::nullopt)
      painter.drawText(QPointF(left, baseline), shortText(*value, 4));
  }
  const QString shown = metrics().elidedText(place, Qt::ElideRight, width_ - firstEnd);
  painter.setPen(colors.secondary);
  painter.drawText(QPointF(kLegendMargin + width_ - metrics().horizontalAdvance(shown), kFirstBaseline),
                   shown);
}

} // namespace taa::app
