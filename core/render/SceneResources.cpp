#include "core/render/SceneResources.h"

#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/gl/Context.h"
#include "shaders/shared/MaterialBlock.h"

#include <cassert>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>

namespace taa {

namespace {

constexpr std::array kAttributes = {
    gl::VertexAttribute{0, 3, offsetof(Vertex, position)},
    gl::VertexAttribute{1, 3, offsetof(Vertex, normal)},
    gl::VertexAttribute{2, 4, offsetof(Vertex, tangent)},
    gl::VertexAttribute{3, 2, offsetof(Vertex, uv0)},
    gl::VertexAttribute{4, 2, offsetof(Vertex, uv1)},
    gl::VertexAttribute{5, 4, offsetof(Vertex, color)},
};

gl::PrimitiveKind primitiveKind(Topology topology) {
  switch (topology) {
  case Topology::Triangles:
    return gl::PrimitiveKind::Triangles;
  case Topology::Lines:
    return gl::PrimitiveKind::Lines;
  case Topology::Points:
    return gl::PrimitiveKind::Points;
  }
  return gl::PrimitiveKind::Triangles;
}

gl::TextureWrap textureWrap(Wrap wrap) {
  switch (wrap) {
  case Wrap::Repeat:
    return gl::TextureWrap::Repeat;
  case Wrap::MirroredRepeat:
    return gl::TextureWrap::MirroredRepeat;
  case Wrap::ClampToEdge:
    return gl::TextureWrap::ClampToEdge;
  }
  return gl::TextureWrap::Repeat;
}

shared::MaterialBlock materialBlock(const Material& material) {
  shared::MaterialBlock block{};
  block.baseColor = material.baseColor;
  // Where the settings draw what blends as a mask, it is one at ½.
  block.emissive =
      glm::vec4(material.emissive, material.alphaMode == AlphaMode::Blend ? 0.5f : material.alphaCutoff);
  block.surface = {material.metallic, material.roughness, material.normalScale, material.occlusionStrength};
  for (int index = 0; index < kSlotCount; ++index) {
    const TextureSlot& slot = textureSlot(material, static_cast<Slot>(index));
    const glm::mat3 rows = glm::transpose(slot.uvFromUv);
    block.uvRows[2 * index] = glm::vec4(rows[0], static_cast<float>(slot.uvSet));
    block.uvRows[2 * index + 1] = glm::vec4(rows[1], 0.0f);
  }
  const Wind& wind = material.wind;
  block.wind = {wind.amplitude, wind.waveNumber, wind.frequency, 0.0f};
  block.windDirection = glm::vec4(wind.direction, 0.0f);
  return block;
}

bool isSrgb(Slot slot) {
  return slot == Slot::BaseColor || slot == Slot::Emissive;
}

/// Four floats for each vector, as a storage block of the shader has them.
gl::Buffer vectorBuffer(const std::vector<glm::vec4>& vectors, const std::string& label) {
  return vectors.empty() ? gl::Buffer()
                         : gl::Buffer(vectors.size() * sizeof(glm::vec4), vectors.data(), label);
}

gl::Buffer influenceBuffer(const Primitive& primitive) {
  std::vector<glm::vec4> vectors;
  for (const Influence& influence : primitive.influences) {
    vectors.push_back(influence.joints);
    vectors.push_back(influence.weights);
  }
  return vectorBuffer(vectors, "influences");
}

gl::Buffer deltaBuffer(const Primitive& primitive) {
  std::vector<glm::vec4> vectors;
  for (const std::vector<MorphDelta>& target : primitive.targets)
    for (const MorphDelta& delta : target) {
      vectors.emplace_back(delta.position, 0.0f);
      vectors.emplace_back(delta.normal, 0.0f);
      vectors.emplace_back(delta.tangent, 0.0f);
    }
  return vectorBuffer(vectors, "morph deltas");
}

gl::Buffer cacheBuffer(const Primitive& primitive) {
  std::vector<glm::vec4> vectors;
  for (const VertexCache::Entry& entry : primitive.cache.entries) {
    vectors.emplace_back(entry.position, 0.0f);
    vectors.emplace_back(entry.normal, 0.0f);
    vectors.emplace_back(entry.velocity, 0.0f);
  }
  return vectorBuffer(vectors, "vertex cache");
}

} // namespace

const TextureSlot& textureSlot(const Material& material, Slot slot) {
  switch (slot) {
  case Slot::BaseColor:
    return material.baseColorTexture;
  case Slot::MetallicRoughness:
    return material.metallicRoughnessTexture;
  case Slot::Normal:
    return material.normalTexture;
  case Slot::Occlusion:
    return material.occlusionTexture;
  case Slot::Emissive:
    return material.emissiveTexture;
  }
  return material.baseColorTexture;
}

unsigned textureMask(const Material& material) {
  unsigned mask = 0;
  for (unsigned slot = 0; slot < kSlotCount; ++slot)
    if (textureSlot(material, static_cast<Slot>(slot)).image >= 0) mask |= 1u << slot;
  return mask;
}

SceneResources::SceneResources(const Scene& scene, const Progress& progress) {
  uploadMeshes(scene, progress);
  uploadTextures(scene, progress);
  uploadMaterials(scene);
}

void SceneResources::uploadMeshes(const Scene& scene, const Progress& progress) {
  meshes_.resize(scene.meshes.size());
  deformations_.resize(scene.meshes.size());
  for (std::size_t index = 0; index < scene.meshes.size(); ++index) {
    report(progress, say<"Uploading meshes">(), static_cast<int>(index),
           static_cast<int>(scene.meshes.size()));
    for (const Primitive& primitive : scene.meshes[index].primitives) {
      deformations_[index].push_back(
          {influenceBuffer(primitive), deltaBuffer(primitive), cacheBuffer(primitive)});
      const bool isEmpty = primitive.vertices.empty() || primitive.indices.empty();
      meshes_[index].push_back(isEmpty ? gl::VertexMesh()
                                       : gl::VertexMesh(std::as_bytes(std::span(primitive.vertices)),
                                                        sizeof(Vertex), kAttributes, primitive.indices,
                                                        primitiveKind(primitive.topology),
                                                        "mesh: " + shownText(scene.meshes[index].name)));
    }
  }
}

// One after the other to its end, so that the progress tells of work done and a cancel waits for one only.
void SceneResources::uploadTextures(const Scene& scene, const Progress& progress) {
  for (const Material& material : scene.materials)
    for (int slot = 0; slot < kSlotCount; ++slot)
      if (const int image = textureSlot(material, static_cast<Slot>(slot)).image; image >= 0)
        textures_[{image, isSrgb(static_cast<Slot>(slot))}];
  int done = 0;
  const int total = static_cast<int>(textures_.size());
  for (auto& [key, texture] : textures_) {
    const SceneImage& image = scene.images[static_cast<std::size_t>(key.first)];
    report(progress, say<"Uploading textures">(), done, total);
    texture =
        gl::Texture({image.width, image.height, 0, 0}, key.second ? gl::Format::SRGBA8 : gl::Format::RGBA8,
                    "texture: " + shownText(image.name));
    texture.uploadBytes(image.rgba);
    report(progress, say<"Making mip levels">(), done, total);
    texture.generateMipmaps();
    gl::finish();
    ++done;
  }
}

void SceneResources::uploadMaterials(const Scene& scene) {
  const std::size_t alignment = gl::uniformAlignment();
  materialStride_ = (sizeof(shared::MaterialBlock) + alignment - 1) / alignment * alignment;
  std::vector<std::byte> blocks(materialStride_ * scene.materials.size());
  for (std::size_t index = 0; index < scene.materials.size(); ++index) {
    const Material& material = scene.materials[index];
    const shared::MaterialBlock block = materialBlock(material);
    std::memcpy(blocks.data() + index * materialStride_, &block, sizeof(block));
    std::array<BoundTexture, kSlotCount>& textures = materials_.emplace_back();
    for (int number = 0; number < kSlotCount; ++number) {
      const Slot slot = static_cast<Slot>(number);
      textures[static_cast<std::size_t>(number)] = texture(textureSlot(material, slot), isSrgb(slot));
    }
  }
  materialBlocks_ = gl::Buffer(blocks.size(), blocks.data(), "materials");
}

SceneResources::BoundTexture SceneResources::texture(const TextureSlot& slot, bool isSrgb) {
  if (slot.image < 0) return {};
  return {&textures_.at({slot.image, isSrgb}), &sampler(slot.sampler)};
}

const gl::Sampler& SceneResources::sampler(const SamplerSettings& settings) {
  for (const auto& [known, sampler] : samplers_)
    if (known == settings) return *sampler;
  gl::SamplerState state;
  state.magnifyLinear = settings.magnify == Filter::Linear;
  state.minifyLinear = settings.minify == Filter::Linear;
  state.mipmapped = settings.mipmaps != Mipmaps::None;
  state.mipmapLinear = settings.mipmaps == Mipmaps::Linear;
  state.wrapU = textureWrap(settings.wrapU);
  state.wrapV = textureWrap(settings.wrapV);
  return *samplers_.emplace_back(settings, std::make_unique<gl::Sampler>(state)).second;
}

void SceneResources::bindDeformation(gl::RenderPass& pass, int mesh, int primitive) const {
  const Deformation& deformation =
      deformations_[static_cast<std::size_t>(mesh)][static_cast<std::size_t>(primitive)];
  if (deformation.influences.bytes() > 0) pass.storageBlock(0, deformation.influences);
  if (deformation.deltas.bytes() > 0) pass.storageBlock(1, deformation.deltas);
  if (deformation.cache.bytes() > 0) pass.storageBlock(2, deformation.cache);
}

void SceneResources::bindMaterial(gl::RenderPass& pass, int material) const {
  const auto index = static_cast<std::size_t>(material);
  pass.uniformBlock(5, materialBlocks_, index * materialStride_, sizeof(shared::MaterialBlock));
  for (unsigned unit = 0; unit < kSlotCount; ++unit)
    if (const BoundTexture& bound = materials_[index][unit]; bound.texture)
      pass.texture(unit, *bound.texture, *bound.sampler);
}

} // namespace taa
