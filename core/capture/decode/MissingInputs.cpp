// What a capture lacks, and what is done instead, in sentences.
#include "core/base/Say.h"
#include "core/capture/decode/Color.h"
#include "core/capture/decode/DecodedFrame.h"

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <string>
#include <vector>

namespace taa::capture {

namespace {

using Sentences = std::vector<std::string>;

/// Matrices of all frames of a capture, and planes of any: sayFrames() says which frames lack them.
struct GivenInputs {
  bool motion, depth, matrices, ids, normals, previousDepth;
  bool canRebuild() const { return depth && matrices; }
};

GivenInputs inputsOf(const Manifest& manifest) {
  const bool hasMatrices = std::ranges::all_of(manifest.frames, [](const CapturedFrame& frame) {
    return frame.view.has_value() && frame.projection.has_value();
  });
  const auto has = [&](PlaneKind kind) { return manifest.framesWith(kind) > 0; };
  return {has(PlaneKind::Motion),   has(PlaneKind::Depth),  hasMatrices,
          has(PlaneKind::ObjectId), has(PlaneKind::Normal), has(PlaneKind::PreviousDepth)};
}

void sayFrames(const Manifest& manifest, Sentences& out) {
  for (std::size_t i = 0; i < kPlaneKinds; ++i) {
    const auto kind = static_cast<PlaneKind>(i);
    const std::size_t frames = manifest.framesWith(kind);
    if (frames == 0 || frames == manifest.frames.size()) continue;
    out.push_back(say<"%1 is part of %2 of %3 frames: the others are as if the capture had none">(
        planeName(kind), frames, manifest.frames.size()));
  }
}

void sayMatrices(const Manifest& manifest, const GivenInputs& inputs, Sentences& out) {
  if (inputs.matrices) return;
  const auto stated = std::ranges::count_if(
      manifest.frames, [](const CapturedFrame& frame) { return frame.view && frame.projection; });
  if (stated > 0)
    out.push_back(say<"matrices are stated for %1 of %2 frames: the others are without">(
        stated, manifest.frames.size()));
  out.push_back(
      say<"without matrices nothing is known of the camera: its motion cannot be rebuilt or compared, "
          "and neither can previous depth or places in the world">());
}

void sayMotion(const Manifest& manifest, const GivenInputs& inputs, Sentences& out) {
  const MotionConventions& motion = manifest.conventions.motion;
  if (!inputs.motion) {
    out.push_back(inputs.canRebuild()
                      ? say<"there is no motion: that of the camera is made of depth and matrices, and what "
                            "moves by itself trails">()
                      : say<"there is no motion, and no depth and matrices to make the camera's of: history "
                            "is read at the pixel itself">());
    return;
  }
  if (inputs.canRebuild()) return;
  const bool canLack = motion.notWritten || motion.encoding == MotionEncoding::Unreal;
  if (canLack && motion.fallback == MotionFallback::Camera)
    out.push_back(
        say<"motion that was not written cannot be made of depth and matrices, as one is missing: it "
            "is taken as 0">());
  if (inputs.depth && motion.whereNothing == MotionFallback::Camera)
    out.push_back(say<"motion of the sky cannot be made without matrices: it is taken as 0">());
  if (!inputs.depth && motion.whereNothing)
    out.push_back(say<"without depth the sky is not known: motion there is taken as it stands">());
  if (!motion.includesCamera)
    out.push_back(say<"motion lacks that of the camera, and depth or matrices to add it are missing">());
}

void sayDepth(const Manifest& manifest, const GivenInputs& inputs, Sentences& out) {
  const DepthConventions& depth = manifest.conventions.depth;
  if (!inputs.depth) {
    out.push_back(say<"there is no depth: motion is not dilated by it, and no history is rejected for it">());
    return;
  }
  if (!inputs.matrices && depth.kind == DepthKind::Window && depth.nearPlane <= 0.0)
    out.push_back(
        say<"neither matrices nor depth.nearPlane are stated: distances are known but for a factor, "
            "as if the near plane were 0.1 m away and the far one infinitely far">());
  if (!inputs.matrices && depth.kind == DepthKind::Radial)
    out.push_back(say<"radial depth is taken for planar, as there are no matrices">());
  if (!inputs.previousDepth)
    out.push_back(
        inputs.matrices
            ? say<"there is no previous depth: it is made of depth and matrices, as if nothing moved "
                  "by itself">()
            : say<"there is no previous depth: no history is rejected for it">());
}

void sayJitter(const Manifest& manifest, Sentences& out) {
  const bool isStill = std::ranges::all_of(
      manifest.frames, [](const CapturedFrame& frame) { return frame.jitter == glm::dvec2(0.0); });
  if (isStill && manifest.frames.size() > 1)
    out.push_back(say<"no frame has a jitter: edges of what rests are not smoothed">());
  const int delay = manifest.conventions.jitter.delay;
  if (delay > 0 && !isStill)
    out.push_back(
        say<"the jitter of the first frame is not stated, as jitter is a frame late: it is taken as 0">());
  if (delay < 0 && !isStill)
    out.push_back(
        say<"the jitter of the last frame is not stated, as jitter is a frame early: it is taken as 0">());
}

void sayExposure(const Manifest& manifest, Sentences& out) {
  const bool isOne = std::ranges::all_of(manifest.frames,
                                         [](const CapturedFrame& frame) { return frame.preExposure == 1.0; });
  if (manifest.conventions.color.preExposed && isOne)
    out.push_back(
        say<"color is pre-exposed by its conventions, and preExposure is 1 or not stated in every frame: "
            "color is taken as it is">());
}

/// Of raw planes the format is stated; that of pictures is known when they are read, see DecodedFrame::notes.
void saySteps(const Manifest& manifest, Sentences& out) {
  const bool hasEightBits = std::ranges::any_of(manifest.frames, [&](const CapturedFrame& frame) {
    const PlaneSource* color = manifest.plane(frame, PlaneKind::Color);
    return color && color->raw == RawFormat::RGBA8_UNORM;
  });
  if (isLinearInSteps(manifest, hasEightBits)) out.push_back(linearInSteps());
}

/// The size that a frame's raw plane states and that is not the frame's; null: none.
const PlaneSource* otherSize(const Manifest& manifest, PlaneKind kind) {
  for (const CapturedFrame& frame : manifest.frames) {
    const PlaneSource* source = manifest.plane(frame, kind);
    if (source && source->sizePx.x > 0 && source->sizePx != manifest.sizePx) return source;
  }
  return nullptr;
}

/// Of raw planes the size is stated; that of pictures is known when they are read, see DecodedFrame::notes.
void saySizes(const Manifest& manifest, Sentences& out) {
  for (std::size_t i = 0; i < kPlaneKinds; ++i) {
    const auto kind = static_cast<PlaneKind>(i);
    const bool hasOwnSize =
        kind == PlaneKind::Overlay || kind == PlaneKind::Output || kind == PlaneKind::Reference;
    const PlaneSource* source = hasOwnSize ? nullptr : otherSize(manifest, kind);
    if (!source) continue;
    out.push_back(say<"%1 is %2×%3 and the frame %4×%5: each pixel takes the nearest value">(
        planeName(kind), source->sizePx.x, source->sizePx.y, manifest.sizePx.x, manifest.sizePx.y));
  }
}

} // namespace

std::vector<std::string> missingInputs(const Manifest& manifest) {
  const GivenInputs inputs = inputsOf(manifest);
  Sentences out;
  sayFrames(manifest, out);
  sayMotion(manifest, inputs, out);
  sayDepth(manifest, inputs, out);
  sayMatrices(manifest, inputs, out);
  if (!inputs.ids) out.push_back(say<"there are no object ids: no history is rejected for another id">());
  if (!inputs.normals)
    out.push_back(say<"there are no normals: no history is rejected for another normal">());
  sayJitter(manifest, out);
  sayExposure(manifest, out);
  saySteps(manifest, out);
  saySizes(manifest, out);
  return out;
}

} // namespace taa::capture
