#include "app/panels/WeightsPanel.h"

#include "app/style/Numbers.h"
#include "app/style/Theme.h"
#include "app/views/plots/CurveChart.h"
#include "app/widgets/areas/FittingArea.h"

#include "core/probe/SampleWeights.h"

#include <QFontMetrics>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

constexpr int kShownBack = 63;   ///< frames back on the first chart
constexpr int kFramesAhead = 32; ///< shown of the effective samples at least

// From the newest back.
std::vector<QPointF> backwards(const std::vector<double>& weights) {
  std::vector<QPointF> points;
  for (std::size_t age = 0; age < weights.size() && age <= kShownBack; ++age)
    points.emplace_back(static_cast<double>(age), weights[weights.size() - 1 - age]);
  return points;
}

std::vector<QPointF> from(int first, const std::vector<double>& values) {
  std::vector<QPointF> points;
  for (std::size_t index = 0; index < values.size(); ++index)
    points.emplace_back(first + static_cast<double>(index), values[index]);
  return points;
}

QString number(double value) {
  return shortText(value, 4); // as the legends of the curves
}

} // namespace

WeightsPanel::WeightsPanel(QWidget* parent)
    : AlphaPage(parent), weights_(new CurveChart(tr("Weight by frames back"), tr("frames back"))),
      samples_(new CurveChart(tr("Effective samples by frame"), tr("frame"))) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  rows->setSpacing(kUnit);
  auto* charts = new QHBoxLayout;
  charts->setSpacing(4 * kUnit);
  charts->addWidget(weights_, 1);
  charts->addWidget(samples_, 1);
  rows->addLayout(charts, 1);
  auto* summary =
      new FittingArea(QFontMetrics(secondaryFont()).lineSpacing()); // in a low window the curves go first
  summary->setWidget(summaryLabel());
  rows->addWidget(summary);
  connect(samples_, &CurveChart::xClicked, this,
          [this](double frame) { Q_EMIT seekRequested(static_cast<int>(frame)); });
  connect(weights_, &CurveChart::xClicked, this, [this](double back) {
    Q_EMIT seekRequested(std::max(0, series().frame - static_cast<int>(back)));
  });
}

void WeightsPanel::resetZoom() {
  weights_->resetZoom();
  samples_->resetZoom();
}

void WeightsPanel::refresh() {
  const std::vector<double> nominal = series().nominal();
  const std::vector<double> nominalWeights = frameWeights(nominal);
  const int first = series().frame - static_cast<int>(nominal.size()) + 1;
  // On to where the count has nearly settled, so that the curve shows where it leads.
  const std::vector<double> ahead = alphasAtRest(
      series().settings, std::max(static_cast<int>(nominal.size()), kFramesAhead) + kFramesAhead);
  const QColor color = curveColor(0), measuredColor = curveColor(1);
  std::vector<Curve> weights, samples;
  QStringList lines;
  lines << tr("Frame %1, %2 after history started. By the settings, where nothing moves or changes: "
              "α = %3; effective samples: %4 now, %5 at last.")
               .arg(series().frame)
               .arg(series().frame - series().start)
               .arg(number(nominal.back()), number(effectiveSamples(nominalWeights)),
                    number(effectiveSamplesOver(alphasAtRest(series().settings, 2 * kMaxFramesBack)).back()));
  if (!series().measured.empty()) {
    const std::vector<double> measured = frameWeights(series().measured);
    const QString name = tr("measured at %1").arg(series().place);
    weights.push_back({name, measuredColor, Qt::SolidLine, backwards(measured)});
    samples.push_back({name, measuredColor, Qt::SolidLine,
                       from(series().frame - static_cast<int>(measured.size()) + 1,
                            effectiveSamplesOver(series().measured))});
    lines << tr("Measured at %1: α = %2; effective samples: %3 of %4 frames.")
                 .arg(series().place, number(series().measured.back()), number(effectiveSamples(measured)))
                 .arg(measured.size())
          << stillNote();
  } else {
    lines << tr("A probe adds what its pixel measured in the frames that were shown.");
  }
  // Last, so that its dashes are seen where both are the same.
  weights.push_back({tr("by the settings"), color, Qt::DashLine, backwards(nominalWeights)});
  samples.push_back({tr("by the settings"), color, Qt::DashLine, from(first, effectiveSamplesOver(ahead))});
  weights_->setBounds({0.0, static_cast<double>(kShownBack)});
  weights_->setCurves(std::move(weights));
  samples_->setBounds({static_cast<double>(first), first + static_cast<double>(ahead.size()) - 1.0});
  samples_->setPlayhead(series().frame);
  samples_->setCurves(std::move(samples));
  setSummary(lines, QLatin1Char(' '));
}

} // namespace taa::app
