// taa-batch render: frames into files.
#include "core/base/ExistingFiles.h"
#include "core/base/Files.h"
#include "core/capture/format/Manifest.h"
#include "core/cli/Command.h"
#include "core/cli/Pictures.h"
#include "core/cli/Terminal.h"
#include "core/inspect/MemoryNeed.h"
#include "core/io/FrameJson.h"
#include "core/io/GifFile.h"
#include "core/io/PictureFile.h"
#include "core/measure/Metrics.h"
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

constexpr const char* kDefaultRow = "resolved";

struct RenderCommand final : Command {
  ShotOptions shot;
  std::string frames, folder;                    ///< frames empty: that of the session
  std::vector<std::string> emit = {kDefaultRow}; ///< ids, or "all"
  std::string format = "exr";
  int referenceSamples = kReferenceSamples; ///< of frames whose reference is looked at
  std::string like;                         ///< starting point of a capture; empty: this program's own
  std::vector<std::string> conventions;     ///< of a capture, "path=value" on top of it
  PictureOptions pictures;
  double framesPerSecond = 0.0; ///< of a GIF; 0: the scene's
  bool force = false, json = false, verbose = false;

  RenderCommand() : Command("render") {
    description("Render frames and write their intermediates to files");
    addShotOptions(*this, shot);
    add_option("--frames", frames, "A..B, both included, or one frame; else the session's");
    add_option("--out", folder, "Folder of the files; made where it is missing")->required();
    add_option("--emit", emit, "Intermediates, with commas between (see list intermediates), or all")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->capture_default_str();
    add_option("--format", format,
               "exr: frame.0007.exr with a part for each intermediate; png: what a view shows, a file for "
               "each; gif: the same as one animation for each; capture: capture.json and raw planes, which "
               "every command takes as a source")
        ->check(CLI::IsMember({"exr", "png", "gif", "capture"}))
        ->capture_default_str();
    addReferenceSamples(
        *this, referenceSamples,
        "of references that are emitted, 4 to 1024; a capture has one only where this is said");
    add_option("--like", like,
               "Of a capture: the engine whose conventions and formats it is written in, which are this "
               "program's without it: " +
                   startingPointIds());
    add_option("--set-convention", conventions,
               "Of a capture: key=value on top of --like, for example motion.unit=ndc; repeat it for more")
        ->allow_extra_args(false);
    addPictureOptions(*this, pictures);
    add_option("--fps", framesPerSecond, "Frames a second of a gif; else the scene's")
        ->check(numberFrom(0.1, 1000.0));
    addForce(*this, force);
    add_flag("--json", json, "Print JSON instead of the names of the files");
    add_flag("--verbose", verbose,
             "Say on standard error what the scene draws and how much memory it takes, before the frames are "
             "rendered");
  }

  int run(std::ostream& out, const Progress& progress) const override;
  FrameRange range(const ShotPlan& plan) const;
  SequenceRequest captureRequest(const ShotPlan& plan, const FrameRange& written) const;
};

FrameRange RenderCommand::range(const ShotPlan& plan) const {
  if (!frames.empty()) return parseFrames(frames);
  if (plan.sessionFrame < 0) throw UsageError("--frames is required: A..B, for example 0..31, or one frame");
  return {plan.sessionFrame, plan.sessionFrame};
}

/// Throws UsageError where it is said what has no effect on a capture, or makes none.
SequenceRequest RenderCommand::captureRequest(const ShotPlan& plan, const FrameRange& written) const {
  if (plan.lanes.size() > 1)
    throw UsageError("--format capture is of one lane: leave --lane out, and say --preset");
  if (emit != std::vector<std::string>{kDefaultRow})
    throw UsageError("--emit: a capture has what the resolve is given and the resolved picture");
  if (!pictures.compare.empty() || !pictures.style.empty())
    throw UsageError("--compare and --style: a capture has neither differences nor pictures");
  SequenceRequest request;
  request.kind = SequenceKind::Capture;
  request.target = fs::path(folder) / capture::kManifestName;
  request.first = written.first;
  request.last = written.last;
  if (!like.empty()) request.capture.like = like;
  request.capture.conventions = conventions;
  if (count("--reference-samples") > 0) {
    checkReferenceSamples(referenceSamples);
    request.capture.referenceSamples = referenceSamples;
  }
  readOption("--like, --set-convention", [&] { return conventionsOf(request.capture); });
  return request;
}

/// What is rendered, read once.
struct RenderPlan {
  ShotPlan shot;
  FrameRange range;
  std::vector<IntermediateId> ids;
  Pictures pictures;
};

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
fs::path exrPath(const RenderCommand& command, int frame) {
  return fs::path(command.folder) / (frameName(frame) + ".exr");
}
fs::path pngPath(const RenderCommand& command, int frame, const LaneChoice& lane, IntermediateId id) {
  return fs::path(command.folder) / (frameName(frame) + "." + rowName(lane, id) + ".png");
}
fs::path gifPath(const RenderCommand& command, const LaneChoice& lane, IntermediateId id) {
  return fs::path(command.folder) / (rowName(lane, id) + ".gif");
}

/// All files that the command writes, in the order in which they appear.
std::vector<fs::path> plannedFiles(const RenderCommand& command, const RenderPlan& plan) {
  std::vector<fs::path> paths;
  const auto ofRows = [&](auto path) {
    for (int lane = 0; lane < plan.pictures.laneCount(plan.shot); ++lane)
      for (const IntermediateId id : plan.ids) paths.push_back(path(plan.shot.lane(lane), id));
  };
  if (command.format == "gif")
    ofRows([&](const LaneChoice& lane, IntermediateId id) { return gifPath(command, lane, id); });
  for (int frame = plan.range.first; frame <= plan.range.last; ++frame) {
    if (command.format == "exr") paths.push_back(exrPath(command, frame));
    if (command.format == "png")
      ofRows([&](const LaneChoice& lane, IntermediateId id) { return pngPath(command, frame, lane, id); });
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
    lanes.push_back({plan.lane(lane).name, inspector.shot().usedSettings(lane), inspector.shot().info(lane),
                     inspector.views().inputs(lane).block});
  return lanes;
}

fs::path writeExr(Inspector& inspector, const RenderCommand& command, const RenderPlan& plan,
                  const Progress& progress) {
  fs::path path = exrPath(command, inspector.shot().frame());
  FrameFile frame{inspector.shot().source(),
                  inspector.shot().camera(),
                  inspector.shot().driver().renderer,
                  laneHeaders(inspector, plan.shot),
                  {}};
  if (plan.pictures.compares()) {
    exportDifferences(inspector, std::move(frame), plan.ids,
                      plan.pictures.request(inspector, plan.ids.front(), 0), command.pictures.compare, path,
                      progress);
    return path;
  }
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    inspector.reference().makeRows(plan.ids, command.referenceSamples, progress, lane);
  exportFrame(inspector, std::move(frame), plan.ids, path);
  return path;
}

/// One file for each intermediate.
std::vector<fs::path> writePngs(Inspector& inspector, const RenderCommand& command, const RenderPlan& plan,
                                const Progress& progress) {
  std::vector<fs::path> paths;
  for (int lane = 0; lane < plan.pictures.laneCount(plan.shot); ++lane)
    for (const IntermediateId id : plan.ids) {
      const Picture picture = plan.pictures.draw(inspector, id, lane, progress);
      paths.push_back(pngPath(command, inspector.shot().frame(), plan.shot.lane(lane), id));
      writePng(paths.back(), picture.width, picture.height, picture.rgba);
    }
  return paths;
}

/// "resolved.gif", or "A.resolved.gif": an animation for each intermediate of each lane.
class Animations {
 public:
  Animations(const Inspector& inspector, const RenderCommand& command, const RenderPlan& plan)
      : pictures_(plan.pictures) {
    const double rate = command.framesPerSecond > 0.0 ? command.framesPerSecond
                                                      : inspector.shot().scene().shot.framesPerSecond;
    for (int lane = 0; lane < pictures_.laneCount(plan.shot); ++lane)
      for (const IntermediateId id : plan.ids) {
        const fs::path path = gifPath(command, plan.shot.lane(lane), id);
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
void renderFrames(Inspector& inspector, const RenderCommand& command, const RenderPlan& plan,
                  const Progress& progress, const std::function<void(const fs::path&)>& written) {
  const FrameRange& range = plan.range;
  std::optional<Animations> animations;
  if (command.format == "gif") animations.emplace(inspector, command, plan);
  for (int frame = range.first; frame <= range.last; ++frame) {
    report(progress, "Rendering", frame - range.first, range.count());
    // Only the way to the first frame is long enough to tell of.
    inspector.shot().seek(frame, frame == range.first ? progress : Progress());
    if (command.format == "exr") {
      written(writeExr(inspector, command, plan, progress));
      continue;
    }
    inspector.views().watch(plan.ids);
    if (animations)
      animations->add(inspector, progress);
    else
      std::ranges::for_each(writePngs(inspector, command, plan, progress), written);
  }
  if (animations) std::ranges::for_each(animations->finish(), written);
}

ordered_json renderJson(const Inspector& inspector, const RenderCommand& command, const RenderPlan& plan) {
  ordered_json json = shotJson(inspector);
  json["frames"] = {plan.range.first, plan.range.last};
  if (plan.pictures.showsReference()) json["referenceSamples"] = command.referenceSamples;
  if (plan.pictures.compares()) json["compare"] = command.pictures.compare;
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    json["lanes"].push_back(laneJson(inspector, plan.shot, lane));
  return json;
}

int RenderCommand::run(std::ostream& out, const Progress& progress) const {
  ShotPlan planned = planShot(shot);
  const FrameRange written = range(planned);
  const std::vector<IntermediateId> ids = parseEmit(emit);
  RenderPlan plan{std::move(planned), written, ids,
                  Pictures(pictures, ids, format == "exr", referenceSamples)};
  plan.pictures.addLane(plan.shot);
  if (plan.pictures.showsReference()) checkReferenceSamples(referenceSamples);
  std::optional<SequenceRequest> captured;
  if (format == "capture")
    captured = captureRequest(plan.shot, plan.range);
  else if (!like.empty() || !conventions.empty())
    throw UsageError("--like and --set-convention are of captures: they need --format capture");
  Inspector inspector;
  openShot(inspector, plan.shot, progress);
  if (verbose) {
    sayScene(inspector.shot().scene());
    sayMemory(inspector, plan.ids); // what is open says its size, and whether it has fog
  }
  requireFrame(inspector, plan.shot, plan.range.last);
  if (!force) refuseToReplace(captured ? sequenceFiles(*captured) : plannedFiles(*this, plan));
  if (!captured) makeFolder(folder);

  ordered_json files = ordered_json::array();
  const auto add = [&](const fs::path& path) {
    files.push_back(path.string());
    if (!json) out << path.string() << '\n' << std::flush;
  };
  if (captured)
    std::ranges::for_each(exportSequence(inspector, *captured, progress), add);
  else
    renderFrames(inspector, *this, plan, progress, add);
  if (!json) return kDone;
  ordered_json result = renderJson(inspector, *this, plan);
  result["files"] = files;
  print(out, result);
  return kDone;
}

} // namespace

std::shared_ptr<Command> renderCommand() {
  return std::make_shared<RenderCommand>();
}

} // namespace taa::cli
