#include "core/render/passes/SceneRenderer.h"

#include "core/base/Say.h"
#include "core/gl/Context.h"
#include "core/gl/PassTimer.h"
#include "core/render/FrameClock.h"
#include "core/render/View.h"
#include "core/render/passes/CameraMotionPass.h"
#include "core/render/passes/FogPass.h"
#include "core/render/passes/GBufferPass.h"
#include "core/render/passes/NoisePass.h"
#include "core/render/passes/ReactivePass.h"
#include "core/render/passes/ShadowPass.h"
#include "core/render/passes/SkyPass.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {

namespace {

/// What the frame before is drawn with where its pixels are counted: nothing that costs and shows in color
/// alone.
InputSettings forwardInputs(InputSettings settings) {
  settings.forward = Switch::Off;
  settings.motion = MotionSource::Objects;
  settings.precision = Precision::Full;
  settings.shadows = Shadows::None;
  settings.fogDensity = 0.0f;
  settings.noise = InputNoise::None;
  settings.mask = MaskSource::None;
  return settings;
}

/// Whether something is another one at another time though no node has moved.
bool movesByTime(const Scene& scene) {
  const bool hasMaterial = std::ranges::any_of(scene.materials, [](const Material& material) {
    return material.wind.amplitude != 0.0f || material.uvAnimation != UvAnimation();
  });
  return hasMaterial || std::ranges::any_of(scene.meshes, [](const Mesh& mesh) {
           return std::ranges::any_of(mesh.primitives,
                                      [](const Primitive& part) { return part.cache.frames > 0; });
         });
}

/// Whether the second is the first at another place of the pixel, as the samples of a reference are. (Forms
/// of jitter other than the translation may move things by pixels.)
bool differsInJitterOnly(const FrameRequest& a, const FrameRequest& b) {
  if (!a.jitterPx || !b.jitterPx || a.jitter.projection != JitterProjection::Translation) return false;
  FrameRequest same = b;
  same.jitterPx = a.jitterPx;
  same.sample = a.sample;
  return same == a;
}

} // namespace

std::size_t scratchBytes(const InputSettings& settings, const glm::ivec2& picturePx, const Scene* scene) {
  const glm::ivec2 size = drawnSize(picturePx, settings.renderScale);
  const std::size_t color = gl::textureBytes({size.x, size.y}, colorFormat(settings));
  return (NoisePass::isNeeded(settings) ? color : 0) +
         (scene && drawsFog(*scene, settings) ? FogPass::scratchBytes(settings, color) : 0) +
         (scene && castsShadows(*scene, settings) ? ShadowPass::bytes() : 0) +
         (settings.mask == MaskSource::AutoReactive ? color : 0) +
         (isOn(settings.forward) ? inputBytes(forwardInputs(settings), picturePx) : 0);
}

Image forwardCount(const Image& motionPx) {
  Image counts(motionPx.width, motionPx.height, 1);
  for (int y = 0; y < motionPx.height; ++y)
    for (int x = 0; x < motionPx.width; ++x) {
      const float* motion = motionPx.at(x, y);
      const float toX = std::floor(static_cast<float>(x) + 0.5f - motion[0]);
      const float toY = std::floor(static_cast<float>(y) + 0.5f - motion[1]);
      const bool isInside = toX >= 0.0f && toY >= 0.0f && toX < static_cast<float>(counts.width) &&
                            toY < static_cast<float>(counts.height);
      if (isInside && motion[0] != kNoPreviousPosition) *counts.at(int(toX), int(toY)) += 1.0f;
    }
  return counts;
}

struct SceneRenderer::Impl {
  std::shared_ptr<const Scene> scene;
  SceneResources resources;
  GBufferPass gbuffer;
  SkyPass sky;
  CameraMotionPass cameraMotion;
  NoisePass noise;
  ReactivePass reactive;
  std::unique_ptr<FogPass> fog;        ///< where the scene has some
  std::unique_ptr<ShadowPass> shadows; ///< made when they are first asked for
  gl::Buffer frame{sizeof(shared::FrameBlock), nullptr, "frame"};
  FrameInputs before; ///< of the frame before, where its pixels are counted
  /// What was drawn last.
  struct Prepared {
    FrameRequest request;
    int frame = 0;
    View view;
    bool isWarmUp = false; ///< not all of it that is seen
  };
  std::optional<Prepared> last;
  /// What the shadow map is of: neither where the camera is nor which part of its picture is wanted.
  struct MapOf {
    ObjectFilter filter;
    InputSettings inputs;
    glm::vec4 light{0.0f};
    std::vector<glm::mat4> worldFromNode;
    std::vector<float> morphWeights;
    std::vector<bool> visible;  ///< nodes
    std::optional<double> time; ///< s; of a scene whose vertices or pictures move by it
    bool operator==(const MapOf&) const = default;
  };
  MapOf shadowMapOf(const FrameRequest& request, const View& view) const;
  std::optional<MapOf> mapOf;

  Impl(std::shared_ptr<const Scene> scene_, const Progress& progress)
      : scene(std::move(scene_)), resources(*scene, progress), gbuffer(*scene),
        fog(scene->fog.empty() ? nullptr : std::make_unique<FogPass>()) {}

  void draw(const FrameRequest& asked, int frame, FrameInputs& out, const Progress& warmUp);
  /// The view, with which the passes are ready to draw.
  const View& prepare(const FrameRequest& request, int frame, const Progress& warmUp);
  /// Draws what the sun sees, if shadows are wanted.
  void drawShadows(const FrameRequest& request, const View& view, const Progress& warmUp);
  /// What surfaces of the prepared view are drawn from.
  GBufferPass::Source source(const FrameRequest& request, int number, const View& view);
  void drawSurfaces(const GBufferPass::Source& source, const FrameInputs& out, const Progress& warmUp);
  void drawBlended(const InputSettings& settings, const GBufferPass::Source& source, const FrameInputs& out,
                   const Progress& warmUp);
  void drawFog(const FrameRequest& request, const View& view, FrameInputs& out);
  /// Counts where the pixels of the frame before are now; leaves another view prepared.
  void countForward(const FrameRequest& request, int number, gl::Texture& out);
};

SceneRenderer::SceneRenderer(std::shared_ptr<const Scene> scene, const Progress& progress)
    : impl_(std::make_unique<Impl>(std::move(scene), progress)) {
  gl::checkErrors(say<"uploading the scene">());
}

SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

const View& SceneRenderer::Impl::prepare(const FrameRequest& request, int number, const Progress& warmUp) {
  const bool isKnown = last && !last->isWarmUp && !warmUp && last->frame == number;
  if (isKnown && differsInJitterOnly(last->request, request)) {
    setJitter(last->view, *request.jitterPx);
    gbuffer.setJitter(last->view.block.jitterPx);
    return last->view;
  }
  last.reset();
  Prepared next{request, number, viewAt(*scene, request, number), static_cast<bool>(warmUp)};
  gbuffer.prepare(*scene, request.inputs, next.view, warmUp);
  drawShadows(request, next.view, warmUp);
  return last.emplace(std::move(next)).view;
}

SceneRenderer::Impl::MapOf SceneRenderer::Impl::shadowMapOf(const FrameRequest& request,
                                                            const View& view) const {
  MapOf out{request.filter,
            request.inputs,
            view.lights.lightDirection[0],
            view.pose.worldFromNode,
            view.pose.morphWeights,
            {},
            {}};
  for (const NodeState& node : view.nodes) out.visible.push_back(node.isVisible);
  if (movesByTime(*scene)) out.time = view.pose.time;
  return out;
}

void SceneRenderer::Impl::drawShadows(const FrameRequest& request, const View& view, const Progress& warmUp) {
  if (!castsShadows(*scene, request.inputs)) return;
  const MapOf wanted = shadowMapOf(request, view);
  // A frame whose time is taken is drawn as in a game, with its own map.
  if (mapOf == wanted && !warmUp && !gl::PassTimer::isTiming()) return;
  mapOf.reset();
  if (!shadows) shadows = std::make_unique<ShadowPass>(*scene);
  shadows->draw(*scene, resources, request.inputs, view, warmUp);
  if (!warmUp) mapOf = wanted;
}

GBufferPass::Source SceneRenderer::Impl::source(const FrameRequest& request, int number, const View& view) {
  GBufferPass::Source source{*scene, resources, view, frame, {}};
  if (castsShadows(*scene, request.inputs)) source.shadowing = shadows->shadowing(*scene, request, number);
  return source;
}

void SceneRenderer::Impl::drawSurfaces(const GBufferPass::Source& source, const FrameInputs& out,
                                       const Progress& warmUp) {
  const std::optional<gl::Rect>& part = source.view.part;
  std::vector<gl::Attachment> attachments{
      {&out.color}, {&out.motion}, {&out.normal}, {&out.objectId}, {&out.previousDepth}};
  const gl::Framebuffer background(attachments, &out.depth, "background");
  if (out.mask) attachments.push_back({&out.mask});
  // Every pixel is written by a surface or by the sky, so only depth and mask need to start from something.
  gl::Framebuffer target(attachments, &out.depth, "frame inputs");
  target.clearDepth(0.0f, part);
  if (out.mask) target.clearColor(GBufferPass::kMaskAttachment, glm::vec4(0.0f), part);
  gbuffer.draw(source, target, warmUp);
  sky.draw(frame, background, part);
}

void SceneRenderer::Impl::drawBlended(const InputSettings& settings, const GBufferPass::Source& source,
                                      const FrameInputs& out, const Progress& warmUp) {
  if (out.overlay) {
    gl::Framebuffer layer({{&out.overlay}}, &out.depth, "overlay");
    layer.clearColor(0, glm::vec4(0.0f));
    if (gbuffer.hasBlended()) gbuffer.drawBlended(source, layer, warmUp);
    return;
  }
  if (!gbuffer.hasBlended()) return;
  const bool writesMotion = settings.blended == BlendedAs::BeforeWithMotion;
  const gl::Framebuffer target(
      {{&out.color}, {writesMotion ? &out.motion : nullptr}, {}, {}, {}, {out.mask ? &out.mask : nullptr}},
      &out.depth, "blended");
  gbuffer.drawBlended(source, target, warmUp);
}

void SceneRenderer::Impl::drawFog(const FrameRequest& request, const View& view, FrameInputs& out) {
  if (drawsFog(*scene, request.inputs)) {
    fog->draw(*scene, request, view, frame, out);
    return;
  }
  out.fog = gl::Texture();
  if (fog) fog->rest();
}

// Pixels' centers, as history has them: neither jittered nor a part, and with the motion that things really
// have.
void SceneRenderer::Impl::countForward(const FrameRequest& request, int number, gl::Texture& out) {
  const int previous = previousFrame(*scene, number);
  if (previous == number) {
    out.clear(kForwardUnknown, 0.0f, 0.0f, 0.0f);
    return;
  }
  FrameRequest asked = request;
  asked.part.reset();
  asked.jitterPx = glm::vec2(0.0f);
  asked.movesOn = true;
  asked.untestedMotion = false;
  asked.inputs = forwardInputs(request.inputs);
  draw(asked, previous, before, {});
  out.upload(forwardCount(before.motion.download()));
}

void SceneRenderer::Impl::draw(const FrameRequest& asked, int number, FrameInputs& out,
                               const Progress& warmUp) {
  FrameRequest request = asked;
  request.inputs.shadows = shadowsOf(*scene, asked.inputs);
  fitInputs(request, out);
  if (out.forwardCount && !warmUp) countForward(request, number, out.forwardCount);
  const View& view = prepare(request, number, warmUp);
  out.info = view.info;
  out.block = view.block;
  frame.update(0, &view.block, sizeof(view.block));

  const GBufferPass::Source drawn = source(request, number, view);
  drawSurfaces(drawn, out, warmUp);
  if (request.inputs.mask == MaskSource::AutoReactive) reactive.keepOpaque(out.color);
  drawBlended(request.inputs, drawn, out, warmUp);
  if (request.untestedMotion) {
    const gl::Framebuffer motion({{}, {&out.motion}}, nullptr, "untested motion");
    gbuffer.drawUntested(drawn, motion);
  }
  if (request.inputs.mask == MaskSource::AutoReactive) reactive.draw(out.color, out.mask, view.part);
  drawFog(request, view, out);
  if (isFromDepth(request.inputs.motion)) cameraMotion.draw(request.inputs.motion, frame, out, view.part);
  if (NoisePass::isNeeded(request.inputs)) noise.draw(request.inputs, frame, out, view.part);
}

void SceneRenderer::draw(const FrameRequest& request, int frame, FrameInputs& out) {
  assert(frame >= 0 && request.width > 0 && request.height > 0);
  impl_->draw(request, frame, out, {});
}

FrameInfo SceneRenderer::info(const FrameRequest& request, int frame) const {
  return frameInfo(*impl_->scene, request, frame);
}

CameraState SceneRenderer::camera(const FrameRequest& request, int frame) const {
  return cameraOf(*impl_->scene, request, frame);
}

void SceneRenderer::warmUp(const FrameRequest& request, const Progress& progress) {
  constexpr int kShrunk = 16;
  FrameRequest small = request;
  small.width = std::max(request.width / kShrunk, 4);
  small.height = std::max(request.height / kShrunk, 4);
  FrameInputs ignored;
  const auto told = [&](std::string_view what, int done, int total) {
    return !progress || progress(what, done, total);
  };
  impl_->draw(small, 0, ignored, told);
  gl::finish();
}

const DrawCounts& SceneRenderer::counts() const {
  return impl_->gbuffer.counts();
}

void SceneRenderer::setCulling(bool culls) {
  impl_->last.reset();
  impl_->gbuffer.setCulling(culls);
}

void SceneRenderer::reloadShaders() {
  SkyPass sky;
  CameraMotionPass cameraMotion = impl_->cameraMotion.reloaded();
  ReactivePass reactive = impl_->reactive.reloaded();
  NoisePass noise = impl_->noise.reloaded();
  std::optional<FogPass> fog;
  if (impl_->fog) fog.emplace(impl_->fog->reloaded());
  impl_->gbuffer.reloadShaders();
  if (impl_->shadows) impl_->shadows->reloadShaders();
  impl_->mapOf.reset();
  impl_->sky = std::move(sky);
  impl_->cameraMotion = std::move(cameraMotion);
  impl_->reactive = std::move(reactive);
  impl_->noise = std::move(noise);
  if (fog) *impl_->fog = std::move(*fog);
}

} // namespace taa
