// What the passes of the last frames took, one area on the other.
#pragma once

#include "app/models/ProfileSeries.h"
#include "app/views/plots/ChartAxes.h"

#include <QList>
#include <QPointF>
#include <QWidget>

#include <vector>

namespace taa::app {

class ProfileChart : public QWidget {
  Q_OBJECT
 public:
  explicit ProfileChart(QWidget* parent = nullptr);
  void show(const ProfileSeries& series);
  /// The color of the pass in this place of ProfileSeries::names().
  static QColor colorOf(std::size_t place);
  /// The bottom, then the upper edge of each area; x in frames before the last, y in ms.
  const std::vector<QList<QPointF>>& edges() const { return edges_; }
  const ChartAxes& axes() const { return axes_; }
  QSize sizeHint() const override { return {300, 160}; }

 protected:
  void resizeEvent(QResizeEvent*) override;
  void paintEvent(QPaintEvent*) override;

 private:
  void fitAxes();

  std::vector<QList<QPointF>> edges_;
  double high_ = 1.0; ///< of the vertical axis, ms
  ChartAxes axes_;
};

} // namespace taa::app
