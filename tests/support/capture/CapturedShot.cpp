#include "tests/support/capture/CapturedShot.h"

#include "core/base/Files.h"
#include "core/capture/planes/Planes.h"
#include "core/render/FrameClock.h"
#include "core/scene/builtin/SceneSource.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <vector>

namespace taa::test {

namespace {

capture::DecodedCamera exactly(const CameraState& camera) {
  return {glm::dmat4(camera.viewFromWorld), glm::dmat4(camera.clipFromView), camera.orthographic};
}

Image pixelsOf(const gl::Texture& texture) {
  return texture ? texture.download() : Image();
}

std::vector<std::uint32_t> integersOf(const gl::Texture& texture) {
  std::vector<std::uint32_t> integers;
  std::ranges::transform(texture.download().pixels, std::back_inserter(integers),
                         [](float value) { return static_cast<std::uint32_t>(value); });
  return integers;
}

// 32 bits of whatever it is.
capture::RawFormat formatOf(const capture::PlaneData& plane) {
  if (!plane.integers.empty()) return capture::RawFormat::R32_UINT;
  if (plane.image.channels == 1) return capture::RawFormat::R32F;
  return plane.image.channels == 2 ? capture::RawFormat::RG32F : capture::RawFormat::RGBA32F;
}

capture::PlaneSource sourceOf(capture::PlaneKind kind, const capture::PlaneData& plane) {
  capture::PlaneSource source;
  source.file = std::string(capture::planeName(kind)) + ".{frame:4}.raw";
  source.raw = formatOf(plane);
  source.sizePx = {plane.width, plane.height};
  return source;
}

} // namespace

CapturedShot::CapturedShot(const std::string& source, const glm::ivec2& sizePx, const Settings& settings,
                           int frames)
    : scene_(std::make_shared<const Scene>(openScene(source))),
      renderer_(scene_), request_{.camera = scene_->shot.camera,
                                  .width = sizePx.x,
                                  .height = sizePx.y,
                                  .jitter = settings.jitter,
                                  .inputs = settings.inputs},
      frames_(frames) {}

capture::Manifest CapturedShot::manifest() {
  capture::Manifest manifest;
  manifest.name = "captured";
  manifest.sizePx = drawnSize({request_.width, request_.height}, request_.inputs.renderScale);
  manifest.outputPx = {request_.width, request_.height};
  manifest.framesPerSecond = scene_->shot.framesPerSecond;
  manifest.frames.resize(static_cast<std::size_t>(frames_));
  for (int index = 0; index < frames_; ++index) {
    manifest.frames[static_cast<std::size_t>(index)].number = index;
    capture::encodeFrame(manifest, static_cast<std::size_t>(index), *frame(index));
  }
  for (const capture::PlaneKind kind :
       {capture::PlaneKind::Color, capture::PlaneKind::Motion, capture::PlaneKind::Depth})
    manifest.planes[kind].file = "in memory";
  if (request_.inputs.mask != MaskSource::None) manifest.planes[capture::PlaneKind::Mask].file = "in memory";
  if (request_.inputs.blended == BlendedAs::After)
    manifest.planes[capture::PlaneKind::Overlay].file = "in memory";
  return manifest;
}

std::shared_ptr<const capture::DecodedFrame> CapturedShot::frame(int index) {
  FrameInputs inputs;
  renderer_.draw(request_, index, inputs);
  auto frame = std::make_shared<capture::DecodedFrame>();
  frame->index = index;
  frame->jitterPx = inputs.info.jitterPx;
  frame->previousJitterPx = glm::vec2(inputs.block.previousJitter.x, inputs.block.previousJitter.y);
  frame->startsHistory = inputs.info.startsHistory;
  frame->seconds = inputs.info.time;
  frame->camera = exactly(renderer_.camera(request_, index));
  frame->previousCamera = exactly(renderer_.camera(request_, previousFrame(*scene_, index)));
  frame->nearPlane = frame->camera->clipFromView[3][2];
  frame->color = pixelsOf(inputs.color);
  frame->motion = pixelsOf(inputs.motion);
  frame->depth = pixelsOf(inputs.depth);
  frame->normal = pixelsOf(inputs.normal);
  frame->previousDepth = pixelsOf(inputs.previousDepth);
  frame->mask = pixelsOf(inputs.mask);
  frame->overlay = pixelsOf(inputs.overlay);
  frame->fog = pixelsOf(inputs.fog);
  frame->objectId = integersOf(inputs.objectId);
  return frame;
}

void CapturedShot::write(const std::filesystem::path& folder, bool hasOutput) {
  writeCapture(folder, manifest(), [&](int index) {
    capture::DecodedFrame decoded = *frame(index);
    if (hasOutput) decoded.output = decoded.color;
    return decoded;
  });
}

void writeCapture(const std::filesystem::path& folder, capture::Manifest manifest,
                  const std::function<capture::DecodedFrame(int)>& frame) {
  std::filesystem::create_directories(folder);
  manifest.planes.clear();
  for (int index = 0; index < static_cast<int>(manifest.frames.size()); ++index)
    for (const auto& [kind, plane] : capture::encode(manifest, frame(index))) {
      const capture::PlaneSource& source = manifest.planes[kind] = sourceOf(kind, plane);
      capture::writeRawPlane(folder / capture::planeFile(source, index), plane, *source.raw);
    }
  writeFile(folder / capture::kManifestName, capture::manifestText(manifest));
}

} // namespace taa::test
