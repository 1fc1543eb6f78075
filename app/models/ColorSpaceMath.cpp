#include "app/models/ColorSpaceMath.h"

#include "app/models/ChartMath.h"
#include "core/settings/Parameters.h"
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace taa::app {

namespace {

using Id = IntermediateId;

/// From box space to the plot's, both without what bounds highlights.
class ToPlot {
 public:
  ToPlot(const SpaceSettings& box, PlotSpace plot)
      : box_{twin::withoutClamp(box).color, ToneSpace::Linear}, plot_{plot == PlotSpace::Rgb
                                                                          ? ColorSpace::Rgb
                                                                          : ColorSpace::YCoCg,
                                                                      ToneSpace::Linear} {}

  glm::vec3 operator()(const glm::vec3& color) const {
    return box_.color == plot_.color ? color : twin::toBox(twin::fromBox(color, box_), plot_);
  }
  Corners box(const glm::vec3& low, const glm::vec3& high) const {
    Corners corners;
    for (std::size_t corner = 0; corner < corners.size(); ++corner)
      corners[corner] =
          (*this)({corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z});
    return corners;
  }

 private:
  SpaceSettings box_, plot_;
};

/// What lies before a wall of a slab: dot(normal, point) ≤ limit.
struct SlabWall {
  glm::dvec3 normal{0.0};
  double limit = 0.0;
};

/// Both walls of the slabs across `directions`.
std::vector<SlabWall> wallsAround(const std::vector<glm::vec3>& points,
                                  const std::vector<glm::vec3>& directions) {
  std::vector<SlabWall> walls;
  for (const glm::vec3& direction : directions)
    for (const double sign : {-1.0, 1.0}) {
      const glm::dvec3 normal = sign * glm::dvec3(direction);
      double limit = std::numeric_limits<double>::lowest();
      for (const glm::vec3& point : points) limit = std::max(limit, glm::dot(normal, glm::dvec3(point)));
      walls.push_back({normal, limit});
    }
  return walls;
}

/// What all walls leave of the line of points a + t·d.
std::optional<std::pair<double, double>> clipped(const std::vector<SlabWall>& walls, const glm::dvec3& a,
                                                 const glm::dvec3& d, double slack) {
  double from = -1e9, to = 1e9;
  for (const SlabWall& wall : walls) {
    const double slope = glm::dot(wall.normal, d), rest = wall.limit - glm::dot(wall.normal, a);
    if (std::abs(slope) < 1e-12) {
      if (rest < -slack) return {};
    } else if (slope > 0) {
      to = std::min(to, rest / slope);
    } else {
      from = std::max(from, rest / slope);
    }
  }
  if (to < from) return {};
  return std::pair(from, to);
}

/// One point for all methods that put history there.
std::vector<RectifiedPoint> pointsByMethod(const twin::PixelRecord& record, const twin::Details& details,
                                           const Settings& settings, const ToPlot& plot) {
  const glm::vec3 history(twin::at(record, Id::historyRaw)), current(twin::at(record, Id::currentFiltered));
  Settings tried = settings;
  std::vector<RectifiedPoint> points;
  const Parameter& row = parameter("rectify.method");
  for (std::size_t method = 0; method < row.choices.size(); ++method) {
    tried.rectify.method = static_cast<RectifyMethod>(method);
    if (tried.rectify.method == RectifyMethod::None || tried.rectify.method == RectifyMethod::ClampForget)
      continue; // history itself, and a clamp
    const twin::Rectified moved = twin::rectifiedFully(tried, history, current, details.neighborhood);
    const glm::vec3 point = plot(twin::toBox(moved.value, settings.space));
    const auto same = std::ranges::find(points, point, &RectifiedPoint::point);
    const std::string label(row.choices[method].label);
    if (same == points.end())
      points.push_back({label, point});
    else
      same->methods += ", " + label;
  }
  return points;
}

} // namespace

ColorScene colorScene(const twin::PixelRecord& record, const twin::Details& details, const Settings& settings,
                      PlotSpace space, const std::vector<WhatIfRow>& variants) {
  const ToPlot plot(settings.space, space);
  const auto boxed = [&](const glm::vec3& color) { return twin::toBox(color, settings.space); };
  const auto row = [&](Id id) { return glm::vec3(twin::at(record, id)); };
  const twin::Neighborhood& hood = details.neighborhood;
  const glm::vec3 reach = hood.gamma * hood.deviation;
  ColorScene scene;
  scene.axes = space == PlotSpace::Rgb ? std::array<std::string, 3>{"R", "G", "B"}
                                       : std::array<std::string, 3>{"Y", "Co", "Cg"};
  for (std::size_t k = 0; k < 9; ++k) scene.samples[k] = plot(hood.samples[k]);
  for (std::size_t k = 0; k < 9; ++k) scene.sampleColors[k] = twin::fromBox(hood.samples[k], settings.space);
  const NeighborhoodShape shape = settings.neighborhood.shape;
  if (shape == NeighborhoodShape::Varying || shape == NeighborhoodShape::Pairs) // not only of the nine
    for (const twin::NeighborhoodSample& member : hood.members) {
      scene.taps.push_back(plot(boxed(member.color)));
      scene.tapColors.push_back(member.color);
    }
  scene.minMax = plot.box(hood.min, hood.max);
  scene.variance = plot.box(hood.mean - reach, hood.mean + reach);
  scene.box = plot.box(hood.boxMin, hood.boxMax);
  scene.mean = plot(hood.mean);
  const glm::vec3 current = boxed(row(Id::currentFiltered));
  scene.current = plot(current);
  scene.resolved = plot(boxed(row(Id::resolved)));
  const auto slabs = twin::slabDirections(settings.rectify.method, settings.space.color);
  if (!slabs.empty()) {
    std::vector<glm::vec3> points(hood.samples.begin(), hood.samples.end());
    points.push_back(current);
    for (const auto& [a, b] : hullEdges(points, slabs)) scene.hull.emplace_back(plot(a), plot(b));
  }
  if (!details.isFirst) {
    scene.historyRaw = plot(boxed(row(Id::historyRaw)));
    scene.historyRectified = plot(boxed(row(Id::historyRectified)));
    const auto target = twin::rectifyTarget(settings.rectify.method, current, hood);
    if (target && twin::at(record, Id::clipAmount).x > 0.0f) scene.target = plot(*target);
    scene.byMethod = pointsByMethod(record, details, settings, plot);
  }
  for (const WhatIfRow& variant : variants) scene.variants.push_back(plot(boxed(variant.resolved)));
  return scene;
}

std::vector<Segment> hullEdges(const std::vector<glm::vec3>& points,
                               const std::vector<glm::vec3>& directions) {
  const std::vector<SlabWall> walls = wallsAround(points, directions);
  glm::vec3 low = points.front(), high = low;
  for (const glm::vec3& point : points) low = glm::min(low, point), high = glm::max(high, point);
  const double size = static_cast<double>(glm::length(high - low));
  std::vector<Segment> edges;
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (std::size_t j = i + 1; j < walls.size(); ++j) {
      const glm::dvec3 along = glm::cross(walls[i].normal, walls[j].normal);
      const double squared = glm::dot(along, along);
      if (squared == 0.0) continue; // parallel
      const glm::dvec3 on = (walls[i].limit * glm::cross(walls[j].normal, along) +
                             walls[j].limit * glm::cross(along, walls[i].normal)) /
                            squared;
      const glm::dvec3 d = along / std::sqrt(squared);
      const auto part = clipped(walls, on, d, 1e-6 * size);
      if (!part || part->second - part->first < 1e-4 * size) continue;
      edges.emplace_back(glm::vec3(on + part->first * d), glm::vec3(on + part->second * d));
    }
  return edges;
}

std::vector<Segment> edgesOf(const Corners& corners) {
  std::vector<Segment> edges;
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
    for (const std::size_t axis : {1u, 2u, 4u})
      if (!(corner & axis)) edges.emplace_back(corners[corner], corners[corner | axis]);
  return edges;
}

ColorRange rangeOf(const ColorScene& scene) {
  glm::vec3 low = scene.current, high = low;
  const auto add = [&](const glm::vec3& point) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(point[axis])) continue;
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  };
  for (const auto& corners : {scene.minMax, scene.variance, scene.box})
    for (const glm::vec3& corner : corners) add(corner);
  for (const glm::vec3& sample : scene.samples) add(sample);
  for (const glm::vec3& tap : scene.taps) add(tap);
  for (const Segment& edge : scene.hull) add(edge.first), add(edge.second);
  for (const glm::vec3& variant : scene.variants) add(variant);
  for (const RectifiedPoint& each : scene.byMethod) add(each.point);
  for (const auto& point : {scene.historyRaw, scene.historyRectified, scene.target})
    if (point) add(*point);
  add(scene.resolved);
  const float widest = std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-4f});
  for (int axis = 0; axis < 3; ++axis) {
    // An axis along which next to nothing differs is not blown up to noise.
    const float width = std::max(high[axis] - low[axis], 0.05f * widest);
    const float middle = 0.5f * (low[axis] + high[axis]);
    low[axis] = middle - 0.55f * width;
    high[axis] = middle + 0.55f * width;
  }
  return {low, high};
}

Corners cornersOf(const ColorRange& range) {
  Corners corners;
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
    for (int axis = 0; axis < 3; ++axis)
      corners[corner][axis] = corner >> axis & 1u ? range.high[axis] : range.low[axis];
  return corners;
}

glm::dvec3 ColorRange::unit(const glm::vec3& color) const {
  return 2.0 * (glm::dvec3(color) - glm::dvec3(low)) / (glm::dvec3(high) - glm::dvec3(low)) - 1.0;
}

std::array<std::vector<double>, 3> ticksOf(const ColorRange& range, int most) {
  std::array<std::vector<double>, 3> ticks;
  for (int axis = 0; axis < 3; ++axis) {
    const Span span{static_cast<double>(range.low[axis]), static_cast<double>(range.high[axis])};
    ticks[static_cast<std::size_t>(axis)] = ticksOf(span, roundStep(span.length(), most));
  }
  return ticks;
}

SpaceTurn turned(const SpaceTurn& turn, glm::dvec2 dragPx) {
  constexpr double kRadiansPerPixel = 0.01, kSteepest = std::numbers::pi / 2;
  return {std::remainder(turn.yaw + kRadiansPerPixel * dragPx.x, 2 * std::numbers::pi),
          std::clamp(turn.pitch + kRadiansPerPixel * dragPx.y, -kSteepest, kSteepest)};
}

Projected projected(const glm::dvec3& unit, const SpaceTurn& turn) {
  const double up = unit.x, right = unit.y, near = unit.z;
  const double c = std::cos(turn.yaw), s = std::sin(turn.yaw);
  const double x = c * right + s * near, depth = c * near - s * right;
  const double cp = std::cos(turn.pitch), sp = std::sin(turn.pitch);
  return {{x, cp * up - sp * depth}, sp * up + cp * depth};
}

glm::vec3 outerEdge(const ColorRange& range, const SpaceTurn& turn, int axis) {
  const int first = (axis + 1) % 3, second = (axis + 2) % 3;
  glm::vec3 outermost = range.low;
  double farthest = -1.0, lowest = 0.0;
  for (unsigned corner = 0; corner < 4; ++corner) {
    glm::vec3 begin = range.low;
    if (corner & 1u) begin[first] = range.high[first];
    if (corner & 2u) begin[second] = range.high[second];
    glm::vec3 end = begin;
    end[axis] = range.high[axis];
    // The four are as long, so that the area between each and the middle says how far out it lies.
    const glm::dvec2 a = projected(range.unit(begin), turn).place, b = projected(range.unit(end), turn).place;
    const double far = std::abs(a.x * b.y - a.y * b.x), low = -0.5 * (a.y + b.y) - 0.05 * (a.x + b.x);
    constexpr double kSame = 1e-6; // opposite ones are as far
    if (far < farthest - kSame || (far < farthest + kSame && low <= lowest)) continue;
    outermost = begin;
    farthest = far;
    lowest = low;
  }
  return outermost;
}

} // namespace taa::app
