#include "core/scene/GltfMesh.h"

#include "core/base/Error.h"
#include "core/scene/GltfAccessor.h"
#include "core/scene/GltfContext.h"
#include "core/scene/GltfPrimitive.h"

#include <glm/gtc/type_ptr.hpp>
#include <tiny_gltf.h>

#include <algorithm>

namespace taa {

namespace {

constexpr std::size_t kMaxInstances = 100000; ///< nodes made for EXT_mesh_gpu_instancing

class MeshAdder {
 public:
  MeshAdder(GltfContext& context, std::span<const glm::mat4> restTransforms)
      : context_(context), restTransforms_(restTransforms), sceneMesh_(context.model.meshes.size(), -1) {}

  void addTo(std::size_t sourceNode) {
    const tinygltf::Node& source = context_.model.nodes[sourceNode];
    const int node = context_.sceneNode[sourceNode];
    if (node < 0 || source.mesh < 0) return;
    if (source.skin >= 0 && addSkinned(source)) return;
    const int mesh = sharedMesh(static_cast<std::size_t>(source.mesh));
    const auto instancing = source.extensions.find("EXT_mesh_gpu_instancing");
    if (instancing != source.extensions.end() && instancing->second.Has("attributes"))
      addInstances(instancing->second.Get("attributes"), sourceNode, mesh);
    else
      context_.scene.nodes[static_cast<std::size_t>(node)].mesh = mesh;
  }

 private:
  int build(std::size_t sourceMesh, std::span<const glm::mat4> worldFromSkin) {
    const tinygltf::Mesh& source = context_.model.meshes.at(sourceMesh);
    Mesh mesh;
    mesh.name = source.name;
    for (std::size_t i = 0; i < source.primitives.size(); ++i) try {
        Primitive primitive = readPrimitive(context_, source.primitives[i], worldFromSkin);
        if (primitive.indices.empty())
          context_.warn("A part of the mesh \"" + source.name + "\" has nothing to draw.");
        else
          mesh.primitives.push_back(std::move(primitive));
      } catch (const Error& error) {
        throw Error(gltfPlace("meshes", sourceMesh) + "." + gltfPlace("primitives", i) + "." + error.what());
      }
    context_.scene.meshes.push_back(std::move(mesh));
    return static_cast<int>(context_.scene.meshes.size()) - 1;
  }

  /// The mesh that all unskinned nodes share.
  int sharedMesh(std::size_t sourceMesh) {
    int& index = sceneMesh_[sourceMesh];
    if (index < 0) index = build(sourceMesh, {});
    return index;
  }

  /// A mesh of its own, in world space: glTF ignores the transform of a skinned node. False when the skin is
  /// unusable.
  bool addSkinned(const tinygltf::Node& source) {
    context_.warn("Skinned meshes stand still in the pose their joints have at rest.");
    const std::vector<glm::mat4> worldFromSkin = skinTransforms(static_cast<std::size_t>(source.skin));
    if (worldFromSkin.empty()) return false;
    Node node;
    node.name = source.name;
    node.mesh = build(static_cast<std::size_t>(source.mesh), worldFromSkin);
    context_.scene.nodes.push_back(std::move(node));
    return true;
  }

  /// Joints at rest after the inverse bind matrices; empty when a joint is not in the scene.
  std::vector<glm::mat4> skinTransforms(std::size_t skinIndex) const {
    const tinygltf::Skin& skin = context_.model.skins.at(skinIndex);
    AccessorValues inverseBinds;
    if (skin.inverseBindMatrices >= 0) {
      inverseBinds = readAccessor(context_.model, skin.inverseBindMatrices);
      if (inverseBinds.components != 16 || inverseBinds.count() < skin.joints.size() ||
          !inverseBinds.isFinite())
        throw Error(gltfPlace("skins", skinIndex) +
                    ": inverseBindMatrices are not a finite 4×4 matrix for each joint");
    }
    std::vector<glm::mat4> transforms;
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      const int joint = context_.sceneNode.at(static_cast<std::size_t>(skin.joints[i]));
      if (joint < 0) return {};
      const glm::mat4 inverseBind =
          inverseBinds.values.empty() ? glm::mat4(1.0f) : glm::make_mat4(&inverseBinds.values[16 * i]);
      transforms.push_back(restTransforms_[static_cast<std::size_t>(joint)] * inverseBind);
    }
    return transforms;
  }

  void addInstances(const tinygltf::Value& attributes, std::size_t sourceNode, int mesh) {
    try {
      const auto read = [&](const char* name, int components) {
        if (!attributes.Has(name)) return AccessorValues{};
        AccessorValues values = readAccessor(context_.model, attributes.Get(name).GetNumberAsInt());
        if (values.components != components || !values.isFinite())
          throw Error(std::string(name) + " does not hold finite vectors of " + std::to_string(components));
        return values;
      };
      addInstances(read("TRANSLATION", 3), read("ROTATION", 4), read("SCALE", 3),
                   context_.sceneNode[sourceNode], mesh);
    } catch (const Error& error) {
      throw Error(gltfPlace("nodes", sourceNode) + ".extensions.EXT_mesh_gpu_instancing: " + error.what());
    }
  }

  void addInstances(const AccessorValues& translations, const AccessorValues& rotations,
                    const AccessorValues& scales, int parent, int mesh) {
    std::size_t count = 0;
    for (const AccessorValues* values : {&translations, &rotations, &scales}) {
      if (values->components == 0) continue;
      if (count != 0 && values->count() != count) throw Error("its attributes have different counts");
      count = values->count();
    }
    instances_ += count;
    if (instances_ > kMaxInstances)
      throw Error("there are more than " + std::to_string(kMaxInstances) + " instances");
    for (std::size_t i = 0; i < count; ++i) {
      Node node;
      node.name = context_.scene.nodes[static_cast<std::size_t>(parent)].name;
      node.parent = parent;
      node.mesh = mesh;
      if (translations.components != 0) node.translation = glm::vec3(translations.at(i));
      if (scales.components != 0) node.scale = glm::vec3(scales.at(i));
      const glm::vec4 q = rotations.components != 0 ? rotations.at(i) : glm::vec4(0, 0, 0, 1);
      if (const float length = glm::length(q); length > 0.0f)
        node.rotation = {q.w / length, q.x / length, q.y / length, q.z / length};
      context_.scene.nodes.push_back(std::move(node));
    }
  }

  GltfContext& context_;
  std::span<const glm::mat4> restTransforms_;
  std::vector<int> sceneMesh_; ///< for each mesh of the file its index in the scene, −1 when not built
  std::size_t instances_ = 0;
};

} // namespace

void addGltfMeshes(GltfContext& context, std::span<const glm::mat4> restTransforms) {
  MeshAdder meshes(context, restTransforms);
  for (std::size_t node = 0; node < context.model.nodes.size(); ++node) meshes.addTo(node);
}

} // namespace taa
