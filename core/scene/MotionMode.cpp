#include "core/scene/MotionMode.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <unordered_set>

namespace taa {

namespace {

bool isBetween(double moment, double after, double until) {
  return moment > after && moment <= until;
}

/// Whether the node itself, whatever its ancestors do, has come to a new place since `previousTime`.
bool isNewlyPlaced(const Node& node, double time, double previousTime) {
  return isBetween(node.visibleFrom, previousTime, time) ||
         std::ranges::any_of(node.teleports,
                             [&](double moment) { return isBetween(moment, previousTime, time); });
}

} // namespace

MotionOverride parseMotionOverride(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  const std::string_view id = equals == std::string::npos ? "" : std::string_view(text).substr(equals + 1);
  const auto mode = std::ranges::find(kMotionModes, id, &MotionModeInfo::id);
  if (equals == 0 || mode == kMotionModes.end())
    throw Error(say<"\"%1\" is not NODE=MODE; modes are perObject, cameraOnly and none">(shownText(text)));
  return {text.substr(0, equals), static_cast<MotionMode>(mode - kMotionModes.begin())};
}

std::vector<std::string> objectNames(const Scene& scene) {
  std::vector<std::string> names;
  std::unordered_set<std::string_view> known;
  for (const Node& node : scene.nodes)
    if (node.mesh >= 0 && !node.name.empty() && known.insert(node.name).second) names.push_back(node.name);
  return names;
}

void checkMotionOverrides(const Scene& scene, const std::vector<MotionOverride>& overrides) {
  if (overrides.empty()) return;
  const std::vector<std::string> names = objectNames(scene);
  for (const MotionOverride& replaced : overrides) {
    if (std::ranges::find(names, replaced.node) != names.end()) continue;
    const std::string asked = shownText(replaced.node);
    std::string known;
    for (std::size_t i = 0; i < std::min(names.size(), kMaxNamesInMessage); ++i)
      known += (i == 0 ? "" : ", ") + shownText(names[i]);
    if (names.size() > kMaxNamesInMessage)
      throw Error(say<"no object is called \"%1\"; there are %2 and more">(asked, known));
    if (known.empty()) throw Error(say<"no object is called \"%1\"; there are none with a name">(asked));
    throw Error(say<"no object is called \"%1\"; there are %2">(asked, known));
  }
}

std::vector<NodeState> nodeStates(const Scene& scene, const std::vector<MotionOverride>& overrides,
                                  double time, double previousTime) {
  std::vector<NodeState> states(scene.nodes.size());
  std::vector<bool> isNew(scene.nodes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    const std::size_t parent = static_cast<std::size_t>(std::max(node.parent, 0));
    states[i].isVisible =
        time >= node.visibleFrom && time < node.visibleUntil && (node.parent < 0 || states[parent].isVisible);
    isNew[i] = isNewlyPlaced(node, time, previousTime) || (node.parent >= 0 && isNew[parent]);
    states[i].mode = node.motionMode;
    for (const MotionOverride& replaced : overrides)
      if (replaced.node == node.name) states[i].mode = replaced.mode;
    if (isNew[i] && states[i].mode == MotionMode::PerObject) states[i].mode = MotionMode::CameraOnly;
  }
  return states;
}

} // namespace taa
