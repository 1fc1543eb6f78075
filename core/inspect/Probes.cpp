#include "core/inspect/Probes.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/gl/PassTimer.h"
#include "core/inspect/ReferenceOfShot.h"
#include "core/inspect/RowsBefore.h"
#include "core/measure/Profiler.h"
#include "core/probe/TwinInputs.h"
#include "core/probe/Verification.h"
#include "core/replay/ShotPlayer.h"
#include "core/settings/Parameters.h"
#include "core/taa/TaaPass.h"
#include "core/taa/twin/SampleStages.h"
#include "core/taa/twin/Traced.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace taa {

namespace {

// Rows that no resolve gives have no value.
PixelRecord noValues() {
  PixelRecord record;
  record.fill(glm::vec4(std::numeric_limits<float>::quiet_NaN()));
  return record;
}

/// All rows that a resolve gives for the pixels of `region`, row-major: the resolve again, on those pixels
/// only, with all of its inside exposed; rows of the reference are NaN. The region lies inside the picture.
/// `resolved`: what the resolve made of the same.
std::vector<PixelRecord> probeRegion(TaaPass& pass, const FrameInputs& inputs, const History* previous,
                                     const History& resolved, const Settings& settings,
                                     const gl::Rect& region) {
  const std::vector<IntermediateId> ids = allRows();
  ExposedRows exposedRows(ids, region);
  pass.expose(inputs, previous, resolved, settings, exposedRows);
  std::vector<PixelRecord> records(static_cast<std::size_t>(region.width) * region.height, noValues());
  for (IntermediateId id : ids) {
    const Image image = exposedRows.image(id);
    for (int y = 0; y < region.height; ++y)
      for (int x = 0; x < region.width; ++x)
        twin::at(records[static_cast<std::size_t>(y) * region.width + x], id) = image.texel(x, y);
  }
  return records;
}

/// The drawn texel that a pixel of the picture shows.
SeenSurface surfaceAt(const FrameInputs& inputs, const glm::ivec2& pixel) {
  const glm::ivec2 texel = pixel * glm::ivec2(inputs.width(), inputs.height()) /
                           glm::ivec2(inputs.outputWidth(), inputs.outputHeight());
  const gl::Rect one{texel.x, texel.y, 1, 1};
  return {static_cast<int>(inputs.objectId.download(one).texel(0, 0).x),
          inputs.depth.download(one).texel(0, 0).x};
}

// Whether something else is drawn in front of the surface that a probe follows.
bool isCovered(const Probe& probe, const ProbeSpot& spot, const PixelRecord& record, const View& view) {
  if (!probe.anchor) return false;
  const SeenSurface drawn{static_cast<int>(twin::at(record, IntermediateId::objectId).x),
                          twin::at(record, IntermediateId::depth).x};
  return isHidden(spot, *probe.anchor, drawn, twin::viewDepth(drawn.depth, view.block.depthTerms));
}

} // namespace

Probes::Probes(ShotPlayer& player, ReferenceOfShot& reference) : player_(player), reference_(reference) {}

PixelRecord Probes::probe(int x, int y, int lane) {
  return probeAround(x, y, 0, lane).front();
}

std::vector<PixelRecord> Probes::probeAround(int x, int y, int radius, int lane) {
  const glm::ivec2 size = player_.picturePx();
  if (x < 0 || y < 0 || x >= size.x || y >= size.y)
    throw Error(say<"pixel (%1, %2) lies outside the picture of %3 × %4 pixels">(x, y, size.x, size.y));
  const int left = std::max(0, x - radius), top = std::max(0, y - radius);
  const int right = std::min(size.x - 1, x + radius), bottom = std::min(size.y - 1, y + radius);
  const gl::Rect region{left, top, right - left + 1, bottom - top + 1};
  const ShownLane& shown = player_.lane(lane);
  const gl::PassGroup group(pass_group::kProbe);
  std::vector<PixelRecord> inside =
      probeRegion(player_.maker().pass, player_.inputs(lane), shown.previous.get(), *shown.current,
                  player_.settings(lane), region);
  reference_.addTo(inside, region, lane);
  std::vector<PixelRecord> around;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx) {
      const int column = std::clamp(x + dx, left, right) - left, row = std::clamp(y + dy, top, bottom) - top;
      around.push_back(inside[static_cast<std::size_t>(row) * region.width + column]);
    }
  return around;
}

std::vector<PixelRecord> Probes::recordsOf(const PictureSource& source, const gl::Rect& region) {
  ShownFrame& frame = *player_.find(source.frame);
  const auto index = static_cast<std::size_t>(source.lane);
  const ShownLane& lane = frame.lanes[index];
  const FrameInputs& inputs = player_.maker().inputs(player_.state(), frame, index);
  std::vector<PixelRecord> records = probeRegion(player_.maker().pass, inputs, lane.previous.get(),
                                                 *lane.current, player_.settings(source.lane), region);
  if (&frame == &player_.shown()) reference_.addTo(records, region, source.lane);
  return records;
}

ComparedPixel Probes::compared(const glm::ivec2& pixel, const PictureSource& other, int lane) {
  const gl::PassGroup group(pass_group::kProbe);
  ComparedPixel compared{.frame = other.frame.value_or(player_.shown().frame), .lane = other.lane};
  if (other.alongMotion) {
    fillBefore(compared, pixel, other, lane);
    return compared;
  }
  const PixelRecord record = recordsOf(other, {pixel.x, pixel.y, 1, 1}).front();
  for (const Intermediate& row : kIntermediates)
    compared.other[static_cast<std::size_t>(row.id)] = valueIn(record, row.id);
  return compared;
}

// The four texels that are read: those at the border stand for what lies beyond.
void Probes::fillBefore(ComparedPixel& compared, const glm::ivec2& pixel, const PictureSource& other,
                        int lane) {
  const PixelRecord now = probe(pixel.x, pixel.y, lane);
  const glm::ivec2 size = player_.picturePx(), last = size - 1;
  const glm::vec2 position(twin::at(now, IntermediateId::historyPosition));
  const Absence ofPlace = absenceAt(position, glm::vec2(twin::at(now, IntermediateId::dilatedMotion)), size);
  const auto absenceOf = [&](IntermediateId id) {
    const Absence ofFrame = absenceBefore(player_.state(), player_.shown().frame, id);
    return ofFrame == Absence::None ? ofPlace : ofFrame;
  };
  std::vector<PixelRecord> taps;
  if (absenceOf(IntermediateId::color) == Absence::None) {
    compared.position = position;
    for (const glm::ivec2 step : {glm::ivec2(0), glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1)}) {
      const glm::ivec2 texel = glm::clamp(firstTap(position) + step, glm::ivec2(0), last);
      taps.push_back(recordsOf(other, {texel.x, texel.y, 1, 1}).front());
    }
  }
  for (const Intermediate& row : kIntermediates) {
    PartialValue& value = compared.other[static_cast<std::size_t>(row.id)];
    const Absence absence = absenceOf(row.id);
    value = absence == Absence::None ? valueBetween(std::span<const PixelRecord, 4>(taps), position, row.id)
                                     : absentValue(absence);
  }
}

twin::Details Probes::details(int x, int y, int lane) {
  const gl::PassGroup group(pass_group::kProbe);
  twin::Details details;
  twin::Inputs twin = twinInputs(player_.inputs(lane), player_.lane(lane).previous.get(), TwinReading::Parts);
  if (const History* resolved = player_.lane(lane).current.get())
    twin.resolved = twinTexels(resolved->color, TwinReading::Parts);
  twin::resolvePixel(twin, player_.settings(lane), {x, y}, details);
  details.trace = std::make_shared<const twin::Trace>(twin::traceOf(twin, player_.settings(lane), {x, y}));
  return details;
}

std::vector<WhatIfRow> Probes::whatIf(int x, int y, int lane) {
  const gl::PassGroup group(pass_group::kProbe);
  return taa::whatIf(twinInputs(player_.inputs(lane), player_.lane(lane).previous.get(), TwinReading::Parts),
                     player_.settings(lane), {x, y});
}

std::vector<Sensitivity> Probes::sensitivities(int x, int y, int lane) {
  const gl::PassGroup group(pass_group::kProbe);
  return sensitivitiesOf(
      twinInputs(player_.inputs(lane), player_.lane(lane).previous.get(), TwinReading::Parts),
      player_.settings(lane), {x, y});
}

SensitivityMap Probes::sensitivityMap(const std::string& path, const Progress& progress, int lane) {
  if (parameter(path).kind != ParameterKind::Number)
    throw Error(say<"%1 is no number: it has no slope">(path));
  const gl::PassGroup group(pass_group::kProbe);
  return taa::sensitivityMap(
      path, twinInputs(player_.inputs(lane), player_.lane(lane).previous.get(), TwinReading::Whole),
      player_.settings(lane), progress);
}

void Probes::verify(FrameVerifier& verifier, const Progress& progress, int lane) {
  const gl::PassGroup group(pass_group::kProbe);
  const ShownLane& shown = player_.lane(lane);
  const FrameInputs& inputs = player_.inputs(lane);
  twin::Inputs twin = twinInputs(inputs, shown.previous.get(), TwinReading::Whole);
  twin.resolved = twinTexels(shown.current->color, TwinReading::Whole);
  const std::vector<IntermediateId> ids = allRows();
  const glm::ivec2 size = player_.picturePx();
  constexpr int kLines = 32; // of a part: its rows take less memory than the frame
  for (int first = 0; first < size.y; first += kLines) {
    report(progress, say<"Verifying lines">(), first, size.y);
    ExposedRows exposedRows(ids, {0, first, size.x, std::min(kLines, size.y - first)});
    player_.maker().pass.expose(inputs, shown.previous.get(), *shown.current, player_.settings(lane),
                                exposedRows);
    std::vector<Image> rows;
    for (const IntermediateId id : ids) rows.push_back(exposedRows.image(id));
    verifier.add(twin, player_.settings(lane), first, ids, rows);
  }
  report(progress, say<"Verifying lines">(), size.y, size.y);
}

Probe Probes::anchored(const Probe& probe) {
  if (probe.follow == Follow::Screen || probe.anchor) return probe;
  const gl::PassGroup group(pass_group::kProbe);
  const ShotState& state = player_.state();
  if (state.frames->capture()) { // it has no triangles to stay on
    Probe still = probe;
    still.follow = Follow::Screen;
    return still;
  }
  const Scene& scene = *state.scene;
  const FrameRequest request = state.request(0);
  const int setIn = std::clamp(probe.frame, 0, scene.shot.frames - 1);
  FrameInputs other; // what a probe follows shows only in its own frame
  const FrameInputs* drawn = &other;
  if (setIn == player_.shown().frame)
    drawn = &player_.inputs(0);
  else
    state.frames->draw(request, setIn, other);
  Probe found = probe;
  found.anchor = anchorAt(scene, viewAt(scene, request, setIn), player_.picturePx(), probe.pixel,
                          surfaceAt(*drawn, probe.pixel));
  return found;
}

ProbeSpot Probes::spot(const Probe& probe) {
  const Scene& scene = *player_.state().scene;
  if (probe.follow == Follow::Screen) return spotOf(scene, {}, player_.picturePx(), probe);
  const View view = viewAt(scene, player_.state().request(0), player_.shown().frame);
  ProbeSpot spot = spotOf(scene, view, player_.picturePx(), probe);
  if (!probe.anchor || spot.state != ProbeState::Seen) return spot;
  const gl::PassGroup group(pass_group::kProbe);
  const SeenSurface drawn = surfaceAt(player_.inputs(0), spot.pixel);
  const float depth = twin::viewDepth(drawn.depth, view.block.depthTerms);
  if (isHidden(spot, *probe.anchor, drawn, depth)) spot.state = ProbeState::Hidden;
  return spot;
}

std::vector<std::optional<TraceSample>> Probes::traceFrame(int frame, const std::vector<Probe>& probes,
                                                           TraceCursor& cursor, const Progress& progress) {
  const gl::PassGroup group(pass_group::kProbe);
  const ShotState state = player_.onlyLane(0);
  const Scene& scene = *state.scene;
  ShownFrame made = player_.makeInBackground(frame, cursor, progress);
  const View view = state.frames->capture() ? View{} : viewAt(scene, state.request(0), frame);
  const FrameInputs& inputs = player_.maker().inputs(state, made, 0);
  const ShownLane& lane = made.lanes[0];
  std::vector<std::optional<TraceSample>> samples(probes.size());
  for (std::size_t index = 0; index < probes.size(); ++index) {
    const ProbeSpot spot = spotOf(scene, view, player_.picturePx(), probes[index]);
    if (spot.state != ProbeState::Seen) continue;
    const gl::Rect pixel{spot.pixel.x, spot.pixel.y, 1, 1};
    const PixelRecord record = probeRegion(player_.maker().pass, inputs, lane.previous.get(), *lane.current,
                                           state.lanes[0], pixel)[0];
    if (!isCovered(probes[index], spot, record, view)) samples[index] = TraceSample{spot.pixel, record};
  }
  player_.maker().recycle(std::move(made));
  return samples;
}

} // namespace taa
