// taa-batch doctor: what is wrong with the frames of a scene or a capture, and what to change.
#include "core/base/Error.h"
#include "core/base/ExistingFiles.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/cli/Commands.h"
#include "core/cli/PlanChecks.h"
#include "core/cli/Shot.h"
#include "core/doctor/examination/Doctor.h"
#include "core/doctor/examination/MendedLook.h"
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

fs::path mendedPreset(const DoctorArguments& arguments) {
  return fs::path(arguments.mended) / "mended.json";
}

/// Throws Error where a file is there that would be replaced.
void refuseFiles(const DoctorArguments& arguments) {
  std::vector<fs::path> files;
  if (!arguments.html.empty()) files.emplace_back(arguments.html);
  if (!arguments.writtenBaseline.empty()) files.emplace_back(arguments.writtenBaseline);
  if (!arguments.mended.empty()) files.push_back(mendedPreset(arguments));
  if (!arguments.force) refuseToReplace(files);
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

/// The settings as a preset, and the pictures, given beside mended.
void writeMended(const doctor::MendedLook& look, const DoctorArguments& arguments) {
  const fs::path folder = arguments.mended;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Error(say<"cannot make the folder %1: %2">(folder.string(), error.message()));
  if (look.mended.findings.empty()) return;
  Preset row{"mended", "Mended", "", 0, "Makes right what the doctor found.", look.mended.settings};
  writeFile(mendedPreset(arguments), presetToText(row));
  for (const doctor::MendedPicture& picture : look.pictures) {
    const std::string name =
        "finding" + std::to_string(picture.finding + 1) + "-frame" + std::to_string(picture.frame);
    writeFile(folder / (name + "-given.png"), pngOfShown(picture.given));
    writeFile(folder / (name + "-mended.png"), pngOfShown(picture.mended));
  }
}

} // namespace

bool runDoctor(const DoctorArguments& arguments, std::ostream& out, const Progress& progress) {
  const ShotPlan plan = planShot(arguments.shot);
  if (arguments.shot.lanes.size() > 1)
    throw UsageError("--lane: the doctor looks at what all lanes are given, so one is enough");
  std::optional<DoctorBaseline> baseline;
  if (!arguments.baseline.empty())
    baseline = baselineFromText(readFile(arguments.baseline), arguments.baseline);
  refuseFiles(arguments);
  sayNotes(plan.notes, plan.lanes);
  const UsedShaders shaders; // before the context: everything is compiled from them
  const gl::Context context;
  doctor::DoctorSource source = openedSource(plan, progress);
  const LaneChoice& lane = plan.lanes.front();
  doctor::Diagnosis diagnosis = doctor::examine(doctor::examinationOf(source, arguments.frames), progress);
  std::optional<doctor::MendedLook> mended;
  if (!arguments.mended.empty() && !diagnosis.isHealthy()) {
    mended = doctor::lookAtMended(source, diagnosis, lane.settings, healthySettings(lane), progress);
    writeMended(*mended, arguments);
  }
  if (!arguments.writtenBaseline.empty()) {
    baseline = baselineOf(diagnosis);
    writeFile(arguments.writtenBaseline, baselineToText(*baseline));
  }
  if (baseline) markKnown(diagnosis, *baseline);
  if (!arguments.html.empty())
    writeFile(arguments.html, doctorHtml(diagnosis, plan.source, mended ? &*mended : nullptr));
  if (arguments.json) {
    nlohmann::ordered_json json = doctorJson(diagnosis, plan.source);
    if (mended) json["mended"] = mendedJson(*mended, diagnosis, lane.settings);
    out << json.dump(2) << '\n';
  } else {
    out << doctorText(diagnosis, plan.source);
    if (mended) out << mendedText(*mended, diagnosis, lane.settings);
  }
  return !diagnosis.hasNews();
}

} // namespace taa::cli
