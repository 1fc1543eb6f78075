#include "core/scene/GltfPrimitive.h"

#include "core/base/Error.h"
#include "core/scene/Geometry.h"
#include "core/scene/GltfAccessor.h"
#include "core/scene/GltfContext.h"

#include <tiny_gltf.h>

#include <cmath>
#include <numeric>
#include <optional>

namespace taa {

namespace {

constexpr std::size_t kMaxVertices = 20'000'000, kMaxIndices = 100'000'000; ///< of all meshes together

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
      throw Error(place + "it has " + std::to_string(values.components) + " components");
    if (count_ == 0) count_ = values.count();
    if (values.count() != count_)
      throw Error(place + "it has " + std::to_string(values.count()) + " elements where POSITION has " +
                  std::to_string(count_));
    return values;
  }

  /// As `read`, with values that are not finite replaced by 0.
  std::optional<AccessorValues> readTame(const char* name, int minComponents, int maxComponents) {
    std::optional<AccessorValues> values = read(name, minComponents, maxComponents);
    if (values && !values->isFinite()) {
      context_.warn(std::string("Values of ") + name + " that are not numbers are taken for 0.");
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
struct Given {
  bool normals = false, tangents = false;
};

void readPositions(GltfContext& context, AttributeReader& attributes, Primitive& primitive) {
  const std::optional<AccessorValues> positions = attributes.read("POSITION", 3, 3);
  if (!positions) return;
  if (!positions->isFinite()) throw Error("attributes.POSITION: a position is not a finite number");
  context.vertices += positions->count();
  if (context.vertices > kMaxVertices)
    throw Error("the scene has more than " + std::to_string(kMaxVertices) + " vertices");
  primitive.vertices.resize(positions->count());
  for (std::size_t i = 0; i < primitive.vertices.size(); ++i)
    primitive.vertices[i].position = glm::vec3(positions->at(i));
}

Given readSurface(AttributeReader& attributes, std::vector<Vertex>& vertices) {
  Given given;
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

/// The mean of the joints' matrices of one vertex; false when it has no weights.
bool addWeights(glm::mat4& matrix, const glm::vec4& joints, const glm::vec4& weights,
                std::span<const glm::mat4> worldFromSkin) {
  float sum = 0.0f;
  glm::mat4 blended(0.0f);
  for (int i = 0; i < 4; ++i) {
    const std::size_t joint = static_cast<std::size_t>(std::max(joints[i], 0.0f));
    if (joint >= worldFromSkin.size())
      throw Error("attributes.JOINTS_0: joint " + std::to_string(joint) + " is out of range; the skin has " +
                  std::to_string(worldFromSkin.size()));
    sum += weights[i];
    blended += weights[i] * worldFromSkin[joint];
  }
  if (!(sum > 0.0f)) return false;
  matrix = blended / sum;
  return true;
}

/// Puts the vertices into the skin's pose at rest; by the first four joints of each.
void applySkin(AttributeReader& attributes, std::vector<Vertex>& vertices,
               std::span<const glm::mat4> worldFromSkin) {
  const auto joints = attributes.readTame("JOINTS_0", 4, 4), weights = attributes.readTame("WEIGHTS_0", 4, 4);
  if (!joints || !weights) return;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    glm::mat4 matrix;
    if (!addWeights(matrix, joints->at(i), weights->at(i), worldFromSkin)) continue;
    Vertex& vertex = vertices[i];
    const glm::mat3 linear(matrix);
    vertex.position = glm::vec3(matrix * glm::vec4(vertex.position, 1.0f));
    vertex.normal = unitOr(linear * vertex.normal, vertex.normal);
    vertex.tangent =
        glm::vec4(unitOr(linear * glm::vec3(vertex.tangent), glm::vec3(vertex.tangent)), vertex.tangent.w);
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
      throw Error("indices: vertex " + std::to_string(index) + " is out of range; there are " +
                  std::to_string(vertexCount));
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
    throw Error("mode: " + std::to_string(mode) + " does not exist");
  }
}

/// Makes the normals and tangents that the file leaves out.
void complete(GltfContext& context, const Given& given, Primitive& primitive) {
  if (!given.normals) {
    context.vertices += primitive.indices.size(); // flat triangles share no vertices
    if (context.vertices > kMaxVertices)
      throw Error("the scene has more than " + std::to_string(kMaxVertices) + " vertices");
    makeFlatNormals(primitive);
  }
  const TextureSlot& normalMap =
      context.scene.materials[static_cast<std::size_t>(primitive.material)].normalTexture;
  if (!given.tangents && normalMap.image >= 0) makeTangents(primitive, normalMap);
}

} // namespace

Primitive readPrimitive(GltfContext& context, const tinygltf::Primitive& source,
                        std::span<const glm::mat4> worldFromSkin) {
  Primitive primitive;
  const int defaultMaterial = static_cast<int>(context.scene.materials.size()) - 1;
  primitive.material = source.material < 0 ? defaultMaterial : source.material;
  AttributeReader attributes(context, source);
  readPositions(context, attributes, primitive);
  if (primitive.vertices.empty()) return primitive;
  if (!source.targets.empty()) context.warn("Morph targets are not shown yet: the mesh keeps its own shape.");
  const Given given = readSurface(attributes, primitive.vertices);
  if (!worldFromSkin.empty()) applySkin(attributes, primitive.vertices, worldFromSkin);
  const std::vector<std::uint32_t> order = readVertexOrder(context, source, primitive.vertices.size());
  context.indices += 3 * order.size();
  if (context.indices > kMaxIndices)
    throw Error("the scene has more than " + std::to_string(kMaxIndices) + " indices");
  unroll(order, source.mode < 0 ? TINYGLTF_MODE_TRIANGLES : source.mode, primitive);
  complete(context, given, primitive);
  updateBounds(primitive);
  return primitive;
}

} // namespace taa
