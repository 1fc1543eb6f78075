#include "app/views/plots/ProfileChart.h"

#include "app/session/Mailbox.h"
#include "app/style/CurveColor.h"
#include "app/style/Theme.h"

#include "core/base/Light.h"
#include "core/picture/ColorMap.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

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

ProfileChart::ProfileChart(QWidget* parent) : QWidget(parent) {
  setMinimumSize(180, 60);
  setAccessibleName(tr("Times of the passes over the last frames"));
  fitAxes();
}

QColor ProfileChart::colorOf(std::size_t place) {
  // Number 0 of the palette stands for nothing elsewhere.
  const std::array<float, 3> linear = categoryColor(static_cast<int>(place) + 1);
  return QColor::fromRgbF(srgbEncoded(linear[0]), srgbEncoded(linear[1]), srgbEncoded(linear[2]));
}

void ProfileChart::show(const ProfileSeries& series) {
  const std::vector<std::string>& names = series.names();
  std::vector<QList<QPointF>> points(names.size() + 1);
  std::vector<double> totals;
  double frame = -static_cast<double>(series.profiles().size());
  for (const FrameProfile& profile : series.profiles()) {
    double height = 0.0;
    // As wide as a frame, so that a single one is seen too.
    const auto add = [&](QList<QPointF>& edge) {
      edge << QPointF(frame, height) << QPointF(frame + 1.0, height);
    };
    add(points[0]);
    for (std::size_t place = 0; place < names.size(); ++place) {
      height += ProfileSeries::timeOf(profile, names[place]);
      add(points[place + 1]);
    }
    totals.push_back(height);
    frame += 1.0;
  }
  edges_ = std::move(points);
  // One frame that compiled a program takes a hundred times the others': it may leave the picture.
  std::ranges::sort(totals);
  high_ = roundedUp(1.1 * (totals.empty() ? 1.0 : totals[(totals.size() - 1) * 95 / 100]));
  fitAxes();
}

void ProfileChart::fitAxes() {
  const ChartAxis frames{{-static_cast<double>(kProfiledFrames), 0.0},
                         static_cast<double>(kProfiledFrames) / 3.0,
                         height() >= kHeightOfTitle ? tr("frames before the last") : QString()};
  axes_.layOut(frames, {{0.0, high_}, 0.5 * high_, tr("ms")},
               QRectF(rect()).adjusted(kUnit, kUnit, -2.0 * kUnit, -1.0));
  update();
}

void ProfileChart::paintEvent(QPaintEvent*) {
  const ThemeColors& colors = themeColors(this);
  QPainter painter(this);
  painter.fillRect(rect(), colors.panel);
  painter.setRenderHint(QPainter::Antialiasing);
  axes_.paint(painter, colors);
  painter.setClipRect(axes_.plot());
  for (std::size_t place = 0; place + 1 < edges_.size(); ++place) {
    QPolygonF area;
    for (const QPointF& point : edges_[place]) area << axes_.pointOf(point);
    for (auto point = edges_[place + 1].rbegin(); point != edges_[place + 1].rend(); ++point)
      area << axes_.pointOf(*point);
    const QColor color = onPanel(colorOf(place), colors);
    painter.setPen(QPen(color, 1.0)); // closes the seams that smooth edges leave
    painter.setBrush(color);
    painter.drawPolygon(area);
  }
}

void ProfileChart::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitAxes();
}

} // namespace taa::app
