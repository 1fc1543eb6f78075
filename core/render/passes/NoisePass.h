// The last that happens to a color before the resolve: it is clipped where the settings ask for a low dynamic
// range (manual 1.2), then given noise against banding (manual §20).
#pragma once

#include "core/gl/RenderPass.h"
#include "core/render/FrameInputs.h"
#include "core/render/passes/NoiseSource.h"
#include "core/settings/Settings.h"

#include <compare>
#include <map>
#include <optional>

namespace taa {

class NoisePass {
 public:
  NoisePass();
  /// Whether settings leave anything to do.
  static bool isNeeded(const InputSettings& settings);
  /// Replaces `out.color` by itself, clipped and with the noise of its frame; `frame` holds the view's block;
  /// `part`: what is drawn, default all. Expects isNeeded(); throws Error when its program does not compile.
  void draw(const InputSettings& settings, const gl::Buffer& frame, FrameInputs& out,
            const std::optional<gl::Rect>& part = {});
  /// One with the programs of this one, compiled again.
  NoisePass reloaded() const;

 private:
  struct Variant {
    InputNoise noise = InputNoise::None;
    bool isTriangular = false, isClipped = false;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a 0 in the comparison it makes
    auto operator<=>(const Variant&) const = default;
  };
  static gl::Program compile(const Variant& variant);

  std::map<Variant, gl::Program> programs_; ///< made when they are first asked for
  NoiseSource source_;
  gl::Texture other_; ///< what is drawn into, then exchanged
  gl::Buffer block_;
  gl::Sampler nearest_;
};

} // namespace taa
