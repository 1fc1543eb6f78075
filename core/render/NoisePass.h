// Adds noise to the shaded color, against banding (catalogue §20).
#pragma once

#include "core/gl/RenderPass.h"
#include "core/render/FrameInputs.h"
#include "core/settings/Settings.h"

#include <map>
#include <utility>

namespace taa {

class NoisePass {
 public:
  NoisePass();
  /// Replaces `out.color` by itself with the noise of its frame; `frame` holds the view's block. Expects
  /// another noise than None; throws Error when its program does not compile.
  void draw(const InputSettings& settings, const gl::Buffer& frame, FrameInputs& out);
  /// One with the programs of this one, compiled again.
  NoisePass reloaded() const;

 private:
  using Variant = std::pair<InputNoise, bool>; ///< triangular or not

  std::map<Variant, gl::Program> programs_; ///< made when they are first asked for
  gl::Texture tile_;                        ///< likewise
  gl::Texture other_;                       ///< what is drawn into, then exchanged
  gl::Buffer block_;
  gl::Sampler nearest_;
};

} // namespace taa
