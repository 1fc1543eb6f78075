#include "tests/support/frames/AnalyticMotion.h"

#include "core/render/FrameClock.h"
#include "core/scene/Deform.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace taa::test {

namespace {

/// Rasterizers snap corners to a 256th of a pixel: closer to an edge, of weight 0, they may decide otherwise.
constexpr double kMargin = 0.05;

/// Of the sample in one pixel.
struct Nearest {
  double depth = -std::numeric_limits<double>::infinity(); ///< reversed
  double runnerUp = -std::numeric_limits<double>::infinity();
  double disputed = -std::numeric_limits<double>::infinity(); ///< of triangles that miss the sample by a hair
  double inside = 0.0; ///< smallest weight of a corner: how far from the triangle's edges
  glm::dvec2 motionPx{0.0};
};

struct Corner {
  glm::dvec4 now, before; ///< clip
};

class Rasterizer {
 public:
  explicit Rasterizer(const FrameInputs& inputs)
      : inputs_(inputs), sizePx_(inputs.width(), inputs.height()),
        pixels_(static_cast<std::size_t>(inputs.width()) * inputs.height()) {}

  void add(const std::array<Corner, 3>& corners) {
    glm::dvec2 low(1e9), high(-1e9);
    for (const Corner& corner : corners) {
      if (corner.now.w <= 0.0) return; // the scenes of the tests keep away from the camera
      const glm::dvec2 window = windowOf(corner.now) + glm::dvec2(inputs_.block.jitterPx);
      low = glm::min(low, window);
      high = glm::max(high, window);
    }
    const glm::dvec2 last = sizePx_ - 1.0;
    for (int y = int(std::max(0.0, std::floor(low.y))); y <= std::min(last.y, high.y); ++y)
      for (int x = int(std::max(0.0, std::floor(low.x))); x <= std::min(last.x, high.x); ++x)
        addPixel(corners, x, y);
  }

  const Nearest& at(int x, int y) const {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(inputs_.width()) +
                   static_cast<std::size_t>(x)];
  }

 private:
  glm::dvec2 windowOf(const glm::dvec4& clip) const {
    return (glm::dvec2(0.5, -0.5) * (glm::dvec2(clip) / clip.w) + 0.5) * sizePx_;
  }

  void addPixel(const std::array<Corner, 3>& corners, int x, int y) {
    const glm::dvec2 window = glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(inputs_.block.jitterPx);
    const glm::dvec2 ndc = glm::dvec2(2.0, -2.0) * (window / sizePx_) + glm::dvec2(-1.0, 1.0);
    // Weights λ with Σ λ (x, y, w) along (ndc, 1): no division by w before the sample's own.
    const auto row = [&](int i) {
      const glm::dvec4& clip = corners[static_cast<std::size_t>(i)].now;
      return glm::dvec3(clip.x, clip.y, clip.w);
    };
    const glm::dmat3 edges(row(0), row(1), row(2));
    if (std::abs(glm::determinant(edges)) < 1e-14) return;
    glm::dvec3 weights = glm::inverse(edges) * glm::dvec3(ndc, 1.0);
    weights /= weights.x + weights.y + weights.z;
    const double inside = std::min({weights.x, weights.y, weights.z});
    if (!(inside >= -kMargin)) return;
    glm::dvec4 now(0.0), before(0.0);
    for (int i = 0; i < 3; ++i) {
      now += weights[i] * corners[static_cast<std::size_t>(i)].now;
      before += weights[i] * corners[static_cast<std::size_t>(i)].before;
    }
    Nearest& pixel = pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(inputs_.width()) +
                             static_cast<std::size_t>(x)];
    const double depth = now.z / now.w;
    if (inside < 0.0) pixel.disputed = std::max(pixel.disputed, depth);
    if (inside < 0.0 || depth <= pixel.depth) {
      if (inside >= 0.0) pixel.runnerUp = std::max(pixel.runnerUp, depth);
      return;
    }
    pixel = {depth, pixel.depth, pixel.disputed, inside, windowOf(now) - windowOf(before)};
  }

  const FrameInputs& inputs_;
  glm::dvec2 sizePx_;
  std::vector<Nearest> pixels_;
};

void addPrimitive(const Scene& scene, const FrameInputs& inputs, const NodeInstance& at,
                  const Primitive& primitive, Rasterizer& rasterizer) {
  const int frame = inputs.info.frame;
  const double time = frameTime(scene, frame), previousTime = frameTime(scene, previousFrame(scene, frame));
  const Pose pose = poseAt(scene, time), previousPose = poseAt(scene, previousTime);
  const Deformer now(scene, at, primitive, pose, time),
      before(scene, at, primitive, previousPose, time, time - previousTime);
  const glm::dmat4 clip(inputs.block.clipFromWorld), previousClip(inputs.block.previousClipFromWorld);
  std::vector<Corner> corners;
  for (std::size_t vertex = 0; vertex < primitive.vertices.size(); ++vertex)
    corners.push_back({clip * glm::dvec4(glm::dvec3(now.position(vertex)), 1.0),
                       previousClip * glm::dvec4(glm::dvec3(before.position(vertex)), 1.0)});
  const bool isDoubleSided = scene.materials[static_cast<std::size_t>(primitive.material)].doubleSided;
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const std::array<Corner, 3> triangle{corners[primitive.indices[i]], corners[primitive.indices[i + 1]],
                                         corners[primitive.indices[i + 2]]};
    const auto row = [&](std::size_t k) {
      return glm::dvec3(triangle[k].now.x, triangle[k].now.y, triangle[k].now.w);
    };
    if (isDoubleSided || glm::determinant(glm::dmat3(row(0), row(1), row(2))) > 0.0) rasterizer.add(triangle);
  }
}

} // namespace

MotionAgreement compareMotion(const Scene& scene, const FrameInputs& inputs) {
  Rasterizer rasterizer(inputs);
  for (int node = 0; node < static_cast<int>(scene.nodes.size()); ++node) {
    const Node& drawn = scene.nodes[static_cast<std::size_t>(node)];
    for (int instance = 0; instance < drawn.timesDrawn(); ++instance)
      for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(drawn.mesh)].primitives)
        if (primitive.topology == Topology::Triangles)
          addPrimitive(scene, inputs, {node, instance}, primitive, rasterizer);
  }
  const Image motion = inputs.motion.download(), ids = inputs.objectId.download();
  MotionAgreement agreement;
  for (int y = 0; y < inputs.height(); ++y)
    for (int x = 0; x < inputs.width(); ++x) {
      const Nearest& nearest = rasterizer.at(x, y);
      // Where triangles meet, and where two are equally near, the GPU may decide for the other one.
      const bool isClear =
          nearest.inside > kMargin && std::max(nearest.runnerUp, nearest.disputed) < 0.999 * nearest.depth;
      if (!isClear || ids.at(x, y)[0] == 0.0f) continue;
      const glm::dvec2 measured(motion.at(x, y)[0], motion.at(x, y)[1]);
      const double difference = glm::length(measured - nearest.motionPx);
      ++agreement.compared;
      agreement.fastestPx = std::max(agreement.fastestPx, glm::length(nearest.motionPx));
      if (!(difference > agreement.worstPx)) continue;
      agreement.worstPx = difference;
      agreement.worst = "(" + std::to_string(x) + ", " + std::to_string(y) + "): measured " +
                        std::to_string(measured.x) + ", " + std::to_string(measured.y) + " px, analytic " +
                        std::to_string(nearest.motionPx.x) + ", " + std::to_string(nearest.motionPx.y);
    }
  return agreement;
}

} // namespace taa::test
