// Which objects of a scene are drawn: some hidden, or only a few shown.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace taa {

struct Scene;

/// Names of nodes, as nodeKey() gives them; each stands for all nodes of its name and for what is below them.
struct ObjectFilter {
  std::vector<std::string> hidden;
  std::vector<std::string> isolated; ///< when there are any, nothing else is drawn
  bool operator==(const ObjectFilter&) const = default;
};

/// Names that a sentence about an unknown object tells at most.
inline constexpr std::size_t kMaxNamesInMessage = 24;

/// What a node is called where it must be told from others: its name, or "#7" for a node without one.
std::string nodeKey(const Scene& scene, std::size_t node);

/// Whether each node is let through, whatever time says about it.
std::vector<bool> drawnNodes(const Scene& scene, const ObjectFilter& filter);

/// Throws Error that names some of the nodes there are when a name is of none of them.
void checkObjectNames(const Scene& scene, const std::vector<std::string>& names);
void checkObjectFilter(const Scene& scene, const ObjectFilter& filter);

} // namespace taa
