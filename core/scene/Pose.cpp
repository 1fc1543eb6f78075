#include "core/scene/Pose.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace taa {

namespace {

/// A node's own transform while the channels write to it.
struct Transform {
  glm::vec3 translation;
  glm::quat rotation;
  glm::vec3 scale;
};

glm::quat toQuaternion(const glm::vec4& v) {
  return {v.w, v.x, v.y, v.z};
}

glm::vec4 toVector(const glm::quat& q) {
  return {q.x, q.y, q.z, q.w};
}

/// Between keys `i` and `i + 1` at `u` in 0…1; glTF 2.0 appendix C.
glm::vec4 interpolate(const AnimationChannel& channel, std::size_t i, float u) {
  const std::vector<glm::vec4>& values = channel.values;
  switch (channel.interpolation) {
  case Interpolation::Step:
    return values[i];
  case Interpolation::Linear:
    if (channel.path == AnimationPath::Rotation) // glm's slerp takes the shorter way round
      return toVector(glm::slerp(toQuaternion(values[i]), toQuaternion(values[i + 1]), u));
    return values[i] + u * (values[i + 1] - values[i]);
  case Interpolation::CubicSpline:
    break;
  }
  const float step = channel.times[i + 1] - channel.times[i];
  const glm::vec4 from = values[3 * i + 1], to = values[3 * i + 4];
  const glm::vec4 fromTangent = step * values[3 * i + 2], toTangent = step * values[3 * i + 3];
  const float u2 = u * u, u3 = u2 * u;
  return (2 * u3 - 3 * u2 + 1) * from + (u3 - 2 * u2 + u) * fromTangent + (3 * u2 - 2 * u3) * to +
         (u3 - u2) * toTangent;
}

/// The last key at or before `time`, and how far on the way to the next one it is, 0…1.
struct KeyPlace {
  std::size_t key = 0;
  float u = 0.0f;
  bool holds = true; ///< no way to the next key: before the first or after the last
};

KeyPlace keyPlace(const std::vector<float>& times, double time) {
  const auto after = std::ranges::upper_bound(times, time, {}, [](float t) { return double(t); });
  if (after == times.begin()) return {};
  if (after == times.end()) return {times.size() - 1, 0.0f, true};
  const std::size_t i = static_cast<std::size_t>(after - times.begin()) - 1;
  const double start = times[i], end = times[i + 1];
  return {i, static_cast<float>((time - start) / (end - start)), false};
}

/// The channel's value at `time` seconds; before the first key and after the last it holds.
glm::vec4 sample(const AnimationChannel& channel, double time) {
  const std::vector<float>& times = channel.times;
  const bool cubic = channel.interpolation == Interpolation::CubicSpline;
  assert(!times.empty() && channel.values.size() == times.size() * (cubic ? 3 : 1));
  const KeyPlace place = keyPlace(times, time);
  if (place.holds) return channel.values[cubic ? 3 * place.key + 1 : place.key];
  return interpolate(channel, place.key, place.u);
}

/// Morph weights at `time`, into those of the channel's node.
void applyWeights(const AnimationChannel& channel, double time, std::span<float> weights) {
  const KeyPlace place = keyPlace(channel.times, time);
  const bool cubic = channel.interpolation == Interpolation::CubicSpline;
  const std::size_t count = weights.size(), stride = cubic ? 3 * count : count;
  assert(channel.weights.size() == channel.times.size() * stride);
  const auto value = [&](std::size_t key, std::size_t part, std::size_t i) {
    return channel.weights[key * stride + part * count + i];
  };
  for (std::size_t i = 0; i < count; ++i) {
    const float from = value(place.key, cubic ? 1 : 0, i);
    weights[i] = from;
    if (place.holds || channel.interpolation == Interpolation::Step) continue;
    const float to = value(place.key + 1, cubic ? 1 : 0, i), u = place.u;
    if (!cubic) {
      weights[i] = from + u * (to - from);
      continue;
    }
    const float step = channel.times[place.key + 1] - channel.times[place.key], u2 = u * u, u3 = u2 * u;
    weights[i] = (2 * u3 - 3 * u2 + 1) * from + (u3 - 2 * u2 + u) * step * value(place.key, 2, i) +
                 (3 * u2 - 2 * u3) * to + (u3 - u2) * step * value(place.key + 1, 0, i);
  }
}

void apply(const AnimationChannel& channel, double time, Transform& transform) {
  const glm::vec4 value = sample(channel, time);
  switch (channel.path) {
  case AnimationPath::Weights:
    break; // applyWeights
  case AnimationPath::Translation:
    transform.translation = glm::vec3(value);
    break;
  case AnimationPath::Scale:
    transform.scale = glm::vec3(value);
    break;
  case AnimationPath::Rotation:
    // A cubic spline leaves the unit sphere; glTF asks for the result to be normalized.
    if (const float length = glm::length(value); length > 0.0f)
      transform.rotation =
          toQuaternion(channel.interpolation == Interpolation::CubicSpline ? value / length : value);
    break;
  }
}

glm::mat4 matrixOf(const Transform& transform) {
  glm::mat4 matrix = glm::mat4_cast(transform.rotation);
  for (int axis = 0; axis < 3; ++axis) matrix[axis] *= transform.scale[axis];
  matrix[3] = glm::vec4(transform.translation, 1.0f);
  return matrix;
}

/// `time` brought into one run of the animation.
double loopedTime(double time, double duration) {
  return duration > 0.0 ? std::max(0.0, time - std::floor(time / duration) * duration) : 0.0;
}

/// At the time of the pose, over what others have written.
void play(const Scene& scene, const Animation& animation, std::vector<Transform>& transforms, Pose& pose) {
  const double time = loopedTime(pose.time, animation.duration);
  for (const AnimationChannel& channel : animation.channels) {
    const auto node = static_cast<std::size_t>(channel.node);
    if (channel.path == AnimationPath::Weights)
      applyWeights(channel, time,
                   std::span(pose.morphWeights)
                       .subspan(static_cast<std::size_t>(scene.nodes[node].firstWeight),
                                static_cast<std::size_t>(channel.weightCount)));
    else
      apply(channel, time, transforms.at(node));
  }
}

} // namespace

Pose poseAt(const Scene& scene, double time) {
  std::vector<Transform> transforms;
  transforms.reserve(scene.nodes.size());
  for (const Node& node : scene.nodes) transforms.push_back({node.translation, node.rotation, node.scale});
  Pose pose;
  pose.time = time;
  pose.morphWeights = scene.morphWeights;
  for (const Animation& animation : scene.animations) play(scene, animation, transforms, pose);
  pose.worldFromNode.reserve(scene.nodes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    assert(node.parent < static_cast<int>(i));
    const glm::mat4 parentFromNode = node.hasMatrix ? node.matrix : matrixOf(transforms[i]);
    pose.worldFromNode.push_back(node.parent < 0 ? parentFromNode
                                                 : pose.worldFromNode[static_cast<std::size_t>(node.parent)] *
                                                       parentFromNode);
  }
  return pose;
}

glm::mat4 worldFromInstance(const Scene& scene, const Pose& pose, const NodeInstance& at) {
  const glm::mat4& worldFromNode = pose.worldFromNode[static_cast<std::size_t>(at.node)];
  const Node& node = scene.nodes[static_cast<std::size_t>(at.node)];
  if (node.firstInstance < 0) return worldFromNode;
  assert(at.instance >= 0 && at.instance < node.instanceCount);
  return worldFromNode *
         glm::mat4(scene.instances[static_cast<std::size_t>(node.firstInstance + at.instance)]);
}

glm::mat4x3 instanceTransform(const glm::vec3& translation, const glm::quat& rotation,
                              const glm::vec3& scale) {
  return glm::mat4x3(matrixOf({translation, rotation, scale}));
}

glm::vec4 animatedUv(const UvAnimation& animation, double time) {
  constexpr double kEarly = 1e-6; // cells: a frame whose time was rounded down shows its own cell
  const auto count = static_cast<long long>(animation.columns) * animation.rows;
  const auto shown =
      static_cast<long long>(std::floor(time * static_cast<double>(animation.cellsPerSecond) + kEarly));
  const auto cell = static_cast<int>((shown % count + count) % count);
  const glm::vec2 size = 1.0f / glm::vec2(animation.columns, animation.rows);
  const glm::vec2 corner(cell % animation.columns, cell / animation.columns);
  const glm::dvec2 way = time * glm::dvec2(animation.scroll);
  return {size, corner * size + glm::vec2(glm::fract(way))};
}

} // namespace taa
