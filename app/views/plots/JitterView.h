// The jitter pattern as samples in one pixel: where they lie, in which order, and what they weigh now.
#pragma once

#include "core/probe/SampleWeights.h"

#include <QPointF>
#include <QRectF>
#include <QWidget>

#include <optional>
#include <vector>

namespace taa::app {

class JitterView : public QWidget {
  Q_OBJECT
 public:
  explicit JitterView(QWidget* parent = nullptr);

  void setPattern(const JitterPattern& pattern, int current);
  const JitterPattern& pattern() const { return pattern_; }
  int current() const { return current_; }
  /// Shows what is known of this sample; nothing: of none.
  void setHighlighted(std::optional<int> index);

  /// Where a place in the pixel (0 to 1) lies in the widget.
  QPointF pointOf(const glm::dvec2& position) const;
  /// Radius of a sample's disk: its area is its weight, and it can always be seen.
  double radiusOf(const JitterSample& sample) const;
  std::optional<int> sampleAt(const QPointF& point) const;
  /// The index of a sample and where it is written, logical px.
  struct Number {
    int index = 0;
    QRectF place;
  };
  /// Of the current sample, of the highlighted one, and of those whose number covers neither a number before
  /// it nor a disk.
  std::vector<Number> numbers() const;
  QSize sizeHint() const override { return {220, 220}; }

 Q_SIGNALS:
  void hovered(std::optional<int> index);
  void chosen(int index); ///< clicked

 protected:
  void paintEvent(QPaintEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;

 private:
  QRectF square() const;
  /// At the right of its disk, at the left where the widget ends.
  QRectF numberPlace(int index, const QRectF& disk) const;
  void paintGrid(QPainter& painter) const;
  void paintSamples(QPainter& painter) const;
  void paintMeans(QPainter& painter) const;

  JitterPattern pattern_;
  int current_ = 0;
  std::optional<int> highlighted_;
};

} // namespace taa::app
