#include "core/scene/builtin/SceneBuilder.h"

#include "core/scene/Geometry.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace taa {

namespace {

template <class T>
int appendTo(std::vector<T>& list, T item) {
  list.push_back(std::move(item));
  return static_cast<int>(list.size()) - 1;
}

} // namespace

SceneBuilder::SceneBuilder(std::string name) {
  scene_.name = std::move(name);
}

int SceneBuilder::addImage(SceneImage image) {
  return appendTo(scene_.images, std::move(image));
}

int SceneBuilder::addMaterial(const Material& material) {
  return appendTo(scene_.materials, material);
}

int SceneBuilder::addObject(const std::string& name, std::vector<Primitive> primitives, int parent) {
  const int object = addNode(name, glm::vec3(0.0f), {1, 0, 0, 0}, parent);
  scene_.nodes.back().mesh = appendTo(scene_.meshes, Mesh{name, std::move(primitives)});
  return object;
}

int SceneBuilder::addInstance(int object, const glm::vec3& translation, const glm::vec3& scale) {
  Node node = scene_.nodes[static_cast<std::size_t>(object)];
  node.translation = translation;
  node.scale = scale;
  return appendTo(scene_.nodes, std::move(node));
}

int SceneBuilder::addNode(const std::string& name, const glm::vec3& translation, const glm::quat& rotation,
                          int parent) {
  Node node;
  node.name = name;
  node.translation = translation;
  node.rotation = rotation;
  node.parent = parent;
  return appendTo(scene_.nodes, std::move(node));
}

void SceneBuilder::addPointLight(const std::string& name, const glm::vec3& position, const glm::vec3& color,
                                 float candela) {
  Light light;
  light.kind = LightKind::Point;
  light.color = color;
  light.intensity = candela;
  light.node = addNode(name, position);
  scene_.nodes.back().light = appendTo(scene_.lights, light);
}

int SceneBuilder::addCamera(const std::string& name, const glm::vec3& eye, const glm::vec3& direction,
                            float fovY) {
  SceneCamera camera;
  camera.name = name;
  camera.fovY = fovY;
  camera.nearPlane = 0.05f;
  camera.node = addNode(name, eye, lookRotation(direction));
  const int node = camera.node;
  scene_.nodes.back().camera = appendTo(scene_.cameras, std::move(camera));
  return node;
}

Animation& SceneBuilder::animation(float seconds) {
  if (scene_.animations.empty()) scene_.animations.push_back({"loop", 0.0f, {}});
  Animation& all = scene_.animations.front();
  all.duration = std::max(all.duration, seconds);
  return all;
}

void SceneBuilder::animateLoop(int node, float seconds, const std::function<glm::vec3(float)>& position,
                               const std::function<glm::vec3(float)>& derivative) {
  constexpr int kKeys = 8; // cubic splines through eighths of a sine are within 0.1 % of it
  AnimationChannel channel;
  channel.node = node;
  channel.path = AnimationPath::Translation;
  channel.interpolation = Interpolation::CubicSpline;
  for (int key = 0; key <= kKeys; ++key) {
    const float angle = kTurn * static_cast<float>(key) / kKeys;
    const glm::vec4 tangent(derivative(angle) * (kTurn / seconds),
                            0.0f); // per second, the same on both sides
    channel.times.push_back(seconds * static_cast<float>(key) / kKeys);
    channel.values.insert(channel.values.end(), {tangent, glm::vec4(position(angle), 0.0f), tangent});
  }
  animation(seconds).channels.push_back(std::move(channel));
}

void SceneBuilder::animateSpin(int node, float seconds, int turns) {
  AnimationChannel channel;
  channel.node = node;
  channel.path = AnimationPath::Rotation;
  channel.interpolation = Interpolation::Linear;
  const int keys = 4 * turns; // quarter turns: the shorter way round is the right one
  for (int key = 0; key <= keys; ++key) {
    const float halfAngle = 0.25f * std::numbers::pi_v<float> * static_cast<float>(key % 8);
    channel.times.push_back(seconds * static_cast<float>(key) / static_cast<float>(keys));
    channel.values.emplace_back(0.0f, 0.0f, std::sin(halfAngle), std::cos(halfAngle));
  }
  animation(seconds).channels.push_back(std::move(channel));
}

void SceneBuilder::animateSwing(int node, float seconds, float angle, int times) {
  AnimationChannel channel;
  channel.node = node;
  channel.path = AnimationPath::Rotation;
  const int keys = 24 * times;
  for (int key = 0; key <= keys; ++key) {
    const float phase = 2.0f * std::numbers::pi_v<float> * static_cast<float>(key % 24) / 24.0f;
    const float half = 0.5f * angle * std::sin(phase);
    channel.times.push_back(seconds * static_cast<float>(key) / static_cast<float>(keys));
    channel.values.emplace_back(0.0f, 0.0f, std::sin(half), std::cos(half));
  }
  animation(seconds).channels.push_back(std::move(channel));
}

void SceneBuilder::animateWeights(int node, const std::vector<float>& times,
                                  const std::vector<float>& weights) {
  AnimationChannel channel;
  channel.node = node;
  channel.path = AnimationPath::Weights;
  channel.times = times;
  channel.weightCount = static_cast<int>(weights.size() / times.size());
  channel.weights = weights;
  animation(times.back()).channels.push_back(std::move(channel));
}

void SceneBuilder::animateSteps(int node, float seconds, const std::vector<glm::vec3>& places) {
  AnimationChannel channel;
  channel.node = node;
  channel.interpolation = Interpolation::Step;
  for (const glm::vec3& place : places) {
    channel.times.push_back(seconds * static_cast<float>(channel.times.size()));
    channel.values.emplace_back(place, 0.0f);
  }
  animation(channel.times.back()).channels.push_back(std::move(channel));
}

void SceneBuilder::animateSteady(int node, float seconds, const glm::vec3& from, const glm::vec3& to) {
  AnimationChannel channel;
  channel.node = node;
  channel.times = {0.0f, seconds};
  channel.values = {glm::vec4(from, 0.0f), glm::vec4(to, 0.0f)};
  animation(seconds).channels.push_back(std::move(channel));
}

Scene SceneBuilder::finish() {
  scene_.bounds = restBounds(scene_);
  return std::move(scene_);
}

Material paintOf(const glm::vec3& color, float roughness, float metallic) {
  Material material;
  material.baseColor = glm::vec4(color, 1.0f);
  material.roughness = roughness;
  material.metallic = metallic;
  return material;
}

TextureSlot textureSlot(int image) {
  TextureSlot slot;
  slot.image = image;
  return slot;
}

glm::quat lookRotation(const glm::vec3& direction) {
  const glm::mat4 view = glm::lookAt(glm::vec3(0.0f), direction, glm::vec3(0, 1, 0));
  return glm::conjugate(glm::quat_cast(glm::mat3(view)));
}

} // namespace taa
