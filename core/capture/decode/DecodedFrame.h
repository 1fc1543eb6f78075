// A captured frame in this program's conventions (manual, conventions): what FrameInputs are filled from. No
// GL.
#pragma once

#include "core/base/Image.h"
#include "core/capture/format/Manifest.h"
#include "core/capture/planes/Planes.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace taa::capture {

/// In double, column vectors; view space looks along −z, y up, meters; clip space is y up with depth
/// reversed, 0…1, perspective with its far plane at infinity. Without jitter.
struct DecodedCamera {
  glm::dmat4 viewFromWorld{1.0};
  glm::dmat4 clipFromView{1.0};
  bool orthographic = false;
  bool operator==(const DecodedCamera&) const = default;
};

/// Row 0 is the top. Images that are empty are not part of the capture and cannot be made up.
struct DecodedFrame {
  int index = 0;                                    ///< into Manifest::frames
  glm::vec2 jitterPx{0.0f}, previousJitterPx{0.0f}; ///< displacement of image content, x right, y down
  bool startsHistory = false;
  double seconds = 0.0;
  std::optional<DecodedCamera> camera, previousCamera; ///< both or none; the same where history starts
  double nearPlane = 0.1;  ///< m; without an orthographic camera depth is nearPlane / distance along its axis
  Image color;             ///< 4 channels, linear, alpha 1 where none is stored
  Image motion;            ///< 2, px of the render size, current − previous, without jitter
  Image depth;             ///< 1, reversed, 0: sky
  Image normal;            ///< 4
  Image previousDepth;     ///< 1, m
  Image mask;              ///< 2: reactive, responsive
  Image overlay, fog;      ///< 4; overlay in its own size
  Image output, reference; ///< 4, as color; in their own sizes
  std::vector<std::uint32_t> objectId;
  std::vector<std::string> notes; ///< sentences: what was done to planes that do not fit
};

/// What a frame's planes lack, and what is done instead; sentences for the user, the same for all frames of a
/// capture.
std::vector<std::string> missingInputs(const Manifest& manifest);

/// Camera of a frame of the manifest; none where matrices are not stated. Throws Error where a stated matrix
/// cannot be one (singular, no projection, NaN).
std::optional<DecodedCamera> decodeCamera(const Manifest& manifest, const CapturedFrame& frame);
/// Displacement of content, px of the render size, x right, y down; 0 where a delay leaves it unstated.
/// Throws Error where it is not finite.
glm::dvec2 decodeJitter(const Manifest& manifest, std::size_t index);

/// Throws Error where planes contradict the manifest. A plane of another size than color gives each pixel the
/// nearest value, but for overlay, output and reference, which have a size of their own. The encoding of
/// color and its exposure are those of output, reference, overlay and fog as well.
DecodedFrame decode(const Manifest& manifest, std::size_t index, FramePlanes&& planes);
DecodedFrame decode(const Manifest& manifest, std::size_t index, const FramePlanes& planes);

/// The other way: planes and frame data in `manifest.conventions`, for writing captures. Lossless but for the
/// precision of `motion` and `depth` in other units.
FramePlanes encode(const Manifest& manifest, const DecodedFrame& frame);
/// Fills jitter, matrices, cut and time of manifest.frames[index]; a delayed jitter goes to the frame that
/// states it, so the manifest has all its frames before. A jitter that no frame of the capture states is
/// lost.
void encodeFrame(Manifest& manifest, std::size_t index, const DecodedFrame& frame);

} // namespace taa::capture
