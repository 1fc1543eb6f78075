// What the lineage's plots are made of: how far they reach, how old a sample is, the way on the screen. No
// widgets.
#pragma once

#include "app/models/ChartMath.h"
#include "core/verdict/lineage/Lineage.h"

#include <glm/vec2.hpp>

#include <vector>

namespace taa::app {

/// Half a side of the square around the pixel's center that holds all samples that count, px: one of round
/// lengths, so that it does not jump with each frame. One counts with a hundredth of the heaviest.
double footprintReach(const std::vector<FootprintSample>& samples);

/// 0: this frame's, 1: as old as the window's oldest.
double ageShare(const Lineage& lineage, int frame);

/// Of the bars: 0, and the largest that a frame's samples, and what rectification put there, come to.
Span barSpan(const Lineage& lineage);

/// A place of the way that the pixel came, and what the frame counts.
struct PathPlace {
  glm::dvec2 at{0.0}; ///< px of the picture
  double weight = 0.0;
  bool operator==(const PathPlace&) const = default;
};
/// Latest first, as far back as something counts a thousandth.
std::vector<PathPlace> pathOf(const Lineage& lineage);

} // namespace taa::app
