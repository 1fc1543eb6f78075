// Which way the camera moves on screen, for the jitter whose points lie across it (manual J10).
#pragma once

#include <glm/vec2.hpp>

namespace taa {

struct FrameRequest;
struct Scene;

/// The way before the camera has moved: to the right.
inline constexpr glm::dvec2 kFirstWay{1.0, 0.0};

/// `way` turned by a fifth of its angle to `goal`: spherical interpolation of unit vectors. From opposite
/// ones by a fifth of half a turn from x to y.
glm::dvec2 turnedTowards(const glm::dvec2& way, const glm::dvec2& goal);

/// Unit vector in px axes (x right, y down), of the camera at `frame`. It begins at kFirstWay where history
/// starts, turns towards the way of each frame in which the camera moves, and rests while that rests.
/// As in Playdead, the camera moves as the point on its axis does, here at a distance of 1 m: old and new one
/// as this frame's camera sees them. A pure function, so that no frame need be made to know another: it looks
/// back over 64 frames of motion, before which any way has 0.8⁶⁴ < 10⁻⁶ of its angle left.
glm::dvec2 jitterWay(const Scene& scene, const FrameRequest& request, int frame);

} // namespace taa
