#include "core/report/CaptureExport.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/Text.h"
#include "core/capture/decode/Cameras.h"
#include "core/capture/decode/DecodedFrame.h"
#include "core/capture/decode/Depth.h"
#include "core/capture/format/Manifest.h"
#include "core/capture/planes/Planes.h"
#include "core/capture/source/Capture.h"
#include "core/inspect/Inspector.h"
#include "core/replay/FrameMaker.h"
#include "core/report/CaptureFormats.h"
#include "core/scene/SceneOutline.h"
#include "core/settings/Faults.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace taa {

namespace fs = std::filesystem;
using capture::DecodedFrame;
using capture::PlaneKind;

namespace {

constexpr const char* kEngineName = "TAA Inspector";

/// "color.{frame:4}.raw", as taa_capture.h names them.
std::string planePattern(PlaneKind kind) {
  return std::string(capture::planeName(kind)) + ".{frame:4}.raw";
}

Image withAlphaOf1(const Image& color) {
  Image result(color.width, color.height, 4);
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x) {
      std::copy_n(color.at(x, y), 3, result.at(x, y));
      result.at(x, y)[3] = 1.0f;
    }
  return result;
}

Image downloaded(const gl::Texture& texture) {
  return texture ? texture.download() : Image();
}

capture::DecodedCamera inDouble(const CameraState& camera) {
  return {glm::dmat4(camera.viewFromWorld), glm::dmat4(camera.clipFromView), camera.orthographic};
}

/// Names of the objects' numbers; those of one node's parts differ.
std::map<std::uint32_t, std::string> namesOfIds(const InspectedShot& shot) {
  std::map<std::uint32_t, std::string> names;
  for (const OutlineNode& node : outlineOf(shot.scene(), shot.source()).nodes)
    for (int part = 0; part < node.objectCount; ++part) {
      const std::string number = part > 0 ? " " + std::to_string(part + 1) : "";
      names[static_cast<std::uint32_t>(node.firstObject + part)] = shownText(node.key) + number;
    }
  return names;
}

template <typename Value>
void turnOver(std::vector<Value>& values, int rows) {
  const std::size_t row = values.size() / static_cast<std::size_t>(rows);
  for (int y = 0; y < rows / 2; ++y) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(y));
    const auto last = values.end() - static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(y + 1));
    std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(row), last);
  }
}

/// Rows as the conventions have them; expects them from the top.
void orderRows(capture::RowOrder order, capture::PlaneData& plane) {
  if (order == capture::RowOrder::TopFirst) return;
  turnOver(plane.integers, plane.height);
  turnOver(plane.image.pixels, plane.height);
}

/// Depth is its frame's near plane over a distance; of another near plane it is as much more.
void scaleDepth(DecodedFrame& frame, double nearPlane) {
  if (nearPlane == frame.nearPlane) return;
  for (float& value : frame.depth.pixels)
    value = static_cast<float>(static_cast<double>(value) * nearPlane / frame.nearPlane);
  frame.nearPlane = nearPlane;
}

} // namespace

struct CaptureExport::Impl {
  Inspector& inspector;
  const CaptureChoice choice;
  const int first;
  capture::Manifest manifest;
  CaptureFormats formats;
  std::shared_ptr<const capture::Capture> source; // also owned by the shot; null: a scene is open

  Impl(Inspector& looked, CaptureChoice chosen, int firstFrame, int last);
  DecodedFrame shownFrame(const Progress& progress);
  void takeInputs(DecodedFrame& frame) const;
  void takeCameras(DecodedFrame& frame) const;
  void leaveOutMadeUp(DecodedFrame& frame) const;
  void write(const fs::path& folder, std::size_t index, capture::FramePlanes&& planes);
};

CaptureExport::Impl::Impl(Inspector& looked, CaptureChoice chosen, int firstFrame, int last)
    : inspector(looked), choice(std::move(chosen)), first(firstFrame),
      formats(choice.like, conventionsOf(choice),
              inspector.shot().usedSettings(choice.lane).inputs.precision == Precision::Half,
              inspector.shot().usedSettings(choice.lane).history.precision == Precision::Half) {
  const InspectedShot& shot = inspector.shot();
  assert(last >= first);
  if (shot.capture()) source = capture::openCapture(shot.source());
  const FrameInputs& inputs = inspector.views().inputs(choice.lane);
  manifest.name = shownText(shot.scene().name);
  manifest.engine = kEngineName;
  manifest.like = choice.like;
  manifest.conventions = conventionsOf(choice);
  manifest.sizePx = {inputs.width(), inputs.height()};
  manifest.outputPx = {shot.width(), shot.height()};
  if (manifest.outputPx == manifest.sizePx) manifest.outputPx = glm::ivec2(0);
  manifest.framesPerSecond = shot.scene().shot.framesPerSecond;
  manifest.objects = namesOfIds(shot);
  if (source) manifest.notes = source->manifest().notes;
  const std::vector<std::string> faults = injectedFaults(shot.usedSettings(choice.lane));
  if (choice.namesFaults && !faults.empty())
    manifest.notes.push_back(say<"faults are injected: %1">(joined(faults)));
  if (manifest.conventions.jitter.delay != 0)
    manifest.notes.push_back(
        say<"jitter is stated with another frame than its own: that of frame %1 is not part of the capture">(
            manifest.conventions.jitter.delay > 0 ? first : last));
  manifest.frames.resize(static_cast<std::size_t>(last - first + 1));
  for (std::size_t i = 0; i < manifest.frames.size(); ++i)
    manifest.frames[i].number = first + static_cast<int>(i);
}

void CaptureExport::Impl::takeInputs(DecodedFrame& frame) const {
  const FrameInputs& inputs = inspector.views().inputs(choice.lane);
  frame.color = inputs.color.download();
  frame.motion = inputs.motion.download();
  frame.depth = inputs.depth.download();
  frame.normal = inputs.normal.download();
  frame.previousDepth = inputs.previousDepth.download();
  frame.objectId = inputs.objectId.downloadIntegers();
  frame.mask = downloaded(inputs.mask);
  frame.overlay = downloaded(inputs.overlay);
  frame.fog = downloaded(inputs.fog);
  frame.jitterPx = inputs.block.jitterPx;
  frame.previousJitterPx = frame.startsHistory ? frame.jitterPx : glm::vec2(inputs.block.previousJitter);
}

// A capture's own are in double.
void CaptureExport::Impl::takeCameras(DecodedFrame& frame) const {
  if (!source) {
    const FrameCameraPair cameras = inspector.shot().shownCameras(choice.lane);
    frame.camera = inDouble(cameras.now);
    frame.previousCamera = inDouble(cameras.previous);
    if (!frame.camera->orthographic) frame.nearPlane = frame.camera->clipFromView[3][2];
  } else {
    const auto index = static_cast<std::size_t>(inspector.shot().frame());
    const capture::StatedCameras cameras = capture::statedCameras(source->manifest(), index);
    if (cameras.now && cameras.previous) {
      frame.camera = cameras.now->camera;
      frame.previousCamera = cameras.previous->camera;
    }
    frame.nearPlane = static_cast<double>(inspector.views().inputs(choice.lane).block.depthTerms.y);
    if (!frame.camera) scaleDepth(frame, capture::DepthDecoder(manifest, nullptr, {}).nearPlane());
  }
  if (frame.startsHistory) frame.previousCamera = frame.camera;
}

// What the source has not is missing in the copy, too: who reads it makes it up in the same way.
void CaptureExport::Impl::leaveOutMadeUp(DecodedFrame& frame) const {
  if (!source) return;
  const capture::Manifest& stated = source->manifest();
  const capture::CapturedFrame& own = stated.frames.at(static_cast<std::size_t>(inspector.shot().frame()));
  const auto isThere = [&](PlaneKind kind) { return stated.plane(own, kind) != nullptr; };
  const std::pair<PlaneKind, Image DecodedFrame::*> planes[] = {
      {PlaneKind::Motion, &DecodedFrame::motion}, {PlaneKind::Depth, &DecodedFrame::depth},
      {PlaneKind::Normal, &DecodedFrame::normal}, {PlaneKind::PreviousDepth, &DecodedFrame::previousDepth},
      {PlaneKind::Mask, &DecodedFrame::mask},     {PlaneKind::Overlay, &DecodedFrame::overlay},
      {PlaneKind::Fog, &DecodedFrame::fog}};
  for (const auto& [kind, plane] : planes)
    if (!isThere(kind)) frame.*plane = Image();
  if (!isThere(PlaneKind::ObjectId)) frame.objectId.clear();
}

DecodedFrame CaptureExport::Impl::shownFrame(const Progress& progress) {
  const FrameInfo info = inspector.shot().info(choice.lane);
  DecodedFrame frame;
  frame.index = info.frame - first;
  frame.startsHistory = frame.index == 0 || info.startsHistory;
  frame.seconds = info.time;
  takeInputs(frame);
  takeCameras(frame);
  leaveOutMadeUp(frame);
  frame.output = withAlphaOf1(inspector.views().image(IntermediateId::resolved, choice.lane));
  if (choice.referenceSamples > 0) {
    inspector.reference().refine(choice.referenceSamples, progress, choice.lane);
    frame.reference = withAlphaOf1(inspector.views().image(IntermediateId::reference, choice.lane));
  }
  return frame;
}

void CaptureExport::Impl::write(const fs::path& folder, std::size_t index, capture::FramePlanes&& planes) {
  capture::CapturedFrame& stated = manifest.frames.at(index);
  for (auto& [kind, plane] : planes) {
    capture::PlaneSource file{.file = planePattern(kind),
                              .part = {},
                              .channels = {},
                              .raw = formats.format(kind),
                              .sizePx = {plane.width, plane.height},
                              .rowPitch = 0,
                              .rows = {}};
    orderRows(manifest.conventions.rows, plane);
    capture::writeRawPlane(folder / capture::planeFile(file, stated.number), plane, *file.raw);
    stated.planes[kind] = std::move(file);
  }
}

capture::Conventions conventionsOf(const CaptureChoice& choice) {
  capture::Conventions conventions = capture::startingPoint(choice.like).conventions;
  for (const std::string& assignment : choice.conventions) capture::applyAssignment(conventions, assignment);
  if (const std::string wrong = capture::contradiction(conventions); !wrong.empty()) throw Error(wrong);
  return capture::normalized(conventions);
}

std::vector<fs::path> captureFiles(const fs::path& folder, int first, int last) {
  std::vector<fs::path> files;
  for (int frame = first; frame <= last; ++frame)
    for (std::size_t i = 0; i < capture::kPlaneKinds; ++i) {
      capture::PlaneSource plane;
      plane.file = planePattern(static_cast<PlaneKind>(i));
      files.push_back(folder / capture::planeFile(plane, frame));
    }
  files.push_back(folder / capture::kManifestName);
  return files;
}

CaptureExport::CaptureExport(Inspector& inspector, CaptureChoice choice, int first, int last)
    : impl_(std::make_unique<Impl>(inspector, std::move(choice), first, last)) {}

CaptureExport::~CaptureExport() = default;

void CaptureExport::add(const fs::path& folder, const Progress& progress) {
  const DecodedFrame frame = impl_->shownFrame(progress);
  const auto index = static_cast<std::size_t>(frame.index);
  capture::encodeFrame(impl_->manifest, index, frame);
  impl_->write(folder, index, capture::encode(impl_->manifest, frame));
}

std::vector<std::string> CaptureExport::finish(const fs::path& folder) {
  capture::Manifest& manifest = impl_->manifest;
  std::vector<std::string> files;
  for (const capture::CapturedFrame& frame : manifest.frames)
    for (const auto& [kind, plane] : frame.planes) files.push_back(capture::planeFile(plane, frame.number));
  // What all frames have in the same way is said once.
  for (const auto& [kind, plane] : std::map(manifest.frames.front().planes)) {
    const auto isThere = [&](const capture::CapturedFrame& frame) {
      const auto found = frame.planes.find(kind);
      return found != frame.planes.end() && found->second == plane;
    };
    if (!std::ranges::all_of(manifest.frames, isThere)) continue;
    manifest.planes[kind] = plane;
    for (capture::CapturedFrame& frame : manifest.frames) frame.planes.erase(kind);
  }
  writeFile(folder / capture::kManifestName, capture::manifestText(manifest));
  files.emplace_back(capture::kManifestName);
  return files;
}

} // namespace taa
