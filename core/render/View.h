// All that is known about a frame before anything is drawn: a pure function of scene, request and frame.
#pragma once

#include "core/render/Cameras.h"
#include "core/render/FrameInputs.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/Pose.h"
#include "core/settings/Settings.h"
#include "shaders/shared/LightBlock.h"

#include <optional>
#include <vector>

namespace taa {

struct FrameRequest;

struct View {
  FrameInfo info;
  Pose pose, previousPose;    ///< the same where history starts; with their times
  shared::FrameBlock block{}; ///< of this frame and, where it says so, of the previous one
  FrameCameras cameras;       ///< what the block says of them is made of
  shared::LightBlock lights{};
  std::vector<NodeState> nodes;                    ///< as Scene::nodes
  std::vector<std::optional<ObjectClass>> classes; ///< likewise: those that nodes are given
  JitterProjection projection = JitterProjection::Translation;
  std::optional<gl::Rect> part; ///< texels that are drawn; default: all
};

/// The camera a request looks through, flown or the scene's. Throws Error when there is none of its name.
CameraState cameraOf(const Scene& scene, const FrameRequest& request, int frame);

/// Throws Error as cameraOf() does.
View viewAt(const Scene& scene, const FrameRequest& request, int frame);

/// Makes it the view of a request whose `jitterPx` this is.
void setJitter(View& view, const glm::vec2& jitterPx);

} // namespace taa
