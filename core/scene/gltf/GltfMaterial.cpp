#include "core/scene/gltf/GltfMaterial.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/JsonFields.h"
#include "core/scene/gltf/GltfContext.h"
#include "core/scene/gltf/GltfImage.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa {

namespace {

using tinygltf::ExtensionMap;
using tinygltf::Value;

/// A number of an extension's object, or `fallback`.
float numberOr(const Value& object, const char* key, float fallback) {
  return object.Has(key) ? toFloat(object.Get(key).GetNumberAsDouble()) : fallback;
}

glm::vec2 pairOr(const Value& object, const char* key, const glm::vec2& fallback) {
  if (!object.Has(key)) return fallback;
  const Value& list = object.Get(key);
  return {toFloat(list.Get(0).GetNumberAsDouble()), toFloat(list.Get(1).GetNumberAsDouble())};
}

const Value* find(const ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found == extensions.end() ? nullptr : &found->second;
}

Wrap wrapOf(int mode) {
  switch (mode) {
  case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
    return Wrap::ClampToEdge;
  case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
    return Wrap::MirroredRepeat;
  default:
    return Wrap::Repeat;
  }
}

SamplerSettings samplerOf(const tinygltf::Sampler& source) {
  SamplerSettings sampler;
  sampler.wrapU = wrapOf(source.wrapS);
  sampler.wrapV = wrapOf(source.wrapT);
  sampler.magnify = source.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? Filter::Nearest : Filter::Linear;
  switch (source.minFilter) {
  case TINYGLTF_TEXTURE_FILTER_NEAREST:
    sampler.minify = Filter::Nearest;
    sampler.mipmaps = Mipmaps::None;
    break;
  case TINYGLTF_TEXTURE_FILTER_LINEAR:
    sampler.mipmaps = Mipmaps::None;
    break;
  case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    sampler.minify = Filter::Nearest;
    sampler.mipmaps = Mipmaps::Nearest;
    break;
  case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
    sampler.mipmaps = Mipmaps::Nearest;
    break;
  case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
    sampler.minify = Filter::Nearest;
    break;
  default:
    break;
  }
  return sampler;
}

/// KHR_texture_transform: scale, then rotation counter-clockwise as seen with v down, then offset.
glm::mat3 uvTransform(const Value& extension) {
  const glm::vec2 offset = pairOr(extension, "offset", {0, 0}), scale = pairOr(extension, "scale", {1, 1});
  const float rotation = numberOr(extension, "rotation", 0.0f), c = std::cos(rotation),
              s = std::sin(rotation);
  return {glm::vec3(c * scale.x, -s * scale.x, 0), glm::vec3(s * scale.y, c * scale.y, 0),
          glm::vec3(offset, 1)};
}

class MaterialReader {
 public:
  MaterialReader(GltfContext& context, const Progress& progress)
      : context_(context), progress_(progress), sceneImage_(context.model.images.size()) {}

  Material read(const tinygltf::Material& source) {
    Material material;
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    material.name = plainText(source.name);
    for (int i = 0; i < 4; ++i)
      material.baseColor[i] = toFloat(pbr.baseColorFactor.at(static_cast<std::size_t>(i)));
    material.metallic = std::clamp(toFloat(pbr.metallicFactor), 0.0f, 1.0f);
    material.roughness = std::clamp(toFloat(pbr.roughnessFactor), 0.0f, 1.0f);
    material.emissive = emissive(source);
    material.normalScale = toFloat(source.normalTexture.scale);
    material.occlusionStrength = std::clamp(toFloat(source.occlusionTexture.strength), 0.0f, 1.0f);
    material.alphaMode = alphaMode(source);
    material.alphaCutoff = toFloat(source.alphaCutoff);
    material.doubleSided = source.doubleSided;
    material.unlit = find(source.extensions, "KHR_materials_unlit") != nullptr;
    material.baseColorTexture = slot(pbr.baseColorTexture);
    material.metallicRoughnessTexture = slot(pbr.metallicRoughnessTexture);
    material.normalTexture = slot(source.normalTexture);
    material.occlusionTexture = slot(source.occlusionTexture);
    material.emissiveTexture = slot(source.emissiveTexture);
    // Without its picture a factor would hold all over, where the picture says nearly nowhere.
    if (isMissing(source.emissiveTexture, material.emissiveTexture)) material.emissive = glm::vec3(0.0f);
    if (isMissing(pbr.metallicRoughnessTexture, material.metallicRoughnessTexture)) material.metallic = 0.0f;
    return material;
  }

 private:
  static glm::vec3 emissive(const tinygltf::Material& source) {
    glm::vec3 color(0.0f);
    for (std::size_t i = 0; i < std::min<std::size_t>(3, source.emissiveFactor.size()); ++i)
      color[static_cast<int>(i)] = std::max(0.0f, toFloat(source.emissiveFactor[i]));
    const Value* strength = find(source.extensions, "KHR_materials_emissive_strength");
    const glm::vec3 radiance =
        color * (strength ? std::max(0.0f, numberOr(*strength, "emissiveStrength", 1.0f)) : 1.0f);
    return glm::min(radiance, glm::vec3(60000.0f)); // what a half float holds
  }

  AlphaMode alphaMode(const tinygltf::Material& source) {
    const std::string& mode = source.alphaMode;
    if (mode == "MASK") return AlphaMode::Mask;
    if (mode == "BLEND") return AlphaMode::Blend;
    if (mode != "OPAQUE" && !mode.empty())
      context_.warn(say<"The material \"%1\" has an alphaMode that is none, \"%2\"; it is drawn as OPAQUE.">(
          shownText(source.name), shownText(mode)));
    return AlphaMode::Opaque;
  }

  template <class Info>
  static bool isMissing(const Info& info, const TextureSlot& slot) {
    return info.index >= 0 && slot.image < 0;
  }

  template <class Info>
  TextureSlot slot(const Info& info) {
    TextureSlot slot;
    if (info.index < 0) return slot;
    const tinygltf::Texture& texture = context_.model.textures.at(static_cast<std::size_t>(info.index));
    if (texture.source < 0) {
      context_.warn(
          say<"A texture has its picture only in a format that is not supported; it is left out.">());
      return slot;
    }
    slot.image = image(static_cast<std::size_t>(texture.source));
    if (texture.sampler >= 0)
      slot.sampler = samplerOf(context_.model.samplers.at(static_cast<std::size_t>(texture.sampler)));
    slot.uvSet = info.texCoord;
    if (const Value* transform = find(info.extensions, "KHR_texture_transform")) {
      slot.uvFromUv = uvTransform(*transform);
      if (transform->Has("texCoord")) slot.uvSet = transform->Get("texCoord").GetNumberAsInt();
    }
    if (slot.uvSet > 1) {
      context_.warn(say<"A texture asks for a third set of texture coordinates; the first is used.">());
      slot.uvSet = 0;
    }
    return slot;
  }

  /// The image's index in the scene, decoded when it is asked for the first time; −1 when it cannot be shown,
  /// of which the user is told.
  int image(std::size_t source) {
    std::optional<int>& index = sceneImage_[source];
    if (index) return *index;
    report(progress_, say<"Decoding images">(), static_cast<int>(context_.scene.images.size()),
           static_cast<int>(sceneImage_.size()));
    try {
      context_.scene.images.push_back(decoded(source));
      index = static_cast<int>(context_.scene.images.size()) - 1;
    } catch (const Error& error) {
      const tinygltf::Image& encoded = context_.model.images[source];
      const std::string name = encoded.uri.empty() ? encoded.name : encoded.uri;
      const std::string place = elementOf("images", source) + (name.empty() ? "" : " (" + name + ")");
      context_.warn(say<"The picture %1 is not shown: %2. What it covers is plain.">(place, error.what()));
      index = -1;
    }
    return *index;
  }

  SceneImage decoded(std::size_t source) {
    if (!context_.imageFaults[source].empty()) throw Error(context_.imageFaults[source]);
    const tinygltf::Image& encoded = context_.model.images[source];
    if (encoded.image.empty()) throw Error(say<"its file cannot be read">());
    SceneImage image = decodeImage(encoded.image);
    const std::size_t pixels = image.rgba.size() / 4;
    if (pixels_ + pixels > kMaxPixels)
      throw Error(say<"with it the images have more than %1 pixels">(kMaxPixels));
    pixels_ += pixels;
    image.name = encoded.name.empty() ? encoded.uri : encoded.name;
    return image;
  }

  static constexpr std::size_t kMaxPixels = std::size_t(1) << 28; ///< of all images: 1 GiB

  GltfContext& context_;
  const Progress& progress_;
  std::vector<std::optional<int>> sceneImage_; ///< image() of each image of the file that was asked for
  std::size_t pixels_ = 0;
};

} // namespace

void addGltfMaterials(GltfContext& context, const Progress& progress) {
  MaterialReader reader(context, progress);
  for (const tinygltf::Material& material : context.model.materials)
    context.scene.materials.push_back(reader.read(material));
  context.scene.materials.emplace_back().name = "default"; // for primitives that name none
}

} // namespace taa
