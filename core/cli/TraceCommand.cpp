// taa-batch trace: intermediates at pixels over frames.
#include "core/base/Error.h"
#include "core/cli/Commands.h"
#include "core/cli/Shot.h"
#include "core/report/TraceText.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

namespace {

/// Without a name those that a resolve gives: others are drawn anew in each frame.
std::vector<IntermediateId> tracedRows(const std::vector<std::string>& emit) {
  std::vector<IntermediateId> rows = parseEmit(emit);
  if (std::ranges::find(emit, "all") != emit.end()) std::erase_if(rows, isOfReference);
  return rows;
}

/// What no resolve knows is drawn for the whole frame, and read where the probe is.
void addReference(Inspector& inspector, const std::vector<IntermediateId>& rows, TraceSample& sample) {
  for (const IntermediateId id : rows) {
    const Image values = inspector.views().image(id, 0, gl::Rect{sample.pixel.x, sample.pixel.y, 1, 1});
    for (int channel = 0; channel < values.channels && channel < 4; ++channel)
      twin::at(sample.record, id)[channel] = values.pixels[static_cast<std::size_t>(channel)];
  }
}

} // namespace

void runTrace(const TraceArguments& arguments, std::ostream& out, const Progress& progress) {
  const ShotPlan plan = planShot(arguments.shot);
  if (plan.lanes.size() > 1) throw UsageError("trace follows one lane; give one preset");
  const FrameRange range = parseFrames(arguments.frames);
  const std::vector<IntermediateId> rows = tracedRows(arguments.emit);
  std::vector<ProbeTrace> traces;
  for (const std::string& pixel : arguments.pixels)
    traces.push_back(
        {{parsePixel(pixel), arguments.surface ? Follow::Surface : Follow::Screen, range.first, {}}, {}});
  std::vector<IntermediateId> ofReference = rows;
  std::erase_if(ofReference, [](IntermediateId id) { return !isOfReference(id); });
  checkReferenceSamples(arguments.referenceSamples);
  Inspector inspector;
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, plan, range.last);
  for (const std::string& pixel : arguments.pixels) requirePixel(inspector, parsePixel(pixel));
  if (arguments.surface && inspector.shot().capture())
    throw UsageError("--surface: a capture has no surfaces to follow, only pictures of them; leave it out");
  for (int frame = range.first; frame <= range.last; ++frame) {
    report(progress, "Tracing", frame - range.first, range.count());
    inspector.shot().seek(frame, progress);
    inspector.reference().makeRows(ofReference, arguments.referenceSamples, progress);
    for (ProbeTrace& traced : traces) {
      traced.probe = inspector.probes().anchored(traced.probe);
      const ProbeSpot spot = inspector.probes().spot(traced.probe);
      if (spot.state != ProbeState::Seen) {
        if (traced.probe.follow == Follow::Screen)
          inspector.probes().probe(traced.probe.pixel.x, traced.probe.pixel.y);
        continue; // probe() says why: it lies outside
      }
      TraceSample sample{spot.pixel, inspector.probes().probe(spot.pixel.x, spot.pixel.y)};
      addReference(inspector, ofReference, sample);
      traced.trace.add(frame, sample);
    }
  }
  if (!arguments.json) {
    out << traceCsv(traces, rows, inspector.shot().settings().space);
    return;
  }
  nlohmann::ordered_json json = shotJson(inspector);
  json["lane"] = laneJson(inspector, plan.lanes[0], 0);
  json["probes"] = traceJson(traces, rows, inspector.shot().settings().space);
  out << json.dump(2) << '\n';
}

} // namespace taa::cli
