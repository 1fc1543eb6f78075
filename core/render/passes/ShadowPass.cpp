#include "core/render/passes/ShadowPass.h"

#include "core/render/FrameRequest.h"

#include <cassert>
#include <string_view>

namespace taa {

namespace {

constexpr gl::TextureSize kMapSize{kShadowMapSize, kShadowMapSize};

} // namespace

ShadowPass::ShadowPass(const Scene& scene)
    : casters_(scene, GBufferPass::Draws::Casters), map_(kMapSize, gl::Format::Depth32F, "shadow map"),
      frame_(sizeof(shared::FrameBlock), nullptr, "the sun's frame"),
      block_(sizeof(shared::ShadowBlock), nullptr, "shadows"), nearest_(gl::SamplerState{}) {}

std::size_t ShadowPass::bytes() {
  return gl::textureBytes(kMapSize, gl::Format::Depth32F);
}

void ShadowPass::draw(const Scene& scene, const SceneResources& resources, const InputSettings& settings,
                      const View& view, const Progress& warmUp) {
  assert(castsShadows(scene, settings));
  // Its programs are not counted among those that are waited for: there are few and they are small.
  const Progress uncounted = warmUp ? Progress([](std::string_view, int, int) { return true; }) : Progress();
  sun_ = sunView(scene, view);
  casters_.prepare(scene, settings, sun_, uncounted);
  frame_.update(0, &sun_.block, sizeof(sun_.block));
  gl::Framebuffer target({}, &map_, "shadow map");
  target.clearDepth(0.0f);
  casters_.draw({scene, resources, sun_, frame_, {}}, target, uncounted);
}

GBufferPass::Shadowing ShadowPass::shadowing(const Scene& scene, const FrameRequest& request, int frame) {
  const shared::ShadowBlock block = shadowBlock(scene, request, frame, sun_);
  block_.update(0, &block, sizeof(block));
  return {&map_, &block_, &noise_.tile(), &nearest_};
}

} // namespace taa
