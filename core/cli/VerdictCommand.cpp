// taa-batch verdict: what is wrong with one pixel of one frame.
#include "core/cli/Commands.h"
#include "core/cli/Shot.h"
#include "core/report/verdicts/VerdictReport.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <ostream>
#include <utility>

namespace taa::cli {

void runVerdict(const VerdictArguments& arguments, std::ostream& out, const Progress& progress) {
  const ShotPlan plan = planShot(arguments.shot);
  checkReferenceSamples(arguments.samples);
  VerdictQuestion question;
  question.pixel = parsePixel(arguments.pixel);
  question.frame = arguments.frame >= 0 ? arguments.frame : plan.frame;
  question.samples = arguments.samples;
  if (question.frame < 0) throw UsageError("--frame is required: the number of a frame, from 0");
  Inspector inspector;
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, question.frame);
  inspector.shot().seek(question.frame, progress);

  VerdictReport report{shotFacts(inspector), question.pixel, question.frame, question.samples, {}};
  for (question.lane = 0; question.lane < inspector.shot().laneCount(); ++question.lane) {
    const LaneChoice& choice = plan.lanes.at(static_cast<std::size_t>(question.lane));
    VerdictOfLane lane{
        laneFacts(inspector, choice, question.lane), inspector.verdicts().of(question, progress), {}};
    if (arguments.remedies)
      lane.remedies = inspector.verdicts().remedies(question, lane.answer.verdict, progress);
    report.lanes.push_back(std::move(lane));
  }
  if (arguments.json) {
    out << verdictJson(report).dump(2) << '\n';
    return;
  }
  for (const VerdictOfLane& lane : report.lanes) {
    if (&lane != report.lanes.data()) out << '\n';
    out << placeText(report.shot, report.pixel, lane.lane) << '\n' << verdictText(lane);
  }
}

} // namespace taa::cli
