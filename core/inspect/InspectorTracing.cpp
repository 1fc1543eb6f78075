// Pins in frames that are not on show.
#include "core/inspect/InspectorParts.h"
#include "core/probe/Probe.h"
#include "core/taa/twin/stages/SampleStages.h"

#include <optional>
#include <utility>
#include <vector>

namespace taa {

namespace {

// Whether something else is drawn in front of the surface that a pin follows.
bool isCovered(const ProbePin& pin, const PinSpot& spot, const PixelRecord& record, const View& view) {
  if (!pin.anchor) return false;
  const SeenSurface drawn{static_cast<int>(twin::at(record, IntermediateId::objectId).x),
                          twin::at(record, IntermediateId::depth).x};
  return isHidden(spot, *pin.anchor, drawn, twin::viewDepth(drawn.depth, view.block.depthTerms));
}

} // namespace

Subject InspectedShot::Parts::onlyLane(int lane) const {
  Subject only = subject;
  only.lanes = {settings(lane)};
  return only;
}

// Checkpoints are only lent: the frames around the one on show stay kept, and of those on the way only the
// last, which the next frame goes on from.
ShownFrame InspectedShot::Parts::makeBeside(int frame, TraceCursor& cursor, const Progress& progress,
                                            int lane) {
  std::vector<Checkpoints> kept(1);
  kept[0] = checkpoints[static_cast<std::size_t>(lane)];
  if (cursor.history) kept[0].keep(cursor.frame, cursor.history);
  const auto watched = std::exchange(maker.watched, {});
  std::optional<ShownFrame> made;
  try {
    made = maker.replay(onlyLane(lane), kept, frame, 0, progress);
  } catch (...) {
    maker.watched = watched;
    throw;
  }
  maker.watched = watched;
  cursor = {frame, made->lanes[0].current};
  return std::move(*made);
}

std::vector<std::optional<TraceSample>> Inspector::traceFrame(int frame, const std::vector<ProbePin>& pins,
                                                              TraceCursor& cursor, const Progress& progress) {
  Parts& parts = *parts_;
  const gl::PassGroup group(pass_group::kProbe);
  const Subject subject = parts.onlyLane(0);
  ShownFrame made = parts.makeBeside(frame, cursor, progress);
  const View view = viewAt(scene(), subject.request(0), frame);
  const FrameInputs& inputs = parts.maker.inputs(subject, made, 0);
  const ShownLane& lane = made.lanes[0];
  std::vector<std::optional<TraceSample>> samples(pins.size());
  for (std::size_t index = 0; index < pins.size(); ++index) {
    const PinSpot spot = spotOf(scene(), view, {width(), height()}, pins[index]);
    if (spot.state != PinState::Seen) continue;
    const gl::Rect pixel{spot.pixel.x, spot.pixel.y, 1, 1};
    const PixelRecord record =
        probeRegion(parts.maker.pass, inputs, lane.previous.get(), *lane.current, subject.lanes[0], pixel)[0];
    if (!isCovered(pins[index], spot, record, view)) samples[index] = TraceSample{spot.pixel, record};
  }
  parts.maker.recycle(std::move(made));
  return samples;
}

} // namespace taa
