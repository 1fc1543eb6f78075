#include "app/views/plots/CurveLegend.h"

#include "app/style/CurveColor.h"
#include "app/style/Numbers.h"
#include "app/style/Theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>

#include <algorithm>

namespace taa::app {

namespace {

constexpr double kLineHeight = 18.0, kFirstBaseline = 13.0;
constexpr double kLegendMargin = 2.0 * kUnit, kTitleGap = 4.0 * kUnit;
constexpr double kEntryGap = kUnit;                       ///< between dashes, name and value
constexpr double kLongSample = 26.0, kShortSample = 16.0; ///< of the dashes

QFontMetricsF metrics() {
  return QFontMetricsF(secondaryFont());
}

/// Its words in as many lines as they need; what is wider than a line is cut.
QStringList brokenTitle(const QString& title, double width) {
  QStringList lines;
  for (const QString& word : title.split(QLatin1Char(' '))) {
    const QString longer = lines.isEmpty() ? word : lines.last() + QLatin1Char(' ') + word;
    if (!lines.isEmpty() && metrics().horizontalAdvance(longer) <= width)
      lines.last() = longer;
    else
      lines << metrics().elidedText(word, Qt::ElideRight, width);
  }
  return lines;
}

} // namespace

const QString& CurveLegend::nameOf(const Curve& curve) const {
  return isShortened_ && !curve.shortName.isEmpty() ? curve.shortName : curve.name;
}

std::vector<double> CurveLegend::widthsOf(const std::vector<Curve>& curves) const {
  const double sample = isShortened_ ? scaled(kShortSample) : scaled(kLongSample);
  const double value = metrics().horizontalAdvance(QStringLiteral("−0.00000")), gap = scaled(kEntryGap);
  std::vector<double> widths;
  for (const Curve& curve : curves)
    widths.push_back(sample + metrics().horizontalAdvance(nameOf(curve)) + value + 2.0 * gap + 2.0 * kUnit);
  return widths;
}

void CurveLegend::layOut(const QString& title, const std::vector<Curve>& curves, double width,
                         double placeWidth) {
  titleEnd_.reset();
  left_ = kLegendMargin;
  width_ = width - 2.0 * kLegendMargin;
  const double start = metrics().horizontalAdvance(title) + kTitleGap, firstEnd = width_ - placeWidth;
  for (const bool isShortened : {false, true}) {
    isShortened_ = isShortened;
    const std::vector<double> widths = widthsOf(curves);
    places_ = placeLegend(widths, start, firstEnd, width_);
    lines_ = places_.empty() ? 1 : places_.back().line + 1;
    placeLine_ = lineWithRoom(widths, start, placeWidth);
    if (lines_ == 1) return;
  }
}

// The first one: where long names take it whole, one below it; 0 where none has room.
int CurveLegend::lineWithRoom(const std::vector<double>& widths, double start, double wanted) const {
  std::vector<double> ends(static_cast<std::size_t>(lines_), 0.0);
  ends[0] = start;
  for (std::size_t index = 0; index < places_.size(); ++index)
    ends[static_cast<std::size_t>(places_[index].line)] = places_[index].left + widths[index];
  const auto found = std::ranges::find_if(ends, [&](double end) { return end + wanted <= width_; });
  return found == ends.end() ? 0 : static_cast<int>(found - ends.begin());
}

void CurveLegend::layOutBeside(const std::vector<Curve>& curves, double titleEnd, double left, double right) {
  titleEnd_ = titleEnd;
  left_ = left;
  width_ = right - left;
  for (const bool isShortened : {false, true}) {
    isShortened_ = isShortened;
    places_ = placeLegend(widthsOf(curves), 0.0, width_, width_);
    lines_ = places_.empty() ? 0 : places_.back().line + 1;
    placeLine_ = lines_ == 1 ? 1 : std::max(0, lines_ - 1); // below a single line, else in the last one
    if (lines_ <= 1) return;
  }
}

double CurveLegend::height() const {
  return titleEnd_ ? 0.0 : lines_ * scaled(kLineHeight);
}

void CurveLegend::paintEntry(QPainter& painter, const ThemeColors& colors, const Curve& curve,
                             const LegendPlace& place, std::optional<double> x) const {
  const double sample = isShortened_ ? scaled(kShortSample) : scaled(kLongSample);
  const double baseline = scaled(kFirstBaseline) + place.line * scaled(kLineHeight);
  double left = left_ + place.left;
  painter.setPen(QPen(onPanel(curve.color, colors), 1.5, curve.dash, Qt::FlatCap));
  painter.drawLine(QPointF(left, baseline - 4.0), QPointF(left + sample, baseline - 4.0));
  left += sample + scaled(kEntryGap);
  painter.setPen(colors.secondary);
  painter.drawText(QPointF(left, baseline), nameOf(curve));
  left += metrics().horizontalAdvance(nameOf(curve)) + scaled(kEntryGap);
  painter.setPen(colors.text);
  if (const auto value = x ? valueAt(curve.points, *x) : std::nullopt)
    painter.drawText(QPointF(left, baseline), shortText(*value, 4));
}

void CurveLegend::paint(QPainter& painter, const ThemeColors& colors, const QString& title,
                        const std::vector<Curve>& curves, std::optional<double> x,
                        const QString& place) const {
  painter.setFont(secondaryFont());
  painter.setPen(colors.text);
  double baseline = scaled(kFirstBaseline);
  for (const QString& line : brokenTitle(title, titleEnd_ ? *titleEnd_ - kLegendMargin : width_)) {
    painter.drawText(QPointF(kLegendMargin, baseline), line);
    baseline += scaled(kLineHeight);
  }
  const std::vector<double> widths = widthsOf(curves);
  double lineEnd = titleEnd_ || placeLine_ > 0 ? 0.0 : metrics().horizontalAdvance(title) + kTitleGap;
  for (std::size_t index = 0; index < std::min(curves.size(), places_.size()); ++index) {
    paintEntry(painter, colors, curves[index], places_[index], x);
    if (places_[index].line == placeLine_) lineEnd = places_[index].left + widths[index];
  }
  const QString shown = metrics().elidedText(place, Qt::ElideRight, width_ - lineEnd);
  painter.setPen(colors.secondary);
  painter.drawText(QPointF(left_ + width_ - metrics().horizontalAdvance(shown),
                           scaled(kFirstBaseline) + placeLine_ * scaled(kLineHeight)),
                   shown);
}

} // namespace taa::app
