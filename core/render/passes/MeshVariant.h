// What the shader of a surface is specialised by: one program for each combination that a scene needs.
#pragma once

#include "core/gl/Program.h"
#include "core/render/Lights.h"
#include "core/scene/Scene.h"
#include "core/settings/Settings.h"

#include <compare>

namespace taa {

struct MeshVariant {
  unsigned textures = 0; ///< textureMask()
  bool masked = false;
  bool lit = true;
  int influenceSets = 0;
  bool morphed = false, cached = false, wind = false;
  bool movingUv = false;
  bool instanced = false;                                    ///< small things that are there often
  bool biased = false, unjittered = false, dithered = false; ///< what the settings ask for
  bool blended = false, steady = false;                      ///< likewise; steady: without jitter
  bool printedJitter = false, printedMotion = false;         ///< likewise: forms as printed
  int mask = 0;                                              ///< kMask of shaders/scene/mesh.frag
  Shadows shadows = Shadows::None;                           ///< that fall on it
  InputNoise shadowNoise = InputNoise::None;                 ///< where they are soft
  bool depthOnly = false;                                    ///< drawn as it casts shadows
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a 0 in the comparison it makes
  auto operator<=>(const MeshVariant&) const = default;
  bool deforms() const { return influenceSets > 0 || morphed || cached || wind; }
  /// Sets what settings and the view ask for, of a surface of this material and motion.
  void apply(const InputSettings& settings, const Material& material, JitterProjection projection,
             MotionMode motion);
  /// Sets what it casts shadows as. What is blended lets all light through.
  void applyAsCaster(const InputSettings& settings, const Material& material);
};

/// What a primitive at a node needs, whatever the settings are.
MeshVariant variantFor(const Primitive& primitive, const Node& node, const Scene& scene);

/// Throws Error when the shader does not compile.
gl::Program compile(const MeshVariant& variant, const LightCounts& lights);

} // namespace taa
