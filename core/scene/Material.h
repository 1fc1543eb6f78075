// How surfaces look: images, texture slots and materials, as data.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace taa {

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
/// model space (manual 3.7).
struct Wind {
  float amplitude = 0.0f;  ///< model units; 0: still
  float waveNumber = 0.0f; ///< radians a model unit
  float frequency = 0.0f;  ///< radians a second
  glm::vec3 direction{1.0f, 0.0f, 0.0f};
};

/// A picture that changes on a surface that does not: cells of an atlas one after another, row by row, and a
/// steady shift (manual 21.7). Of the first uv set, before the slots' own transforms.
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

} // namespace taa
