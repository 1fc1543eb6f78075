// taa-batch render: frames into files.
#include "core/cli/Commands.h"
#include "core/cli/Terminal.h"

#include "core/base/Error.h"
#include "core/base/ExistingFiles.h"
#include "core/base/Files.h"
#include "core/capture/format/Manifest.h"
#include "core/cli/Pictures.h"
#include "core/inspect/MemoryNeed.h"
#include "core/io/FrameJson.h"
#include "core/io/GifFile.h"
#include "core/io/PictureFile.h"
#include "core/report/FrameExport.h"
#include "core/report/SequenceExport.h"
#include "core/scene/SceneCost.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <iterator>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

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

/// "A.resolved", or the row alone where there is one lane.
std::string rowName(const LaneChoice& lane, IntermediateId id) {
  return (lane.name.empty() ? "" : lane.name + ".") + std::string(intermediate(id).name);
}

// Where the files are
fs::path exrPath(const RenderArguments& arguments, int frame) {
  return fs::path(arguments.folder) / (frameName(frame) + ".exr");
}
fs::path pngPath(const RenderArguments& arguments, int frame, const LaneChoice& lane, IntermediateId id) {
  return fs::path(arguments.folder) / (frameName(frame) + "." + rowName(lane, id) + ".png");
}
fs::path gifPath(const RenderArguments& arguments, const LaneChoice& lane, IntermediateId id) {
  return fs::path(arguments.folder) / (rowName(lane, id) + ".gif");
}

/// All files that the command writes, in the order in which they appear.
std::vector<fs::path> plannedFiles(const RenderArguments& arguments, const ShotPlan& plan,
                                   const FrameRange& range, const std::vector<IntermediateId>& ids,
                                   const Pictures& pictures) {
  std::vector<fs::path> paths;
  const auto ofRows = [&](auto path) {
    for (int lane = 0; lane < pictures.laneCount(plan); ++lane)
      for (const IntermediateId id : ids)
        paths.push_back(path(plan.lanes.at(static_cast<std::size_t>(lane)), id));
  };
  if (arguments.format == "gif")
    ofRows([&](const LaneChoice& lane, IntermediateId id) { return gifPath(arguments, lane, id); });
  for (int frame = range.first; frame <= range.last; ++frame) {
    if (arguments.format == "exr") paths.push_back(exrPath(arguments, frame));
    if (arguments.format == "png")
      ofRows([&](const LaneChoice& lane, IntermediateId id) { return pngPath(arguments, frame, lane, id); });
  }
  return paths;
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Error("cannot make the folder " + folder.string() + ": " + error.message());
}

std::vector<FrameLane> laneHeaders(const Inspector& inspector, const ShotPlan& plan) {
  std::vector<FrameLane> lanes;
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    lanes.push_back({plan.lanes.at(static_cast<std::size_t>(lane)).name, inspector.shot().usedSettings(lane),
                     inspector.shot().info(lane), inspector.views().inputs(lane).block});
  return lanes;
}

fs::path writeExr(Inspector& inspector, const ShotPlan& plan, const RenderArguments& arguments,
                  const std::vector<IntermediateId>& ids, const Pictures& pictures,
                  const Progress& progress) {
  fs::path path = exrPath(arguments, inspector.shot().frame());
  FrameFile frame{inspector.shot().source(),
                  inspector.shot().camera(),
                  inspector.shot().driver().renderer,
                  laneHeaders(inspector, plan),
                  {}};
  if (pictures.compares()) {
    exportDifferences(inspector, std::move(frame), ids, pictures.request(inspector, ids.front(), 0),
                      arguments.compare, path, progress);
    return path;
  }
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    inspector.reference().makeRows(ids, arguments.referenceSamples, progress, lane);
  exportFrame(inspector, std::move(frame), ids, path);
  return path;
}

/// One file for each intermediate.
std::vector<fs::path> writePngs(Inspector& inspector, const ShotPlan& plan, const RenderArguments& arguments,
                                const std::vector<IntermediateId>& ids, const Pictures& pictures,
                                const Progress& progress) {
  std::vector<fs::path> paths;
  for (int lane = 0; lane < pictures.laneCount(plan); ++lane)
    for (const IntermediateId id : ids) {
      const Picture picture = pictures.draw(inspector, id, lane, progress);
      paths.push_back(
          pngPath(arguments, inspector.shot().frame(), plan.lanes.at(static_cast<std::size_t>(lane)), id));
      writePng(paths.back(), picture.width, picture.height, picture.rgba);
    }
  return paths;
}

/// "resolved.gif", or "A.resolved.gif": an animation for each intermediate of each lane.
class Animations {
 public:
  Animations(const Inspector& inspector, const ShotPlan& plan, const RenderArguments& arguments,
             const std::vector<IntermediateId>& ids, const Pictures& pictures)
      : pictures_(pictures) {
    const double rate = arguments.framesPerSecond > 0.0 ? arguments.framesPerSecond
                                                        : inspector.shot().scene().shot.framesPerSecond;
    for (int lane = 0; lane < pictures.laneCount(plan); ++lane)
      for (const IntermediateId id : ids) {
        const fs::path path = gifPath(arguments, plan.lanes.at(static_cast<std::size_t>(lane)), id);
        const fs::path temporary = temporaryBeside(path);
        rows_.push_back({lane, id, path, temporary,
                         std::make_unique<GifWriter>(temporary, path, inspector.shot().width(),
                                                     inspector.shot().height(), rate)});
      }
  }
  ~Animations() {
    std::error_code ignored;
    for (const Row& row : rows_) fs::remove(row.temporary, ignored);
  }
  Animations(const Animations&) = delete;
  Animations& operator=(const Animations&) = delete;

  void add(Inspector& inspector, const Progress& progress) {
    for (const Row& row : rows_) row.writer->add(pictures_.draw(inspector, row.id, row.lane, progress).rgba);
  }
  std::vector<fs::path> finish() {
    std::vector<fs::path> paths;
    for (const Row& row : rows_) {
      row.writer->finish();
      std::error_code error;
      fs::rename(row.temporary, row.path, error);
      if (error) throw Error("cannot write " + row.path.string() + ": " + error.message());
      paths.push_back(row.path);
    }
    return paths;
  }

 private:
  struct Row {
    int lane;
    IntermediateId id;
    fs::path path, temporary;
    std::unique_ptr<GifWriter> writer;
  };
  const Pictures& pictures_;
  std::vector<Row> rows_;
};

void sayMemory(const Inspector& inspector, const std::vector<IntermediateId>& ids) {
  std::vector<Settings> lanes;
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    lanes.push_back(inspector.shot().usedSettings(lane));
  // Rows that are written to files are counted with the export.
  std::vector<IntermediateId> ofReference;
  std::ranges::copy_if(ids, std::back_inserter(ofReference), isOfReference);
  const glm::ivec2 size(inspector.shot().width(), inspector.shot().height());
  const MemoryNeed need = memoryNeed(lanes, size, ofReference, &inspector.shot().scene());
  std::string text = "about " + bytesText(need.total()) + " for " + std::to_string(size.x) + " × " +
                     std::to_string(size.y) + " pixels (inputs " + bytesText(need.inputs) + ", histories " +
                     bytesText(need.histories);
  if (need.reference > 0) text += ", reference " + bytesText(need.reference);
  text +=
      "), besides the scene, kept histories and an export of up to " + bytesText(kExportBytes) + " at a time";
  if (const std::optional<std::size_t> available = gl::availableMemory(inspector.shot().driver()))
    text += "; " + bytesText(*available) + " are free";
  tell("memory", text);
}

/// What drawing the scene takes, before anything of it is drawn; nothing of a capture.
void sayScene(const Scene& scene) {
  const SceneCost cost = costOf(scene);
  if (cost.objects == 0) return;
  tell("scene", std::to_string(cost.objects) + " objects, " + std::to_string(cost.triangles) +
                    " triangles, " + std::to_string(cost.vertices) + " vertices, " + bytesText(cost.bytes) +
                    " of buffers and textures");
}

/// All frames; `written` is told of each file as soon as it is there.
void renderFrames(Inspector& inspector, const RenderArguments& arguments, const ShotPlan& plan,
                  const FrameRange& range, const Pictures& pictures, const Progress& progress,
                  const std::function<void(const fs::path&)>& written) {
  const std::vector<IntermediateId> ids = parseEmit(arguments.emit);
  const bool isExr = arguments.format == "exr";
  std::optional<Animations> animations;
  if (arguments.format == "gif") animations.emplace(inspector, plan, arguments, ids, pictures);
  for (int frame = range.first; frame <= range.last; ++frame) {
    report(progress, "Rendering", frame - range.first, range.count());
    // Only the way to the first frame is long enough to tell of.
    inspector.shot().seek(frame, frame == range.first ? progress : Progress());
    if (isExr) {
      written(writeExr(inspector, plan, arguments, ids, pictures, progress));
      continue;
    }
    inspector.views().watch(ids);
    if (animations)
      animations->add(inspector, progress);
    else
      for (const fs::path& path : writePngs(inspector, plan, arguments, ids, pictures, progress))
        written(path);
  }
  if (animations)
    for (const fs::path& path : animations->finish()) written(path);
}

FrameRange rangeOf(const RenderArguments& arguments, const ShotPlan& plan) {
  if (!arguments.frames.empty()) return parseFrames(arguments.frames);
  if (plan.frame < 0) throw UsageError("--frames is required: A..B, for example 0..31, or one frame");
  return {plan.frame, plan.frame};
}

/// Throws UsageError where it is said what has no effect on a capture, or makes none.
SequenceRequest captureRequest(const RenderArguments& arguments, const ShotPlan& plan,
                               const FrameRange& range) {
  if (plan.lanes.size() > 1)
    throw UsageError("--format capture is of one lane: leave --lane out, and say --preset");
  if (arguments.emit != RenderArguments().emit)
    throw UsageError("--emit: a capture has what the resolve is given and the resolved picture");
  if (!arguments.compare.empty() || !arguments.style.empty())
    throw UsageError("--compare and --style: a capture has neither differences nor pictures");
  if (arguments.isReferenceAsked) checkReferenceSamples(arguments.referenceSamples);
  SequenceRequest request;
  request.kind = SequenceKind::Capture;
  request.target = fs::path(arguments.folder) / capture::kManifestName;
  request.first = range.first;
  request.last = range.last;
  if (!arguments.like.empty()) request.capture.like = arguments.like;
  request.capture.conventions = arguments.conventions;
  if (arguments.isReferenceAsked) request.capture.referenceSamples = arguments.referenceSamples;
  try {
    conventionsOf(request.capture);
  } catch (const Error& error) {
    throw UsageError(std::string("--like, --set-convention: ") + error.what());
  }
  return request;
}

void printRenderJson(const RenderArguments& arguments, const ShotPlan& plan, const FrameRange& range,
                     const Pictures& pictures, const Inspector& inspector, const ordered_json& files,
                     std::ostream& out) {
  ordered_json json = shotJson(inspector);
  json["frames"] = {range.first, range.last};
  if (pictures.showsReference()) json["referenceSamples"] = arguments.referenceSamples;
  if (pictures.compares()) json["compare"] = arguments.compare;
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    json["lanes"].push_back(laneJson(inspector, plan.lanes.at(static_cast<std::size_t>(lane)), lane));
  json["files"] = files;
  out << json.dump(2) << '\n';
}

} // namespace

void runRender(const RenderArguments& arguments, std::ostream& out, const Progress& progress) {
  ShotPlan plan = planShot(arguments.shot);
  const FrameRange range = rangeOf(arguments, plan);
  const std::vector<IntermediateId> ids = parseEmit(arguments.emit);
  const Pictures pictures(arguments, ids);
  pictures.addLane(plan);
  if (pictures.showsReference()) checkReferenceSamples(arguments.referenceSamples);
  std::optional<SequenceRequest> captured;
  if (arguments.format == "capture")
    captured = captureRequest(arguments, plan, range);
  else if (!arguments.like.empty() || !arguments.conventions.empty())
    throw UsageError("--like and --set-convention are of captures: they need --format capture");
  Inspector inspector;
  openShot(inspector, arguments.shot, plan, progress);
  if (arguments.verbose) {
    sayScene(inspector.shot().scene());
    sayMemory(inspector, ids); // what is open says its size, and whether it has fog
  }
  requireFrame(inspector, plan, range.last);
  if (!arguments.force)
    refuseToReplace(captured ? sequenceFiles(*captured)
                             : plannedFiles(arguments, plan, range, ids, pictures));
  if (!captured) makeFolder(arguments.folder);

  ordered_json files = ordered_json::array();
  const auto written = [&](const fs::path& path) {
    files.push_back(path.string());
    if (!arguments.json) out << path.string() << '\n' << std::flush;
  };
  if (captured)
    std::ranges::for_each(exportSequence(inspector, *captured, progress), written);
  else
    renderFrames(inspector, arguments, plan, range, pictures, progress, written);
  if (arguments.json) printRenderJson(arguments, plan, range, pictures, inspector, files, out);
}

} // namespace taa::cli
