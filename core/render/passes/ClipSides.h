// What of clip space is seen of a part of the picture, and what lies outside it.
#pragma once

#include "core/render/View.h"
#include "core/scene/TriangleGroups.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <limits>
#include <optional>

namespace taa {

/// Of clip space divided by w, along x and y.
struct ClipSides {
  glm::vec2 low{-1.0f}, high{1.0f};
};

/// Of the part that is wanted, with a margin for jitter and the width of points and lines.
ClipSides clipSides(const View& view);

/// How far what nothing is known of reaches.
inline constexpr float kBeyondAll = std::numeric_limits<float>::max();

/// How far from the camera a box reaches, or nothing when it lies wholly outside one of the planes of the
/// view. The distance is view depth less a constant; only its order matters. `jitter` is
/// FrameBlock::printedJitter, which may move near or far things by more than the margin.
std::optional<float> farthestPoint(const Bounds& box, const glm::mat4& clipFromModel, const ClipSides& sides,
                                   const glm::vec4& jitter);

/// What lies beyond each of the sides; `jitter` as there.
std::array<HalfSpace, 4> beyondSides(const glm::mat4& clipFromModel, const ClipSides& sides,
                                     const glm::vec4& jitter);

/// How far from the camera the middle of a box is, in the unit of farthestPoint().
float middleDistance(const Bounds& box, const glm::mat4& clipFromModel);

} // namespace taa
