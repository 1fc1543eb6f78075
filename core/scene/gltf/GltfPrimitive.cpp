#include "core/scene/gltf/GltfPrimitive.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/json/JsonFields.h"
#include "core/scene/Geometry.h"
#include "core/scene/gltf/GltfAccessor.h"
#include "core/scene/gltf/GltfContext.h"

#include <tiny_gltf.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa {

namespace {

constexpr std::size_t kMaxVertices = 20'000'000, kMaxIndices = 100'000'000; ///< of all meshes together

/// `place` is what brought the last of the scene's vertices.
void requireFewVertices(const GltfContext& context, const std::string& place) {
  if (context.vertices > kMaxVertices)
    throw Error(place + ": " +
                say<"with these the scene has %1 vertices, more than the %2 that can be opened">(
                    context.vertices, kMaxVertices));
}

/// Reads attributes of one primitive and checks that they belong together.
class AttributeReader {
 public:
  AttributeReader(GltfContext& context, const tinygltf::Primitive& source)
      : context_(context), source_(source) {}

  /// Null when the primitive has no such attribute.
  std::optional<AccessorValues> read(const char* name, int minComponents, int maxComponents) {
    const auto found = source_.attributes.find(name);
    if (found == source_.attributes.end()) return std::nullopt;
    AccessorValues values = readAccessor(context_.model, found->second);
    const std::string place = std::string("attributes.") + name + ": ";
    if (values.components < minComponents || values.components > maxComponents)
      throw Error(place + say<"it has %1 components">(values.components));
    if (count_ == 0) count_ = values.count();
    if (values.count() != count_)
      throw Error(place + say<"it has %1 elements where POSITION has %2">(values.count(), count_));
    return values;
  }

  /// As `read`, with values that are not finite replaced by 0.
  std::optional<AccessorValues> readTame(const char* name, int minComponents, int maxComponents) {
    std::optional<AccessorValues> values = read(name, minComponents, maxComponents);
    if (values && !values->isFinite()) {
      context_.warn(say<"Values of %1 that are not numbers are taken for 0.">(name));
      for (float& value : values->values) value = std::isfinite(value) ? value : 0.0f;
    }
    return values;
  }

 private:
  GltfContext& context_;
  const tinygltf::Primitive& source_;
  std::size_t count_ = 0; ///< of vertices; 0 until the first attribute is read
};

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& fallback) {
  const float length = glm::length(v);
  return std::isfinite(length) && length > 0.0f ? v / length : fallback;
}

/// What else than vertices the attributes tell.
struct GivenAttributes {
  bool normals = false, tangents = false;
};

void readPositions(GltfContext& context, AttributeReader& attributes, Primitive& primitive) {
  const std::optional<AccessorValues> positions = attributes.read("POSITION", 3, 3);
  if (!positions) return;
  if (!positions->isFinite())
    throw Error("attributes.POSITION: " + say<"a position is not a finite number">());
  context.vertices += positions->count();
  requireFewVertices(context, "attributes.POSITION");
  primitive.vertices.resize(positions->count());
  for (std::size_t i = 0; i < primitive.vertices.size(); ++i)
    primitive.vertices[i].position = glm::vec3(positions->at(i));
}

GivenAttributes readSurface(AttributeReader& attributes, std::vector<Vertex>& vertices) {
  GivenAttributes given;
  if (const auto normals = attributes.readTame("NORMAL", 3, 3)) {
    given.normals = true;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      vertices[i].normal = unitOr(glm::vec3(normals->at(i)), {0, 1, 0});
  }
  if (const auto tangents = attributes.readTame("TANGENT", 4, 4)) {
    given.tangents = given.normals; // glTF: without normals, tangents do not count
    for (std::size_t i = 0; i < vertices.size(); ++i)
      vertices[i].tangent =
          glm::vec4(unitOr(glm::vec3(tangents->at(i)), {1, 0, 0}), tangents->at(i).w < 0.0f ? -1.0f : 1.0f);
  }
  if (const auto uvs = attributes.readTame("TEXCOORD_0", 2, 2))
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i].uv0 = glm::vec2(uvs->at(i));
  if (const auto uvs = attributes.readTame("TEXCOORD_1", 2, 2))
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i].uv1 = glm::vec2(uvs->at(i));
  if (const auto colors = attributes.readTame("COLOR_0", 3, 4))
    for (std::size_t i = 0; i < vertices.size(); ++i)
      vertices[i].color =
          glm::vec4(glm::vec3(colors->at(i)), colors->components == 4 ? colors->at(i).w : 1.0f);
  return given;
}

/// Joints and weights, up to two sets of four; what weighs nothing follows its first joint.
void readInfluences(AttributeReader& attributes, Primitive& primitive) {
  const std::size_t count = primitive.vertices.size();
  std::vector<std::pair<AccessorValues, AccessorValues>> sets;
  for (const char* set : {"0", "1"}) {
    auto joints = attributes.readTame((std::string("JOINTS_") + set).c_str(), 4, 4);
    auto weights = attributes.readTame((std::string("WEIGHTS_") + set).c_str(), 4, 4);
    if (!joints || !weights) break;
    sets.emplace_back(std::move(*joints), std::move(*weights));
  }
  primitive.influenceSets = static_cast<int>(sets.size());
  for (std::size_t vertex = 0; vertex < count && !sets.empty(); ++vertex) {
    const std::size_t first = primitive.influences.size();
    float sum = 0.0f;
    for (const auto& [joints, weights] : sets) {
      const glm::vec4 weight = weights.at(vertex);
      sum += weight.x + weight.y + weight.z + weight.w;
      primitive.influences.push_back({glm::max(glm::floor(joints.at(vertex)), glm::vec4(0.0f)), weight});
    }
    for (std::size_t i = first; i < primitive.influences.size(); ++i)
      primitive.influences[i].weights =
          sum > 0.0f ? primitive.influences[i].weights / sum : glm::vec4(i == first ? 1.0f : 0.0f, 0, 0, 0);
  }
}

/// Deltas of one attribute of one target.
void readDeltas(GltfContext& context, const std::map<std::string, int>& target, const char* name,
                glm::vec3 MorphDelta::*member, std::vector<MorphDelta>& deltas) {
  const auto found = target.find(name);
  if (found == target.end()) return;
  const AccessorValues values = readAccessor(context.model, found->second);
  if (values.components != 3 || values.count() != deltas.size() || !values.isFinite())
    throw Error(name +
                (": " + say<"it is not a finite vector of 3 for each of the %1 vertices">(deltas.size())));
  for (std::size_t i = 0; i < deltas.size(); ++i) deltas[i].*member = glm::vec3(values.at(i));
}

void readTargets(GltfContext& context, const tinygltf::Primitive& source, Primitive& primitive) {
  // As vec4 for position, normal and tangent in one storage block, which every driver lets have 128 MiB.
  constexpr std::size_t kMaxDeltas = (std::size_t(128) << 20) / 48;
  if (source.targets.size() * primitive.vertices.size() > kMaxDeltas)
    throw Error("targets: " + say<"they have more than %1 vertices together">(kMaxDeltas));
  context.vertices += source.targets.size() * primitive.vertices.size();
  requireFewVertices(context, "targets");
  for (std::size_t i = 0; i < source.targets.size(); ++i) try {
      std::vector<MorphDelta>& deltas = primitive.targets.emplace_back(primitive.vertices.size());
      readDeltas(context, source.targets[i], "POSITION", &MorphDelta::position, deltas);
      readDeltas(context, source.targets[i], "NORMAL", &MorphDelta::normal, deltas);
      readDeltas(context, source.targets[i], "TANGENT", &MorphDelta::tangent, deltas);
    } catch (const Error& error) {
      throw Error(elementOf("targets", i) + "." + error.what());
    }
}

/// Velocities as a cache of one frame; its positions and normals are taken once they are final.
void readVelocities(AttributeReader& attributes, Primitive& primitive) {
  const auto velocities = attributes.readTame("_VELOCITY", 3, 3);
  if (!velocities) return;
  primitive.cache.frames = 1;
  for (std::size_t i = 0; i < primitive.vertices.size(); ++i)
    primitive.cache.entries.push_back({{}, {}, glm::vec3(velocities->at(i))});
}

void finishVelocities(Primitive& primitive) {
  for (std::size_t i = 0; i < primitive.cache.entries.size(); ++i) {
    primitive.cache.entries[i].position = primitive.vertices[i].position;
    primitive.cache.entries[i].normal = primitive.vertices[i].normal;
  }
}

std::vector<std::uint32_t> readVertexOrder(const GltfContext& context, const tinygltf::Primitive& source,
                                           std::size_t vertexCount) {
  if (source.indices < 0) {
    std::vector<std::uint32_t> order(vertexCount);
    std::iota(order.begin(), order.end(), 0u);
    return order;
  }
  std::vector<std::uint32_t> order = readIndices(context.model, source.indices);
  for (const std::uint32_t index : order)
    if (index >= vertexCount)
      throw Error("indices: " + say<"vertex %1 is out of range; there are %2">(index, vertexCount));
  return order;
}

/// Writes strips, fans and loops as single lines and triangles (glTF 2.0 §3.7.2.1); what is left over is
/// dropped.
void unroll(const std::vector<std::uint32_t>& order, int mode, Primitive& primitive) {
  std::vector<std::uint32_t>& out = primitive.indices;
  const std::size_t n = order.size();
  const auto add = [&](std::initializer_list<std::size_t> corners) {
    for (const std::size_t corner : corners) out.push_back(order[corner]);
  };
  switch (mode) {
  case TINYGLTF_MODE_POINTS:
    primitive.topology = Topology::Points;
    out = order;
    break;
  case TINYGLTF_MODE_LINE:
  case TINYGLTF_MODE_LINE_LOOP:
  case TINYGLTF_MODE_LINE_STRIP:
    primitive.topology = Topology::Lines;
    for (std::size_t i = 0; i + 1 < n; i += mode == TINYGLTF_MODE_LINE ? 2 : 1) add({i, i + 1});
    if (mode == TINYGLTF_MODE_LINE_LOOP && n > 1) add({n - 1, 0});
    break;
  case TINYGLTF_MODE_TRIANGLES:
    for (std::size_t i = 0; i + 2 < n; i += 3) add({i, i + 1, i + 2});
    break;
  case TINYGLTF_MODE_TRIANGLE_STRIP:
    for (std::size_t i = 0; i + 2 < n; ++i) add({i, i + 1 + i % 2, i + 2 - i % 2});
    break;
  case TINYGLTF_MODE_TRIANGLE_FAN:
    for (std::size_t i = 0; i + 2 < n; ++i) add({i + 1, i + 2, 0});
    break;
  default:
    throw Error("mode: " + say<"%1 does not exist">(mode));
  }
}

/// Makes the normals and tangents that the file leaves out.
void complete(GltfContext& context, const GivenAttributes& given, Primitive& primitive) {
  if (!given.normals) {
    context.vertices -= primitive.vertices.size(); // flat triangles share none: each corner becomes one
    context.vertices += primitive.indices.size();
    requireFewVertices(context, "attributes.NORMAL");
    makeFlatNormals(primitive);
  }
  const TextureSlot& normalMap =
      context.scene.materials[static_cast<std::size_t>(primitive.material)].normalTexture;
  if (!given.tangents && normalMap.image >= 0) makeTangents(primitive, normalMap);
}

} // namespace

Primitive readPrimitive(GltfContext& context, const tinygltf::Primitive& source) {
  Primitive primitive;
  const int defaultMaterial = static_cast<int>(context.scene.materials.size()) - 1;
  primitive.material = source.material < 0 ? defaultMaterial : source.material;
  AttributeReader attributes(context, source);
  readPositions(context, attributes, primitive);
  if (primitive.vertices.empty()) return primitive;
  const GivenAttributes given = readSurface(attributes, primitive.vertices);
  readInfluences(attributes, primitive);
  readTargets(context, source, primitive);
  readVelocities(attributes, primitive);
  const std::vector<std::uint32_t> order = readVertexOrder(context, source, primitive.vertices.size());
  context.indices += 3 * order.size();
  if (context.indices > kMaxIndices)
    throw Error("indices: " +
                say<"with these the scene has more than the %1 that can be opened">(kMaxIndices));
  unroll(order, source.mode < 0 ? TINYGLTF_MODE_TRIANGLES : source.mode, primitive);
  complete(context, given, primitive);
  finishVelocities(primitive);
  updateBounds(primitive);
  return primitive;
}

} // namespace taa
