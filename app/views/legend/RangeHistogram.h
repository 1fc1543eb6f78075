// How often which value is in view, on a logarithmic scale, with handles for both ends of the range.
#pragma once

#include "app/views/legend/RangeMath.h"

#include <QWidget>

#include <vector>

class QPainter;

namespace taa::app {

struct ThemeColors;

class RangeHistogram : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kWidth = 288, kHeight = 92;
  static constexpr int kSide = 8,
                       kColumn = 2; ///< px beside the columns, width of one where text has its own size
  static constexpr int kBins = (kWidth - 2 * kSide) / kColumn;

  explicit RangeHistogram(QWidget* parent = nullptr);

  /// Of the values in view; one without counts: they are being counted. While an end is dragged nothing else
  /// moves.
  void setDistribution(const Distribution& found);
  void setRange(ValueRange range);
  ValueRange range() const { return range_; }
  const HistogramAxis& axis() const { return axis_; }
  const std::vector<int>& counts() const { return counts_; }
  /// Where a value lies, logical px; what is not above the left end of a logarithmic axis lies at it.
  double position(double value) const;
  /// The ends of the range beside the signs of their handles.
  QString rangeText() const;
  /// What stands at the left end of the axis.
  QString leftText() const;
  QSize sizeHint() const override { return minimumSize(); }

 Q_SIGNALS:
  void rangeEdited(ValueRange range);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void showEvent(QShowEvent*) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();
  void moveEnd(bool high, double value);
  double valueAt(double x) const;
  void paintColumns(QPainter& painter, const ThemeColors& colors) const;
  void paintRange(QPainter& painter, const ThemeColors& colors) const;

  ValueRange range_;
  HistogramAxis axis_;
  std::vector<int> counts_;
  bool movesHigh_ = false, drags_ = false;
};

} // namespace taa::app
