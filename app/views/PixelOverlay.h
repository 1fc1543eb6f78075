// What is drawn over a picture at high zoom and at the probes: pixel grid, values in texels, crosshair.
#pragma once

#include "app/models/verdict/LineageMath.h"
#include "app/session/ProbeList.h"
#include "app/views/ViewportMath.h"

#include "core/doctor/Outline.h"
#include "core/requests/Results.h"

#include <optional>
#include <vector>

class QColor;
class QPainter;

namespace taa::app {

inline constexpr double kGridZoom = 16.0;  ///< logical pixels a picture pixel from which a grid is drawn
inline constexpr double kValueZoom = 48.0; ///< and from which values are written

/// Paints in logical pixels for a view that looks through `transform` at `pixelRatio` device pixels each.
class PixelOverlay {
 public:
  PixelOverlay(const ViewGeometry& geometry, const ViewTransform& transform, double pixelRatio)
      : geometry_(geometry), transform_(transform), pixelRatio_(pixelRatio),
        texel_(static_cast<double>(transform.zoom) / pixelRatio) {}

  double texelSize() const { return texel_; } ///< logical pixels
  void paintGrid(QPainter& painter) const;
  /// Writes the values of a region of the row into their texels.
  void paintValues(QPainter& painter, const Intermediate& row, const PartialImage& numbers,
                   const gl::Rect& region) const;
  /// A cross with its number; dotted where the surface it follows is hidden.
  void paintProbe(QPainter& painter, const ProbeMark& mark) const;
  /// A line through where a pixel was, latest first, with dots the larger the more its frame counts.
  void paintPath(QPainter& painter, const std::vector<PathPlace>& path) const;
  /// The corners of a box of pixels.
  void paintFrame(QPainter& painter, const gl::Rect& box) const;
  /// A dashed line of a color around a box of pixels.
  void paintRegion(QPainter& painter, const gl::Rect& box, const QColor& color) const;
  /// A line around regions, by its edges between pixels.
  void paintOutline(QPainter& painter, const std::vector<doctor::OutlineEdge>& edges) const;
  /// Logical rectangle of a pixel.
  ScreenRect pixelRect(glm::ivec2 pixel) const;

 private:
  ViewGeometry geometry_;
  ViewTransform transform_;
  double pixelRatio_, texel_;
};

} // namespace taa::app
