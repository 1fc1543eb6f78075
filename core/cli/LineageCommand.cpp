// taa-batch lineage: which samples one pixel of one frame is made of.
#include "core/cli/Command.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/report/LineageReport.h"
#include "core/verdict/lineage/LineageWords.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <ostream>
#include <string>

namespace taa::cli {

namespace {

struct LineageCommand final : Command {
  ShotOptions shot;
  std::string pixel;
  int frame = -1;              ///< −1: that of the session
  int frames = kLineageFrames; ///< how far back
  bool json = false;

  LineageCommand() : Command("lineage") {
    description("Print which samples of the frames before one pixel of one frame is made of");
    addShotOptions(*this, shot);
    addFrame(*this, frame);
    addPixel(*this, pixel)->required();
    add_option("--frames", frames, "How many frames are followed back, with the frame itself")
        ->check(CLI::Range(1, kMaxLineageFrames))
        ->capture_default_str();
    addJson(*this, json);
  }

  int run(std::ostream& out, const Progress& progress) const override;
};

int LineageCommand::run(std::ostream& out, const Progress& progress) const {
  const ShotPlan plan = planShot(shot);
  const glm::ivec2 place = parsePixel(pixel);
  const int last = frameOf(plan, frame);
  Inspector inspector;
  openShot(inspector, plan, progress);
  requireFrame(inspector, plan, last);
  requirePixel(inspector, place);
  inspector.shot().seek(last, progress);

  LineageReport report{shotFacts(inspector), place, {}};
  LineageOptions options;
  options.frames = frames;
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    report.lanes.push_back(
        {laneFacts(inspector, plan, lane), inspector.lineage().of(last, place, lane, options, progress)});
  if (json) {
    print(out, lineageJson(report));
    return kDone;
  }
  for (const LineageOfLane& lane : report.lanes) {
    if (&lane != report.lanes.data()) out << '\n';
    out << placeText(report.shot, place, lane.lane) << '\n';
    for (const std::string& line : lineageSentences(lane.lineage)) out << line << '\n';
    printTable(out, lineageTable(lane.lineage));
  }
  return kDone;
}

} // namespace

std::shared_ptr<Command> lineageCommand() {
  return std::make_shared<LineageCommand>();
}

} // namespace taa::cli
