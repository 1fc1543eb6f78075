// A frame in this program's conventions becomes planes and frame data in those of a capture.
#include "core/capture/decode/CameraMotion.h"
#include "core/capture/decode/Cameras.h"
#include "core/capture/decode/Color.h"
#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/decode/Depth.h"
#include "core/capture/decode/Motion.h"
#include "core/capture/decode/ScreenUnits.h"

#include <limits>
#include <optional>
#include <utility>

namespace taa::capture {

namespace {

void put(FramePlanes& planes, PlaneKind kind, Image&& image) {
  if (image.empty()) return;
  PlaneData& plane = planes[kind];
  plane.width = image.width;
  plane.height = image.height;
  plane.image = std::move(image);
}

/// The camera with the planes that encodeFrame() gives its projection.
std::optional<StatedCamera> cameraToState(const Manifest& manifest, const DecodedFrame& frame) {
  if (!frame.camera) return {};
  const double farPlane = manifest.conventions.depth.farPlane;
  StatedCamera camera{*frame.camera, frame.nearPlane, std::numeric_limits<double>::infinity()};
  const glm::dmat4& clip = frame.camera->clipFromView;
  if (camera.camera.orthographic) {
    camera.nearPlane = (clip[3][2] - 1.0) / clip[2][2];
    camera.farPlane = clip[3][2] / clip[2][2];
    return camera;
  }
  camera.nearPlane = clip[3][2];
  if (farPlane > 0.0) camera.farPlane = farPlane * manifest.conventions.matrices.metersPerUnit;
  return camera;
}

void putGeometry(const Manifest& manifest, const DecodedFrame& frame, FramePlanes& planes) {
  const std::optional<StatedCamera> camera = cameraToState(manifest, frame);
  if (!frame.depth.empty()) {
    Image depth = frame.depth;
    DepthDecoder(manifest, camera ? &*camera : nullptr, frame.jitterPx).encode(depth);
    put(planes, PlaneKind::Depth, std::move(depth));
  }
  if (frame.motion.empty()) return;
  std::optional<CameraMotion> cameraMotion;
  if (frame.camera && frame.previousCamera && !frame.depth.empty())
    cameraMotion.emplace(*frame.camera, *frame.previousCamera, manifest.sizePx,
                         manifest.conventions.depth.jittered ? glm::dvec2(frame.jitterPx) : glm::dvec2(0.0));
  const MotionInputs inputs{frame.jitterPx, frame.previousJitterPx,
                            frame.depth.empty() ? nullptr : &frame.depth,
                            cameraMotion ? &*cameraMotion : nullptr};
  Image motion = frame.motion;
  MotionDecoder(manifest, inputs).encode(motion);
  put(planes, PlaneKind::Motion, std::move(motion));
}

} // namespace

FramePlanes encode(const Manifest& manifest, const DecodedFrame& frame) {
  const CapturedFrame& stated = manifest.frames.at(static_cast<std::size_t>(frame.index));
  FramePlanes planes;
  const auto putColor = [&](PlaneKind kind, Image image) {
    if (!image.empty()) ColorDecoder(manifest, stated, kind).encode(image);
    put(planes, kind, std::move(image));
  };
  putColor(PlaneKind::Color, frame.color);
  putColor(PlaneKind::Overlay, frame.overlay);
  putColor(PlaneKind::Fog, frame.fog);
  putColor(PlaneKind::Output, frame.output);
  putColor(PlaneKind::Reference, frame.reference);
  putGeometry(manifest, frame, planes);
  put(planes, PlaneKind::Normal, Image(frame.normal));
  put(planes, PlaneKind::PreviousDepth, Image(frame.previousDepth));
  put(planes, PlaneKind::Mask, Image(frame.mask));
  if (!frame.objectId.empty()) {
    PlaneData& ids = planes[PlaneKind::ObjectId];
    ids.width = manifest.sizePx.x;
    ids.height = manifest.sizePx.y;
    ids.integers = frame.objectId;
  }
  return planes;
}

void encodeFrame(Manifest& manifest, std::size_t index, const DecodedFrame& frame) {
  CapturedFrame& stated = manifest.frames.at(index);
  if (const std::optional<std::size_t> at = statesJitterOf(manifest, index))
    manifest.frames[*at].jitter = glm::dvec2(frame.jitterPx) / pxPerJitter(manifest) + 0.0; // no −0
  stated.seconds = frame.seconds;
  stated.cut = frame.startsHistory && index > 0;
  stated.view = stated.projection = stated.previousView = stated.previousProjection = {};
  if (!frame.camera) return;
  const CameraMatrices now = encodedCamera(manifest, *frame.camera, frame.jitterPx);
  stated.view = now.view;
  stated.projection = now.projection;
  if (!frame.previousCamera || frame.startsHistory) return;
  const CameraMatrices before = encodedCamera(manifest, *frame.previousCamera, frame.previousJitterPx);
  stated.previousView = before.view;
  stated.previousProjection = before.projection;
}

} // namespace taa::capture
