// taa-batch render: frames into files.
#include "core/cli/Commands.h"

#include "core/FrameExport.h"
#include "core/base/Error.h"
#include "core/cli/Shot.h"
#include "core/inspect/MemoryNeed.h"
#include "core/io/FrameJson.h"
#include "core/io/PictureFile.h"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <ostream>
#include <sstream>

namespace taa::cli {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

/// "frame.0007" in the folder.
std::string frameName(int frame) {
  std::ostringstream name;
  name << "frame." << std::setw(4) << std::setfill('0') << frame;
  return name.str();
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Error("cannot make the folder " + folder.string() + ": " + error.message());
}

std::vector<FrameLane> laneHeaders(const Inspector& inspector, const ShotPlan& plan) {
  std::vector<FrameLane> lanes;
  for (int lane = 0; lane < inspector.laneCount(); ++lane)
    lanes.push_back({plan.lanes.at(static_cast<std::size_t>(lane)).name, inspector.settings(lane),
                     inspector.info(lane), inspector.inputs(lane).block});
  return lanes;
}

fs::path writeExr(Inspector& inspector, const ShotPlan& plan, const std::vector<IntermediateId>& ids,
                  const fs::path& folder) {
  fs::path path = folder / (frameName(inspector.frame()) + ".exr");
  FrameFile frame{
      inspector.source(), inspector.camera(), inspector.driver().renderer, laneHeaders(inspector, plan), {}};
  exportFrame(inspector, std::move(frame), ids, path);
  return path;
}

/// What a view at 1:1 shows: one file for each intermediate.
std::vector<fs::path> writePngs(Inspector& inspector, const ShotPlan& plan,
                                const std::vector<IntermediateId>& ids, const fs::path& folder) {
  std::vector<fs::path> paths;
  const std::vector<FrameLane> lanes = laneHeaders(inspector, plan);
  for (int lane = 0; lane < inspector.laneCount(); ++lane)
    for (const IntermediateId id : ids) {
      const Picture picture = inspector.picture(id, defaultStyle(intermediate(id)), {}, inspector.width(),
                                                inspector.height(), lane);
      const std::string part = partName(lanes.at(static_cast<std::size_t>(lane)), id);
      paths.push_back(folder / (frameName(inspector.frame()) + "." + part + ".png"));
      writePng(paths.back(), picture.width, picture.height, picture.rgba);
    }
  return paths;
}

void sayMemory(const Inspector& inspector, const ShotPlan& plan) {
  std::vector<Settings> lanes;
  for (const LaneChoice& lane : plan.lanes) lanes.push_back(lane.settings);
  const MemoryNeed need = memoryNeed(lanes, plan.size, {});
  std::cerr << "memory: about " << bytesText(need.total()) << " for " << plan.size.x << " × " << plan.size.y
            << " pixels (inputs " << bytesText(need.inputs) << ", histories " << bytesText(need.histories)
            << "), besides the scene, kept histories and an export of up to " << bytesText(kExportBytes)
            << " at a time";
  if (const std::optional<std::size_t> available = gl::availableMemory(inspector.driver()))
    std::cerr << "; " << bytesText(*available) << " are free";
  std::cerr << '\n';
}

} // namespace

void runRender(const RenderArguments& arguments, std::ostream& out, const Progress& progress) {
  const ShotPlan plan = planShot(arguments.shot);
  const FrameRange range = parseFrames(arguments.frames);
  const std::vector<IntermediateId> ids = parseEmit(arguments.emit);
  const fs::path folder = arguments.folder;
  const bool showsReference = std::ranges::any_of(ids, isOfReference);
  if (showsReference) checkReferenceSamples(arguments.referenceSamples);
  Inspector inspector;
  if (arguments.verbose) sayMemory(inspector, plan);
  openShot(inspector, arguments.shot, plan, progress);
  requireFrame(inspector, range.last);
  makeFolder(folder);

  ordered_json files = ordered_json::array();
  for (int frame = range.first; frame <= range.last; ++frame) {
    report(progress, "Rendering", frame - range.first, range.count());
    // Only the way to the first frame is long enough to tell of.
    inspector.seek(frame, frame == range.first ? progress : Progress());
    for (int lane = 0; showsReference && lane < inspector.laneCount(); ++lane)
      inspector.refineReference(arguments.referenceSamples, progress, lane);
    if (arguments.format == "png") inspector.watch(ids);
    std::vector<fs::path> paths;
    if (arguments.format == "png")
      paths = writePngs(inspector, plan, ids, folder);
    else
      paths.push_back(writeExr(inspector, plan, ids, folder));
    for (const fs::path& path : paths) {
      files.push_back(path.string());
      if (!arguments.json) out << path.string() << '\n' << std::flush;
    }
  }
  if (!arguments.json) return;
  ordered_json json = shotJson(inspector);
  json["frames"] = {range.first, range.last};
  if (showsReference) json["referenceSamples"] = arguments.referenceSamples;
  for (int lane = 0; lane < inspector.laneCount(); ++lane)
    json["lanes"].push_back(laneJson(inspector, plan.lanes.at(static_cast<std::size_t>(lane)), lane));
  json["files"] = files;
  out << json.dump(2) << '\n';
}

} // namespace taa::cli
