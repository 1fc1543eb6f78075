// A picture that can be zoomed, panned and probed. While a sharper one is on its way it moves the last one at
// once.
#pragma once

#include "app/models/verdict/LineageMath.h"
#include "app/session/ProbeList.h"
#include "app/views/ViewSides.h"
#include "app/views/ViewportMath.h"
#include "app/widgets/Drags.h"

#include "core/doctor/Outline.h"
#include "core/inspect/Comparison.h"
#include "core/requests/Results.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace taa::app {

class Viewport : public QWidget, public Draggable {
  Q_OBJECT
 public:
  explicit Viewport(QWidget* parent = nullptr);

  /// Size of what is looked at, px.
  void setPictureSize(glm::ivec2 size);
  /// What legend and overlays speak of.
  void setContent(const ViewContent& content);
  const ViewContent& shownContent() const { return sides_.content(); }
  const std::optional<ViewContent>& otherContent() const { return sides_.other(); }
  /// The other side, when there is one.
  void setOther(const std::optional<ViewContent>& other);
  void setShowing(Showing showing);
  /// Shows the other side meanwhile.
  void setPeeking(bool peeking);
  void setShowsGrid(bool shows);
  /// Also where it covers much of the pictures (ShownLegend).
  void setLegendWhole(bool whole);
  /// Whether time goes on: another frame beside it is then not made.
  void setPlaying(bool playing);
  /// Where the divider lies, share of the width.
  void setDivider(double share);
  void setResult(std::shared_ptr<const ViewResult> result);
  void setMarks(const std::vector<ProbeMark>& marks);
  /// Draws the way that a pixel came; empty: none.
  void setPath(const std::vector<PathPlace>& path) {
    if (path == path_) return;
    path_ = path;
    update();
  }
  const std::vector<PathPlace>& path() const { return path_; }
  /// Draws a frame around these pixels.
  void setFramed(const std::optional<gl::Rect>& box);
  /// Draws these outlines, edges between pixels of the picture.
  void setOutlines(const std::vector<doctor::OutlineEdge>& edges);
  const std::vector<doctor::OutlineEdge>& outlines() const { return outlines_; }
  /// Draws an outline around the region whose values are described.
  void setMeasured(const std::optional<gl::Rect>& region);
  void setCamera(const ViewCamera& camera);

  const ViewCamera& camera() const { return camera_; }
  ViewGeometry viewGeometry() const; ///< in device pixels
  ViewTransform transform() const;   ///< of now, in device pixels
  double zoom() const { return static_cast<double>(transform().zoom); }
  /// Whether a texel is large enough to hold its values.
  bool showsValues() const;
  std::optional<glm::ivec2> hovered() const { return hovered_; }
  /// The value at a pixel, when the last result brought it.
  std::optional<std::vector<float>> valueAt(glm::ivec2 pixel) const { return sides_.valueAt(pixel); }
  std::optional<std::vector<float>> otherValueAt(glm::ivec2 pixel) const {
    return sides_.otherValueAt(pixel);
  }
  Absence absenceAt(glm::ivec2 pixel) const { return sides_.absenceAt(pixel); }
  Absence otherAbsenceAt(glm::ivec2 pixel) const { return sides_.otherAbsenceAt(pixel); }
  double divider() const { return divider_; }
  /// The first column of the picture that a divider leaves to the other side.
  int dividerColumn() const;
  /// What is on the screen now, peeking included.
  Showing shown() const { return sides_.shown(); }
  /// What it shows of the picture, pixel for pixel of the screen, without what is only held for a moment and
  /// without what is around the picture; `withLegend`: with all that lies over it, and below it what that
  /// means. Null while a part of it is on its way.
  QImage picture(bool withLegend) const;
  /// What of it is covered by the picture, logical px.
  QRect pictureRect() const;
  /// The same in device px; all of it where nothing of the picture is in it. Expects a result.
  QRect shownPart() const;
  /// What the picture means, without what is only held for a moment.
  LegendFlow legendBelow() const { return legend(sides_.showing()); }
  /// Who is on a side: row, settings, frame.
  QString label(bool other) const { return sides_.label(other); }
  const std::shared_ptr<const ViewResult>& result() const { return sides_.result(); }
  ShownLegend shownLegend() const;

  void cancelDrag() override;
  void fit();
  void oneToOne();
  void zoomBy(double notches);
  void reveal(glm::ivec2 pixel);

 Q_SIGNALS:
  void cameraChanged(const ViewCamera& camera); ///< by the user
  void transformChanged();                      ///< by anything
  void hoverChanged();
  void probed(glm::ivec2 pixel);
  void otherProbed(glm::ivec2 pixel); ///< another probe
  void doubleClicked();
  void probeMoved(int dx, int dy);
  void activated();
  void dividerMoved();
  /// With Ctrl held; a click removes it.
  void regionDragged(const std::optional<gl::Rect>& region);

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void focusInEvent(QFocusEvent*) override;

 private:
  glm::dvec2 deviceFrom(QPointF logical) const;
  void moveCamera(const ViewCamera& camera);
  void setHovered(std::optional<glm::ivec2> pixel);
  bool isOnDivider(QPointF position) const;
  /// A side and the part of the widget that it is seen in.
  struct SidePart {
    bool other = false;
    QRect part;
  };
  std::vector<SidePart> parts(Showing showing) const;
  void paintSide(QPainter& painter, const SidePart& side) const;
  void paintGridAndValues(QPainter& painter, const SidePart& side) const;
  /// The labels of the sides lie in the upper corners of `area`.
  void paintLabels(QPainter& painter, Showing showing, const QRect& area) const;
  /// All that lies over the pictures but the legend.
  void paintOver(QPainter& painter, Showing showing, const QRect& area) const;
  void dragRegion(glm::ivec2 pixel);
  LegendFlow legend(Showing showing, LegendFold fold = LegendFold::Nothing) const;
  int legendTop(int height) const;
  void paintLegend(QPainter& painter) const;
  void openLegend(bool mayOpen);

  glm::ivec2 size_{0};
  ViewCamera camera_, pressCamera_; ///< now, and when a drag began
  ViewSides sides_;
  bool showsGrid_ = true, dragsDivider_ = false;
  bool isLegendWhole_ = false, isLegendOpen_ = false;
  double divider_ = 0.5;
  std::vector<ProbeMark> marks_; ///< the active one last
  std::vector<PathPlace> path_;
  std::optional<glm::ivec2> hovered_;
  std::optional<gl::Rect> framed_;
  std::vector<doctor::OutlineEdge> outlines_;
  std::optional<gl::Rect> measured_;
  std::optional<glm::ivec2> regionFrom_; ///< where the drag of a region began
  QPointF cursor_;
  Qt::MouseButton drag_ = Qt::NoButton;
};

} // namespace taa::app
