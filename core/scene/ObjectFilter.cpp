#include "core/scene/ObjectFilter.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/scene/Scene.h"
#include "core/scene/SceneOutline.h"

#include <algorithm>
#include <unordered_set>

namespace taa {

namespace {

using Names = std::unordered_set<std::string>;

Names asSet(const std::vector<std::string>& names) {
  return {names.begin(), names.end()};
}

std::string unknownObject(const std::string& name, const Scene& scene) {
  const std::string asked = shownText(name);
  std::string known;
  Names told;
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
    const std::string key = nodeKey(scene, node);
    if (!told.insert(key).second) continue;
    if (told.size() > kMaxNamesInMessage)
      return say<"no object is called \"%1\"; there are %2 and more">(asked, known);
    known += (known.empty() ? "" : ", ") + shownText(key);
  }
  if (known.empty()) return say<"no object is called \"%1\"; there are none">(asked);
  return say<"no object is called \"%1\"; there are %2">(asked, known);
}

/// Of a tree that is given by its keys and parents, parents first.
template <class Key, class Parent>
std::vector<bool> drawnNodes(std::size_t count, Key keyOf, Parent parentOf, const ObjectFilter& filter) {
  const Names hidden = asSet(filter.hidden), isolated = asSet(filter.isolated);
  std::vector<bool> isHidden(count), isInside(count), isDrawn(count);
  for (std::size_t i = 0; i < count; ++i) {
    const int parent = parentOf(i);
    const std::string key = keyOf(i);
    const auto inherits = [&](const std::vector<bool>& flags) {
      return parent >= 0 && flags[static_cast<std::size_t>(parent)];
    };
    isHidden[i] = hidden.contains(key) || inherits(isHidden);
    isInside[i] = isolated.empty() || isolated.contains(key) || inherits(isInside);
    isDrawn[i] = isInside[i] && !isHidden[i];
  }
  return isDrawn;
}

} // namespace

std::string nodeKey(const Scene& scene, std::size_t node) {
  const std::string& name = scene.nodes[node].name;
  return name.empty() ? "#" + std::to_string(node) : name;
}

std::vector<bool> drawnNodes(const Scene& scene, const ObjectFilter& filter) {
  if (filter == ObjectFilter{}) return std::vector<bool>(scene.nodes.size(), true);
  return drawnNodes(
      scene.nodes.size(), [&](std::size_t node) { return nodeKey(scene, node); },
      [&](std::size_t node) { return scene.nodes[node].parent; }, filter);
}

std::vector<bool> drawnNodes(const SceneOutline& outline, const ObjectFilter& filter) {
  return drawnNodes(
      outline.nodes.size(), [&](std::size_t node) { return outline.nodes[node].key; },
      [&](std::size_t node) { return outline.nodes[node].parent; }, filter);
}

void checkObjectNames(const Scene& scene, const std::vector<std::string>& names) {
  if (names.empty()) return;
  Names keys;
  for (std::size_t node = 0; node < scene.nodes.size(); ++node) keys.insert(nodeKey(scene, node));
  for (const std::string& name : names)
    if (!keys.contains(name)) throw Error(unknownObject(name, scene));
}

void checkObjectFilter(const Scene& scene, const ObjectFilter& filter) {
  checkObjectNames(scene, filter.hidden);
  checkObjectNames(scene, filter.isolated);
}

} // namespace taa
