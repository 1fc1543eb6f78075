#include "core/scene/gltf/GltfMesh.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/JsonFields.h"
#include "core/scene/Pose.h"
#include "core/scene/gltf/GltfAccessor.h"
#include "core/scene/gltf/GltfContext.h"
#include "core/scene/gltf/GltfPrimitive.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x3.hpp>
#include <tiny_gltf.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr std::size_t kMaxInstances = 100000; ///< of EXT_mesh_gpu_instancing, of all nodes together
constexpr std::size_t kMaxJoints = 65536;     ///< of all skins together
constexpr std::size_t kMaxWeights = 1000000;  ///< of all nodes together

class MeshAdder {
 public:
  explicit MeshAdder(GltfContext& context)
      : context_(context), sceneMesh_(context.model.meshes.size(), -1),
        sceneSkin_(context.model.skins.size(), -1) {}

  void addTo(std::size_t sourceNode) {
    const tinygltf::Node& source = context_.model.nodes[sourceNode];
    const int index = context_.sceneNode[sourceNode];
    if (index < 0 || source.mesh < 0 || context_.isPosedOnly(sourceNode)) return;
    const int mesh = sharedMesh(static_cast<std::size_t>(source.mesh));
    const auto instancing = source.extensions.find("EXT_mesh_gpu_instancing");
    if (instancing != source.extensions.end() && instancing->second.Has("attributes")) {
      addInstances(instancing->second.Get("attributes"), sourceNode, mesh);
      return;
    }
    Node& node = context_.scene.nodes[static_cast<std::size_t>(index)];
    node.mesh = mesh;
    node.firstWeight = addWeights(source, mesh);
    if (source.skin >= 0) node.skin = sharedSkin(static_cast<std::size_t>(source.skin));
    if (node.skin >= 0) checkJoints(static_cast<std::size_t>(source.mesh), mesh, node.skin);
  }

 private:
  int build(std::size_t sourceMesh) {
    const tinygltf::Mesh& source = context_.model.meshes.at(sourceMesh);
    Mesh mesh;
    mesh.name = plainText(source.name);
    for (std::size_t i = 0; i < source.primitives.size(); ++i) try {
        Primitive primitive = readPrimitive(context_, source.primitives[i]);
        if (primitive.indices.empty())
          context_.warn(say<"A part of the mesh \"%1\" has nothing to draw.">(shownText(source.name)));
        else
          mesh.primitives.push_back(std::move(primitive));
      } catch (const Error& error) {
        throw Error(elementOf("meshes", sourceMesh) + "." + elementOf("primitives", i) + "." + error.what());
      }
    context_.scene.meshes.push_back(std::move(mesh));
    return static_cast<int>(context_.scene.meshes.size()) - 1;
  }

  /// The mesh that all its nodes share.
  int sharedMesh(std::size_t sourceMesh) {
    int& index = sceneMesh_[sourceMesh];
    if (index < 0) index = build(sourceMesh);
    return index;
  }

  /// Where the morph weights of a node begin; −1 when its mesh has no targets.
  int addWeights(const tinygltf::Node& source, int mesh) {
    std::size_t count = 0;
    for (const Primitive& primitive : context_.scene.meshes[static_cast<std::size_t>(mesh)].primitives)
      count = std::max(count, primitive.targets.size());
    if (count == 0) return -1;
    const tinygltf::Mesh& sourceMesh = context_.model.meshes[static_cast<std::size_t>(source.mesh)];
    const std::vector<double>& weights = source.weights.empty() ? sourceMesh.weights : source.weights;
    std::vector<float>& all = context_.scene.morphWeights;
    const std::size_t first = all.size();
    if (first + count > kMaxWeights)
      throw Error(say<"the scene has more than %1 morph weights">(kMaxWeights));
    for (std::size_t i = 0; i < count; ++i)
      all.push_back(i < weights.size() ? static_cast<float>(weights[i]) : 0.0f);
    return static_cast<int>(first);
  }

  int sharedSkin(std::size_t skinIndex) {
    if (sceneSkin_[skinIndex] >= 0) return sceneSkin_[skinIndex];
    Skin skin = readSkin(skinIndex);
    joints_ += skin.joints.size();
    if (joints_ > kMaxJoints) throw Error(say<"the scene's skins have more than %1 joints">(kMaxJoints));
    context_.scene.skins.push_back(std::move(skin));
    return sceneSkin_[skinIndex] = static_cast<int>(context_.scene.skins.size()) - 1;
  }

  Skin readSkin(std::size_t skinIndex) const {
    const tinygltf::Skin& source = context_.model.skins.at(skinIndex);
    AccessorValues inverseBinds;
    if (source.inverseBindMatrices >= 0) {
      inverseBinds = readAccessor(context_.model, source.inverseBindMatrices);
      if (inverseBinds.components != 16 || inverseBinds.count() < source.joints.size() ||
          !inverseBinds.isFinite())
        throw Error(elementOf("skins", skinIndex) + ": " +
                    say<"%1 are not a finite 4×4 matrix for each joint">("inverseBindMatrices"));
    }
    Skin skin;
    for (std::size_t i = 0; i < source.joints.size(); ++i) {
      const int joint = context_.sceneNode.at(static_cast<std::size_t>(source.joints[i]));
      assert(joint >= 0); // addGltfNodes has brought it in
      skin.joints.push_back(joint);
      skin.inverseBinds.push_back(inverseBinds.values.empty() ? glm::mat4(1.0f)
                                                              : glm::make_mat4(&inverseBinds.values[16 * i]));
    }
    return skin;
  }

  /// Throws Error when a vertex asks for a joint the skin has not.
  void checkJoints(std::size_t sourceMesh, int mesh, int skin) const {
    const std::size_t count = context_.scene.skins[static_cast<std::size_t>(skin)].joints.size();
    const std::vector<Primitive>& primitives =
        context_.scene.meshes[static_cast<std::size_t>(mesh)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i)
      for (const Influence& influence : primitives[i].influences)
        for (int joint = 0; joint < 4; ++joint)
          if (!(influence.joints[joint] < static_cast<float>(count)))
            throw Error(elementOf("meshes", sourceMesh) + "." + elementOf("primitives", i) +
                        ".attributes.JOINTS_0: " +
                        say<"joint %1 is out of range; the skin has %2">(
                            static_cast<long long>(influence.joints[joint]), count));
  }

  void addInstances(const tinygltf::Value& attributes, std::size_t sourceNode, int mesh) {
    try {
      const auto read = [&](const char* name, int components) {
        if (!attributes.Has(name)) return AccessorValues{};
        AccessorValues values = readAccessor(context_.model, attributes.Get(name).GetNumberAsInt());
        if (values.components != components || !values.isFinite())
          throw Error(say<"%1 does not hold finite vectors of %2">(name, components));
        return values;
      };
      addInstances(read("TRANSLATION", 3), read("ROTATION", 4), read("SCALE", 3),
                   context_.scene.nodes[static_cast<std::size_t>(context_.sceneNode[sourceNode])], mesh);
    } catch (const Error& error) {
      throw Error(elementOf("nodes", sourceNode) + ".extensions.EXT_mesh_gpu_instancing: " + error.what());
    }
  }

  void addInstances(const AccessorValues& translations, const AccessorValues& rotations,
                    const AccessorValues& scales, Node& node, int mesh) {
    std::size_t count = 0;
    for (const AccessorValues* values : {&translations, &rotations, &scales}) {
      if (values->components == 0) continue;
      if (count != 0 && values->count() != count) throw Error(say<"its attributes have different counts">());
      count = values->count();
    }
    instances_ += count;
    if (instances_ > kMaxInstances) throw Error(say<"there are more than %1 instances">(kMaxInstances));
    std::vector<glm::mat4x3>& all = context_.scene.instances;
    node.mesh = mesh;
    node.firstInstance = static_cast<int>(all.size());
    node.instanceCount = static_cast<int>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const glm::vec4 q = rotations.components != 0 ? rotations.at(i) : glm::vec4(0, 0, 0, 1);
      glm::quat rotation(1.0f, 0.0f, 0.0f, 0.0f);
      if (const float length = glm::length(q); length > 0.0f)
        rotation = {q.w / length, q.x / length, q.y / length, q.z / length};
      all.push_back(
          instanceTransform(translations.components != 0 ? glm::vec3(translations.at(i)) : glm::vec3(0.0f),
                            rotation, scales.components != 0 ? glm::vec3(scales.at(i)) : glm::vec3(1.0f)));
    }
  }

  GltfContext& context_;
  std::vector<int> sceneMesh_; ///< for each mesh of the file its index in the scene, −1 when not built
  std::vector<int> sceneSkin_; ///< likewise for skins
  std::size_t instances_ = 0, joints_ = 0;
};

} // namespace

void addGltfMeshes(GltfContext& context) {
  MeshAdder meshes(context);
  for (std::size_t node = 0; node < context.model.nodes.size(); ++node) meshes.addTo(node);
  context.scene.instances.shrink_to_fit();
  context.scene.nodes.shrink_to_fit();
}

} // namespace taa
