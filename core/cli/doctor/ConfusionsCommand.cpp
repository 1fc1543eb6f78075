// taa-batch confusions: what the doctor says of frames with injected faults, as a table.
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/cli/Commands.h"
#include "core/gl/Context.h"
#include "core/inspect/UsedShaders.h"
#include "core/report/doctor/CaseJudge.h"
#include "core/report/doctor/CasePlan.h"
#include "core/report/doctor/DoctorCases.h"
#include "core/scene/SceneSource.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace taa::cli {

namespace {

std::vector<Fault> confusedFaults(const std::vector<std::string>& ids) {
  std::vector<Fault> out;
  if (ids.empty())
    for (const FaultInfo& info : faultTable()) out.push_back(info.fault);
  for (const std::string& id : ids) {
    try {
      out.push_back(faultInfo(id).fault);
    } catch (const Error& error) {
      throw UsageError(std::string("--faults: ") + error.what());
    }
  }
  return out;
}

void requireScenes(const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (std::ranges::find(builtinScenes(), name, &BuiltinScene::id) == builtinScenes().end())
      throw UsageError("--scenes: there is no built-in scene \"" + name +
                       "\"; taa-batch list scenes says which there are");
}

CasePlan casePlanOf(const ConfusionsArguments& arguments) {
  requireScenes(arguments.scenes);
  const auto isAsked = [&](const char* kind) {
    return std::ranges::find(arguments.kinds, kind) != arguments.kinds.end();
  };
  CasePlan plan{arguments.scenes, arguments.cameras, arguments.captures, confusedFaults(arguments.faults)};
  plan.healthy = isAsked("healthy");
  plan.single = isAsked("single");
  plan.half = isAsked("half");
  plan.pairs = isAsked("pairs");
  plan.presets = isAsked("presets");
  plan.sizePx = parseSize(arguments.size);
  plan.frames = arguments.frames;
  return plan;
}

/// What the file holds already; nothing where there is none.
std::vector<JudgedCase> casesOfFile(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  return judgedCasesFrom(readFile(file), file.string());
}

std::string fileText(const std::vector<JudgedCase>& judged) {
  std::string text = judgedCasesHead();
  for (const JudgedCase& one : judged) text += judgedCaseText(one);
  return text;
}

} // namespace

void runConfusions(const ConfusionsArguments& arguments, std::ostream& out, const Progress& progress) {
  std::vector<JudgedCase> judged = casesOfFile(arguments.file);
  std::vector<PlannedCase> planned = plannedCases(casePlanOf(arguments));
  const std::size_t all = planned.size();
  std::erase_if(planned, [&](const PlannedCase& one) {
    return std::ranges::find(judged, one.tried, &JudgedCase::tried) != judged.end();
  });
  out << all << " cases, " << all - planned.size() << " there already\n";
  const UsedShaders shaders; // before the context: everything is compiled from them
  const gl::Context context;
  CaseJudge judge;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    report(progress, "Trying the doctor", static_cast<int>(i), static_cast<int>(planned.size()));
    judged.push_back(judge.judge(planned[i]));
    // Whole, so that it can be stopped at any time, and goes on from there.
    writeFile(arguments.file, fileText(judged));
    out << judgedCaseText(judged.back()) << std::flush;
  }
}

} // namespace taa::cli
