#include "core/cli/doctor/ConfusionsOptions.h"

#include "core/cli/Commands.h"
#include "core/doctor/Diagnosis.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <string>
#include <vector>

namespace taa::cli {

void addConfusions(CLI::App& app, ConfusionsArguments& confusions, const Progress& progress) {
  CLI::App* command = app.add_subcommand(
      "confusions",
      "Inject faults into scenes and captures, and write down what the doctor says of each: the "
      "table that the manual shows");
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
  command->callback([&confusions, &progress] { runConfusions(confusions, std::cout, progress); });
}

} // namespace taa::cli
