// taa-batch probe: one pixel of one frame.
#include "core/cli/Commands.h"

#include "core/base/Error.h"
#include "core/cli/Shot.h"
#include "core/cli/Table.h"
#include "core/io/FrameJson.h"

#include <ostream>

namespace taa::cli {

using nlohmann::ordered_json;

namespace {

std::string valuesText(const Intermediate& row, const glm::vec4& value) {
  std::string text;
  for (int channel = 0; channel < row.channels; ++channel)
    text += (channel > 0 ? "  " : "") + floatText(value[channel]);
  if (row.id == IntermediateId::rejectReason)
    text += " (" + std::string(rejectReasonText(static_cast<int>(value.x))) + ")";
  return text;
}

void printRecord(std::ostream& out, const PixelRecord& record) {
  for (const StageInfo& stage : kStages) {
    std::vector<std::vector<std::string>> rows;
    for (const Intermediate& row : kIntermediates)
      if (row.stage == stage.stage && reference::hasValue(record, row.id))
        rows.push_back(
            {std::string(row.label), valuesText(row, reference::at(record, row.id)), std::string(row.unit)});
    if (rows.empty()) continue;
    out << stage.label << '\n';
    printTable(out, rows, "  ");
  }
}

} // namespace

void runProbe(const ProbeArguments& arguments, std::ostream& out, const Progress& progress) {
  const ShotPlan plan = planShot(arguments.shot);
  const glm::ivec2 pixel = parsePixel(arguments.pixel);
  if (arguments.frame < 0) throw UsageError("--frame must not be negative");
  Inspector inspector;
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, arguments.frame);
  inspector.seek(arguments.frame, progress);

  ordered_json json = shotJson(inspector);
  json["frame"] = arguments.frame;
  json["time"] = inspector.info().time;
  json["pixel"] = {pixel.x, pixel.y};
  for (int lane = 0; lane < inspector.laneCount(); ++lane) {
    const LaneChoice& choice = plan.lanes.at(static_cast<std::size_t>(lane));
    const PixelRecord record = inspector.probe(pixel.x, pixel.y, lane);
    if (!arguments.json) {
      if (!choice.name.empty())
        out << (lane > 0 ? "\n" : "") << "LANE " << choice.name << ": " << choice.preset << '\n';
      printRecord(out, record);
      continue;
    }
    ordered_json row = laneJson(inspector, choice, lane);
    row["values"] = recordJson(record);
    json["lanes"].push_back(row);
  }
  if (arguments.json) out << json.dump(2) << '\n';
}

} // namespace taa::cli
