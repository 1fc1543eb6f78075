#include "core/scene/gltf/GltfNodes.h"

#include "core/base/Error.h"
#include "core/base/Light.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/JsonFields.h"
#include "core/scene/Pose.h"
#include "core/scene/gltf/GltfContext.h"

#include <glm/geometric.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr std::size_t kMaxNodes = 200000;

glm::vec3 vectorOr(const std::vector<double>& list, const glm::vec3& fallback) {
  return list.size() == 3 ? glm::vec3(toFloat(list[0]), toFloat(list[1]), toFloat(list[2])) : fallback;
}

void readTransform(const tinygltf::Node& source, Node& node) {
  if (source.matrix.size() == 16) {
    node.hasMatrix = true;
    for (int i = 0; i < 16; ++i)
      node.matrix[i / 4][i % 4] = toFloat(source.matrix[static_cast<std::size_t>(i)]);
    return;
  }
  node.translation = vectorOr(source.translation, glm::vec3(0.0f));
  node.scale = vectorOr(source.scale, glm::vec3(1.0f));
  if (source.rotation.size() != 4) return;
  const glm::dvec4 q(source.rotation[0], source.rotation[1], source.rotation[2], source.rotation[3]);
  const double length = glm::length(q);
  if (length > 0.0)
    node.rotation = {toFloat(q.w / length), toFloat(q.x / length), toFloat(q.y / length),
                     toFloat(q.z / length)};
}

/// The nearest of a range; `isOther` becomes true where that is another value than the file's.
float nearestIn(double value, float least, float most, bool& isOther) {
  const float given = toFloat(value), nearest = std::clamp(given, least, most);
  isOther = isOther || nearest != given;
  return nearest;
}

constexpr float kLargest = std::numeric_limits<float>::max();

void addCamera(GltfContext& context, const tinygltf::Camera& source, int nodeIndex) {
  bool isOther = false;
  SceneCamera camera;
  const std::string& ofNode = context.scene.nodes[static_cast<std::size_t>(nodeIndex)].name;
  camera.name = source.name.empty() ? ofNode : plainText(source.name);
  camera.node = nodeIndex;
  camera.orthographic = source.type == "orthographic";
  if (camera.orthographic) {
    const tinygltf::OrthographicCamera& given = source.orthographic;
    camera.height = 2.0f * nearestIn(std::abs(given.ymag), 1e-6f, kLargest, isOther); // either sign is seen
    camera.nearPlane = nearestIn(given.znear, 0.0f, kLargest, isOther);
    camera.farPlane = nearestIn(given.zfar, camera.nearPlane + 1e-3f, kLargest, isOther);
  } else {
    camera.fovY = nearestIn(source.perspective.yfov, 0.01f, 3.0f, isOther);
    const float nearPlane = toFloat(source.perspective.znear);
    isOther = isOther || !(nearPlane > 0.0f);
    camera.nearPlane = nearPlane > 0.0f ? nearPlane : camera.nearPlane;
  }
  if (isOther)
    context.warn(say<"The camera \"%1\" has a size or a plane that none can have; the nearest is taken.">(
        shownText(source.name)));
  context.scene.nodes[static_cast<std::size_t>(nodeIndex)].camera =
      static_cast<int>(context.scene.cameras.size());
  context.scene.cameras.push_back(std::move(camera));
}

/// What a light cannot be, such as darker than black, is taken for the nearest.
void keepInRange(GltfContext& context, const tinygltf::Light& source, Light& light) {
  constexpr float kHalfPi = 0.5f * std::numbers::pi_v<float>;
  bool isOther = false;
  const glm::vec3 color = vectorOr(source.color, glm::vec3(1.0f));
  light.color = glm::max(color, glm::vec3(0.0f));
  isOther = light.color != color;
  light.intensity = nearestIn(source.intensity, 0.0f, kLargest, isOther);
  light.range = nearestIn(source.range, 0.0f, kLargest, isOther);
  light.outerConeAngle = nearestIn(source.spot.outerConeAngle, 1e-3f, kHalfPi, isOther);
  const float inner = nearestIn(source.spot.innerConeAngle, 0.0f, light.outerConeAngle, isOther);
  light.innerConeAngle = std::min(inner, 0.999f * light.outerConeAngle); // never a quotient by 0
  if (isOther)
    context.warn(say<"The light \"%1\" has values that none can have; the nearest are taken.">(
        shownText(source.name)));
}

void addLight(GltfContext& context, const tinygltf::Light& source, int nodeIndex) {
  Light light;
  light.node = nodeIndex;
  if (source.type == "point")
    light.kind = LightKind::Point;
  else if (source.type == "spot")
    light.kind = LightKind::Spot;
  else if (source.type != "directional") {
    context.warn(say<"A light of the unknown type \"%1\" is left out.">(shownText(source.type)));
    return;
  }
  keepInRange(context, source, light);
  context.scene.nodes[static_cast<std::size_t>(nodeIndex)].light =
      static_cast<int>(context.scene.lights.size());
  context.scene.lights.push_back(light);
}

std::vector<int> parentsOf(const tinygltf::Model& model) {
  std::vector<int> parents(model.nodes.size(), -1);
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    for (const int child : model.nodes[i].children)
      parents[static_cast<std::size_t>(child)] = static_cast<int>(i);
  return parents;
}

/// Of the nodes that a scene names, those that hang on no other one of them. glTF wants roots; whole kits of
/// assets name children, and mean them to be where their parents put them.
std::vector<int> topmost(GltfContext& context, const std::vector<int>& named,
                         const std::vector<int>& parents) {
  const std::set<int> all(named.begin(), named.end());
  std::vector<int> out;
  for (const int node : named) {
    int above = parents[static_cast<std::size_t>(node)];
    if (above >= 0)
      context.warn(say<"The scene names nodes[%1], which is a child of nodes[%2] and no root: it is drawn "
                       "once, where its parents put it.">(node, above));
    while (above >= 0 && !all.contains(above)) above = parents[static_cast<std::size_t>(above)];
    if (above < 0) out.push_back(node);
  }
  return out;
}

/// The nodes the default scene starts from; all roots when the file has no scenes.
std::vector<int> rootsOf(GltfContext& context, const std::vector<int>& parents) {
  const tinygltf::Model& model = context.model;
  if (!model.scenes.empty()) {
    const std::size_t chosen = model.defaultScene < 0 ? 0 : static_cast<std::size_t>(model.defaultScene);
    if (model.scenes.size() > 1)
      context.warn(say<"The file has %1 scenes; scenes[%2] is shown.">(model.scenes.size(), chosen));
    return topmost(context, model.scenes.at(chosen).nodes, parents);
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < parents.size(); ++i)
    if (parents[i] < 0) roots.push_back(static_cast<int>(i));
  return roots;
}

void addNode(GltfContext& context, std::size_t sourceIndex, int parent) {
  const tinygltf::Node& source = context.model.nodes[sourceIndex];
  const int index = static_cast<int>(context.scene.nodes.size());
  if (context.scene.nodes.size() >= kMaxNodes)
    throw Error("nodes: " + say<"more than %1 are drawn">(kMaxNodes));
  context.sceneNode[sourceIndex] = index;
  Node node;
  node.name = plainText(source.name);
  node.parent = parent;
  readTransform(source, node);
  context.scene.nodes.push_back(std::move(node));
  if (context.isPosedOnly(sourceIndex)) return;
  if (source.camera >= 0)
    addCamera(context, context.model.cameras.at(static_cast<std::size_t>(source.camera)), index);
  const auto light = source.extensions.find("KHR_lights_punctual");
  if (light != source.extensions.end())
    addLight(context,
             context.model.lights.at(static_cast<std::size_t>(light->second.Get("light").GetNumberAsInt())),
             index);
}

/// A node and what it hangs on, as far as that is not there yet: posed and not drawn. Its index in the
/// scene; −1 of none.
int addPosedOnly(GltfContext& context, int node, const std::vector<int>& parents) {
  std::vector<std::size_t> way; // from the node up to what is there
  int at = node;
  for (; at >= 0 && context.sceneNode[static_cast<std::size_t>(at)] < 0;
       at = parents[static_cast<std::size_t>(at)])
    way.push_back(static_cast<std::size_t>(at));
  int parent = at < 0 ? -1 : context.sceneNode[static_cast<std::size_t>(at)];
  for (auto above = way.rbegin(); above != way.rend(); ++above) {
    context.posedOnly[*above] = true;
    addNode(context, *above, parent);
    parent = context.sceneNode[*above];
  }
  return parent;
}

/// Joints outside the shown scene that move skins in it.
void addJointsOutside(GltfContext& context, const std::vector<int>& parents) {
  const tinygltf::Model& model = context.model;
  std::set<int> skins;
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    if (context.sceneNode[i] >= 0 && model.nodes[i].mesh >= 0 && model.nodes[i].skin >= 0)
      skins.insert(model.nodes[i].skin);
  for (const int skin : skins)
    for (const int joint : model.skins[static_cast<std::size_t>(skin)].joints)
      addPosedOnly(context, joint, parents);
}

} // namespace

void addGltfNodes(GltfContext& context) {
  struct Visit {
    int source, parent;
  };
  const std::vector<int> parents = parentsOf(context.model);
  context.sceneNode.assign(parents.size(), -1);
  context.posedOnly.assign(parents.size(), false);
  std::vector<Visit> open;
  const std::vector<int> roots = rootsOf(context, parents);
  for (auto root = roots.rbegin(); root != roots.rend(); ++root)
    open.push_back({*root, addPosedOnly(context, parents[static_cast<std::size_t>(*root)], parents)});
  while (!open.empty()) { // depth first, in the file's order; checkGltfGraph has seen to it that this ends
    const Visit visit = open.back();
    open.pop_back();
    const std::size_t source = static_cast<std::size_t>(visit.source);
    addNode(context, source, visit.parent);
    const std::vector<int>& children = context.model.nodes[source].children;
    for (auto child = children.rbegin(); child != children.rend(); ++child)
      open.push_back({*child, context.sceneNode[source]});
  }
  addJointsOutside(context, parents);
}

void keepStrongestLights(GltfContext& context) {
  std::vector<Light>& lights = context.scene.lights;
  const std::size_t most = kMaxLights, count = lights.size();
  if (count <= most) return;
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto rank = [&](std::size_t index) {
    const Light& light = lights[index];
    return std::pair(light.kind == LightKind::Directional, luminance(light.color) * light.intensity);
  };
  std::ranges::stable_sort(order, std::ranges::greater{}, rank);
  order.resize(most);
  std::ranges::sort(order); // as the file has them
  std::vector<Light> kept;
  for (Node& node : context.scene.nodes) node.light = -1;
  for (const std::size_t index : order) {
    context.scene.nodes[static_cast<std::size_t>(lights[index].node)].light = static_cast<int>(kept.size());
    kept.push_back(lights[index]);
  }
  lights = std::move(kept);
  context.warn(
      say<"The file has %1 lights; the %2 strongest are drawn, directional ones first.">(count, most));
}

void checkRestTransforms(const GltfContext& context) {
  Scene atRest;
  atRest.nodes = context.scene.nodes;
  const std::vector<glm::mat4> transforms = poseAt(atRest, 0.0).worldFromNode;
  for (std::size_t source = 0; source < context.sceneNode.size(); ++source) {
    if (context.sceneNode[source] < 0) continue;
    const glm::mat4& transform = transforms[static_cast<std::size_t>(context.sceneNode[source])];
    for (int i = 0; i < 16; ++i)
      if (!std::isfinite(transform[i / 4][i % 4]))
        throw Error(elementOf("nodes", source) + ": " + say<"its transform is not finite">());
  }
}

} // namespace taa
