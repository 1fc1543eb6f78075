// The tree of a scene, as a window shows it: names, kinds, what the numbers of objects stand for.
#pragma once

#include "core/scene/MotionMode.h"
#include "core/scene/ObjectFilter.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace taa {

struct Scene;

enum class NodeKind : std::uint8_t { Group, Mesh, Light, Camera };

struct OutlineNode {
  std::string key;     ///< nodeKey()
  int parent = -1;     ///< smaller than its own index; −1: a root
  NodeKind kind{};     ///< Mesh: it is drawn
  MotionMode motion{}; ///< what the scene gives it
  int firstObject = 0; ///< number of its first object in the row objectId; 0: it draws none
  int objectCount = 0; ///< one for each of its primitives, and of each instance
  std::size_t triangles = 0;
};

/// Made once when a scene is opened.
struct SceneOutline {
  std::string source;
  float radius = 1.0f;               ///< of the scene's bounds, world units
  std::vector<OutlineNode> nodes;    ///< as Scene::nodes
  std::vector<int> drawing;          ///< those of them that draw objects, whose numbers rise along it
  std::map<int, int> nodeOfCaptured; ///< by the number of the object: of a capture, whose numbers are any
  /// −1 for the sky and for numbers there are not.
  int nodeOf(int object) const;
  /// Numbers of all objects of a node and of what is below it.
  std::vector<int> objectsBelow(int node) const;
};

SceneOutline outlineOf(const Scene& scene, const std::string& source);

/// As drawnNodes() of its scene.
std::vector<bool> drawnNodes(const SceneOutline& outline, const ObjectFilter& filter);

} // namespace taa
