#include "app/views/ViewportMath.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace taa::app {

double ViewGeometry::fitZoom() const {
  if (isEmpty()) return 1.0;
  const double zoom = std::min(static_cast<double>(viewport.x) / picture.x,
                               static_cast<double>(viewport.y - covered) / picture.y);
  return std::clamp(zoom >= kSharpZoom ? std::floor(zoom) : zoom, kMinZoom, kGreatestZoom);
}

ViewCamera ViewGeometry::settled(const ViewCamera& camera) const {
  if (camera.fit) {
    const double zoom = fitZoom();
    return {true, zoom, glm::dvec2(picture) / 2.0 + glm::dvec2(0.0, covered / 2.0 / zoom)};
  }
  return {false, std::clamp(camera.zoom, kMinZoom, kGreatestZoom),
          glm::clamp(camera.center, glm::dvec2(0.0), glm::dvec2(picture))};
}

ViewTransform ViewGeometry::transform(const ViewCamera& camera) const {
  const ViewCamera now = settled(camera);
  // Rounded in screen pixels: otherwise pixel edges crawl while the view is dragged.
  const glm::dvec2 corner = glm::round(now.center * now.zoom - glm::dvec2(viewport) / 2.0);
  return {glm::vec2(corner / now.zoom), static_cast<float>(now.zoom)};
}

ViewCamera ViewGeometry::zoomed(const ViewCamera& camera, glm::dvec2 cursor, double factor) const {
  const ViewCamera now = settled(camera);
  const double zoom = std::clamp(now.zoom * factor, kMinZoom, kGreatestZoom);
  const glm::dvec2 fromMiddle = cursor - glm::dvec2(viewport) / 2.0;
  const glm::dvec2 held = now.center + fromMiddle / now.zoom;
  return settled({false, zoom, held - fromMiddle / zoom});
}

ViewCamera ViewGeometry::panned(const ViewCamera& camera, glm::dvec2 delta) const {
  const ViewCamera now = settled(camera);
  return settled({false, now.zoom, now.center - delta / now.zoom});
}

ViewCamera ViewGeometry::oneToOne(const ViewCamera& camera, glm::dvec2 cursor) const {
  return zoomed(camera, cursor, 1.0 / settled(camera).zoom);
}

ViewCamera ViewGeometry::revealed(const ViewCamera& camera, glm::ivec2 pixel) const {
  const ViewCamera now = settled(camera);
  const glm::dvec2 half = glm::dvec2(viewport) / 2.0 / now.zoom;
  const glm::dvec2 least = glm::dvec2(pixel) + 1.0 - half, greatest = glm::dvec2(pixel) + half;
  if (least.x > greatest.x || least.y > greatest.y) return {false, now.zoom, glm::dvec2(pixel) + 0.5};
  const glm::dvec2 center = glm::clamp(now.center, least, greatest);
  return center == now.center ? camera : settled({false, now.zoom, center});
}

std::optional<glm::ivec2> ViewGeometry::pixelAt(const ViewTransform& transform, glm::dvec2 screen) const {
  const glm::dvec2 position = glm::floor(pictureFromScreen(transform, screen));
  if (position.x < 0 || position.y < 0 || position.x >= picture.x || position.y >= picture.y) return {};
  return glm::ivec2(position);
}

glm::ivec2 ViewGeometry::nearestPixel(const ViewTransform& transform, glm::dvec2 screen) const {
  const glm::dvec2 position = glm::floor(pictureFromScreen(transform, screen));
  return glm::ivec2(glm::clamp(position, glm::dvec2(0.0), glm::dvec2(picture) - 1.0));
}

gl::Rect ViewGeometry::visiblePixels(const ViewTransform& transform) const {
  if (isEmpty()) return {};
  const glm::dvec2 size(picture);
  const glm::dvec2 low = glm::clamp(glm::floor(pictureFromScreen(transform, {0, 0})), glm::dvec2(0.0), size);
  const glm::dvec2 high =
      glm::clamp(glm::ceil(pictureFromScreen(transform, viewport)), glm::dvec2(0.0), size);
  const glm::ivec2 from(low), extent(high - low);
  return {from.x, from.y, extent.x, extent.y};
}

gl::Rect regionBetween(glm::ivec2 one, glm::ivec2 other) {
  const glm::ivec2 low = glm::min(one, other), extent = glm::max(one, other) - low + 1;
  return {low.x, low.y, extent.x, extent.y};
}

glm::dvec2 pictureFromScreen(const ViewTransform& transform, glm::dvec2 screen) {
  return glm::dvec2(transform.origin) + screen / static_cast<double>(transform.zoom);
}

glm::dvec2 screenFromPicture(const ViewTransform& transform, glm::dvec2 position) {
  return (position - glm::dvec2(transform.origin)) * static_cast<double>(transform.zoom);
}

ScreenRect movedPicture(const ViewTransform& drawn, glm::ivec2 size, const ViewTransform& current) {
  const glm::dvec2 corner = screenFromPicture(current, glm::dvec2(drawn.origin));
  const double scale = static_cast<double>(current.zoom) / static_cast<double>(drawn.zoom);
  return {corner.x, corner.y, size.x * scale, size.y * scale};
}

double wheelFactor(double notches) {
  return std::exp2(notches / 2.0);
}

} // namespace taa::app
