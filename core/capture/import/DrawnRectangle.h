// A picture that lies in a part of the files that hold it: what an engine draws into a viewport of a larger
// target.
#pragma once

#include "core/base/Progress.h"
#include "core/capture/format/Manifest.h"

#include <glm/vec2.hpp>

#include <filesystem>
#include <optional>

namespace taa::capture {

struct DrawnRectangle {
  glm::ivec2 atPx{0}, sizePx{0};

  double shareOf(const glm::ivec2& wholePx) const {
    return static_cast<double>(sizePx.x) * sizePx.y / (static_cast<double>(wholePx.x) * wholePx.y);
  }
};

/// The rectangle around which color is the same to the last bit at all pixels of some frames, first and last
/// among them. Nothing where hardly anything lies around it, or hardly anything in it. It may as well be a
/// sky without a color above a scene. Throws Error, Cancelled.
std::optional<DrawnRectangle> drawnRectangle(const std::filesystem::path& folder, const Manifest& manifest,
                                             const Progress& progress);

/// The same capture with that rectangle of each file as its pictures.
Manifest croppedTo(const DrawnRectangle& rectangle, Manifest manifest);

} // namespace taa::capture
