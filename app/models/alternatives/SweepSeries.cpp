#include "app/models/alternatives/SweepSeries.h"

#include "app/style/Text.h"
#include "core/sweep/ParetoFront.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace taa::app {

namespace {

/// Dashes tell apart what has a color of the palette again.
constexpr std::array<Qt::PenStyle, 4> kSettingsDashes{Qt::SolidLine, Qt::DashLine, Qt::DotLine,
                                                      Qt::DashDotLine};
constexpr std::size_t kPaletteColors = 8;

QColor settingsColor(std::size_t index) {
  return curveColor(static_cast<int>(index % kPaletteColors));
}

double lessIsBetter(Metric metric, double value) {
  return metricInfo(metric).isHigherBetter ? -value : value;
}

QString quotedField(const QString& text) {
  if (!text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n')) return text;
  QString inside = text;
  return u'"' + inside.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

} // namespace

void SweepSeries::begin(std::vector<QString> names, std::vector<Metric> metrics) {
  metrics_ = std::move(metrics);
  entries_.clear();
  for (QString& name : names) entries_.push_back({std::move(name), {}});
}

void SweepSeries::add(std::size_t index, LaneMetrics frames) {
  if (index < entries_.size()) entries_[index].frames = std::move(frames);
}

std::size_t SweepSeries::measuredCount() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(entries_, [](const Entry& entry) { return !entry.frames.empty(); }));
}

std::optional<double> SweepSeries::mean(std::size_t index, Metric metric) const {
  return meanOfFrames(entries_[index].frames, metric);
}

std::vector<Curve> SweepSeries::curves(Metric metric) const {
  std::vector<Curve> curves;
  for (std::size_t index = 0; index < entries_.size(); ++index) {
    if (!isMeasured(index)) continue;
    Curve curve{entries_[index].name,
                settingsColor(index),
                kSettingsDashes[index / kPaletteColors % kSettingsDashes.size()],
                {},
                {}};
    for (const FrameMetrics& frame : entries_[index].frames)
      curve.points.emplace_back(frame.frame,
                                frame.at(metric).value_or(std::numeric_limits<double>::quiet_NaN()));
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<ScatterPoint> SweepSeries::tradeOff(Metric x, Metric y) const {
  std::vector<ScatterPoint> points;
  std::vector<TradeOff> tradeOffs;
  for (std::size_t index = 0; index < entries_.size(); ++index) {
    const std::optional<double> ofX = mean(index, x), ofY = mean(index, y);
    if (!ofX || !ofY || !std::isfinite(*ofX) || !std::isfinite(*ofY)) continue;
    points.push_back({index, entries_[index].name, settingsColor(index), {*ofX, *ofY}, false});
    tradeOffs.emplace_back(std::array{lessIsBetter(x, *ofX), lessIsBetter(y, *ofY)});
  }
  const std::vector<bool> isOnFront = onParetoFront(tradeOffs);
  for (std::size_t place = 0; place < points.size(); ++place) points[place].isOnFront = isOnFront[place];
  return points;
}

QString SweepSeries::csv() const {
  QStringList header{QStringLiteral("settings")};
  for (const Metric metric : metrics_) header << qtext(metricInfo(metric).id);
  QString text = header.join(u',') + u'\n';
  for (std::size_t index = 0; index < entries_.size(); ++index) {
    if (!isMeasured(index)) continue;
    QStringList line{quotedField(entries_[index].name)};
    for (const Metric metric : metrics_) line << QString::fromStdString(exactMetricText(mean(index, metric)));
    text += line.join(u',') + u'\n';
  }
  return text;
}

} // namespace taa::app
