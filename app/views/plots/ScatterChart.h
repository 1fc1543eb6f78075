// Settings by two numbers, with the front that no others beat: what is on it is filled and joined, scene by
// scene, each with a sign of its own.
#pragma once

#include "app/models/alternatives/SweepSeries.h"
#include "app/views/plots/ChartAxes.h"

#include <QString>
#include <QWidget>

#include <cstddef>
#include <optional>
#include <vector>

namespace taa::app {

class ScatterChart : public QWidget {
  Q_OBJECT
 public:
  explicit ScatterChart(QWidget* parent = nullptr);

  void setPoints(std::vector<ScatterPoint> points);
  const std::vector<ScatterPoint>& points() const { return points_; }
  void setTitles(const QString& x, const QString& y);
  /// Which is chosen, by the index of its settings.
  void setChosen(std::optional<std::size_t> index);

  /// Where a point lies on the widget.
  QPointF placeOf(const ScatterPoint& point) const { return axes_.pointOf(point.value); }
  /// The nearest point to a place, within some pixels of it.
  const ScatterPoint* pointAt(QPointF place) const;
  /// "balanced: RMSE 0.021, Flicker 0.0013"
  QString textOf(const ScatterPoint& point) const;
  /// The scenes that points are of, in their order; none where there is only one.
  std::vector<ScatterPoint> scenes() const;
  QSize sizeHint() const override { return {360, 260}; }

 Q_SIGNALS:
  void pointClicked(std::size_t index);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  bool event(QEvent*) override;

 private:
  void fitAxes();
  double legendHeight() const;
  void paintLegend(QPainter& painter) const;
  void paintFront(QPainter& painter, std::size_t scene) const;

  std::vector<ScatterPoint> points_;
  QString xTitle_, yTitle_;
  std::optional<std::size_t> chosen_;
  ChartAxes axes_;
};

} // namespace taa::app
