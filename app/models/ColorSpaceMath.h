// The neighborhood of a probed pixel as points and boxes in a color space, and how they are projected. No
// painting.
#pragma once

#include "core/probe/WhatIf.h"
#include "core/settings/Settings.h"
#include "core/taa/twin/Details.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::app {

/// Which axes the plot has. Highlights are bounded as the settings bound them, in both.
enum class PlotSpace { Rgb, YCoCg };

using Corners = std::array<glm::vec3, 8>; ///< corner i has the upper wall of axis a where bit a of i is set
using Segment = std::pair<glm::vec3, glm::vec3>;

/// Where rectification would put history.
struct RectifiedPoint {
  std::string methods; ///< labels of those that put it there: "Clamp, Clip to center"
  glm::vec3 point{0.0f};
};

/// All in the plot's space.
struct ColorScene {
  std::array<std::string, 3> axes;
  std::array<glm::vec3, 9> samples{};      ///< row-major, [4] is the pixel's own
  std::vector<glm::vec3> taps;             ///< that the box is of; empty: it is of samples
  std::array<glm::vec3, 9> sampleColors{}; ///< of `samples` as they are, scene-linear RGB
  std::vector<glm::vec3> tapColors;        ///< of `taps`
  Corners minMax{}, variance{}, box{};
  std::vector<Segment> hull; ///< edges of what slabs around the samples leave; empty: not the method
  glm::vec3 mean{0.0f}, current{0.0f}, resolved{0.0f};
  std::optional<glm::vec3> historyRaw, historyRectified; ///< nothing: no history
  std::optional<glm::vec3> target;      ///< where the way into the box leads; nothing: history was not moved
  std::vector<RectifiedPoint> byMethod; ///< of each method with all of its correction; empty: no history
  std::vector<glm::vec3> variants;      ///< resolved colors of what-ifs
};

ColorScene colorScene(const twin::PixelRecord& record, const twin::Details& details, const Settings& settings,
                      PlotSpace space, const std::vector<WhatIfRow>& variants);

/// Edges of the intersection of the slabs across `directions` that hold `points` (manual 9.7, 10.12).
std::vector<Segment> hullEdges(const std::vector<glm::vec3>& points,
                               const std::vector<glm::vec3>& directions);
/// The twelve edges of a box.
std::vector<Segment> edgesOf(const Corners& corners);

/// What the axes span: everything in the scene and a little more.
struct ColorRange {
  glm::vec3 low{0.0f}, high{1.0f};
  /// −1 to 1 over the range.
  glm::dvec3 unit(const glm::vec3& color) const;
};
ColorRange rangeOf(const ColorScene& scene);
Corners cornersOf(const ColorRange& range);

/// Round numbers on the axes, from low to high; a few each.
std::array<std::vector<double>, 3> ticksOf(const ColorRange& range, int most);

/// How the plot is turned: about the upright axis, then towards the eye; radians.
struct SpaceTurn {
  double yaw = 0.6, pitch = 0.35;
  bool operator==(const SpaceTurn&) const = default;
};
/// Turned by a drag of so many pixels; upright stays upright.
SpaceTurn turned(const SpaceTurn& turn, glm::dvec2 dragPx);

/// A point of the unit cube seen so: x right, y up, and how near to the eye. The first axis (R or Y) is
/// upright, the second goes right, the third to the eye when nothing is turned.
struct Projected {
  glm::dvec2 place{0.0};
  double nearness = 0.0;
};
Projected projected(const glm::dvec3& unit, const SpaceTurn& turn);

/// Where, in the plot's space, the edge along `axis` begins that has its ticks: of those at the outside of
/// the range as it is seen the lower one, of two as low the left one. Labels beside it cover nothing.
glm::vec3 outerEdge(const ColorRange& range, const SpaceTurn& turn, int axis);

/// The two axes of a flat projection: right, up.
inline constexpr std::array<std::pair<int, int>, 3> kProjections{{{1, 0}, {2, 0}, {1, 2}}};

} // namespace taa::app
