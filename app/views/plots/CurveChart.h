// Curves over frames with a playhead, marks and values under the mouse; told apart by dash and name, not by
// color alone.
#pragma once

#include "app/views/plots/ChartAxes.h"
#include "app/views/plots/CurveLegend.h"
#include "app/widgets/Drags.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

namespace taa::app {

class CurveChart : public QWidget, public Draggable {
  Q_OBJECT
 public:
  /// `xTitle`: what x counts; also before its value in the readout: "frame 41".
  CurveChart(const QString& title, const QString& xTitle, QWidget* parent = nullptr);

  void setCurves(std::vector<Curve> curves);
  const std::vector<Curve>& curves() const { return curves_; }
  void setMarks(std::vector<ChartMark> marks);
  const std::vector<ChartMark>& marks() const { return marks_; }
  void setPlayhead(std::optional<double> x);
  /// Where its plot begins and ends, px: in line with something else that has the labels of x. Names and
  /// values then stand beside the plot.
  void setEdges(const Span& edges);
  /// All there is to see.
  void setBounds(const Span& all);
  void setShown(const Span& shown);
  Span shown() const { return shown_; }
  Span values() const { return axes_.y().range; }
  void resetZoom() { setShown(all_); }
  /// Where the mouse is, in all charts that show the same x.
  void setHovered(std::optional<double> x);

  /// The line above the curves: names and values under the mouse, else at the playhead.
  QString readout() const;
  double xAt(double viewX) const;
  double viewXOf(double x) const;
  void cancelDrag() override;
  QSize sizeHint() const override { return QSize(400, 120).expandedTo(minimumSizeHint()); }
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void xClicked(double x);
  void shownChanged(const Span& shown);
  void hovered(std::optional<double> x);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void leaveEvent(QEvent*) override;
  void resizeEvent(QResizeEvent*) override;

 private:
  void fitAxes();
  void layOutLegend();
  void layOutNames();
  void drawCurves(QPainter& painter) const;
  void drawMarks(QPainter& painter, const QRectF& plot) const;
  std::optional<double> readX() const { return hovered_ ? hovered_ : playhead_; }
  QString markText(double x) const;

  QString title_, xTitle_;
  ChartAxes axes_;
  std::vector<Curve> curves_;
  CurveLegend legend_;
  std::vector<ChartMark> marks_;
  Span all_, shown_;
  std::optional<Span> edges_;
  std::optional<double> playhead_, hovered_;
  std::optional<double> pressedX_; ///< view px
  double draggedX_ = 0.0;
};

} // namespace taa::app
