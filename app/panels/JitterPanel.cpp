#include "app/panels/JitterPanel.h"

#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/plots/JitterView.h"
#include "app/widgets/ValueTable.h"
#include "app/widgets/areas/FittingArea.h"

#include "core/render/Jitter.h"
#include "core/settings/Parameters.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace taa::app {

namespace {

QString pair(const glm::dvec2& value) {
  return QStringLiteral("(%1, %2)").arg(fixedText(value.x, 3), fixedText(value.y, 3));
}

int periodOf(const AlphaSeries& series) {
  return series.jitterPx.empty() ? jitterPeriod(series.settings.jitter)
                                 : static_cast<int>(series.jitterPx.size());
}

JitterPattern patternOf(const AlphaSeries& series, const std::vector<double>& weights) {
  if (!series.jitterPx.empty()) return jitterPattern(series.jitterPx, series.frame, weights);
  return jitterPattern(series.settings.jitter, series.frame, weights, series.jitterWay.value_or(kFirstWay));
}

QString patternName(const AlphaSeries& series) {
  if (!series.jitterPx.empty()) return JitterPanel::tr("The capture's own");
  const Parameter& row = parameter("jitter.sequence");
  return qtext(row.choices[static_cast<std::size_t>(row.get(series.settings))].label);
}

} // namespace

JitterPanel::JitterPanel(QWidget* parent)
    : AlphaPage(parent), view_(new JitterView),
      table_(new ValueTable({tr("Index"), tr("x"), tr("y"), tr("Weight, %"), tr("Frame")})),
      title_(new QLabel), legend_(makeNote()) {
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  columns->setSpacing(4 * kUnit);
  auto* words = new QWidget;
  auto* texts = new QVBoxLayout(words);
  texts->setContentsMargins(0, 0, 0, 0);
  texts->setSpacing(2 * kUnit);
  texts->addWidget(title_);
  texts->addWidget(summaryLabel());
  texts->addWidget(legend_);
  texts->addStretch(1);
  legend_->setToolTip(
      tr("x and y are where in the pixel a frame samples. Its picture moves the other way, by "
         "what the timeline says."));
  legend_->setText(tr("Disks: samples, with areas as their weights; ringed: this frame's. "
                      "+ middle of the samples, × with their weights: where the picture's content lies. "
                      "The grid has as many cells as there are samples, or a few less. "
                      "Click a sample to go to the frame that took it last."));
  // Its columns are whole before the others get their shares.
  table_->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Expanding);
  columns->addWidget(view_, 4);
  columns->addWidget(table_, 4);
  columns->addWidget(scrolled(words), 5);
  connect(view_, &JitterView::hovered, this, &JitterPanel::highlight);
  connect(view_, &JitterView::chosen, this, [this](int index) {
    const int period = periodOf(series());
    const int back = (series().frame % period - index + period) % period;
    Q_EMIT seekRequested(std::max(0, series().frame - back));
  });
}

void JitterPanel::highlight(std::optional<int> index) {
  view_->setHighlighted(index);
  for (int row = 0; row < table_->topLevelItemCount(); ++row)
    table_->topLevelItem(row)->setSelected(index == row);
  if (index && *index < table_->topLevelItemCount()) table_->scrollToItem(table_->topLevelItem(*index));
}

void JitterPanel::showTable(const JitterPattern& pattern, int current) {
  const int period = static_cast<int>(pattern.samples.size());
  std::vector<ValueTable::Row> rows;
  for (int index = 0; index < period; ++index) {
    const JitterSample& sample = pattern.samples[static_cast<std::size_t>(index)];
    const int latest = series().frame - (current - index + period) % period;
    const bool isCurrent = index == current;
    rows.push_back({{isCurrent ? tr("%1 now").arg(index) : QString::number(index),
                     fixedText(sample.position.x - 0.5, 3), fixedText(sample.position.y - 0.5, 3),
                     fixedText(100.0 * sample.weight, 2), latest < 0 ? QString() : QString::number(latest)},
                    {},
                    isCurrent});
  }
  table_->setRows(rows);
}

void JitterPanel::refresh() {
  const JitterSettings& jitter = series().settings.jitter;
  const bool isMeasured = !series().measured.empty();
  const std::vector<double> weights = frameWeights(isMeasured ? series().measured : series().nominal());
  const JitterPattern pattern = patternOf(series(), weights);
  const int current = series().frame % periodOf(series());
  view_->setPattern(pattern, current);
  showTable(pattern, current);
  const int period = static_cast<int>(pattern.samples.size());
  title_->setText(tr("%1, index %2 of %3").arg(patternName(series())).arg(current).arg(period));
  QStringList lines;
  lines << (isMeasured ? tr("Weights as measured at %1. Frames: %2.").arg(series().place).arg(weights.size())
                       : tr("Weights by the settings, where nothing moves or changes. Frames: %1.")
                             .arg(weights.size()));
  lines << tr("Effective samples: %1, at %2 of the %3 places.")
               .arg(shortText(effectiveSamples(weights), 3), shortText(pattern.effective, 3))
               .arg(period);
  lines << tr("All places cover %1 % of %2×%2 cells.")
               .arg(fixedText(100.0 * pattern.coverage, 0))
               .arg(pattern.cells);
  lines << tr("Middle %1 px, with weights %2 px.").arg(pair(pattern.mean), pair(pattern.weightedMean));
  if (isMeasured) lines << stillNote();
  if (series().jitterPx.empty() && jitter.sequence == JitterSequence::Perpendicular)
    lines << (series().jitterWay ? tr("The samples lie across the way the camera moves in this frame.")
                                 : tr("The samples are shown as for a camera that moves to the right."));
  setSummary(lines, QLatin1Char('\n'));
}

} // namespace taa::app
