// How much each of the last frames counts in a pixel: its samples, and on them what rectification put there.
#pragma once

#include "app/views/plots/ChartAxes.h"
#include "core/verdict/lineage/Lineage.h"

#include <QColor>
#include <QWidget>

#include <memory>
#include <optional>

namespace taa::app {

/// Of samples and bars: this frame's, and the oldest at 1.
QColor ageColor(const QWidget* widget, double share);

class LineageBars : public QWidget {
  Q_OBJECT
 public:
  explicit LineageBars(QWidget* parent = nullptr);

  /// Null: nothing is known.
  void setLineage(std::shared_ptr<const Lineage> lineage);
  void setHighlighted(std::optional<int> frame);
  /// The line above the bars: what is known of the frame under the mouse.
  QString readout() const;
  /// From the bottom of a frame's samples to their top; of what rectification put there.
  QRectF barOf(const LineageFrame& entry) const;
  QRectF rectifiedOf(const LineageFrame& entry) const;
  std::optional<int> frameAt(double viewX) const;
  QSize sizeHint() const override { return {360, 200}; }

 Q_SIGNALS:
  void hovered(std::optional<int> frame);
  void chosen(int frame); ///< clicked

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;

 private:
  void fitAxes();
  QRectF boxOf(int frame, double from, double to) const;

  std::shared_ptr<const Lineage> lineage_;
  std::optional<int> highlighted_;
  ChartAxes axes_;
};

} // namespace taa::app
