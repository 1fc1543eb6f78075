#include "app/views/plots/ProfileChart.h"

#include "app/style/Theme.h"

#include "core/picture/ColorMap.h"

#include <QAreaSeries>
#include <QChart>
#include <QEvent>
#include <QLineSeries>
#include <QValueAxis>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace taa::app {

namespace {

constexpr int kHeightOfTitle = 140; ///< of a chart that has room for the title of its horizontal axis

/// The next of 1, 2, 5 times a power of ten, so that the scale does not jump with each frame.
double roundedUp(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-3))));
  for (const double step : {1.0, 2.0, 3.0, 5.0})
    if (value <= step * power) return step * power;
  return 10.0 * power;
}

} // namespace

ProfileChart::ProfileChart(QWidget* parent)
    : QChartView(parent), frames_(new QValueAxis), times_(new QValueAxis) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  setMinimumSize(180, 90);
  setAccessibleName(tr("Times of the passes over the last frames"));
  QChart* chart = this->chart();
  chart->legend()->hide(); // the table beside it has the colors
  chart->setMargins({0, 0, 0, 0});
  chart->setBackgroundRoundness(0);
  chart->addAxis(frames_, Qt::AlignBottom);
  chart->addAxis(times_, Qt::AlignLeft);
  frames_->setRange(-static_cast<double>(kProfiledFrames), 0.0);
  frames_->setTickCount(4);
  frames_->setLabelFormat(QStringLiteral("%.0f"));
  frames_->setTitleText(tr("frames before the last"));
  frames_->setTruncateLabels(false);
  times_->setTickCount(3);
  times_->setLabelFormat(QStringLiteral("%g"));
  times_->setTitleText(tr("ms"));
  applyColors();
}

QColor ProfileChart::colorOf(std::size_t place) {
  // Number 0 of the palette stands for nothing elsewhere.
  const std::array<float, 3> linear = categoryColor(static_cast<int>(place) + 1);
  return QColor::fromRgbF(srgbEncoded(linear[0]), srgbEncoded(linear[1]), srgbEncoded(linear[2]));
}

void ProfileChart::fitSeries(std::size_t count) {
  if (areas_.size() == count) return;
  for (QAreaSeries* area : areas_) {
    chart()->removeSeries(area);
    delete area;
  }
  areas_.clear();
  for (QLineSeries* edge : edges_) delete edge;
  edges_.clear();
  for (std::size_t edge = 0; edge <= count; ++edge) edges_.push_back(new QLineSeries(this));
  for (std::size_t place = 0; place < count; ++place) {
    auto* area = new QAreaSeries(edges_[place + 1], edges_[place]);
    area->setColor(colorOf(place));
    area->setBorderColor(colorOf(place));
    chart()->addSeries(area);
    area->attachAxis(frames_);
    area->attachAxis(times_);
    areas_.push_back(area);
  }
}

void ProfileChart::show(const ProfileHistory& history) {
  const std::vector<std::string>& names = history.names();
  fitSeries(names.size());
  std::vector<QList<QPointF>> points(names.size() + 1);
  std::vector<double> totals;
  double frame = -static_cast<double>(history.profiles().size());
  for (const FrameProfile& profile : history.profiles()) {
    double height = 0.0;
    // As wide as a frame, so that a single one is seen too.
    const auto add = [&](QList<QPointF>& edge) {
      edge << QPointF(frame, height) << QPointF(frame + 1.0, height);
    };
    add(points[0]);
    for (std::size_t place = 0; place < names.size(); ++place) {
      height += ProfileHistory::timeOf(profile, names[place]);
      add(points[place + 1]);
    }
    totals.push_back(height);
    frame += 1.0;
  }
  for (std::size_t edge = 0; edge < points.size(); ++edge) edges_[edge]->replace(points[edge]);
  // One frame that compiled a program takes a hundred times the others': it may leave the picture.
  std::ranges::sort(totals);
  const double high = totals.empty() ? 1.0 : totals[(totals.size() - 1) * 95 / 100];
  times_->setRange(0.0, roundedUp(1.1 * high));
}

void ProfileChart::applyColors() {
  const ThemeColors& colors = themeColors(this);
  setBackgroundBrush(colors.panel);
  chart()->setBackgroundBrush(colors.panel);
  for (QValueAxis* axis : {frames_, times_}) {
    axis->setLabelsFont(secondaryFont());
    axis->setTitleFont(secondaryFont());
    axis->setLabelsBrush(colors.secondary);
    axis->setTitleBrush(colors.secondary);
    axis->setLinePen(QPen(colors.line));
    axis->setGridLinePen(QPen(colors.line));
  }
}

// Qt Charts shortens the labels of an axis to dots where its title leaves them too little height.
void ProfileChart::resizeEvent(QResizeEvent* event) {
  frames_->setTitleVisible(height() >= kHeightOfTitle);
  QChartView::resizeEvent(event);
}

void ProfileChart::changeEvent(QEvent* event) {
  QChartView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) applyColors();
}

} // namespace taa::app
