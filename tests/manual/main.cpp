// taa_manual: the pages of the manual that follow from the program's tables, and the exam of the doctor that
// one of them shows.
//
//   taa_manual pages resources/manual          writes those pages, over those that are there
//   taa_manual confusions tests/manual/doctor.csv   injects faults, and adds what the doctor says of each
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/cli/Options.h"
#include "core/doctor/Diagnosis.h"
#include "core/gl/Context.h"
#include "core/inspect/UsedShaders.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/manual/CaseJudge.h"
#include "tests/manual/CasePlan.h"
#include "tests/manual/DoctorCases.h"
#include "tests/manual/ManualTables.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <ostream>
#include <string>
#include <vector>

using namespace taa;
using namespace taa::cli;

namespace {

struct ConfusionsArguments {
  std::string file; ///< CSV
  std::vector<std::string> scenes = {"gallery", "disocclusion", "fence", "crowd", "foliage", "glass"};
  std::vector<std::string> cameras = {"still", "pan", "orbit"};
  std::vector<std::string> captures; ///< folders
  std::vector<std::string> faults;   ///< ids; empty: all
  std::vector<std::string> kinds = {"healthy", "single", "half", "pairs"};
  std::string size = "240x136";
  int frames = 14; ///< the table's faults of one frame are in 8 and 12
};

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

void runConfusions(const ConfusionsArguments& arguments, std::ostream& out) {
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
  for (const PlannedCase& one : planned) {
    judged.push_back(judge.judge(one));
    // Whole, so that it can be stopped at any time, and goes on from there.
    writeFile(arguments.file, fileText(judged));
    out << judgedCaseText(judged.back()) << std::flush;
  }
}

void addConfusions(CLI::App& app, ConfusionsArguments& confusions) {
  CLI::App* command =
      app.add_subcommand("confusions", "Inject faults into scenes and captures, and write down "
                                       "what the doctor says of each");
  command
      ->add_option("FILE", confusions.file,
                   "CSV with a line for each case; cases that it holds are not tried again")
      ->required();
  const auto addNames = [&](const char* name, std::vector<std::string>& names, const char* what) {
    return command->add_option(name, names, what)->delimiter(',')->allow_extra_args(false);
  };
  addNames("--scenes", confusions.scenes, "Built-in scenes, with commas between")->capture_default_str();
  addNames("--cameras", confusions.cameras, "Cameras of each scene")->capture_default_str();
  addNames("--captures", confusions.captures, "Folders of captures that faults are injected into, too");
  addNames("--faults", confusions.faults, "Ids of faults (manual, faults); without it all");
  addNames("--kinds", confusions.kinds,
           "healthy frames, a single fault, half of its strength, pairs of faults; "
           "presets: healthy frames and outputs of each preset")
      ->check(CLI::IsMember({"healthy", "single", "half", "pairs", "presets"}))
      ->capture_default_str();
  command->add_option("--size", confusions.size, "WxH of scenes, px")->capture_default_str();
  command->add_option("--frames", confusions.frames, "How many frames are examined, from frame 0 on")
      ->check(CLI::Range(doctor::kLeastDoctorFrames, doctor::kMaxDoctorFrames))
      ->capture_default_str();
  command->callback([&confusions] { runConfusions(confusions, std::cout); });
}

void writePages(const std::filesystem::path& folder) {
  for (const ManualPage& page : manualTables()) {
    writeFile(folder / page.file, page.text);
    std::cout << (folder / page.file).string() << '\n';
  }
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app("Writes what the manual takes from the program's tables.", "taa_manual");
  app.require_subcommand(1);
  std::string folder;
  CLI::App* pages = app.add_subcommand("pages", "Write the pages that follow from the program's tables");
  pages->add_option("FOLDER", folder, "Where they go; in the repository, resources/manual")->required();
  pages->callback([&folder] { writePages(folder); });
  ConfusionsArguments confusions;
  addConfusions(app, confusions);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  } catch (const UsageError& error) {
    std::cerr << "taa_manual: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "taa_manual: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
