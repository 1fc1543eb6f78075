// What each explanation leaves, as numbers and bars: the shorter, the better it fits.
#pragma once

#include "core/doctor/Diagnosis.h"

#include <QWidget>

#include <vector>

class QPainter;

namespace taa::app {

class ResidualBars : public QWidget {
  Q_OBJECT
 public:
  explicit ResidualBars(QWidget* parent = nullptr);

  void setResiduals(const std::vector<doctor::Residual>& residuals);

  struct Bar {
    QString label, mark, number; ///< mark: a word for what fits and what is stored; empty: neither
    double share = 0.0;          ///< of the longest, 0 to 1
    bool isGiven = false, isBest = false;
  };
  const std::vector<Bar>& bars() const { return bars_; }
  /// Where the bar of a line is painted, px.
  QRectF barRect(int line) const;
  /// Whether all labels are painted whole.
  bool areLabelsWhole() const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  /// Labels that are too long for their column take more lines.
  int heightForWidth(int width) const override;

 protected:
  void paintEvent(QPaintEvent*) override;
  bool event(QEvent*) override;

 private:
  struct Columns {
    int label = 0, mark = 0, number = 0, bar = 0; ///< where they begin, px; numbers end at `bar`
  };
  int wantedLabel(int mark) const;
  Columns columns(int width) const;
  static int labelRoom(const Bar& bar, const Columns& at);
  int rowHeight(int line, const Columns& at) const;
  int rowTop(int line, const Columns& at) const; ///< of one past the last: the height of all
  void paintLine(QPainter& painter, int line) const;

  std::vector<Bar> bars_;
};

} // namespace taa::app
