// The pixels of a region row by row, and the line around them.
#pragma once

#include <glm/vec2.hpp>

#include <vector>

namespace taa::doctor {

/// Pixels of a row, left to right.
struct PixelRun {
  int y = 0, from = 0, to = 0; ///< to: the first one beyond
  bool operator==(const PixelRun&) const = default;
};

/// The runs of pixels in any order, each once or more.
std::vector<PixelRun> runsOf(std::vector<glm::ivec2> pixels);

/// Between corners of pixels, to the right or down: pixel (0, 0) lies between (0, 0) and (1, 1).
struct OutlineEdge {
  glm::ivec2 from{0}, to{0};
  bool operator==(const OutlineEdge&) const = default;
};

/// All edges between pixels of the runs and others, holes included, each as long as it goes on. Expects runs
/// by rising row, then by rising `from`, apart from each other.
std::vector<OutlineEdge> outlineOf(const std::vector<PixelRun>& runs);

} // namespace taa::doctor
