// What the passes of the last frames took, one area on the other.
#pragma once

#include "app/models/ProfileHistory.h"

#include <QChartView>

#include <vector>

class QAreaSeries;
class QLineSeries;
class QValueAxis;

namespace taa::app {

class ProfileChart : public QChartView {
  Q_OBJECT
 public:
  explicit ProfileChart(QWidget* parent = nullptr);
  void show(const ProfileHistory& history);
  /// The color of the pass in this place of ProfileHistory::names().
  static QColor colorOf(std::size_t place);
  QSize sizeHint() const override { return {300, 160}; }

 protected:
  void resizeEvent(QResizeEvent*) override;
  void changeEvent(QEvent*) override;

 private:
  void fitSeries(std::size_t count);
  void applyColors();

  QValueAxis *frames_ = nullptr, *times_ = nullptr;
  std::vector<QLineSeries*> edges_; ///< the bottom, then the upper edge of each area
  std::vector<QAreaSeries*> areas_;
};

} // namespace taa::app
