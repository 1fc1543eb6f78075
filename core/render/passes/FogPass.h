// Fog in the beams of a scene's lamps, laid over the shaded color before the resolve (source 001, "improving
// banding"): few steps, with a noise that TAA has to average, and a history of its own where that is chosen.
#pragma once

#include "core/gl/RenderPass.h"
#include "core/render/FogCones.h"
#include "core/render/FrameInputs.h"
#include "core/render/passes/NoiseSource.h"

#include <compare>
#include <map>

namespace taa {

class FogPass {
 public:
  FogPass();
  /// Replaces `out.color` by itself behind fog, and `out.fog` by that fog; `frame` holds the view's block.
  /// Expects drawsFog(); throws Error when a program does not compile.
  void draw(const Scene& scene, const FrameRequest& request, const View& view, const gl::Buffer& frame,
            FrameInputs& out);
  /// Gives back what no frame without fog needs.
  void rest();
  /// One with the programs of this one, compiled again.
  FogPass reloaded() const;
  /// What it keeps while it draws a picture whose colors take `colorBytes`.
  static std::size_t scratchBytes(const InputSettings& settings, std::size_t colorBytes);

 private:
  struct Variant {
    InputNoise noise = InputNoise::None;
    bool isExact = false;
    FogHistory history = FogHistory::None;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a 0 in the comparison it makes
    auto operator<=>(const Variant&) const = default;
  };
  struct Programs {
    gl::Program march, apply;
  };
  static Programs compile(const Variant& variant);
  void fit(const FrameInputs& out, bool hasHistory);

  std::map<Variant, Programs> programs_; ///< made when they are first asked for
  NoiseSource source_;
  gl::Texture marched_, before_; ///< of this frame; mean of those before
  gl::Texture other_;            ///< what is drawn into, then exchanged with the color
  gl::Buffer block_;
  gl::Sampler nearest_;
};

} // namespace taa
