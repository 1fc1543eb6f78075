// Little scenes whose motion is known in closed form, and frames drawn of them.
#pragma once

#include "core/render/SceneRenderer.h"
#include "core/scene/Scene.h"

#include <glm/vec3.hpp>

#include <memory>

namespace taa::test {

/// A camera "main" at the origin that looks along −z, 60° high, and what a test adds.
struct TestScene {
  Scene scene;
  int cameraNode = -1;

  TestScene();
  /// An unlit square of half size `halfSize` m, seen from both sides, facing +z; returns its node.
  int addSquare(const glm::vec3& center, float halfSize);
  /// Moves a node by `perFrame` m from each frame to the next, frames 0 to 120.
  void move(int node, const glm::vec3& perFrame);
  /// Turns a node about one of the axes by `perFrame` radians (120 · perFrame < π), frames 0 to 120.
  void turn(int node, const glm::vec3& axis, float perFrame);
};

/// Frame and picture size; what is drawn otherwise is full precision, objects' motion, without jitter.
FrameRequest stillRequest(int width, int height, const std::string& camera = "gltf:main");

/// One frame of `scene`.
FrameInputs drawFrame(const Scene& scene, const FrameRequest& request, int frame);

/// Pixels of `motion` that differ from what `expected(x, y)` says of their centers by more than `tolerance`
/// px, told in a sentence; empty when there are none. NaN differs.
template <typename Expected>
std::string wrongMotion(const Image& motion, double tolerance, const Expected& expected) {
  for (int y = 0; y < motion.height; ++y) {
    for (int x = 0; x < motion.width; ++x) {
      const glm::dvec2 want = expected(x + 0.5, y + 0.5);
      const glm::dvec2 is(motion.at(x, y)[0], motion.at(x, y)[1]);
      if (std::abs(is.x - want.x) <= tolerance && std::abs(is.y - want.y) <= tolerance) continue;
      return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") moves by " + std::to_string(is.x) +
             ", " + std::to_string(is.y) + " px and should by " + std::to_string(want.x) + ", " +
             std::to_string(want.y);
    }
  }
  return {};
}

} // namespace taa::test
