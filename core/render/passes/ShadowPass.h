// Draws what the sun sees of a scene, for its shadows: depth alone, in one map for all of it.
#pragma once

#include "core/gl/RenderPass.h"
#include "core/render/SceneResources.h"
#include "core/render/passes/GBufferPass.h"
#include "core/render/passes/NoiseSource.h"
#include "core/render/passes/SunView.h"

#include <cstddef>

namespace taa {

class ShadowPass {
 public:
  explicit ShadowPass(const Scene& scene);

  /// Draws the map for the frame of `view`. Expects castsShadows(); throws Error when a shader does not
  /// compile. With `warmUp` as GBufferPass does.
  void draw(const Scene& scene, const SceneResources& resources, const InputSettings& settings,
            const View& view, const Progress& warmUp);
  /// What surfaces are shaded with, of the last map: at another sample of a pixel there is another noise.
  GBufferPass::Shadowing shadowing(const Scene& scene, const FrameRequest& request, int frame);
  /// Compiles again; on Error the old programs stay.
  void reloadShaders() { casters_.reloadShaders(); }

  /// What the map takes.
  static std::size_t bytes();

 private:
  GBufferPass casters_;
  View sun_; ///< of the last map
  gl::Texture map_;
  gl::Buffer frame_, block_;
  gl::Sampler nearest_;
  NoiseSource noise_;
};

} // namespace taa
