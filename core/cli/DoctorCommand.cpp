// taa-batch doctor: what is wrong with the frames of a scene or a capture, and what to change.
#include "core/base/ExistingFiles.h"
#include "core/base/Files.h"
#include "core/cli/Commands.h"
#include "core/cli/Shot.h"
#include "core/doctor/Doctor.h"
#include "core/gl/Context.h"
#include "core/inspect/UsedShaders.h"
#include "core/report/doctor/DoctorBaseline.h"
#include "core/report/doctor/DoctorPage.h"
#include "core/report/doctor/DoctorReport.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <ostream>

namespace taa::cli {

bool runDoctor(const DoctorArguments& arguments, std::ostream& out, const Progress& progress) {
  const ShotPlan plan = planShot(arguments.shot);
  if (arguments.shot.lanes.size() > 1)
    throw UsageError("--lane: the doctor looks at what all lanes are given, so one is enough");
  std::optional<DoctorBaseline> baseline;
  if (!arguments.baseline.empty())
    baseline = baselineFromText(readFile(arguments.baseline), arguments.baseline);
  if (!arguments.html.empty() && !arguments.force) refuseToReplace({arguments.html});
  if (!arguments.writtenBaseline.empty() && !arguments.force) refuseToReplace({arguments.writtenBaseline});
  sayNotes(plan.notes, plan.lanes);
  const UsedShaders shaders; // before the context: everything is compiled from them
  const gl::Context context;
  doctor::DoctorSource source = doctor::openForDoctor(
      {plan.source, plan.camera, plan.size, plan.lanes.front().settings, plan.choice}, progress);
  if (plan.track) source.request.track = std::make_shared<const CameraTrack>(*plan.track);
  source.request.motionModes = plan.motionModes;
  source.request.filter = plan.filter;
  source.request.objectClasses = plan.objectClasses;
  source.request.restarts = plan.restarts;
  doctor::Diagnosis diagnosis = doctor::examine(doctor::examinationOf(source, arguments.frames), progress);
  if (!arguments.writtenBaseline.empty()) {
    baseline = baselineOf(diagnosis);
    writeFile(arguments.writtenBaseline, baselineToText(*baseline));
  }
  if (baseline) markKnown(diagnosis, *baseline);
  if (!arguments.html.empty()) writeFile(arguments.html, doctorHtml(diagnosis, plan.source));
  if (arguments.json)
    out << doctorJson(diagnosis, plan.source).dump(2) << '\n';
  else
    out << doctorText(diagnosis, plan.source);
  return !diagnosis.hasNews();
}

} // namespace taa::cli
