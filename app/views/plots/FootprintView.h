// Where the samples that a pixel is made of lie around its center now: how much of them, and how old.
#pragma once

#include "core/verdict/lineage/Lineage.h"

#include <QPointF>
#include <QWidget>

#include <memory>
#include <optional>

namespace taa::app {

class FootprintView : public QWidget {
  Q_OBJECT
 public:
  explicit FootprintView(QWidget* parent = nullptr);

  /// Null: nothing is known.
  void setLineage(std::shared_ptr<const Lineage> lineage);
  /// Rings the samples of a frame.
  void setHighlighted(std::optional<int> frame);

  /// Where a place lies in the widget, px from the pixel's center.
  QPointF pointOf(const glm::dvec2& offset) const;
  /// Of a sample's disk: its area is its weight, and it can always be seen.
  double radiusOf(const FootprintSample& sample) const;
  std::optional<int> frameAt(const QPointF& point) const;
  QSize sizeHint() const override { return {220, 220}; }

 Q_SIGNALS:
  void hovered(std::optional<int> frame);
  void chosen(int frame); ///< clicked

 protected:
  void paintEvent(QPaintEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;

 private:
  QRectF square() const;
  void paintGrid(QPainter& painter) const;
  void paintSamples(QPainter& painter) const;

  std::shared_ptr<const Lineage> lineage_;
  double reach_ = 0.75; ///< px, half a side of the square
  std::optional<int> highlighted_;
};

} // namespace taa::app
