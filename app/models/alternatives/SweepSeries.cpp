#include "app/models/alternatives/SweepSeries.h"

#include "app/style/Text.h"
#include "core/sweep/ParetoFront.h"

#include <QObject>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace taa::app {

namespace {

/// Dashes tell apart scenes, and what has a color of the palette again.
constexpr std::array<Qt::PenStyle, 4> kSettingsDashes{Qt::SolidLine, Qt::DashLine, Qt::DotLine,
                                                      Qt::DashDotLine};
constexpr std::size_t kPaletteColors = 8;
const QColor kSupersamplingColor(128, 128, 128); // of no settings

double lessIsBetter(Metric metric, double value) {
  return metricInfo(metric).isHigherBetter ? -value : value;
}

QString quotedField(const QString& text) {
  if (!text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n')) return text;
  QString inside = text;
  return u'"' + inside.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

/// Marks those that no other one of them beats.
void markFront(std::vector<ScatterPoint>& points, std::size_t first, Metric x, Metric y) {
  std::vector<TradeOff> tradeOffs;
  for (std::size_t place = first; place < points.size(); ++place)
    tradeOffs.emplace_back(
        std::array{lessIsBetter(x, points[place].value.x()), lessIsBetter(y, points[place].value.y())});
  const std::vector<bool> isOnFront = onParetoFront(tradeOffs);
  for (std::size_t place = first; place < points.size(); ++place)
    points[place].isOnFront = isOnFront[place - first];
}

} // namespace

void SweepSeries::begin(std::vector<QString> settings, std::vector<QString> scenes,
                        std::vector<Metric> metrics) {
  assert(settings.empty() || !scenes.empty());
  metrics_ = std::move(metrics);
  settings_ = std::move(settings);
  scenes_ = std::move(scenes);
  frames_.assign(settings_.size() * scenes_.size(), {});
}

void SweepSeries::add(std::size_t index, LaneMetrics frames) {
  if (index < frames_.size()) frames_[index] = std::move(frames);
}

std::size_t SweepSeries::measuredCount() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(frames_, [](const LaneMetrics& frames) { return !frames.empty(); }));
}

std::optional<double> SweepSeries::mean(std::size_t index, Metric metric) const {
  return meanOfFrames(frames_[index], metric);
}

QString SweepSeries::fullName(std::size_t index) const {
  if (scenes_.size() < 2) return name(index);
  return QStringLiteral("%1 · %2").arg(sceneName(sceneOf(index)), name(index));
}

QColor SweepSeries::colorOf(std::size_t index) const {
  return curveColor(static_cast<int>(settingsOf(index) % kPaletteColors));
}

Curve SweepSeries::curveOf(std::size_t index, Metric metric) const {
  Curve curve{fullName(index), colorOf(index), Qt::SolidLine, {}, {}};
  for (const FrameMetrics& frame : frames_[index])
    curve.points.emplace_back(frame.frame,
                              frame.at(metric).value_or(std::numeric_limits<double>::quiet_NaN()));
  return curve;
}

std::vector<Curve> SweepSeries::curves(Metric metric, std::optional<std::size_t> scene) const {
  std::vector<Curve> curves;
  for (std::size_t index = 0; index < count(); ++index) {
    if (!isMeasured(index) || (scene && sceneOf(index) != *scene)) continue;
    if (metric == Metric::Rmse && mean(index, Metric::Supersampling)) {
      Curve& line = curves.emplace_back(curveOf(index, Metric::Supersampling));
      line.name = QObject::tr("supersampling");
      if (!scene && scenes_.size() > 1)
        line.name = QStringLiteral("%1 · %2").arg(sceneName(sceneOf(index)), line.name);
      line.color = kSupersamplingColor;
      line.dash = Qt::DashDotDotLine;
    }
    const std::size_t dash = settingsOf(index) / kPaletteColors + (scene ? 0 : sceneOf(index));
    Curve& curve = curves.emplace_back(curveOf(index, metric));
    if (scene) curve.name = name(index);
    curve.dash = kSettingsDashes[dash % kSettingsDashes.size()];
  }
  return curves;
}

std::vector<ScatterPoint> SweepSeries::tradeOff(Metric x, Metric y, std::optional<std::size_t> scene) const {
  std::vector<ScatterPoint> points;
  std::size_t first = 0; // of the points, of the scene
  for (std::size_t index = 0; index < count(); ++index) {
    if (settingsOf(index) == 0) {
      markFront(points, first, x, y);
      first = points.size();
    }
    if (scene && sceneOf(index) != *scene) continue;
    const std::optional<double> ofX = mean(index, x), ofY = mean(index, y);
    if (!ofX || !ofY || !std::isfinite(*ofX) || !std::isfinite(*ofY)) continue;
    points.push_back({index,
                      fullName(index),
                      colorOf(index),
                      {*ofX, *ofY},
                      false,
                      sceneOf(index),
                      scenes_.size() < 2 ? QString() : sceneName(sceneOf(index))});
  }
  markFront(points, first, x, y);
  return points;
}

QString SweepSeries::csv() const {
  const bool namesScenes = scenes_.size() > 1;
  QStringList header;
  if (namesScenes) header << QStringLiteral("scene");
  header << QStringLiteral("settings");
  for (const Metric metric : metrics_) header << qtext(metricInfo(metric).id);
  QString text = header.join(u',') + u'\n';
  for (std::size_t index = 0; index < count(); ++index) {
    if (!isMeasured(index)) continue;
    QStringList line;
    if (namesScenes) line << quotedField(sceneName(sceneOf(index)));
    line << quotedField(name(index));
    for (const Metric metric : metrics_) line << QString::fromStdString(exactMetricText(mean(index, metric)));
    text += line.join(u',') + u'\n';
  }
  return text;
}

} // namespace taa::app
