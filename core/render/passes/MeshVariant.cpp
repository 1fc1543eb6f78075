#include "core/render/passes/MeshVariant.h"

#include "core/render/SceneResources.h"
#include "core/render/passes/NoiseSource.h"

#include <cassert>
#include <string>

namespace taa {

namespace {

bool isBlended(BlendedAs blended) {
  return blended == BlendedAs::Before || blended == BlendedAs::BeforeWithMotion ||
         blended == BlendedAs::After;
}

std::string constantInt(const char* name, int value) {
  return std::string("const int ") + name + " = " + std::to_string(value) + ";\n";
}

std::string constantBool(const char* name, bool value) {
  return std::string("const bool ") + name + " = " + (value ? "true" : "false") + ";\n";
}

std::string shadowPrelude(const MeshVariant& variant) {
  return constantInt("kShadows", static_cast<int>(variant.shadows)) +
         constantInt("kNoShadows", static_cast<int>(Shadows::None)) +
         constantInt("kHardShadows", static_cast<int>(Shadows::Hard)) + noisePrelude(variant.shadowNoise);
}

} // namespace

void MeshVariant::apply(const InputSettings& settings, const Material& material, JitterProjection projection,
                        MotionMode motion) {
  biased = settings.mipBias != 0.0f && textures != 0;
  const bool blends = material.alphaMode == AlphaMode::Blend;
  dithered = settings.blended == BlendedAs::Dithered && blends;
  blended = isBlended(settings.blended) && blends;
  steady = settings.blended == BlendedAs::After && blends;
  masked = material.alphaMode != AlphaMode::Opaque && !blended;
  unjittered = settings.unjitterTextures == Switch::On && textures != 0 && !steady;
  mask = settings.mask == MaskSource::None || steady       ? 0
         : settings.mask == MaskSource::Opacity && blended ? 2
                                                           : 1;
  printedJitter = projection != JitterProjection::Translation && !steady;
  // What is forced to have no motion has none in any form.
  assert(settings.shadows != Shadows::AsScene);
  if (lit) shadows = settings.shadows;
  shadowNoise = shadows == Shadows::Soft ? settings.shadowNoise : InputNoise::None;
  printedMotion = settings.motion == MotionSource::ObjectsAsPrinted && motion != MotionMode::None;
}

void MeshVariant::applyAsCaster(const InputSettings& settings, const Material& material) {
  depthOnly = true;
  lit = false;
  blended = isBlended(settings.blended) && material.alphaMode == AlphaMode::Blend;
  masked = material.alphaMode != AlphaMode::Opaque && !blended;
  textures &= masked ? 1u << static_cast<int>(Slot::BaseColor) : 0u;
}

MeshVariant variantFor(const Primitive& primitive, const Node& node, const Scene& scene) {
  const Material& material = scene.materials[static_cast<std::size_t>(primitive.material)];
  // Lines and points have no side that could face a light.
  const bool lit = !material.unlit && primitive.topology == Topology::Triangles;
  return {textureMask(material),
          material.alphaMode != AlphaMode::Opaque,
          lit,
          node.skin >= 0 ? primitive.influenceSets : 0,
          node.firstWeight >= 0 && !primitive.targets.empty(),
          primitive.cache.frames > 0,
          material.wind.amplitude != 0.0f,
          material.uvAnimation != UvAnimation{}};
}

gl::Program compile(const MeshVariant& variant, const LightCounts& lights) {
  const std::string shading =
      constantInt("kTextures", static_cast<int>(variant.textures)) +
      constantInt("kDirectionalLights", lights.directional) + constantInt("kNearLights", lights.near) +
      constantBool("kMasked", variant.masked) + constantBool("kLit", variant.lit) +
      constantBool("kBiased", variant.biased) + constantBool("kUnjittered", variant.unjittered) +
      constantBool("kDithered", variant.dithered) + constantBool("kBlended", variant.blended) +
      constantInt("kMask", variant.mask) + constantBool("kPrintedMotion", variant.printedMotion) +
      constantBool("kInstanced", variant.instanced) + constantBool("kDepthOnly", variant.depthOnly) +
      shadowPrelude(variant);
  const std::string deform =
      constantInt("kInfluenceSets", variant.influenceSets) + constantBool("kMorphed", variant.morphed) +
      constantBool("kCached", variant.cached) + constantBool("kWind", variant.wind) +
      constantBool("kSteady", variant.steady) + constantBool("kPrintedJitter", variant.printedJitter) +
      constantBool("kMovingUv", variant.movingUv) + constantBool("kInstanced", variant.instanced);
  return {gl::ShaderSource("scene/mesh.vert", deform), gl::ShaderSource("scene/mesh.frag", shading),
          "GBufferPass"};
}

} // namespace taa
