// Planes as they were read become a frame in this program's conventions.
#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/decode/CameraMotion.h"
#include "core/capture/decode/Cameras.h"
#include "core/capture/decode/Color.h"
#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/decode/Depth.h"
#include "core/capture/decode/Motion.h"
#include "core/capture/decode/PlaneShapes.h"

#include <cmath>
#include <optional>
#include <utility>

namespace taa::capture {

namespace {

void checkFrame(const Manifest& manifest, std::size_t index) {
  const bool hasSize = manifest.sizePx.x > 0 && manifest.sizePx.y > 0;
  if (!hasSize || manifest.sizePx.x > kMaxCaptureSide || manifest.sizePx.y > kMaxCaptureSide)
    throw Error(say<"the capture's frames are %1×%2; a side is 1 to %3 pixels">(
        manifest.sizePx.x, manifest.sizePx.y, kMaxCaptureSide));
  if (index >= manifest.frames.size())
    throw Error(say<"there is no frame %1 in this capture; it has %2">(index, manifest.frames.size()));
  if (!(manifest.framesPerSecond > 0.0)) throw Error(say<"framesPerSecond of the capture is not above 0">());
}

void takeInfo(const Manifest& manifest, std::size_t index, DecodedFrame& out) {
  const CapturedFrame& frame = manifest.frames[index];
  out.index = static_cast<int>(index);
  out.startsHistory = index == 0 || frame.cut;
  out.seconds = frame.seconds.value_or(static_cast<double>(index) / manifest.framesPerSecond);
  out.jitterPx = glm::vec2(decodeJitter(manifest, index));
  out.previousJitterPx = out.startsHistory ? out.jitterPx : glm::vec2(decodeJitter(manifest, index - 1));
}

void takeColors(const Manifest& manifest, const CapturedFrame& frame, PlaneShapes& planes,
                DecodedFrame& out) {
  out.color = planes.takeUnscaled(PlaneKind::Color);
  if (out.color.empty()) throw Error(say<"frame %1 has no color">(frame.number));
  if (glm::ivec2(out.color.width, out.color.height) != manifest.sizePx)
    throw Error(say<"frame %1: color is %2×%3, and the capture states %4×%5">(
        frame.number, out.color.width, out.color.height, manifest.sizePx.x, manifest.sizePx.y));
  out.overlay = planes.takeUnscaled(PlaneKind::Overlay);
  out.fog = planes.take(PlaneKind::Fog);
  out.output = planes.takeUnscaled(PlaneKind::Output);
  out.reference = planes.takeUnscaled(PlaneKind::Reference);
  const std::pair<PlaneKind, Image*> colors[] = {{PlaneKind::Color, &out.color},
                                                 {PlaneKind::Overlay, &out.overlay},
                                                 {PlaneKind::Fog, &out.fog},
                                                 {PlaneKind::Output, &out.output},
                                                 {PlaneKind::Reference, &out.reference}};
  for (const auto& [kind, image] : colors)
    if (!image->empty()) ColorDecoder(manifest, frame, kind).decode(*image);
}

/// Depth, previous depth and motion, which are made of each other and the cameras.
void takeGeometry(const Manifest& manifest, const StatedCamera* camera, PlaneShapes& planes,
                  DecodedFrame& out) {
  const DepthDecoder depth(manifest, camera, out.jitterPx);
  out.nearPlane = depth.nearPlane();
  out.depth = planes.take(PlaneKind::Depth);
  if (!out.depth.empty()) depth.decode(out.depth);

  std::optional<CameraMotion> cameraMotion;
  if (out.camera && !out.depth.empty())
    cameraMotion.emplace(*out.camera, *out.previousCamera, manifest.sizePx,
                         manifest.conventions.depth.jittered ? glm::dvec2(out.jitterPx) : glm::dvec2(0.0));
  out.previousDepth = planes.take(PlaneKind::PreviousDepth);
  if (out.previousDepth.empty() && cameraMotion)
    out.previousDepth = previousDepthOf(*cameraMotion, out.depth);

  const MotionInputs inputs{out.jitterPx, out.previousJitterPx, out.depth.empty() ? nullptr : &out.depth,
                            cameraMotion ? &*cameraMotion : nullptr};
  const MotionDecoder motion(manifest, inputs);
  out.motion = planes.take(PlaneKind::Motion);
  if (!out.motion.empty())
    motion.decode(out.motion);
  else if (cameraMotion)
    out.motion = motionOf(*cameraMotion, out.depth);
}

} // namespace

DecodedFrame decode(const Manifest& manifest, std::size_t index, FramePlanes&& planes) {
  checkFrame(manifest, index);
  const CapturedFrame& frame = manifest.frames[index];
  DecodedFrame out;
  takeInfo(manifest, index, out);
  const StatedCameras cameras = statedCameras(manifest, index);
  if (cameras.now && cameras.previous) {
    out.camera = cameras.now->camera;
    out.previousCamera = cameras.previous->camera;
  }
  const auto color = planes.find(PlaneKind::Color);
  const bool isInSteps = color != planes.end() && isLinearInSteps(manifest, color->second.hasEightBits);
  PlaneShapes shapes(planes, manifest.sizePx, frame.number);
  takeColors(manifest, frame, shapes, out);
  takeGeometry(manifest, cameras.now ? &*cameras.now : nullptr, shapes, out);
  out.normal = shapes.takeNormals();
  out.mask = shapes.take(PlaneKind::Mask);
  out.objectId = shapes.takeIds();
  out.notes = shapes.notes();
  if (isInSteps) out.notes.push_back(linearInSteps());
  return out;
}

DecodedFrame decode(const Manifest& manifest, std::size_t index, const FramePlanes& planes) {
  return decode(manifest, index, FramePlanes(planes));
}

} // namespace taa::capture
