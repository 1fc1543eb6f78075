// taa-batch verdict: what is wrong with one pixel of one frame, or with all of it.
#include "core/cli/Commands.h"
#include "core/cli/Shot.h"
#include "core/report/verdicts/MapReport.h"
#include "core/report/verdicts/VerdictReport.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <ostream>
#include <utility>

namespace taa::cli {

namespace {

void printOfPixel(const VerdictArguments& arguments, const ShotPlan& plan, Inspector& inspector,
                  std::ostream& out, const Progress& progress) {
  VerdictQuestion question{
      .frame = inspector.shot().frame(), .pixel = parsePixel(arguments.pixel), .samples = arguments.samples};
  VerdictReport report{shotFacts(inspector), question.pixel, question.frame, question.samples, {}};
  for (question.lane = 0; question.lane < inspector.shot().laneCount(); ++question.lane) {
    const LaneChoice& choice = plan.lanes.at(static_cast<std::size_t>(question.lane));
    VerdictOfLane lane{
        laneFacts(inspector, choice, question.lane), inspector.verdicts().of(question, progress), {}};
    if (arguments.remedies) lane.remedies = inspector.verdicts().remedies(question, lane.answer, progress);
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

void printOfPicture(const VerdictArguments& arguments, const ShotPlan& plan, Inspector& inspector,
                    std::ostream& out, const Progress& progress) {
  MapReport report{shotFacts(inspector), inspector.shot().frame(), arguments.samples, {}};
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    report.lanes.push_back(
        mapOfLane(inspector, laneFacts(inspector, plan.lanes.at(static_cast<std::size_t>(lane)), lane), lane,
                  arguments.samples, arguments.worst, progress));
  if (arguments.json) {
    out << mapJson(report).dump(2) << '\n';
    return;
  }
  for (const MapOfLane& lane : report.lanes) {
    if (&lane != report.lanes.data()) out << '\n';
    if (!lane.lane.name.empty()) out << "LANE " << lane.lane.name << ": " << lane.lane.preset << '\n';
    out << mapText(lane);
  }
}

} // namespace

void runVerdict(const VerdictArguments& arguments, std::ostream& out, const Progress& progress) {
  const ShotPlan plan = planShot(arguments.shot);
  checkReferenceSamples(arguments.samples);
  const bool isOfPixel = !arguments.pixel.empty();
  if (isOfPixel) parsePixel(arguments.pixel); // what is wrong is said before anything is opened
  const int frame = arguments.frame >= 0 ? arguments.frame : plan.frame;
  if (frame < 0) throw UsageError("--frame is required: the number of a frame, from 0");
  Inspector inspector;
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, plan, frame);
  if (isOfPixel) requirePixel(inspector, parsePixel(arguments.pixel));
  inspector.shot().seek(frame, progress);
  if (isOfPixel) return printOfPixel(arguments, plan, inspector, out, progress);
  printOfPicture(arguments, plan, inspector, out, progress);
}

} // namespace taa::cli
