// The arithmetic of a view: zoom, pan, and which pixel lies where. Screen lengths are device pixels.
#pragma once

#include "core/gl/Texture.h"
#include "core/picture/Visualizer.h"

#include <glm/vec2.hpp>

#include <optional>

namespace taa::app {

inline constexpr double kMinZoom = 0.1;
inline constexpr double kGreatestZoom = 256.0;

/// Where a view looks. With `fit`, zoom and center follow from the sizes.
struct ViewCamera {
  bool fit = true;
  double zoom = 1.0;      ///< screen pixels per picture pixel
  glm::dvec2 center{0.0}; ///< picture position in the middle of the viewport
  bool operator==(const ViewCamera&) const = default;
};

struct ScreenRect {
  double x = 0, y = 0, width = 0, height = 0;
};

/// A viewport and what it shows, both in their own pixels.
struct ViewGeometry {
  glm::ivec2 viewport{0}; ///< screen pixels
  glm::ivec2 picture{0};  ///< picture pixels
  int covered = 0;        ///< screen pixels at the lower edge that fit leaves free, for a legend
  bool isEmpty() const { return viewport.x < 1 || viewport.y < 1 || picture.x < 1 || picture.y < 1; }

  /// The largest zoom that shows everything; whole numbers above 1, so that all pixels are equally wide.
  double fitZoom() const;
  /// `camera` with fit worked out and its center kept inside the picture.
  ViewCamera settled(const ViewCamera& camera) const;
  /// The transform of a camera; the picture's corner lies on a whole screen pixel.
  ViewTransform transform(const ViewCamera& camera) const;

  /// `factor` times the zoom, with the picture position under `cursor` (screen) held; leaves fit.
  ViewCamera zoomed(const ViewCamera& camera, glm::dvec2 cursor, double factor) const;
  /// Drags the picture by `delta` screen pixels; leaves fit.
  ViewCamera panned(const ViewCamera& camera, glm::dvec2 delta) const;
  /// One screen pixel for each picture pixel, around `cursor`.
  ViewCamera oneToOne(const ViewCamera& camera, glm::dvec2 cursor) const;
  /// Moves the least way that shows `pixel`.
  ViewCamera revealed(const ViewCamera& camera, glm::ivec2 pixel) const;

  /// The pixel at a screen position, or nothing outside the picture.
  std::optional<glm::ivec2> pixelAt(const ViewTransform& transform, glm::dvec2 screen) const;
  /// Nearest pixel to a screen position.
  glm::ivec2 nearestPixel(const ViewTransform& transform, glm::dvec2 screen) const;
  /// The pixels that are at least partly visible.
  gl::Rect visiblePixels(const ViewTransform& transform) const;
};

/// The least box that holds both pixels.
gl::Rect regionBetween(glm::ivec2 one, glm::ivec2 other);

glm::dvec2 pictureFromScreen(const ViewTransform& transform, glm::dvec2 screen);
glm::dvec2 screenFromPicture(const ViewTransform& transform, glm::dvec2 position);

/// Where a picture that was drawn with `drawn` belongs on a screen that now looks through `current`.
ScreenRect movedPicture(const ViewTransform& drawn, glm::ivec2 size, const ViewTransform& current);

/// The factor of `notches` of a wheel: two of them double.
double wheelFactor(double notches);

} // namespace taa::app
