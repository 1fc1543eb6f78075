// Decoded planes on their way into a frame's inputs.
#pragma once

#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/format/Manifest.h"
#include "core/render/FrameInputs.h"
#include "core/scene/Pose.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

namespace taa::capture {

/// Stands where no matrices are stated, so that depth still tells near from far: at the origin, a right angle
/// from top to bottom.
DecodedCamera unknownCamera(const glm::ivec2& sizePx, double nearPlane);
CameraState stateOf(const DecodedCamera& camera);

/// The block of the frame, as a renderer fills it but for the sky.
shared::FrameBlock blockOf(const DecodedFrame& frame, const Manifest& manifest, Precision precision);

/// All but motion and previous depth, into the textures that fitInputs() made. What the frame lacks is 0:
/// depth and ids of the sky, no normal, nothing masked, laid over or scattered.
void uploadSurfaces(const DecodedFrame& frame, FrameInputs& out);
/// Motion and previous depth; what the frame lacks is rest, and the depth of now.
void uploadMotion(const DecodedFrame& frame, FrameInputs& out);

} // namespace taa::capture
