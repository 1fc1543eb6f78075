// Pictures and colors of core as those of Qt.
#pragma once

#include "core/base/Light.h"
#include "core/picture/Visualizer.h"

#include <QColor>
#include <QImage>
#include <glm/vec3.hpp>

namespace taa::app {

/// Reads the picture's own bytes: copy it where it outlives the picture. Null where there are no pixels.
inline QImage imageOver(const Picture& picture) {
  if (picture.rgba.empty()) return {};
  return {picture.rgba.data(), picture.width, picture.height, 4 * picture.width, QImage::Format_RGBA8888};
}

/// As a screen shows it; what is brighter than white, or negative, at its end.
inline QColor shownColor(const glm::vec3& linear) {
  return {srgbByte(linear.x), srgbByte(linear.y), srgbByte(linear.z)};
}

} // namespace taa::app
