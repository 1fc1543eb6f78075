// Which motion an object is given, whatever moves it (manual §3, motion modes).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

struct Scene;

enum class MotionMode : std::uint8_t {
  PerObject,  ///< its own, with the camera's
  CameraOnly, ///< the camera's, as if it stood still in the world
  None,       ///< 0, as of things that stick to the screen
};

struct MotionModeInfo {
  std::string_view id;    ///< in flags and files
  std::string_view label; ///< in the window
};

/// In the order of the enumerators.
inline constexpr std::array<MotionModeInfo, 3> kMotionModes{
    {{"perObject", "Per object"}, {"cameraOnly", "Camera only"}, {"none", "Force none"}}};

/// A mode that replaces what the nodes of this name have.
struct MotionOverride {
  std::string node;
  MotionMode mode = MotionMode::PerObject;
  bool operator==(const MotionOverride&) const = default;
};

/// Reads "NODE=cameraOnly"; the last = counts. Throws Error that says what is expected.
MotionOverride parseMotionOverride(const std::string& text);

/// Names of the nodes that draw something, each once, in their order.
std::vector<std::string> objectNames(const Scene& scene);

/// Throws Error that names the objects there are when an override is for none of them.
void checkMotionOverrides(const Scene& scene, const std::vector<MotionOverride>& overrides);

/// A node at one frame, what it inherits from its ancestors included.
struct NodeState {
  bool isVisible = true;
  MotionMode mode = MotionMode::PerObject;
};

/// States of all nodes at `time` seconds. What has appeared or jumped since `previousTime` has no motion of
/// its own yet: it is taken to have been where it is (manual §3, rule 3).
std::vector<NodeState> nodeStates(const Scene& scene, const std::vector<MotionOverride>& overrides,
                                  double time, double previousTime);

} // namespace taa
