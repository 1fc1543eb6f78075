#include "core/render/SceneRenderer.h"

#include "core/gl/Context.h"
#include "core/render/CameraMotionPass.h"
#include "core/render/GBufferPass.h"
#include "core/render/SkyPass.h"

#include <cassert>
#include <utility>

namespace taa {

namespace {

void fit(gl::Texture& texture, int width, int height, gl::Format format, const char* label) {
  const gl::TextureSize size{width, height};
  if (texture && texture.size() == size && texture.format() == format) return;
  texture = gl::Texture();
  texture = gl::Texture(size, format, label);
}

void fitInputs(const FrameRequest& request, FrameInputs& out) {
  const bool isHalf = request.inputs.precision == Precision::Half;
  const int width = request.width, height = request.height;
  fit(out.color, width, height, isHalf ? gl::Format::RGBA16F : gl::Format::RGBA32F, "color");
  fit(out.motion, width, height, isHalf ? gl::Format::RG16F : gl::Format::RG32F, "motion");
  fit(out.normal, width, height, gl::Format::RGBA16F, "normal");
  fit(out.objectId, width, height, gl::Format::R32UI, "object id");
  fit(out.previousDepth, width, height, gl::Format::R32F, "previous depth");
  fit(out.depth, width, height, gl::Format::Depth32F, "depth");
}

} // namespace

struct SceneRenderer::Parts {
  std::shared_ptr<const Scene> scene;
  SceneResources resources;
  GBufferPass gbuffer;
  SkyPass sky;
  CameraMotionPass cameraMotion;
  gl::Buffer frame{sizeof(shared::FrameBlock), nullptr, "frame"};

  Parts(std::shared_ptr<const Scene> scene_, const Progress& progress)
      : scene(std::move(scene_)), resources(*scene, progress), gbuffer(*scene) {}
};

SceneRenderer::SceneRenderer(std::shared_ptr<const Scene> scene, const Progress& progress)
    : parts_(std::make_unique<Parts>(std::move(scene), progress)) {
  gl::checkErrors("uploading the scene");
}

SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

void SceneRenderer::draw(const FrameRequest& request, int frame, FrameInputs& out) {
  assert(frame >= 0 && request.width > 0 && request.height > 0);
  Parts& parts = *parts_;
  const View view = viewAt(*parts.scene, request, frame);
  fitInputs(request, out);
  out.info = view.info;
  out.block = view.block;
  parts.frame.update(0, &view.block, sizeof(view.block));

  // Every pixel is written by a surface or by the sky, so only depth needs to start from something.
  gl::Framebuffer target({{&out.color}, {&out.motion}, {&out.normal}, {&out.objectId}, {&out.previousDepth}},
                         &out.depth, "frame inputs");
  target.clearDepth(0.0f);
  parts.gbuffer.draw(*parts.scene, parts.resources, request.inputs, view, parts.frame, target);
  parts.sky.draw(parts.frame, target);
  if (request.inputs.motion != MotionSource::Objects)
    parts.cameraMotion.draw(request.inputs.motion, parts.frame, out);
}

void SceneRenderer::reloadShaders() {
  SkyPass sky;
  CameraMotionPass cameraMotion = parts_->cameraMotion.reloaded();
  parts_->gbuffer.reloadShaders();
  parts_->sky = std::move(sky);
  parts_->cameraMotion = std::move(cameraMotion);
}

} // namespace taa
