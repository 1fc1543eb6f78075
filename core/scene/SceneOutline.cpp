#include "core/scene/SceneOutline.h"

#include "core/scene/ObjectFilter.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace taa {

namespace {

NodeKind kindOf(const Node& node) {
  if (node.mesh >= 0 || node.capturedId > 0) return NodeKind::Mesh;
  if (node.light >= 0) return NodeKind::Light;
  return node.camera >= 0 ? NodeKind::Camera : NodeKind::Group;
}

} // namespace

int SceneOutline::nodeOf(int object) const {
  if (const auto captured = nodeOfCaptured.find(object); captured != nodeOfCaptured.end())
    return captured->second;
  const auto firstOf = [this](int node) { return nodes[static_cast<std::size_t>(node)].firstObject; };
  const auto after = std::ranges::upper_bound(drawing, object, {}, firstOf);
  if (after == drawing.begin()) return -1;
  const OutlineNode& node = nodes[static_cast<std::size_t>(*std::prev(after))];
  return object < node.firstObject + node.objectCount ? *std::prev(after) : -1;
}

std::vector<int> SceneOutline::objectsBelow(int node) const {
  std::vector<bool> isBelow(nodes.size());
  std::vector<int> objects;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const OutlineNode& item = nodes[i];
    isBelow[i] =
        static_cast<int>(i) == node || (item.parent >= 0 && isBelow[static_cast<std::size_t>(item.parent)]);
    if (!isBelow[i]) continue;
    for (int object = 0; object < item.objectCount; ++object) objects.push_back(item.firstObject + object);
  }
  return objects;
}

// Objects are numbered as GBufferPass does: by node, then by instance, then by primitive.
SceneOutline outlineOf(const Scene& scene, const std::string& source) {
  SceneOutline outline;
  outline.source = source;
  if (const float radius = scene.bounds.radius(); std::isfinite(radius) && radius > 0.0f)
    outline.radius = radius;
  outline.nodes.reserve(scene.nodes.size());
  int objects = 0; // so far
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    OutlineNode item;
    item.key = nodeKey(scene, i);
    item.parent = node.parent;
    item.kind = kindOf(node);
    item.motion = node.motionMode;
    if (const int times = node.timesDrawn(); times > 0) {
      item.firstObject = objects + 1;
      for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
        item.triangles += static_cast<std::size_t>(times) * (primitive.indices.size() / 3);
        item.objectCount += times;
      }
      objects += item.objectCount;
      if (item.objectCount > 0) outline.drawing.push_back(static_cast<int>(i));
    }
    if (node.capturedId > 0 && std::in_range<int>(node.capturedId)) {
      item.firstObject = static_cast<int>(node.capturedId);
      item.objectCount = 1;
      outline.nodeOfCaptured.emplace(item.firstObject, static_cast<int>(i));
    }
    outline.nodes.push_back(std::move(item));
  }
  return outline;
}

} // namespace taa
