#include "core/doctor/source/DoctorSource.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/decode/Cameras.h"
#include "core/capture/source/Capture.h"
#include "core/capture/source/CaptureSource.h"
#include "core/capture/source/OpenSource.h"
#include "core/doctor/source/StatedConventions.h"
#include "core/doctor/source/StatedMotion.h"
#include "core/render/CaptureFacts.h"
#include "core/render/faults/FaultySource.h"
#include "core/scene/SceneOutline.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Faults.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

namespace taa::doctor {

namespace {

bool hasResolveFault(const Settings& settings) {
  return std::ranges::any_of(faultTable(), [&](const FaultInfo& info) {
    return info.part == FaultPart::Resolve && isInjected(info.fault, settings);
  });
}

/// Cuts are stated as they are, whatever the resolve does there.
FaultSettings statedFaults(FaultSettings faults) {
  faults.keepsAtCuts = Switch::Off;
  return faults;
}

/// Leaves the near plane to the matrices where these have another one than is stated, so that all else can be
/// examined by depth. Returns what is stated over that of the matrices.
float takeNearPlane(capture::Manifest& manifest) {
  constexpr double kSame = 1e-3;
  capture::DepthConventions& depth = manifest.conventions.depth;
  const auto camera = capture::statedCameras(manifest, 0).now;
  if (!camera || depth.kind != capture::DepthKind::Window || !(depth.nearPlane > 0.0)) return 1.0f;
  const double factor = depth.nearPlane * manifest.conventions.matrices.metersPerUnit / camera->nearPlane;
  if (std::abs(factor - 1.0) <= kSame) return 1.0f;
  depth.nearPlane = depth.farPlane = 0.0;
  return static_cast<float>(factor);
}

DoctorSource openCaptureForDoctor(const SourceRequest& request, const Progress& progress) {
  const auto opened = capture::openCapture(request.source, progress);
  capture::Manifest manifest = opened->manifest();
  DoctorSource out;
  out.frameCount = static_cast<int>(manifest.frames.size());
  out.objectNames = manifest.objects;
  for (std::size_t frame = 0; frame < manifest.frames.size(); ++frame)
    out.preExposure[static_cast<int>(frame)] = manifest.frames[frame].preExposure;
  std::vector<int> numbers;
  for (const capture::CapturedFrame& frame : manifest.frames) numbers.push_back(frame.number);
  out.frameNames = FrameNames(std::move(numbers));
  out.known.motion = manifest.framesWith(capture::PlaneKind::Motion) > 0;
  out.known.depth = manifest.framesWith(capture::PlaneKind::Depth) > 0;
  out.known.ids = manifest.framesWith(capture::PlaneKind::ObjectId) > 0;
  out.contradicted = correctContradicted(opened->folder(), manifest);
  out.conventions = manifest.conventions;
  out.known.nearFactor = takeNearPlane(manifest);
  for (Finding& finding : correctMotion(opened->folder(), manifest))
    out.contradicted.push_back(std::move(finding));
  out.known.depthJittered = manifest.conventions.depth.jittered;
  out.known.depthDistance = manifest.conventions.depth.kind != capture::DepthKind::Window;
  out.conventions->motion = manifest.conventions.motion;
  out.conventions->jitter = manifest.conventions.jitter;
  out.frames = std::make_shared<FaultySource>(std::make_unique<capture::CaptureSource>(
      std::make_shared<const capture::Capture>(opened->folder(), std::move(manifest))));
  const auto facts = out.frames->capture();
  out.known.camera = facts->hasCameraMotion;
  out.request.camera = kCaptureCamera;
  out.request.width = facts->outputPx.x;
  out.request.height = facts->outputPx.y;
  drawWith(request.settings, out);
  return out;
}

DoctorSource openSceneForDoctor(const SourceRequest& request, const Progress& progress) {
  OpenedSource opened = openSource(request.source, progress, request.choice);
  DoctorSource out;
  out.frames = std::move(opened.frames);
  out.scene = opened.scene;
  out.frameCount = opened.scene->shot.frames;
  const SceneOutline outline = outlineOf(*opened.scene, request.source);
  for (const int node : outline.drawing) {
    const OutlineNode& item = outline.nodes[static_cast<std::size_t>(node)];
    for (int object = 0; object < item.objectCount; ++object)
      out.objectNames[static_cast<std::uint32_t>(item.firstObject + object)] =
          opened.scene->nodes[static_cast<std::size_t>(node)].name;
  }
  out.request.camera = request.camera.empty() ? opened.scene->shot.camera : request.camera;
  out.request.width = request.sizePx.x;
  out.request.height = request.sizePx.y;
  drawWith(request.settings, out);
  return out;
}

} // namespace

DoctorSource openForDoctor(const SourceRequest& request, const Progress& progress) {
  if (isBuiltinScene(request.source) || !capture::isCapture(request.source))
    return openSceneForDoctor(request, progress);
  if (request.choice != ShotChoice{})
    throw ChoiceError(say<"%1 is a captured sequence, whose animation and length are fixed">(request.source));
  return openCaptureForDoctor(request, progress);
}

void drawWith(const Settings& settings, DoctorSource& source) {
  const auto facts = source.frames->capture();
  const Settings used = facts ? settingsOn(*facts, settings) : settings;
  source.request.jitter = used.jitter;
  source.request.inputs = used.inputs;
  source.request.faults = statedFaults(used.fault);
  if (!facts || hasResolveFault(used))
    source.output = std::make_shared<OwnOutput>(used);
  else
    source.output = facts->hasOutput ? std::make_shared<CapturedOutput>() : nullptr;
  source.known.output = source.output != nullptr;
  source.known.maskUsed = facts || used.inputs.mask != MaskSource::None;
  // What is blended over a surface, and what changes without motion, is no evidence of it.
  if (!facts) source.request.inputs.mask = MaskSource::Opacity;
}

FrameReader readerOf(const DoctorSource& source) {
  return [frames = source.frames, output = source.output, request = source.request, known = source.known,
          count = source.frameCount](int frame) {
    if (frame < 0 || frame >= count)
      throw Error(say<"there is no frame %1: there are %2, from 0">(frame, count));
    return readFrame(*frames, request, known, frame, output.get());
  };
}

} // namespace taa::doctor
