// A probe: a place that stays; what it follows from frame to frame, and where that is. No GL.
#pragma once

#include "core/render/View.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace taa {

/// As many as have a key.
inline constexpr int kMaxProbes = 9;

/// What a probe stays on while time goes on.
enum class Follow : std::uint8_t {
  Screen, ///< a pixel
  Surface ///< a point of what was seen there
};

/// A point of a triangle of a drawn object, which moves and deforms with it; of the sky a direction.
struct SurfaceAnchor {
  int object = 0;                          ///< number of the drawn object; 0: the sky
  std::array<std::uint32_t, 3> vertices{}; ///< of its primitive; the same thrice for a line's or point's end
  glm::vec3 weights{0.0f};                 ///< of the vertices, their sum is 1; of the sky the direction
  bool operator==(const SurfaceAnchor&) const = default;
};

struct Probe {
  glm::ivec2 pixel{0}; ///< where it was set, (0, 0) top left
  Follow follow = Follow::Screen;
  int frame = 0;                         ///< the frame it was set in, which says what it follows
  std::optional<SurfaceAnchor> anchor{}; ///< found once its surface was looked up
  bool operator==(const Probe&) const = default;
};

/// What became of what a probe follows.
enum class ProbeState : std::uint8_t {
  Seen,
  Hidden,    ///< something else is in front of it
  OffScreen, ///< or behind the camera
  Gone       ///< its object is not drawn in this frame
};

/// Where a probe is in one frame.
struct ProbeSpot {
  glm::ivec2 pixel{0};    ///< the one that holds it; of the nearest place inside when it is off screen
  glm::vec2 position{0};  ///< px, without jitter
  float viewDepth = 0.0f; ///< m; 0: the sky, or it follows the screen
  ProbeState state = ProbeState::Seen;
};

/// What is known of the pixel that a probe was set on: its object and how far it is (device depth).
struct SeenSurface {
  int object = 0;
  float depth = 0.0f;
};

/// The point of the surface that the middle of `pixel` shows in `view`.
SurfaceAnchor anchorAt(const Scene& scene, const View& view, const glm::ivec2& picturePx,
                       const glm::ivec2& pixel, const SeenSurface& seen);

/// Where a probe is: a pure function of the scene, the view (so of the frame's number) and the probe. A
/// surface is projected from where its triangle is in this frame, whatever moved or deformed it on the way;
/// nothing is summed up from frame to frame. Expects an anchor of probes that follow a surface. Not Hidden:
/// what is in front is known only when the frame is drawn, see isHidden().
ProbeSpot spotOf(const Scene& scene, const View& view, const glm::ivec2& picturePx, const Probe& probe);

/// Whether what is drawn at the spot is nearer than the surface by more than a hundredth.
bool isHidden(const ProbeSpot& spot, const SurfaceAnchor& anchor, const SeenSurface& drawn,
              float drawnViewDepth);

} // namespace taa
