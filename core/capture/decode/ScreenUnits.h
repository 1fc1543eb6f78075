// Places on the screen in the units that captures state them in.
#pragma once

#include "core/capture/format/Conventions.h"
#include "core/capture/format/Manifest.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <optional>

namespace taa::capture {

/// What a stated length times is px, x right and y down.
inline glm::dvec2 pxPerUnit(ScreenUnit unit, VerticalAxis yAxis, const glm::ivec2& sizePx) {
  glm::dvec2 px(1.0);
  if (unit == ScreenUnit::Uv) px = glm::dvec2(sizePx);
  if (unit == ScreenUnit::Ndc) px = 0.5 * glm::dvec2(sizePx);
  if (yAxis == VerticalAxis::Up) px.y = -px.y;
  return px;
}

/// What a stated jitter times is a displacement of content in px.
glm::dvec2 pxPerJitter(const Manifest& manifest);

/// The frame that states the jitter of frame `index`; none where that lies outside of the capture.
std::optional<std::size_t> statesJitterOf(const Manifest& manifest, std::size_t index);

} // namespace taa::capture
