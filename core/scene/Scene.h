// A scene as data: what a glTF file or a procedural builder makes and the renderer draws. No GL.
#pragma once

#include "core/scene/Material.h"
#include "core/scene/Mesh.h"
#include "core/scene/MotionMode.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace taa {

struct Node {
  std::string name;
  int parent = -1; ///< into Scene::nodes, smaller than the node's own index (parents come first); −1: a root
  glm::vec3 translation{0.0f};
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 scale{1.0f};
  glm::mat4 matrix{1.0f}; ///< used instead of translation, rotation and scale when `hasMatrix`
  bool hasMatrix = false;
  int mesh = -1, camera = -1, light = -1;
  int firstInstance = -1; ///< into Scene::instances, where its mesh is drawn; −1: once, at the node itself
  int instanceCount = 0;  ///< how many of them
  int skin = -1;          ///< into Scene::skins; the node's own transform does not count then
  std::uint32_t capturedId = 0; ///< of a capture: what the object's pixels have as object id; 0: none
  int firstWeight = -1; ///< into Scene::morphWeights, one for each target of the mesh; −1: it has none
  MotionMode motionMode = MotionMode::PerObject;
  // Its children appear, vanish and jump with it.
  double visibleFrom = 0.0;                                      ///< seconds; it is drawn from then on …
  double visibleUntil = std::numeric_limits<double>::infinity(); ///< … and not any more from then on
  std::vector<double> teleports; ///< seconds at which it jumps to another place, which is no motion

  /// How often its mesh is drawn.
  int timesDrawn() const { return mesh < 0 ? 0 : firstInstance < 0 ? 1 : instanceCount; }
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
inline constexpr int kMaxLights = 64; ///< of a scene, the sun among them

/// How the shadows of a scene's sun look where nobody says it.
enum class SunShadows : std::uint8_t { None, Hard, Soft };

/// The sky: a vertical gradient and a sun disk, radiance in scene-referred linear units.
struct Sky {
  glm::vec3 zenith{0.18f, 0.32f, 0.62f}, horizon{0.62f, 0.70f, 0.80f}, ground{0.16f, 0.15f, 0.14f};
  glm::vec3 sunDirection{0.4f, 0.8f, 0.45f}; ///< to the sun; need not be normalized
  glm::vec3 sunColor{2.5f, 2.35f,
                     2.1f}; ///< irradiance; the sky lights scenes that bring no light of their own
  bool sunEnabled = true;
  SunShadows shadows = SunShadows::None;
  Bounds shadowed; ///< around what casts shadows and what they fall on, world space; empty: Scene::bounds
};

/// A cone of fog in the beam of a lamp, equally dense everywhere.
struct FogCone {
  int node = -1;                              ///< middle of its small end; it opens along the node's −z
  float length = 1.0f;                        ///< m
  float startRadius = 0.0f, endRadius = 1.0f; ///< m; the end is not the smaller one
  float density = 0.1f;                       ///< extinction, 1/m
  glm::vec3 light{1.0f};                      ///< radiance that endless fog would have at the small end
  float fading = 0.0f;                        ///< share of it that is lost on the way to the large end
};
inline constexpr int kMaxFogCones = 4; ///< of a scene

/// How long a scene is and what is asked for first.
struct Shot {
  int frames = 240;
  double framesPerSecond = 60.0;
  std::string camera = "orbit"; ///< camera path it opens with
  std::vector<int> cuts;        ///< frames at which the history starts anew, besides frame 0
  int loopFrames = 0;           ///< after which camera paths come round; 0: after the shot

  int cameraLoopFrames() const { return loopFrames > 0 ? loopFrames : frames; }
};

struct Scene {
  std::string name;
  std::vector<SceneImage> images;
  std::vector<Material> materials; ///< at least one
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<glm::mat4x3> instances; ///< node from instance, of all nodes one after another
  std::vector<Skin> skins;
  std::vector<float> morphWeights;         ///< at rest, of all nodes one after another
  std::vector<Animation> animations;       ///< all of them play, each in a loop; later ones move over earlier
  std::vector<std::string> animationNames; ///< that could be chosen, those that do not play included
  std::vector<SceneCamera> cameras;
  std::vector<Light> lights;
  std::vector<FogCone> fog; ///< at most kMaxFogCones
  Sky sky;
  Shot shot;
  Bounds bounds;                     ///< world space, at rest
  std::vector<std::string> warnings; ///< sentences about what was left out, for the user
};

} // namespace taa
