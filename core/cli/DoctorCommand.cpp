// taa-batch doctor: what is wrong with the frames of a scene or a capture, and what to change.
#include "core/base/Error.h"
#include "core/base/ExistingFiles.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/cli/Command.h"
#include "core/cli/Shot.h"
#include "core/doctor/examination/CorrectedLook.h"
#include "core/doctor/examination/Doctor.h"
#include "core/gl/Context.h"
#include "core/inspect/UsedShaders.h"
#include "core/report/doctor/DoctorBaseline.h"
#include "core/report/doctor/DoctorPage.h"
#include "core/report/doctor/DoctorReport.h"
#include "core/report/doctor/ShownPng.h"
#include "core/settings/Faults.h"
#include "core/settings/Presets.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

namespace taa::cli {

namespace {

namespace fs = std::filesystem;

struct DoctorCommand final : Command {
  ShotOptions shot;
  int frames = doctor::kDoctorFrames;
  std::string html;                      ///< a file; empty: none is written
  std::string baseline, writtenBaseline; ///< of known findings: read, written; empty: none
  std::string corrected;                 ///< a folder; empty: what is found is not corrected
  bool json = false, force = false;

  DoctorCommand() : Command("doctor") {
    description("Say what is wrong with jitter, depth and motion vectors of an engine's frames, region by "
                "region, and what to change; ends with 3 where something is");
    addShotOptions(*this, shot);
    add_option("--frames", frames, "How many frames are examined, from frame 0 on")
        ->check(CLI::Range(doctor::kLeastDoctorFrames, doctor::kMaxDoctorFrames))
        ->capture_default_str();
    add_option("--html", html,
               "Also write all of it as one page of HTML, without scripts, to put into a bug tracker");
    add_option("--baseline", baseline,
               "A JSON file of findings that are known: where there are no others, it ends with 0");
    add_option("--write-baseline", writtenBaseline,
               "Also write all that is found as such a file, and end with 0");
    add_option(
        "--mended", corrected,
        "Also look at the frames with what was found made right: what is found then, how far both are from "
        "the reference, and in this folder pictures and settings of them, as a preset to compare with");
    addForce(*this, force);
    addJson(*this, json);
  }

  int run(std::ostream& out, const Progress& progress) const override;
};

fs::path correctedPreset(const fs::path& folder) {
  return folder / "mended.json";
}

/// Throws Error where a file is there that would be replaced.
void refuseFiles(const DoctorCommand& command) {
  std::vector<fs::path> files;
  if (!command.html.empty()) files.emplace_back(command.html);
  if (!command.writtenBaseline.empty()) files.emplace_back(command.writtenBaseline);
  if (!command.corrected.empty()) files.push_back(correctedPreset(command.corrected));
  if (!command.force) refuseToReplace(files);
}

doctor::DoctorSource openedSource(const ShotPlan& plan, const Progress& progress) {
  const ShotWishes wishes = wishesOf(plan);
  doctor::DoctorSource source;
  openChosen(plan, [&] {
    source = doctor::openForDoctor(
        {plan.source, wishes.camera, plan.size, plan.lanes.front().settings, plan.choice}, progress);
  });
  checkWishes(plan, {source.scene.get(), source.frameCount});
  if (wishes.track) source.request.track = std::make_shared<const CameraTrack>(*wishes.track);
  source.request.motionModes = wishes.motionModes;
  source.request.filter = wishes.filter;
  source.request.objectClasses = wishes.objectClasses;
  source.request.restarts = wishes.restarts;
  return source;
}

/// What settings go back to where a fault is taken back: those of the lane's preset. The preset of a session
/// may be a file that is not there any more.
Settings healthySettings(const LaneChoice& lane) {
  const bool isBuiltin = std::ranges::count(builtinPresets(), lane.preset, &Preset::id) > 0;
  Settings healthy = isBuiltin || fs::exists(lane.preset) ? preset(lane.preset).settings : lane.settings;
  clearFaults(healthy);
  return healthy;
}

/// The settings as a preset, and the pictures, given beside corrected.
void writeCorrected(const doctor::CorrectedLook& look, const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Error(say<"cannot make the folder %1: %2">(folder.string(), error.message()));
  if (look.corrected.findings.empty()) return;
  Preset row{"mended", "Mended", "", 0, "Makes right what the doctor found.", look.corrected.settings};
  writeFile(correctedPreset(folder), presetToText(row));
  for (const doctor::CorrectedPicture& picture : look.pictures) {
    const std::string name =
        "finding" + std::to_string(picture.finding + 1) + "-frame" + std::to_string(picture.frame);
    writeFile(folder / (name + "-given.png"), pngOfShown(picture.given));
    writeFile(folder / (name + "-mended.png"), pngOfShown(picture.corrected));
  }
}

int DoctorCommand::run(std::ostream& out, const Progress& progress) const {
  const ShotPlan plan = planShot(shot);
  if (shot.lanes.size() > 1)
    throw UsageError("--lane: the doctor looks at what all lanes are given, so one is enough");
  std::optional<DoctorBaseline> known;
  if (!baseline.empty()) known = baselineFromText(readFile(baseline), baseline);
  refuseFiles(*this);
  sayNotes(plan.notes, plan.lanes);
  const UsedShaders shaders; // before the context: everything is compiled from them
  const gl::Context context;
  doctor::DoctorSource source = openedSource(plan, progress);
  const LaneChoice& lane = plan.lanes.front();
  doctor::Diagnosis diagnosis = doctor::examine(doctor::examinationOf(source, frames), progress);
  std::optional<doctor::CorrectedLook> look;
  if (!corrected.empty() && !diagnosis.isHealthy()) {
    look = doctor::lookAtCorrected(source, diagnosis, lane.settings, healthySettings(lane), progress);
    writeCorrected(*look, corrected);
  }
  if (!writtenBaseline.empty()) {
    known = baselineOf(diagnosis);
    writeFile(writtenBaseline, baselineToText(*known));
  }
  if (known) markKnown(diagnosis, *known);
  if (!html.empty()) writeFile(html, doctorHtml(diagnosis, plan.source, look ? &*look : nullptr));
  if (json) {
    nlohmann::ordered_json result = doctorJson(diagnosis, plan.source);
    if (look) result["mended"] = correctedJson(*look, diagnosis, lane.settings);
    print(out, result);
  } else {
    out << doctorText(diagnosis, plan.source);
    if (look) out << correctedText(*look, diagnosis, lane.settings);
  }
  return diagnosis.hasNews() ? kFindings : kDone;
}

} // namespace

std::shared_ptr<Command> doctorCommand() {
  return std::make_shared<DoctorCommand>();
}

} // namespace taa::cli
