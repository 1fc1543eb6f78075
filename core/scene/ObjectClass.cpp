#include "core/scene/ObjectClass.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/SceneOutline.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace taa {

namespace {

using GivenClasses = std::vector<std::optional<ObjectClass>>;

/// Of a tree that is given by its keys and parents, parents first.
template <class Key, class Parent>
GivenClasses givenClasses(std::size_t count, Key keyOf, Parent parentOf,
                          const std::vector<ClassOverride>& overrides) {
  GivenClasses given(count);
  if (overrides.empty()) return given;
  std::unordered_map<std::string, ObjectClass> byName;
  for (const ClassOverride& replaced : overrides) byName[replaced.object] = replaced.objectClass;
  for (std::size_t i = 0; i < count; ++i) {
    const int parent = parentOf(i);
    if (parent >= 0) given[i] = given[static_cast<std::size_t>(parent)];
    if (const auto found = byName.find(keyOf(i)); found != byName.end()) given[i] = found->second;
  }
  return given;
}

} // namespace

ClassOverride parseClassOverride(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  const std::string_view id = equals == std::string::npos ? "" : std::string_view(text).substr(equals + 1);
  const auto found = std::ranges::find(kObjectClasses, id, &ObjectClassInfo::id);
  if (equals == 0 || found == kObjectClasses.end() || found == kObjectClasses.begin())
    throw Error(say<"\"%1\" is not OBJECT=CLASS; classes are still, moving, deforming and character">(
        shownText(text)));
  return {text.substr(0, equals), static_cast<ObjectClass>(found - kObjectClasses.begin())};
}

void checkClassOverrides(const Scene& scene, const std::vector<ClassOverride>& overrides) {
  std::vector<std::string> names;
  for (const ClassOverride& replaced : overrides) names.push_back(replaced.object);
  checkObjectNames(scene, names);
}

std::vector<std::optional<ObjectClass>> givenClasses(const Scene& scene,
                                                     const std::vector<ClassOverride>& overrides) {
  return givenClasses(
      scene.nodes.size(), [&](std::size_t node) { return nodeKey(scene, node); },
      [&](std::size_t node) { return scene.nodes[node].parent; }, overrides);
}

std::vector<std::optional<ObjectClass>> givenClasses(const SceneOutline& outline,
                                                     const std::vector<ClassOverride>& overrides) {
  return givenClasses(
      outline.nodes.size(), [&](std::size_t node) { return outline.nodes[node].key; },
      [&](std::size_t node) { return outline.nodes[node].parent; }, overrides);
}

std::vector<bool> movingNodes(const Scene& scene) {
  std::vector<bool> moves(scene.nodes.size(), false);
  for (const Animation& animation : scene.animations)
    for (const AnimationChannel& channel : animation.channels)
      if (channel.node >= 0 && channel.path != AnimationPath::Weights)
        moves[static_cast<std::size_t>(channel.node)] = true;
  for (std::size_t index = 0; index < scene.nodes.size(); ++index) { // parents come first
    const Node& node = scene.nodes[index];
    if (!node.teleports.empty() || (node.parent >= 0 && moves[static_cast<std::size_t>(node.parent)]))
      moves[index] = true;
  }
  return moves;
}

} // namespace taa
