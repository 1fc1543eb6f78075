// All that is known about a frame before anything is drawn: a pure function of scene, request and frame.
#pragma once

#include "core/render/FrameInputs.h"
#include "core/scene/Pose.h"
#include "shaders/shared/LightBlock.h"

namespace taa {

struct FrameRequest;

struct View {
  FrameInfo info;
  Pose pose, previousPose;    ///< the same where history starts; with their times
  shared::FrameBlock block{}; ///< of this frame and, where it says so, of the previous one
  shared::LightBlock lights{};
  std::vector<NodeState> nodes; ///< as Scene::nodes
};

/// Throws Error when the scene has no camera path of the request's name.
View viewAt(const Scene& scene, const FrameRequest& request, int frame);

} // namespace taa
