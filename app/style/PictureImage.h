// Pictures of core as images of Qt.
#pragma once

#include "core/picture/Visualizer.h"

#include <QImage>

namespace taa::app {

/// Reads the picture's own bytes: copy it where it outlives the picture. Null where there are no pixels.
inline QImage imageOver(const Picture& picture) {
  if (picture.rgba.empty()) return {};
  return {picture.rgba.data(), picture.width, picture.height, 4 * picture.width, QImage::Format_RGBA8888};
}

} // namespace taa::app
