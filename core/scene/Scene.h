// A scene as data: what a glTF file or a procedural builder makes and the renderer draws. No GL.
#pragma once

#include "core/scene/MotionMode.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace taa {

/// An axis-aligned box, world or model space as the owner says; empty until something is added.
struct Bounds {
  glm::vec3 min{std::numeric_limits<float>::max()};
  glm::vec3 max{std::numeric_limits<float>::lowest()};
  bool isEmpty() const { return min.x > max.x; }
  glm::vec3 center() const { return 0.5f * (min + max); }
  float radius() const { return isEmpty() ? 0.0f : 0.5f * glm::length(max - min); }
  void add(const glm::vec3& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }
};

/// 8-bit RGBA, row 0 at v = 0 (the top of the file's picture, as glTF has it). Whether the bytes are sRGB or
/// linear is decided by the slot of the material that uses it.
struct SceneImage {
  std::string name;
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

enum class Filter : std::uint8_t { Nearest, Linear };
enum class Mipmaps : std::uint8_t { None, Nearest, Linear };
enum class Wrap : std::uint8_t { Repeat, MirroredRepeat, ClampToEdge };

struct SamplerSettings {
  Filter magnify = Filter::Linear, minify = Filter::Linear;
  Mipmaps mipmaps = Mipmaps::Linear;
  Wrap wrapU = Wrap::Repeat, wrapV = Wrap::Repeat;
  bool operator==(const SamplerSettings&) const = default;
};

/// One texture slot of a material.
struct TextureSlot {
  int image = -1; ///< into Scene::images; −1: no texture, the slot's factor alone
  SamplerSettings sampler;
  int uvSet = 0;            ///< 0 or 1
  glm::mat3 uvFromUv{1.0f}; ///< KHR_texture_transform as a matrix on (u, v, 1)
};

enum class AlphaMode : std::uint8_t { Opaque, Mask, Blend }; ///< how Blend is drawn is a setting

/// Vertices that sway: each moves by direction · amplitude · uv1.y · sin(waveNumber·(x + z) + frequency·t) in
/// model space (catalogue 3.7).
struct Wind {
  float amplitude = 0.0f;  ///< model units; 0: still
  float waveNumber = 0.0f; ///< radians a model unit
  float frequency = 0.0f;  ///< radians a second
  glm::vec3 direction{1.0f, 0.0f, 0.0f};
};

/// A picture that changes on a surface that does not: cells of an atlas one after another, row by row, and a
/// steady shift (catalogue 21.7). Of the first uv set, before the slots' own transforms.
struct UvAnimation {
  int columns = 1, rows = 1;
  float cellsPerSecond = 0.0f;
  glm::vec2 scroll{0.0f}; ///< uv a second
  bool operator==(const UvAnimation&) const = default;
};

struct Material {
  std::string name;
  glm::vec4 baseColor{1.0f}; ///< linear
  float metallic = 1.0f, roughness = 1.0f;
  glm::vec3 emissive{0.0f}; ///< linear, KHR_materials_emissive_strength multiplied in
  float normalScale = 1.0f, occlusionStrength = 1.0f;
  AlphaMode alphaMode = AlphaMode::Opaque;
  float alphaCutoff = 0.5f;
  bool doubleSided = false;
  bool unlit = false;      ///< KHR_materials_unlit
  bool responsive = false; ///< changes without motion that could be followed: screens, particles
  Wind wind;
  UvAnimation uvAnimation;
  TextureSlot baseColorTexture, metallicRoughnessTexture, normalTexture, occlusionTexture, emissiveTexture;
};

/// Interleaved as the vertex buffer holds it.
struct Vertex {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f, 0.0f, 1.0f};
  glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f}; ///< w: sign of the bitangent
  glm::vec2 uv0{0.0f}, uv1{0.0f};
  glm::vec4 color{1.0f}; ///< linear
};

enum class Topology : std::uint8_t {
  Triangles,
  Lines,
  Points
}; ///< strips, fans and loops are unrolled by the loader

/// Four of the joints that move a vertex, and how much.
struct Influence {
  glm::vec4 joints{0.0f};  ///< into Skin::joints, whole numbers
  glm::vec4 weights{0.0f}; ///< their sum over all sets of a vertex is 1
};

/// What a morph target of weight 1 adds to a vertex.
struct MorphDelta {
  glm::vec3 position{0.0f}, normal{0.0f}, tangent{0.0f};
};

/// Positions baked for each vertex, frame after frame, as Alembic has them (catalogue 3.6).
struct VertexCache {
  struct Entry {
    glm::vec3 position{0.0f}, normal{0.0f};
    glm::vec3 velocity{0.0f}; ///< model units a second
  };
  int frames = 0;               ///< 0: none; they repeat
  double framesPerSecond = 0.0; ///< 0: always the first
  std::vector<Entry> entries;   ///< frames × vertices
};

struct Primitive {
  Topology topology = Topology::Triangles;
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;           ///< always given
  int material = 0;                             ///< into Scene::materials, always valid
  Bounds bounds;                                ///< model space, undeformed
  int influenceSets = 0;                        ///< 0 to 2; 0: no skin moves it
  std::vector<Influence> influences;            ///< influenceSets for each vertex
  std::vector<std::vector<MorphDelta>> targets; ///< one delta a vertex each
  VertexCache cache;
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
};

struct Node {
  std::string name;
  int parent = -1; ///< into Scene::nodes, smaller than the node's own index (parents come first); −1: a root
  glm::vec3 translation{0.0f};
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 scale{1.0f};
  glm::mat4 matrix{1.0f}; ///< used instead of translation, rotation and scale when `hasMatrix`
  bool hasMatrix = false;
  int mesh = -1, camera = -1, light = -1;
  int skin = -1;        ///< into Scene::skins; the node's own transform does not count then
  int firstWeight = -1; ///< into Scene::morphWeights, one for each target of the mesh; −1: it has none
  MotionMode motionMode = MotionMode::PerObject;
  // Its children appear, vanish and jump with it.
  double visibleFrom = 0.0;                                      ///< seconds; it is drawn from then on …
  double visibleUntil = std::numeric_limits<double>::infinity(); ///< … and not any more from then on
  std::vector<double> teleports; ///< seconds at which it jumps to another place, which is no motion
};

struct Skin {
  std::vector<int> joints;             ///< into Scene::nodes
  std::vector<glm::mat4> inverseBinds; ///< joint from model, one for each joint
};

enum class Interpolation : std::uint8_t { Step, Linear, CubicSpline };
enum class AnimationPath : std::uint8_t { Translation, Rotation, Scale, Weights };

struct AnimationChannel {
  int node = -1;
  AnimationPath path = AnimationPath::Translation;
  Interpolation interpolation = Interpolation::Linear;
  std::vector<float> times;      ///< seconds, strictly rising
  std::vector<glm::vec4> values; ///< one a key (rotation x, y, z, w); three a key for cubic splines:
                                 ///< in-tangent, value, out-tangent
  int weightCount = 0;           ///< of path Weights: how many a value has
  std::vector<float> weights{};  ///< the values of path Weights, which leaves `values` empty
};

struct Animation {
  std::string name;
  float duration = 0.0f; ///< seconds; the animation repeats after it
  std::vector<AnimationChannel> channels;
};

struct SceneCamera {
  std::string name;
  int node = -1;
  bool orthographic = false;
  float fovY = 0.8f;   ///< radians, perspective
  float height = 2.0f; ///< world units from bottom to top, orthographic
  float nearPlane = 0.01f;
  float farPlane = 0.0f; ///< orthographic only; perspective is infinite
};

enum class LightKind : std::uint8_t { Directional, Point, Spot };

struct Light {
  LightKind kind = LightKind::Directional;
  int node = -1; ///< shines along the node's −z
  glm::vec3 color{1.0f};
  float intensity = 1.0f;                                   ///< lux (directional) or candela
  float range = 0.0f;                                       ///< 0: unlimited
  float innerConeAngle = 0.0f, outerConeAngle = 0.7853982f; ///< radians, spot
};

/// The sky: a vertical gradient and a sun disk, radiance in scene-referred linear units.
struct Sky {
  glm::vec3 zenith{0.18f, 0.32f, 0.62f}, horizon{0.62f, 0.70f, 0.80f}, ground{0.16f, 0.15f, 0.14f};
  glm::vec3 sunDirection{0.4f, 0.8f, 0.45f}; ///< to the sun; need not be normalized
  glm::vec3 sunColor{2.5f, 2.35f,
                     2.1f}; ///< irradiance; the sky lights scenes that bring no light of their own
  bool sunEnabled = true;
};

/// How long a scene is and what is asked for first.
struct Shot {
  int frames = 240;
  double framesPerSecond = 60.0;
  std::string camera = "orbit"; ///< camera path it opens with
  std::vector<int> cuts;        ///< frames at which the history starts anew, besides frame 0
};

struct Scene {
  std::string name;
  std::vector<SceneImage> images;
  std::vector<Material> materials; ///< at least one
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<Skin> skins;
  std::vector<float> morphWeights;   ///< at rest, of all nodes one after another
  std::vector<Animation> animations; ///< the first one plays
  std::vector<SceneCamera> cameras;
  std::vector<Light> lights;
  Sky sky;
  Shot shot;
  Bounds bounds;                     ///< world space, at rest
  std::vector<std::string> warnings; ///< sentences about what was left out, for the user
};

} // namespace taa
