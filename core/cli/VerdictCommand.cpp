// taa-batch verdict: what is wrong with one pixel of one frame, or with all of it.
#include "core/cli/Command.h"
#include "core/cli/Shot.h"
#include "core/report/verdicts/MapReport.h"
#include "core/report/verdicts/VerdictReport.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

namespace taa::cli {

namespace {

struct VerdictCommand final : Command {
  ShotOptions shot;
  std::string pixel;             ///< empty: of the whole picture
  int frame = -1;                ///< −1: that of the session
  int samples = kVerdictSamples; ///< of the references
  int worst = 5;                 ///< pixels of each category and error of the whole picture
  bool triesRemedies = false;    ///< also what corrects it
  bool json = false;

  VerdictCommand() : Command("verdict") {
    description("Say what is wrong with one pixel of one frame, since when, and because of what; without a "
                "pixel where history was rightly kept or removed, let through or thrown away, what the error "
                "is made of, and the worst pixels of each");
    addShotOptions(*this, shot);
    addFrame(*this, frame);
    CLI::Option* place = addPixel(*this, pixel);
    add_option("--worst", worst, "Without a pixel: worst pixels of each, 0 to 1000")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str()
        ->excludes(place);
    addReferenceSamples(*this, samples, "of the references that it is held against, 4 to 1024");
    add_flag("--remedies", triesRemedies, "Also try what may mend it, and print the best with their costs")
        ->needs(place);
    addJson(*this, json);
  }

  int run(std::ostream& out, const Progress& progress) const override;
  void printOfPixel(const glm::ivec2& place, const ShotPlan& plan, Inspector& inspector, std::ostream& out,
                    const Progress& progress) const;
  void printOfPicture(const ShotPlan& plan, Inspector& inspector, std::ostream& out,
                      const Progress& progress) const;
};

void VerdictCommand::printOfPixel(const glm::ivec2& place, const ShotPlan& plan, Inspector& inspector,
                                  std::ostream& out, const Progress& progress) const {
  VerdictQuestion question{.frame = inspector.shot().frame(), .pixel = place, .samples = samples};
  VerdictReport report{shotFacts(inspector), place, question.frame, samples, {}};
  for (question.lane = 0; question.lane < inspector.shot().laneCount(); ++question.lane) {
    VerdictOfLane lane{
        laneFacts(inspector, plan, question.lane), inspector.verdicts().of(question, progress), {}};
    if (triesRemedies) lane.remedies = inspector.verdicts().remedies(question, lane.answer, progress);
    report.lanes.push_back(std::move(lane));
  }
  if (json) {
    print(out, verdictJson(report));
    return;
  }
  for (const VerdictOfLane& lane : report.lanes) {
    if (&lane != report.lanes.data()) out << '\n';
    out << placeText(report.shot, place, lane.lane) << '\n' << verdictText(lane);
  }
}

void VerdictCommand::printOfPicture(const ShotPlan& plan, Inspector& inspector, std::ostream& out,
                                    const Progress& progress) const {
  MapReport report{shotFacts(inspector), inspector.shot().frame(), samples, {}};
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    report.lanes.push_back(
        mapOfLane(inspector, laneFacts(inspector, plan, lane), lane, samples, worst, progress));
  if (json) {
    print(out, mapJson(report));
    return;
  }
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    out << laneHeading(plan, lane) << mapText(report.lanes[static_cast<std::size_t>(lane)]);
}

int VerdictCommand::run(std::ostream& out, const Progress& progress) const {
  const ShotPlan plan = planShot(shot);
  checkReferenceSamples(samples);
  std::optional<glm::ivec2> place;
  if (!pixel.empty()) place = parsePixel(pixel);
  const int shown = frameOf(plan, frame);
  Inspector inspector;
  openShot(inspector, plan, progress);
  requireFrame(inspector, plan, shown);
  if (place) requirePixel(inspector, *place);
  inspector.shot().seek(shown, progress);
  if (place)
    printOfPixel(*place, plan, inspector, out, progress);
  else
    printOfPicture(plan, inspector, out, progress);
  return kDone;
}

} // namespace

std::shared_ptr<Command> verdictCommand() {
  return std::make_shared<VerdictCommand>();
}

} // namespace taa::cli
