// taa-batch trace: intermediates at pixels over frames.
#include "core/base/Error.h"
#include "core/cli/Commands.h"
#include "core/cli/shot/Shot.h"
#include "core/report/TraceText.h"

#include <nlohmann/json.hpp>

#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

void runTrace(const TraceArguments& arguments, std::ostream& out, const Progress& progress) {
  const ShotPlan plan = planShot(arguments.shot);
  if (plan.lanes.size() > 1) throw UsageError("trace follows one lane; give one preset");
  const FrameRange range = parseFrames(arguments.frames);
  const std::vector<IntermediateId> rows = parseEmit(arguments.emit);
  std::vector<ProbeTrace> traces;
  for (const std::string& pixel : arguments.pixels)
    traces.push_back(
        {{parsePixel(pixel), arguments.surface ? Follow::Surface : Follow::Screen, range.first, {}}, {}});
  Inspector inspector;
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, plan, range.last);
  for (const std::string& pixel : arguments.pixels) requirePixel(inspector, parsePixel(pixel));
  if (arguments.surface && inspector.shot().capture())
    throw UsageError("--surface: a capture has no surfaces to follow, only pictures of them; leave it out");
  for (int frame = range.first; frame <= range.last; ++frame) {
    report(progress, "Tracing", frame - range.first, range.count());
    inspector.shot().seek(frame, progress);
    for (ProbeTrace& traced : traces) {
      traced.probe = inspector.probes().anchored(traced.probe);
      const ProbeSpot spot = inspector.probes().spot(traced.probe);
      if (spot.state != ProbeState::Seen) {
        if (traced.probe.follow == Follow::Screen)
          inspector.probes().probe(traced.probe.pixel.x, traced.probe.pixel.y);
        continue; // probe() says why: it lies outside
      }
      traced.trace.add(frame, {spot.pixel, inspector.probes().probe(spot.pixel.x, spot.pixel.y)});
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
