// A frame's cameras from the matrices that a capture states, and the other way.
#pragma once

#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/format/Manifest.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <limits>
#include <optional>

namespace taa::capture {

/// Distance of a far plane that is none, and of the sky.
inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A camera and the planes that its stated projection has, m; the far one may be infinite.
struct StatedCamera {
  DecodedCamera camera;
  double nearPlane = 0.0, farPlane = 0.0;
};

/// Of this frame and the one before; the same where history starts, none where matrices are not stated.
struct StatedCameras {
  std::optional<StatedCamera> now, previous;
};

/// Throws Error as decodeCamera() does.
StatedCameras statedCameras(const Manifest& manifest, std::size_t index);

/// A stated projection without what displaces content by `jitterPx` in it. Throws nothing.
StatedMatrix withoutJitter(const Manifest& manifest, const StatedMatrix& projection,
                           const glm::dvec2& jitterPx);

/// A camera's matrices as a capture of these conventions states them. `jitterPx`: that of its frame, content.
struct CameraMatrices {
  StatedMatrix view{}, projection{};
};
CameraMatrices encodedCamera(const Manifest& manifest, const DecodedCamera& camera,
                             const glm::dvec2& jitterPx);

} // namespace taa::capture
