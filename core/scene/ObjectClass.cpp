#include "core/scene/ObjectClass.h"

namespace taa {

std::vector<bool> movingNodes(const Scene& scene) {
  std::vector<bool> moves(scene.nodes.size(), false);
  if (!scene.animations.empty())
    for (const AnimationChannel& channel : scene.animations.front().channels)
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
