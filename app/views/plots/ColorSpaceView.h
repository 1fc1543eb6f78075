// The neighborhood, the boxes and the way of history in a color space: a plot to turn, and its three flat
// projections.
#pragma once

#include "app/models/ColorSpaceMath.h"
#include "app/views/plots/ChartAxes.h"

#include <QPointF>
#include <QString>
#include <QWidget>

#include <optional>
#include <utility>
#include <vector>

class QPainter;

namespace taa::app {

struct ThemeColors;

class ColorSpaceView : public QWidget {
  Q_OBJECT
 public:
  explicit ColorSpaceView(QWidget* parent = nullptr);

  /// Nothing: there is no probe to show.
  void setScene(const std::optional<ColorScene>& scene);
  const std::optional<ColorScene>& scene() const { return scene_; }
  const SpaceTurn& turn() const { return turn_; }
  void setTurn(const SpaceTurn& turn);
  void turnBy(double stepsRight, double stepsUp); ///< a step is 5 degrees
  void resetTurn() { setTurn({}); }

  /// Where a color is in the plot.
  QPointF placeOf(const glm::vec3& color) const;
  /// What is nearest to a place, with its values; empty when nothing is near.
  QString textAt(QPointF place) const;
  /// Of the plot that can be turned: names of the axes, then as many ticks as stand apart; none without a
  /// scene.
  std::vector<ChartLabel> axisLabels() const;
  QSize sizeHint() const override { return {380, 520}; }

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  bool event(QEvent*) override;

 private:
  struct Content;
  QRectF plotRect() const;
  QRectF projectionRect(int index) const;
  double upLabelsWidth(int projection) const;
  int projections() const; ///< how many are shown
  int legendHeight() const;
  QPointF flatPlace(const glm::vec3& color, int projection) const;
  void paintPlot(QPainter& painter, const Content& content) const;
  void paintAxes(QPainter& painter, const Content& content) const;
  void paintNames(QPainter& painter, const Content& content) const;
  void paintFlatAxes(QPainter& painter, const Content& content, int index) const;
  std::vector<std::pair<QPointF, double>> axisTicks() const;
  QString axisName(int axis) const; ///< expects a scene
  void paintProjection(QPainter& painter, const Content& content, int index) const;
  void paintLegend(QPainter& painter, const Content& content) const;

  std::optional<ColorScene> scene_;
  ColorRange range_;
  SpaceTurn turn_;
  std::optional<QPointF> held_; ///< where the mouse was, while it turns the plot
};

} // namespace taa::app
