// How often which value is in view, on a logarithmic scale, with handles for both ends of the range.
#pragma once

#include "app/views/RangeMath.h"

#include <QWidget>

#include <vector>

namespace taa::app {

class RangeHistogram : public QWidget {
  Q_OBJECT
 public:
  static constexpr int kWidth = 288, kHeight = 92;

  explicit RangeHistogram(QWidget* parent = nullptr);

  /// Values in view, of which the shown channels count.
  void setValues(const Image& values, const Intermediate& row, const ViewStyle& style);
  void setRange(ValueRange range);
  ValueRange range() const { return range_; }
  /// Values from the left end to the right one.
  ValueRange scale() const { return scale_; }
  const std::vector<int>& counts() const { return counts_; }
  /// Where a value lies, logical px.
  double position(double value) const;
  QSize sizeHint() const override { return {kWidth, kHeight}; }

 Q_SIGNALS:
  void rangeEdited(ValueRange range);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  void moveEnd(bool high, double value);
  void fitScale();
  double valueAt(double x) const;

  ValueRange range_, scale_, values_;
  std::vector<int> counts_;
  bool movesHigh_ = false, drags_ = false;
};

} // namespace taa::app
