#include "core/scene/gltf/GltfCost.h"

#include "core/base/Error.h"
#include "core/base/json/JsonFields.h"
#include "core/scene/gltf/GltfContext.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace taa {

namespace {

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

/// Indices of lists that are unrolled, as readPrimitive() does it.
std::uint64_t unrolled(std::uint64_t count, int mode) {
  switch (mode) {
  case TINYGLTF_MODE_POINTS:
    return count;
  case TINYGLTF_MODE_LINE:
    return count / 2 * 2;
  case TINYGLTF_MODE_LINE_LOOP:
    return count > 1 ? 2 * count : 0;
  case TINYGLTF_MODE_LINE_STRIP:
    return count > 1 ? 2 * (count - 1) : 0;
  case TINYGLTF_MODE_TRIANGLE_STRIP:
  case TINYGLTF_MODE_TRIANGLE_FAN:
    return count > 2 ? 3 * (count - 2) : 0;
  default:
    return count / 3 * 3;
  }
}

/// How many elements an attribute has; 0: there is none of this name.
std::uint64_t attributeCount(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                             const char* name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? 0 : model.accessors.at(std::size_t(found->second)).count;
}

PrimitiveSize sizeOfSource(const tinygltf::Model& model, const tinygltf::Primitive& source) {
  const std::uint64_t positions = attributeCount(model, source, "POSITION");
  const std::uint64_t order =
      source.indices < 0 ? positions : model.accessors.at(std::size_t(source.indices)).count;
  PrimitiveSize size;
  size.indices = unrolled(order, source.mode < 0 ? TINYGLTF_MODE_TRIANGLES : source.mode);
  if (positions == 0 || size.indices == 0) return {};
  const bool isOfTriangles = source.mode < 0 || source.mode >= TINYGLTF_MODE_TRIANGLES;
  const bool isFlat = isOfTriangles && attributeCount(model, source, "NORMAL") == 0;
  size.vertices = isFlat ? size.indices : positions; // flat triangles share none
  for (const std::string set : {"0", "1"}) {
    if (attributeCount(model, source, ("JOINTS_" + set).c_str()) == 0 ||
        attributeCount(model, source, ("WEIGHTS_" + set).c_str()) == 0)
      break;
    size.influences += size.vertices;
  }
  size.deltas = source.targets.size() * size.vertices;
  size.cacheEntries = attributeCount(model, source, "_VELOCITY") > 0 ? size.vertices : 0;
  return size;
}

/// How often a node draws its mesh.
std::uint64_t timesDrawn(const tinygltf::Model& model, const tinygltf::Node& node) {
  const auto found = node.extensions.find(kInstancing);
  if (found == node.extensions.end() || !found->second.Has("attributes")) return 1;
  const tinygltf::Value& attributes = found->second.Get("attributes");
  for (const char* name : {"TRANSLATION", "ROTATION", "SCALE"})
    if (attributes.Has(name))
      return model.accessors.at(std::size_t(attributes.Get(name).GetNumberAsInt())).count;
  return 0;
}

/// The cost of a whole scene, and who asks for most of it.
struct ToldCost {
  SceneCost scene;
  std::size_t largestNode = 0, largestMesh = 0;
};

/// Of one mesh at one node: triangles, objects; of the mesh itself: vertices, bytes.
SceneCost costOfMesh(const tinygltf::Model& model, const tinygltf::Mesh& mesh) {
  SceneCost cost;
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    const PrimitiveSize size = sizeOfSource(model, primitive);
    cost.objects += size.indices > 0 ? 1 : 0;
    cost.triangles += size.indices / 3;
    cost.vertices += size.vertices;
    cost.bytes = cappedSum(cost.bytes, size.bytes());
  }
  return cost;
}

ToldCost toldCost(const GltfContext& context) {
  const tinygltf::Model& model = context.model;
  std::vector<SceneCost> meshes;
  for (const tinygltf::Mesh& mesh : model.meshes) meshes.push_back(costOfMesh(model, mesh));
  std::vector<bool> isCounted(model.meshes.size());
  ToldCost told;
  std::uint64_t mostTriangles = 0, mostBytes = 0;
  for (std::size_t index = 0; index < model.nodes.size(); ++index) {
    const tinygltf::Node& node = model.nodes[index];
    if (context.sceneNode[index] < 0 || node.mesh < 0 || context.isPosedOnly(index)) continue;
    const auto mesh = static_cast<std::size_t>(node.mesh);
    const std::uint64_t times = timesDrawn(model, node);
    const std::uint64_t triangles = cappedProduct(times, meshes.at(mesh).triangles);
    told.scene.objects = cappedSum(told.scene.objects, cappedProduct(times, meshes[mesh].objects));
    told.scene.triangles = cappedSum(told.scene.triangles, triangles);
    if (triangles > mostTriangles) told.largestNode = index;
    mostTriangles = std::max(mostTriangles, triangles);
    if (isCounted[mesh]) continue;
    isCounted[mesh] = true;
    told.scene.vertices += meshes[mesh].vertices;
    told.scene.bytes = cappedSum(told.scene.bytes, meshes[mesh].bytes);
    if (meshes[mesh].bytes > mostBytes) told.largestMesh = mesh;
    mostBytes = std::max(mostBytes, meshes[mesh].bytes);
  }
  return told;
}

} // namespace

SceneCost gltfCost(const GltfContext& context) {
  return toldCost(context).scene;
}

void checkGltfCost(const GltfContext& context, const SceneBudget& budget) {
  const ToldCost told = toldCost(context);
  const std::string refusal = costRefusal(told.scene, budget);
  if (refusal.empty()) return;
  const bool isOfNode = told.scene.triangles > budget.triangles;
  const bool isInstanced = isOfNode && context.model.nodes[told.largestNode].extensions.contains(kInstancing);
  const std::string place =
      isOfNode ? elementOf("nodes", told.largestNode) : elementOf("meshes", told.largestMesh);
  throw BudgetError(place + (isInstanced ? ".extensions." + std::string(kInstancing) : "") + ": " + refusal,
                    budgetFor(told.scene, budget));
}

} // namespace taa
