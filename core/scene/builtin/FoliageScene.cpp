// builtin:foliage: grass, reeds and leaves in the wind: vertices that sway in the shader, leaves cut out by
// alpha.
#include "core/scene/builtin/BuiltinScenes.h"
#include "core/scene/builtin/ProceduralTextures.h"
#include "core/scene/builtin/SceneBuilder.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace taa {

namespace {

/// The wind's frequency in whole waves a loop of four seconds, so that the shot's end is its start.
Wind windOf(float amplitude, float waveNumber, int wavesInLoop, const glm::vec3& direction) {
  return {amplitude, waveNumber, kTurn * static_cast<float>(wavesInLoop) / 4.0f, direction};
}

/// How far up a vertex is decides how far it sways.
void bendByHeight(Primitive& primitive, float height) {
  for (Vertex& vertex : primitive.vertices) {
    const float t = glm::clamp(vertex.position.y / height, 0.0f, 1.0f);
    vertex.uv1 = {0.0f, t * t};
  }
}

/// Narrow pointed blades spread by the R2 sequence.
Primitive blades(int count, float height, float width, int seed, int material) {
  MeshBuilder mesh;
  for (int i = 0; i < count; ++i) {
    const float n = static_cast<float>(i + 31 * seed);
    const float angle = kTurn * glm::fract(0.6180340f * n),
                tall = height * (0.6f + 0.4f * glm::fract(0.3819660f * n));
    const glm::vec3 root(-5.0f + 10.0f * glm::fract(0.7548777f * n), 0.0f,
                         -7.5f + 8.5f * glm::fract(0.5698403f * n));
    const glm::vec3 across = width * glm::vec3(std::cos(angle), 0.0f, std::sin(angle));
    const glm::vec3 lean = 0.25f * tall * glm::vec3(std::sin(angle), 0.0f, std::cos(angle));
    const glm::vec3 middle = root + glm::vec3(0, 0.55f * tall, 0) + 0.4f * lean;
    const glm::vec3 tip = root + glm::vec3(0, tall, 0) + lean;
    mesh.face(root - across, root + across, middle + 0.7f * across);
    mesh.face(root - across, middle + 0.7f * across, middle - 0.7f * across);
    mesh.face(middle - 0.7f * across, middle + 0.7f * across, tip);
  }
  Primitive primitive = mesh.build(material);
  bendByHeight(primitive, height);
  return primitive;
}

/// A leaf with its ribs, alpha 0 around it.
SceneImage leafImage() {
  constexpr int kSize = 128;
  SceneImage image{"leaf", kSize, kSize, {}};
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / kSize - 0.5f,
                  v = 1.0f - (static_cast<float>(y) + 0.5f) / kSize;
      const float half = 0.42f * std::sin(3.1415927f * std::sqrt(v)) * (1.0f - 0.25f * v);
      const bool isRib =
          std::abs(u) < 0.012f || std::abs(glm::fract(6.0f * (v - 0.7f * std::abs(u))) - 0.5f) < 0.05f;
      const float shade = isRib ? 0.75f : 0.5f + 0.12f * std::sin(40.0f * u) * std::sin(31.0f * v);
      for (const float channel : {0.55f * shade, shade, 0.22f * shade})
        image.rgba.push_back(static_cast<std::uint8_t>(std::lround(255.0f * channel)));
      image.rgba.push_back(std::abs(u) < half ? 255 : 0);
    }
  return image;
}

/// A bush of leaf cards around its middle.
Primitive bush(const glm::vec3& place, float size, int cards, int material) {
  MeshBuilder mesh;
  for (int i = 0; i < cards; ++i) {
    const float n = static_cast<float>(i);
    const float turn = kTurn * glm::fract(0.7548777f * n), up = 0.1f + 0.9f * glm::fract(0.5698403f * n);
    const glm::vec3 out(std::cos(turn), 0.0f, std::sin(turn));
    const glm::vec3 at =
        place + size * (0.75f * std::sqrt(1.0f - up * up * 0.8f) * out + glm::vec3(0, 1.4f * up, 0));
    const glm::vec3 right =
        0.22f * size * glm::normalize(glm::vec3(-out.z, 0.3f * std::sin(5.0f * n), out.x));
    const glm::vec3 rise = 0.26f * size * glm::normalize(out + glm::vec3(0, 1.2f, 0));
    mesh.quad(at - 0.5f * right, right, rise);
  }
  Primitive primitive = mesh.build(material);
  bendByHeight(primitive, place.y + 1.6f * size);
  return primitive;
}

Material leafy(const glm::vec3& color, const Wind& wind) {
  Material material = paintOf(color, 0.7f);
  material.doubleSided = true;
  material.wind = wind;
  return material;
}

} // namespace

Scene makeFoliageScene() {
  SceneBuilder builder("builtin:foliage");
  Material meadow = paintOf({0.7f, 0.75f, 0.6f}, 1.0f);
  meadow.baseColorTexture = textureSlot(builder.addImage(grassImage()));
  MeshBuilder ground;
  ground.quad({-30.0f, 0.0f, 8.0f}, {60.0f, 0, 0}, {0, 0, -68.0f}, {24.0f, 27.0f});
  builder.addObject("ground", {ground.build(builder.addMaterial(meadow))});
  const glm::vec3 east(1.0f, -0.1f, 0.2f);
  const int grass = builder.addMaterial(leafy({0.16f, 0.36f, 0.06f}, windOf(0.10f, 1.3f, 6, east))),
            straw = builder.addMaterial(leafy({0.55f, 0.46f, 0.18f}, windOf(0.16f, 0.9f, 5, east)));
  builder.addObject("grass", {blades(3200, 0.42f, 0.012f, 1, grass)});
  builder.addObject("reeds", {blades(420, 1.15f, 0.008f, 4, straw)});
  Material leaf = leafy(glm::vec3(1.0f), windOf(0.09f, 2.0f, 8, east));
  leaf.baseColorTexture = textureSlot(builder.addImage(leafImage()));
  leaf.alphaMode = AlphaMode::Mask;
  const int leaves = builder.addMaterial(leaf),
            bark = builder.addMaterial(paintOf({0.16f, 0.1f, 0.06f}, 0.9f));
  builder.addObject("bushes", {bush({-2.3f, 0.2f, -2.6f}, 1.0f, 700, leaves),
                               bush({2.7f, 0.1f, -3.6f}, 1.2f, 700, leaves),
                               bush({0.6f, 0.2f, -6.8f}, 1.5f, 700, leaves)});
  MeshBuilder trunks;
  for (const glm::vec3 foot :
       {glm::vec3(-2.3f, 0, -2.6f), glm::vec3(2.7f, 0, -3.6f), glm::vec3(0.6f, 0, -6.8f)}) {
    const std::array<glm::vec3, 2> trunk{{foot + glm::vec3(0, 1.3f, 0), foot}};
    trunks.tube(trunk, 0.05f, 10);
  }
  builder.addObject("trunks", {trunks.build(bark)});
  const glm::vec3 eye(0.0f, 0.95f, 3.1f);
  const int camera = builder.addCamera("meadow", eye, {0.0f, -0.05f, -1.0f}, 0.85f);
  builder.animateLoop(
      camera, 4.0f, [&](float angle) { return eye + glm::vec3(0.15f * std::sin(angle), 0, 0); },
      [](float angle) { return glm::vec3(0.15f * std::cos(angle), 0, 0); });
  Scene& scene = builder.scene();
  scene.sky.sunDirection = {-0.5f, 0.7f, 0.35f};
  scene.sky.sunColor = {3.4f, 3.0f, 2.3f};
  scene.sky.shadowed = {{-9.0f, 0.0f, -14.0f}, {9.0f, 4.0f, 4.0f}}; // not of the meadow to its end
  scene.shot = {240, 60.0, "gltf:meadow", {}};
  return builder.finish();
}

} // namespace taa
