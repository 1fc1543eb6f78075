#include "core/capture/source/CaptureSource.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/source/Capture.h"
#include "core/capture/source/CaptureInputs.h"
#include "core/gl/Buffer.h"
#include "core/gl/Context.h"
#include "core/render/CaptureFacts.h"
#include "core/render/FrameInputs.h"
#include "core/render/FrameRequest.h"
#include "core/render/passes/CameraMotionPass.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace taa::capture {

namespace {

constexpr double kNearPlaneOfNoCamera = 0.1; // m; of what is only a place to stand
constexpr double kSameStep = 1e-6;           // s; times are rounded sums of steps

bool startsHistoryAt(const Manifest& manifest, int frame) {
  return frame == 0 || manifest.frames[static_cast<std::size_t>(frame)].cut;
}

void checkSize(const Manifest& manifest) {
  const glm::ivec2 render = manifest.sizePx, output = manifest.outputSize();
  if (render.x < 1 || render.y < 1)
    throw Error(say<"cannot use a capture of %1 × %2 pixels">(render.x, render.y));
  if (output.x < render.x || output.y < render.y)
    throw Error(
        say<"the engine's output of this capture, %1 × %2 pixels, is smaller than its color, %3 × %4: "
            "leave the output out, or state the size it has">(output.x, output.y, render.x, render.y));
}

std::shared_ptr<const CaptureFacts> factsOf(const Manifest& manifest) {
  auto facts = std::make_shared<CaptureFacts>();
  facts->renderPx = manifest.sizePx;
  facts->outputPx = manifest.outputSize();
  for (std::size_t frame = 0; frame < manifest.frames.size(); ++frame)
    facts->jitterPx.emplace_back(decodeJitter(manifest, frame));
  facts->jitterPeriod = periodOf(facts->jitterPx);
  const auto has = [&](PlaneKind kind) { return manifest.framesWith(kind) > 0; };
  facts->hasCameraMotion =
      has(PlaneKind::Depth) && std::ranges::all_of(manifest.frames, [](const CapturedFrame& frame) {
        return frame.view && frame.projection;
      });
  facts->hasMask = has(PlaneKind::Mask);
  facts->hasOverlay = has(PlaneKind::Overlay);
  facts->hasOutput = has(PlaneKind::Output);
  facts->hasReference = has(PlaneKind::Reference);
  return facts;
}

/// Image `of` the frame, which lives as long as the handle; null where it is empty. Throws Error where it is
/// not as large as the picture.
std::shared_ptr<const Image> part(std::shared_ptr<const DecodedFrame> frame, const Image& of, PlaneKind kind,
                                  const Manifest& manifest) {
  if (of.empty()) return nullptr;
  const glm::ivec2 picturePx = manifest.outputSize();
  const int number = manifest.frames[static_cast<std::size_t>(frame->index)].number;
  if (of.width != picturePx.x || of.height != picturePx.y)
    throw Error(
        say<"plane \"%1\" of frame %2 has %3 × %4 pixels, and the picture has %5 × %6: nothing can be "
            "compared">(planeName(kind), number, of.width, of.height, picturePx.x, picturePx.y));
  return {std::move(frame), &of};
}

} // namespace

struct CaptureSource::Impl {
  Manifest manifest;
  FrameReader read;
  std::shared_ptr<const CaptureFacts> facts;
  CameraMotionPass cameraMotion;
  gl::Buffer frame{sizeof(shared::FrameBlock), nullptr, "frame"};
  DrawCounts counts; // nothing is drawn

  Impl(Manifest stated, FrameReader reader) : manifest(std::move(stated)), read(std::move(reader)) {
    checkSize(manifest);
    facts = factsOf(manifest);
  }

  std::shared_ptr<const DecodedFrame> decoded(int index) const {
    assert(index >= 0 && index < static_cast<int>(manifest.frames.size()));
    return read(index);
  }
  /// The engine's own, as messages say it.
  int numberOf(int index) const { return manifest.frames[static_cast<std::size_t>(index)].number; }
  void drawMotion(MotionSource source, const DecodedFrame& decoded, FrameInputs& out);
};

CaptureSource::CaptureSource(std::shared_ptr<const Capture> capture)
    : CaptureSource(capture->manifest(), [capture](int index) { return capture->frame(index); }) {}

CaptureSource::CaptureSource(Manifest manifest, FrameReader frames)
    : impl_(std::make_unique<Impl>(std::move(manifest), std::move(frames))) {}

CaptureSource::~CaptureSource() = default;

// Where it is asked for and can be, motion is made from depth and matrices; decode() has made what planes
// lack.
void CaptureSource::Impl::drawMotion(MotionSource source, const DecodedFrame& decoded, FrameInputs& out) {
  if (!isFromDepth(source) || !decoded.camera || decoded.depth.empty()) {
    uploadMotion(decoded, out);
    return;
  }
  frame.update(0, &out.block, sizeof(out.block));
  cameraMotion.draw(source, frame, out);
}

void CaptureSource::draw(const FrameRequest& request, int frame, FrameInputs& out) {
  const std::shared_ptr<const DecodedFrame> decoded = impl_->decoded(frame);
  InputSettings fitted = request.inputs;
  if (!impl_->facts->hasMask) fitted.mask = MaskSource::None;
  if (!impl_->facts->hasOverlay) fitted.blended = BlendedAs::Mask;
  fitInputs(fitted, impl_->facts->renderPx, impl_->facts->outputPx, out);
  out.info = info(request, frame);
  out.block = blockOf(*decoded, impl_->manifest, fitted.precision);
  uploadSurfaces(*decoded, out);
  if (out.forwardCount)
    out.forwardCount.clear(kForwardUnknown, 0.0f, 0.0f, 0.0f); // it holds no forward motion
  impl_->drawMotion(fitted.motion, *decoded, out);
  gl::checkErrors(say<"uploading frame %1 of the capture">(impl_->numberOf(frame)));
}

FrameInfo CaptureSource::info(const FrameRequest& request, int frame) const {
  const Manifest& manifest = impl_->manifest;
  const auto index = static_cast<std::size_t>(frame);
  const CapturedFrame& stated = manifest.frames.at(index);
  FrameInfo info;
  info.frame = frame;
  info.stepSeconds = 1.0 / manifest.framesPerSecond;
  info.time = stated.seconds.value_or(frame * info.stepSeconds);
  if (frame > 0 && stated.seconds && manifest.frames[index - 1].seconds)
    if (const double step = *stated.seconds - *manifest.frames[index - 1].seconds;
        step > 0.0 && std::abs(step - info.stepSeconds) > kSameStep)
      info.stepSeconds = step;
  info.jitterIndex = frame % impl_->facts->jitterPeriod;
  info.jitterPx = impl_->facts->jitterPx[index];
  info.startsHistory = startsHistoryAt(manifest, frame) ||
                       std::ranges::find(request.restarts, frame) != request.restarts.end();
  return info;
}

CameraState CaptureSource::camera(const FrameRequest& request, int frame) const {
  if (request.camera != kCaptureCamera || request.track)
    throw Error(say<"there is no camera \"%1\": %2">(request.camera, whyNoScene()));
  const Manifest& manifest = impl_->manifest;
  const auto stated = decodeCamera(manifest, manifest.frames.at(static_cast<std::size_t>(frame)));
  return stateOf(stated.value_or(unknownCamera(manifest.sizePx, kNearPlaneOfNoCamera)));
}

void CaptureSource::warmUp(const FrameRequest& request, const Progress& progress) {
  report(progress, say<"Reading the first frame">(), 0, 1);
  FrameInputs ignored;
  draw(request, 0, ignored);
  gl::finish();
  report(progress, say<"Reading the first frame">(), 1, 1);
}

const DrawCounts& CaptureSource::counts() const {
  return impl_->counts;
}

void CaptureSource::reloadShaders() {
  impl_->cameraMotion = impl_->cameraMotion.reloaded();
}

std::shared_ptr<const CaptureFacts> CaptureSource::capture() const {
  return impl_->facts;
}

std::shared_ptr<const Image> CaptureSource::reference(int frame) {
  if (!impl_->facts->hasReference) throw Error(whyNoReference());
  const auto decoded = impl_->decoded(frame);
  auto image = part(decoded, decoded->reference, PlaneKind::Reference, impl_->manifest);
  if (!image) throw Error(say<"frame %1 of this capture has no reference">(impl_->numberOf(frame)));
  return image;
}

std::shared_ptr<const Image> CaptureSource::engineOutput(int frame) {
  if (!impl_->facts->hasOutput) return nullptr;
  const auto decoded = impl_->decoded(frame);
  return part(decoded, decoded->output, PlaneKind::Output, impl_->manifest);
}

} // namespace taa::capture
