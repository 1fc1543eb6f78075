#include "core/capture/source/CaptureInputs.h"

#include "core/base/Half.h"
#include "core/capture/decode/Nearest.h"
#include "core/render/Cameras.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace taa::capture {

namespace {

// Larger ones would be infinite in half floats. NaN stays: it is for the resolve to catch, and to be seen.
Image insideHalves(const Image& color) {
  constexpr float kLargestHalf = 65504.0f;
  Image inside = color;
  for (float& value : inside.pixels) value = std::clamp(value, -kLargestHalf, kLargestHalf);
  return inside;
}

Image scaled(const Image& image, int width, int height) {
  Image other;
  other.width = width;
  other.height = height;
  other.channels = image.channels;
  other.pixels = resized(image.pixels, {image.width, image.height}, {width, height},
                         static_cast<std::size_t>(image.channels));
  return other;
}

void upload(const Image& image, gl::Texture& texture) {
  if (image.width != texture.width() || image.height != texture.height()) {
    upload(scaled(image, texture.width(), texture.height()), texture);
    return;
  }
  if (!gl::isHalf(texture.format())) {
    texture.upload(image);
    return;
  }
  // Drivers differ in how they round.
  std::vector<std::uint16_t> halves(image.pixels.size());
  toHalves(image.pixels, halves);
  texture.uploadHalves(halves);
}

void uploadOr0(const Image& image, gl::Texture& texture) {
  if (image.empty()) {
    texture.clear(0.0f, 0.0f, 0.0f, 0.0f);
    return;
  }
  upload(image, texture);
}

void uploadColor(const Image& color, gl::Texture& texture) {
  upload(gl::isHalf(texture.format()) ? insideHalves(color) : color, texture);
}

glm::dmat4 clipFromWorldOf(const DecodedCamera& camera) {
  return camera.clipFromView * camera.viewFromWorld;
}

// View depth of now: as if nothing came nearer or went away.
Image unchangedDepth(const Image& depth, const glm::vec4& terms) {
  Image view = depth;
  for (float& value : view.pixels)
    value = value > 0.0f ? (value * terms.x - terms.y) / (value * terms.z - terms.w) : 0.0f;
  return view;
}

} // namespace

DecodedCamera unknownCamera(const glm::ivec2& sizePx, double nearPlane) {
  DecodedCamera camera;
  camera.clipFromView = glm::dmat4(0.0);
  camera.clipFromView[0][0] = static_cast<double>(sizePx.y) / sizePx.x;
  camera.clipFromView[1][1] = 1.0;
  camera.clipFromView[2][3] = -1.0;
  camera.clipFromView[3][2] = nearPlane;
  return camera;
}

CameraState stateOf(const DecodedCamera& camera) {
  CameraState state;
  state.viewFromWorld = glm::mat4(camera.viewFromWorld);
  state.clipFromView = glm::mat4(camera.clipFromView);
  state.orthographic = camera.orthographic;
  if (!camera.orthographic) state.nearPlane = state.clipFromView[3][2];
  return state;
}

shared::FrameBlock blockOf(const DecodedFrame& frame, const Manifest& manifest, Precision precision) {
  const DecodedCamera camera = frame.camera ? *frame.camera : unknownCamera(manifest.sizePx, frame.nearPlane);
  const DecodedCamera previous = frame.previousCamera ? *frame.previousCamera : camera;
  shared::FrameBlock block{};
  fillCameras({stateOf(camera), stateOf(previous), glm::vec2(manifest.sizePx), frame.jitterPx,
               frame.previousJitterPx, JitterProjection::Translation},
              block);
  // Engines state worlds that are kilometers wide: floats would round the difference away.
  block.previousClipFromClip = previousClipFromClip(clipFromWorldOf(camera), clipFromWorldOf(previous));
  fillStorage(precision, 0.0f, frame.index, block);
  return block;
}

void uploadSurfaces(const DecodedFrame& frame, FrameInputs& out) {
  uploadColor(frame.color, out.color);
  uploadOr0(frame.depth, out.depth);
  uploadOr0(frame.normal, out.normal);
  if (frame.objectId.empty())
    out.objectId.clear(0.0f, 0.0f, 0.0f, 0.0f);
  else
    out.objectId.uploadIntegers(frame.objectId);
  if (out.mask) uploadOr0(frame.mask, out.mask);
  if (out.overlay) uploadOr0(frame.overlay, out.overlay);
  if (frame.fog.empty()) {
    out.fog = gl::Texture();
    return;
  }
  fitTexture(out.fog, {frame.fog.width, frame.fog.height}, out.color.format(), "fog");
  uploadColor(frame.fog, out.fog);
}

void uploadMotion(const DecodedFrame& frame, FrameInputs& out) {
  uploadOr0(frame.motion, out.motion);
  if (frame.previousDepth.empty() && !frame.depth.empty())
    upload(unchangedDepth(frame.depth, out.block.depthTerms), out.previousDepth);
  else
    uploadOr0(frame.previousDepth, out.previousDepth);
}

} // namespace taa::capture
