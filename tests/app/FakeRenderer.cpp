#include "tests/app/FakeRenderer.h"

#include "core/render/CaptureFacts.h"
#include "core/taa/twin/Traced.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace taa::app::test {

namespace {

// A group with two objects, whose numbers are 1 and 2, beside a light.
std::shared_ptr<const SceneOutline> fakeOutline(const std::string& source) {
  SceneOutline outline;
  outline.source = source;
  outline.radius = 2.0f;
  const auto add = [&](const char* name, int parent, NodeKind kind, int object) {
    OutlineNode node;
    node.key = name;
    node.parent = parent;
    node.kind = kind;
    node.firstObject = object;
    node.objectCount = object > 0 ? 1 : 0;
    outline.nodes.push_back(node);
  };
  add("fan", -1, NodeKind::Group, 0);
  add("floor", 0, NodeKind::Mesh, 1);
  add("rotor & hub", 0, NodeKind::Mesh, 2);
  add("lamp", -1, NodeKind::Light, 0);
  outline.drawing = {1, 2};
  return std::make_shared<const SceneOutline>(std::move(outline));
}

std::shared_ptr<const CaptureFacts> fakeCapture() {
  CaptureFacts facts;
  facts.renderPx = facts.outputPx = {64, 36};
  facts.jitterPx = {{0.25f, 0.0f}, {-0.25f, 0.0f}, {0.25f, 0.0f}, {-0.25f, 0.0f}};
  facts.jitterPeriod = 2;
  facts.hasOutput = true;
  return std::make_shared<const CaptureFacts>(facts);
}

} // namespace

FakeRenderer::FakeRenderer(Listener listener) : listener_(std::move(listener)) {}

FakeRenderer::~FakeRenderer() = default;

void FakeRenderer::tell(Result result) const {
  listener_({requests, std::move(result)});
}

RequestId FakeRenderer::post(Request request) {
  const RequestKind kind = ruleOf(request).kind;
  status.taken.note(kind, requests + 1);
  std::visit(
      [&]<class T>(const T& asked) {
        if (refuses(kind)) return;
        all<T>().push_back(asked);
        take(asked);
      },
      request);
  return ++requests;
}

void FakeRenderer::take(const request::Open& asked) {
  const auto& [source, choice, budget] = asked;
  const bool isCapture = source.ends_with(kFakeCapture);
  if (!source.starts_with("builtin:") && !isCapture) {
    tell(Failure{"cannot open " + source + ": there is no such file", RequestKind::Source, requests + 1});
    return;
  }
  const SceneBudget allowed = budget.value_or(last<request::SetSceneBudget>().budget);
  if (source == kFakeLarge && allowed.triangles < kTrianglesOfLarge) {
    const SceneBudget needed{kTrianglesOfLarge, allowed.bytes};
    tell(Failure{"cannot open it: too many triangles", RequestKind::Source, requests + 1, needed});
    return;
  }
  status.source = source;
  status.opened = requests + 1; // as post() is about to say
  ++status.shotVersion;
  status.cameras = {"still", "pan"};
  status.camera = "still";
  status.capture = isCapture ? fakeCapture() : nullptr;
  if (isCapture) {
    status.camera = kCaptureCamera;
    status.cameras = {kCaptureCamera};
  }
  status.objects = {"floor", "rotor & hub"};
  status.motionModes.clear();
  status.filter = {};
  status.objectClasses.clear();
  status.restarts.clear();
  status.tracks.clear();
  status.outline = fakeOutline(source);
  status.choice = choice;
  status.animations.clear();
  if (source == kFakeAnimated) status.animations = {"walk", "run & jump"};
  status.frameCount = choice.frames > 0 ? choice.frames : 240;
  status.width = 64;
  status.height = 36;
  status.jitterPeriod = 16;
  status.info = {};
  deliver();
}

void FakeRenderer::take(const request::SetSize& asked) {
  const auto& [width, height] = asked;
  status.width = width;
  status.height = height;
  deliver();
}

bool FakeRenderer::refuses(RequestKind kind) {
  if (refused != kind) return false;
  refused.reset();
  tell(Failure{"this is refused", kind, requests + 1});
  tell(status);
  return true;
}

void FakeRenderer::take(const request::AddCameraTrack& asked) {
  const auto& [track] = asked;
  std::erase_if(status.tracks, [&](const CameraTrackHandle& known) { return known->name == track.name; });
  std::erase(status.cameras, track.name);
  status.tracks.push_back(std::make_shared<const CameraTrack>(track));
  status.cameras.push_back(track.name);
  status.camera = track.name;
  status.pose = track.at(status.info.frame);
  deliver();
}

void FakeRenderer::take(const request::SetFlownCameras& asked) {
  const auto& [cameras] = asked;
  for (const CameraTrackHandle& track : status.tracks) std::erase(status.cameras, track->name);
  status.tracks.clear();
  for (const CameraTrack& track : cameras.tracks) {
    status.tracks.push_back(std::make_shared<const CameraTrack>(track));
    status.cameras.push_back(track.name);
  }
  status.camera = cameras.camera;
  deliver();
}

/// Object n is seen in the box from (10·n, 5) that is 4 pixels wide and 3 high.
void FakeRenderer::take(const request::Locate& asked) {
  const auto& [objects] = asked;
  if (objects.empty()) return;
  ObjectArea area;
  area.objects = objects;
  area.frame = status.info.frame;
  area.pixels = 12;
  area.box = {10 * objects.front(), 5, 4, 3};
  area.pixel = {10 * objects.front() + 1, 6};
  tell(std::move(area));
}

/// The n-th that is asked for is at (n, 2).
void FakeRenderer::take(const request::FindWorst& asked) {
  const int number = static_cast<int>(all<request::FindWorst>().size());
  WorstDelivery worst;
  worst.frame = status.info.frame;
  worst.found.question = {.row = IntermediateId::verdictMap, .category = 2};
  worst.found.step = asked.step;
  worst.found.worst.badness = 0.5f;
  worst.found.worst.pixel = {number, 2};
  worst.found.number = number;
  worst.found.count = 5;
  tell(std::move(worst));
}

void FakeRenderer::take(const request::SetSettings& asked) {
  const auto& [settings] = asked;
  ++status.shotVersion;
  status.settings = settings;
  deliver();
}

void FakeRenderer::take(const request::FillTraces& asked) {
  for (int frame = asked.first; frame <= asked.last; ++frame)
    for (const Probe& probe : last<request::SetProbes>().all) deliverTrace(probe, frame);
}

/// Every channel is valueAt(); history is rejected in frames that are multiples of ten, for their depth.
void FakeRenderer::deliverTrace(const Probe& probe, int frame) {
  TraceDelivery trace{
      .probe = probe, .frame = frame, .sample = {probe.pixel, {}}, .shotVersion = status.shotVersion};
  trace.sample.record.fill(glm::vec4(valueAt(probe.pixel.x, probe.pixel.y, frame)));
  const float reason = frame % 10 == 0 ? 4.0f : 0.0f;
  twin::at(trace.sample.record, IntermediateId::rejectReason) = glm::vec4(reason);
  tell(trace);
}

void FakeRenderer::take(const request::Seek& asked) {
  const auto& [frame] = asked;
  status.info.frame = std::clamp(frame, 0, std::max(0, status.frameCount - 1));
  status.info.jitterIndex = status.info.frame % 16;
  status.info.time = status.info.frame / 60.0;
  deliver();
  deliverProfile();
}

void FakeRenderer::take(const request::MeasureStages&) {
  StageCosts costs;
  costs.frame = status.info.frame;
  costs.width = status.width;
  costs.height = status.height;
  costs.rounds = 15;
  costs.whole = {4.0, 3.9, 4.2};
  costs.cheapest = {1.0, 0.9, 1.1};
  costs.stages = {{Stage::Neighborhood, {2.0, 1.75, 2.125}},
                  {Stage::BlendWeight, {0.25, -0.5, 0.5}},
                  {Stage::Blend, {-1.0, -1.5, -0.75}},
                  {.stage = Stage::Reproject, .ms = {}, .isCheapest = true}};
  tell(costs);
}

void FakeRenderer::deliverThumbnails() {
  const auto& [width, height] = last<request::SetThumbnails>();
  if (width == 0) return;
  if (!status.playing) {
    const double share = 0.01 * (status.info.frame % 100);
    tell(StageShares{status.info.frame,
                     status.info.frame == 0,
                     {{Stage::DilateMotion, 0.0}, {Stage::ValidateHistory, share}}});
  }
  for (const IntermediateId id : mainRows()) {
    Thumbnail thumbnail{id, status.info.frame, {width, height, {}}, status.shotVersion};
    const auto gray = static_cast<std::uint8_t>(static_cast<int>(id) * 3 + status.info.frame);
    thumbnail.picture.rgba.assign(static_cast<std::size_t>(width) * height * 4, gray);
    for (std::size_t alpha = 3; alpha < thumbnail.picture.rgba.size(); alpha += 4)
      thumbnail.picture.rgba[alpha] = 255;
    tell(std::move(thumbnail));
  }
}

void FakeRenderer::deliverMetrics() {
  const std::vector<Metric>& metrics = last<request::SetMetrics>().metrics;
  if (metrics.empty()) return;
  FrameMetrics result{.frame = status.info.frame, .values = {}, .shotVersion = status.shotVersion};
  for (const Metric metric : metrics) result.at(metric) = 0.01 * status.info.frame;
  tell(result);
}

/// Frame n: two passes of n and 2n ms, 3 MiB of textures.
void FakeRenderer::deliverProfile() {
  if (!last<request::SetProfiling>().on) return;
  FrameProfile profile;
  const double n = status.info.frame;
  profile.frame = status.info.frame;
  profile.passes = {{"G-buffer", n, 1}, {"Resolve", 2.0 * n, 1}, {"Between the passes", 0.0, 0}};
  profile.totalMs = 3.0 * n;
  profile.memory = {{"history, \"kept\"", std::size_t(3) << 20, 5}};
  profile.memoryBytes = std::size_t(3) << 20;
  profile.checkpointBytes = std::size_t(1) << 20;
  tell(profile);
}

Image FakeRenderer::valuesOf(IntermediateId id, int lane, int frame) const {
  Image values(status.width, status.height, intermediate(id).channels);
  for (int y = 0; y < status.height; ++y)
    for (int x = 0; x < status.width; ++x)
      std::fill_n(values.at(x, y), values.channels,
                  valueAt(x, y, frame) + 10000.0f * static_cast<float>(lane));
  return values;
}

/// A picture of one gray; alpha is whole.
Picture FakeRenderer::gray(const ViewRequest& request, int level) {
  Picture picture{request.width, request.height, {}};
  picture.rgba.assign(static_cast<std::size_t>(request.width) * request.height * 4,
                      static_cast<std::uint8_t>(level));
  for (std::size_t alpha = 3; alpha < picture.rgba.size(); alpha += 4) picture.rgba[alpha] = 255;
  return picture;
}

ViewResult FakeRenderer::draw(int view) const {
  ViewResult result;
  result.view = view;
  result.request = last<request::SetViews>().views[static_cast<std::size_t>(view)];
  result.frame = status.info.frame;
  result.shotVersion = status.shotVersion;
  const ViewRequest& request = result.request;
  result.picture = gray(request, request.asDifference ? kDifferenceGray : kGray);
  if (isOfReference(request.id)) {
    result.referenceSamples = 64;
    result.error = PictureError{0.0125, 38.25, 0.5};
    result.overTimeSamples = 64;
    result.number = 0.00125;
  }
  if (request.withValues) {
    result.region = {0, 0, status.width, status.height};
    result.values = valuesOf(request.id, request.lane, result.frame);
  }
  if (request.measured) {
    const gl::Rect& of = *request.measured;
    Image values(of.width, of.height, intermediate(request.id).channels);
    for (int y = 0; y < of.height; ++y)
      for (int x = 0; x < of.width; ++x)
        std::fill_n(values.at(x, y), values.channels, valueAt(of.x + x, of.y + y, result.frame));
    result.spread = regionSpread(values, {}, intermediate(request.id), of);
  }
  if (request.style.markRejected) result.reasons = {1000, 0, 0, 0, 300};
  // As the real one: no other frame while it plays, and no reference of one.
  const bool isMade = request.other && !(status.playing && request.other->framesBefore > 0) &&
                      !(request.other->isOfAnotherFrame() && isOfReference(request.other->id));
  if (!isMade) return result;
  ViewSide& side = result.other.emplace();
  side.frame = frameOf(*request.other);
  side.picture = gray(request, kOtherGray);
  if (request.withValues) side.values = valuesOf(request.other->id, request.other->lane, side.frame);
  if (request.other->alongMotion) addAbsence(result);
  return result;
}

int FakeRenderer::frameOf(const OtherSide& other) const {
  const int before = other.alongMotion ? std::min(1, status.info.frame) : other.framesBefore;
  return other.frame.value_or(status.info.frame - before);
}

/// The first pixel of a difference comes from off screen; the first frame has none before.
void FakeRenderer::addAbsence(ViewResult& result) const {
  if (result.frame == 0) result.other->allAbsent = Absence::FirstFrame;
  if (!result.request.withValues || !result.request.asDifference) return;
  result.absence = Image(result.values.width, result.values.height, 1);
  *result.absence.at(0, 0) = static_cast<float>(Absence::OffScreen);
}

void FakeRenderer::deliver() {
  if (holdsBack) return;
  tell(status);
  if (status.frameCount == 0) return;
  const std::vector<ViewRequest>& views = last<request::SetViews>().views;
  for (std::size_t view = 0; view < views.size(); ++view)
    if (views[view].width > 0) tell(draw(static_cast<int>(view)));
  deliverThumbnails();
  for (const Probe& probe : last<request::SetProbes>().all) {
    deliverProbe(probe);
    if (last<request::SetTracing>().on) deliverTrace(probe, status.info.frame);
  }
  deliverMetrics();
  deliverLineage();
  deliverVerdict();
}

/// Half of each frame's history is older, and lies a pixel further to the left. Samples lie a quarter of a
/// pixel to the right of the center, or to the left in odd frames.
void FakeRenderer::deliverLineage() {
  const int lineageFrames = last<request::SetLineage>().frames;
  const Probe* probe = activeProbe();
  if (lineageFrames == 0 || !probe || status.playing) return;
  auto lineage = std::make_shared<Lineage>();
  lineage->frame = status.info.frame;
  lineage->pixel = probe->pixel;
  double older = 1.0;
  for (int frame = lineage->frame; frame >= 0 && lineage->frame - frame < lineageFrames; --frame) {
    LineageFrame entry;
    entry.frame = frame;
    entry.weight = frame == 0 ? older : 0.5 * older;
    entry.place = {probe->pixel.x + 0.5 - (lineage->frame - frame), probe->pixel.y + 0.5};
    entry.pixels = 1;
    older -= entry.weight;
    lineage->weight += entry.weight;
    lineage->frames.push_back(entry);
    lineage->samples.push_back({frame, probe->pixel, {frame % 2 == 0 ? 0.25 : -0.25, 0.0}, entry.weight});
  }
  lineage->older = older;
  lineage->effectiveFrames = 3.0;
  tell(LineageDelivery{*probe, status.info.frame, std::move(lineage), status.shotVersion});
}

void FakeRenderer::deliverVerdict() {
  const bool isAny = verdict.answer || !verdict.whyNot.empty();
  const Probe* probe = activeProbe();
  if (!last<request::SetVerdicts>().on || !isAny || status.playing || !probe) return;
  const ProbeSpot spot = spotOf(*probe);
  if (spot.state != ProbeState::Seen) return;
  VerdictDelivery delivery = verdict;
  delivery.frame = status.info.frame;
  delivery.pixel = spot.pixel;
  delivery.shotVersion = status.shotVersion;
  tell(std::move(delivery));
}

/// A surface goes one pixel to the right a frame, and out of the picture.
ProbeSpot FakeRenderer::spotOf(const Probe& probe) const {
  ProbeSpot spot{.pixel = probe.pixel};
  if (probe.follow != Follow::Surface) return spot;
  spot.pixel.x += status.info.frame - probe.frame;
  if (spot.pixel.x >= status.width) spot.state = ProbeState::OffScreen;
  return spot;
}

/// Null: there is none.
const Probe* FakeRenderer::activeProbe() const {
  const request::SetProbes& probes = last<request::SetProbes>();
  return probes.active < 0 ? nullptr : &probes.all[static_cast<std::size_t>(probes.active)];
}

namespace {

/// How a history position is made of a motion whose components are both `motion`.
std::shared_ptr<const twin::Details> madeDetails(const glm::ivec2& pixel, float motion) {
  twin::Tracing tracing;
  const auto read = [](float value) { return twin::Traced::made(twin::Operation::Read, value, value); };
  twin::Trace trace;
  for (int i = 0; i < 2; ++i)
    trace.rows[static_cast<std::size_t>(IntermediateId::historyPosition)][static_cast<std::size_t>(i)] =
        (twin::Traced(static_cast<float>(pixel[i]) + 0.5f) - read(motion)).operand();
  trace.nodes = tracing.take();
  twin::Details details;
  details.trace = std::make_shared<const twin::Trace>(std::move(trace));
  return std::make_shared<const twin::Details>(std::move(details));
}

} // namespace

void FakeRenderer::deliverProbe(const Probe& probe) {
  ProbeResult result{.probe = probe, .spot = spotOf(probe), .around = {}};
  if (probe.follow == Follow::Surface) result.probe.anchor = SurfaceAnchor{.object = 1};
  result.x = result.spot.pixel.x;
  result.y = result.spot.pixel.y;
  result.frame = status.info.frame;
  result.info = status.info;
  result.settings = status.settings;
  for (int y = -1; y <= 1 && result.spot.state == ProbeState::Seen; ++y)
    for (int x = -1; x <= 1; ++x) {
      PixelRecord record;
      record.fill(glm::vec4(valueAt(result.x + x, result.y + y, status.info.frame)));
      twin::at(record, IntermediateId::rejectReason) = glm::vec4(0);
      result.around.push_back(record);
    }
  const request::SetProbes& probes = last<request::SetProbes>();
  const bool isActive = activeProbe() && *activeProbe() == probe;
  if (isActive && !result.around.empty())
    result.details = madeDetails({result.x, result.y}, valueAt(result.x, result.y, status.info.frame));
  if (isActive && probes.other && !result.around.empty()) {
    ComparedPixel& compared = result.compared.emplace();
    compared.frame = frameOf(*probes.other);
    for (PartialValue& value : compared.other)
      value.value = glm::vec4(valueAt(result.x, result.y, compared.frame));
  }
  if (isActive && probes.whatIf)
    result.sensitivities = {{.to = SensitivityTo::Sample, .slope = glm::dvec3(0.25)},
                            {.to = SensitivityTo::Parameter,
                             .path = "weight.minimum",
                             .value = 0.1,
                             .slope = glm::dvec3(-0.5),
                             .isOneSided = true}};
  if (isActive && probes.whatIf)
    for (const Variant& variant : variantsOf(status.settings))
      result.whatIf.push_back({variant.group,
                               variant.id,
                               variant.label,
                               variant.note,
                               variant.isCurrent,
                               glm::vec3(0.25f),
                               glm::vec3(variant.isCurrent ? 0.0f : 0.125f),
                               {},
                               {},
                               0.5f,
                               0});
  tell(result);
}

} // namespace taa::app::test
