// A scene's meshes, textures and materials on the GPU: uploaded once, then only read.
#pragma once

#include "core/base/Progress.h"
#include "core/gl/RenderPass.h"
#include "core/scene/Scene.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace taa {

/// Texture slots in the order of their texture units (shaders/scene/mesh.frag).
enum class Slot : std::uint8_t { BaseColor, MetallicRoughness, Normal, Occlusion, Emissive };
inline constexpr int kSlotCount = 5;

const TextureSlot& textureSlot(const Material& material, Slot slot);

/// Which slots have a texture: bit s for Slot s.
unsigned textureMask(const Material& material);

class SceneResources {
 public:
  /// Throws Error when the driver has not the memory, Cancelled when `progress` says so.
  SceneResources(const Scene& scene, const Progress& progress);

  const gl::VertexMesh& mesh(int mesh, int primitive) const {
    return meshes_[static_cast<std::size_t>(mesh)][static_cast<std::size_t>(primitive)];
  }
  /// Binds what deforms a primitive's vertices, for those that have such.
  void bindDeformation(gl::RenderPass& pass, int mesh, int primitive) const;
  /// Binds factors and textures of `material` for the mesh program.
  void bindMaterial(gl::RenderPass& pass, int material) const;

 private:
  struct BoundTexture {
    const gl::Texture* texture = nullptr; ///< null: the slot has none
    const gl::Sampler* sampler = nullptr;
  };
  BoundTexture texture(const TextureSlot& slot, bool isSrgb);
  const gl::Sampler& sampler(const SamplerSettings& settings);
  void uploadMeshes(const Scene& scene, const Progress& progress);
  void uploadTextures(const Scene& scene, const Progress& progress);
  void uploadMaterials(const Scene& scene);

  struct Deformation {
    gl::Buffer influences, deltas, cache;
  };

  std::vector<std::vector<gl::VertexMesh>> meshes_;
  std::vector<std::vector<Deformation>> deformations_;
  std::map<std::pair<int, bool>, gl::Texture>
      textures_; ///< by image and whether it is sRGB; stable addresses
  std::vector<std::pair<SamplerSettings, std::unique_ptr<gl::Sampler>>> samplers_;
  std::vector<std::array<BoundTexture, kSlotCount>> materials_;
  gl::Buffer materialBlocks_;
  std::size_t materialStride_ = 0; ///< bytes
};

} // namespace taa
