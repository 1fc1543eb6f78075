// taa-batch trace: intermediates at pixels over frames.
#include "core/cli/Command.h"
#include "core/cli/Shot.h"
#include "core/report/TraceText.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

namespace {

struct TraceCommand final : Command {
  ShotOptions shot;
  std::string frames;
  std::vector<std::string> pixels;
  std::vector<std::string> emit = {"alpha", "historyLength"}; ///< ids, or "all"
  int referenceSamples = kVerdictSamples;                     ///< of rows of the reference that are named
  bool followsSurfaces = false;   ///< that are seen at the pixels in the first frame
  bool json = false, csv = false; ///< CSV is also what neither asks for

  TraceCommand() : Command("trace") {
    description("Print intermediates at pixels over frames, as CSV");
    addShotOptions(*this, shot);
    add_option("--pixel", pixels, "X,Y; 0,0 is the top left; repeat it for more")
        ->required()
        ->allow_extra_args(false);
    add_option("--frames", frames, "A..B, both included, or one frame")->required();
    add_option("--emit", emit,
               "Intermediates, with commas between (see list intermediates), or all of the resolve's; those "
               "of the reference are drawn where they are named")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    addReferenceSamples(*this, referenceSamples, "of rows of the reference that are named, 4 to 1024");
    add_flag("--surface", followsSurfaces, "Follow the surfaces seen at the pixels in the first frame");
    add_flag("--csv", csv, "Print CSV, as without it")->excludes(addJson(*this, json));
  }

  int run(std::ostream& out, const Progress& progress) const override;
};

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

int TraceCommand::run(std::ostream& out, const Progress& progress) const {
  const ShotPlan plan = planShot(shot);
  if (plan.lanes.size() > 1) throw UsageError("trace follows one lane; give one preset");
  const FrameRange range = parseFrames(frames);
  const std::vector<IntermediateId> rows = tracedRows(emit);
  const Follow follow = followsSurfaces ? Follow::Surface : Follow::Screen;
  std::vector<ProbeTrace> traces;
  for (const std::string& pixel : pixels)
    traces.push_back({{parsePixel(pixel), follow, range.first, {}}, {}});
  std::vector<IntermediateId> ofReference = rows;
  std::erase_if(ofReference, [](IntermediateId id) { return !isOfReference(id); });
  checkReferenceSamples(referenceSamples);
  Inspector inspector;
  openShot(inspector, plan, progress);
  requireFrame(inspector, plan, range.last);
  for (const ProbeTrace& traced : traces) requirePixel(inspector, traced.probe.pixel);
  if (followsSurfaces && inspector.shot().capture())
    throw UsageError("--surface: a capture has no surfaces to follow, only pictures of them; leave it out");
  for (int frame = range.first; frame <= range.last; ++frame) {
    report(progress, "Tracing", frame - range.first, range.count());
    inspector.shot().seek(frame, progress);
    inspector.reference().makeRows(ofReference, referenceSamples, progress);
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
  const SpaceSettings& space = inspector.shot().settings().space;
  if (!json) {
    out << traceCsv(traces, rows, space);
    return kDone;
  }
  nlohmann::ordered_json result = shotJson(inspector);
  result["lane"] = laneJson(inspector, plan, 0);
  result["probes"] = traceJson(traces, rows, space);
  print(out, result);
  return kDone;
}

} // namespace

std::shared_ptr<Command> traceCommand() {
  return std::make_shared<TraceCommand>();
}

} // namespace taa::cli
