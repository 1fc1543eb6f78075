// The part of a frame's block that says where it is seen from: the same of drawn and of captured frames.
#pragma once

#include "core/scene/Pose.h"
#include "core/settings/Settings.h"
#include "shaders/shared/FrameBlock.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace taa {

/// Cameras and jitter of a frame and of the one that its motion refers to.
struct FrameCameras {
  CameraState camera, previous;
  glm::vec2 sizePx{1.0f};                           ///< of what is drawn
  glm::vec2 jitterPx{0.0f}, previousJitterPx{0.0f}; ///< displacement of image content, x right, y down
  JitterProjection projection = JitterProjection::Translation;
};
void fillCameras(const FrameCameras& cameras, shared::FrameBlock& block);

/// What takes a picture's clip positions to the previous one's; exactly 1 for a camera that rests.
/// `clipFromWorld`: without jitter.
glm::mat4 previousClipFromClip(const glm::dmat4& clipFromWorld, const glm::dmat4& previousClipFromWorld);

/// How color and motion are kept, and what textures were read with.
void fillStorage(Precision precision, float mipBias, int frame, shared::FrameBlock& block);

} // namespace taa
