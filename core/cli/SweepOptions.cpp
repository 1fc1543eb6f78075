#include "core/cli/SweepOptions.h"

#include "core/cli/Commands.h"
#include "core/cli/ShotOptions.h"
#include "core/measure/Flicker.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace taa::cli {

void addSweep(CLI::App& app, SweepArguments& sweep, const Progress& progress, bool& hasFailed) {
  CLI::App* command = app.add_subcommand(
      "sweep", "Measure settings, ranges of parameters and scenes in all combinations that a file names, in "
               "parts where several processes share them, and go on after being stopped");
  command->add_option("SPEC", sweep.spec, "A JSON file: what to go over (manual, sweep)")->required();
  command->add_option("--out", sweep.folder, "Folder of the results; what is there is not computed again")
      ->required();
  command->add_option("--shard", sweep.shard, "I/N: only the I-th of N parts of the points, from 1");
  addSceneBudget(*command, sweep.sceneMillions, sweep.sceneMiB);
  command->add_flag("--json", sweep.json, "Print JSON");
  command->callback([&sweep, &progress, &hasFailed] { hasFailed = !runSweep(sweep, std::cout, progress); });
}

void addTune(CLI::App& app, TuneArguments& tune, const Progress& progress) {
  CLI::App* command = app.add_subcommand(
      "tune", "Find settings of the resolve that serve a goal better than those it is given, on some frames");
  addShotOptions(*command, tune.shot);
  command
      ->add_option("--goal", tune.goal,
                   "METRIC=WEIGHT with commas between, of the metrics that metrics --json names, and cost, "
                   "the time of the resolve; each counts relative to what it is at the start")
      ->capture_default_str();
  command->add_flag("--trade", tune.trades,
                    "RMSE and flicker may become worse where the goal gains by it; else nothing is kept that "
                    "raises one of them by more than 1 %");
  command->add_option("--frames", tune.frames,
                      "A..B, both included: what is measured; else the session's frame");
  addReferenceSamples(*command, tune.referenceSamples, "of the reference, 4 to 1024");
  command->add_option("--flicker-frames", tune.flickerFrames, "Frames that flicker is taken over, 2 to 64")
      ->check(CLI::Range(kMinFlickerFrames, kMaxFlickerFrames))
      ->capture_default_str();
  CLI::Option* budget =
      command->add_option("--budget", tune.evaluations, "Settings that are measured at most")
          ->check(CLI::Range(1, 1'000'000))
          ->capture_default_str();
  command->add_option("--seconds", tune.seconds, "How long to look, instead of --budget")
      ->check(CLI::Range(1, 1'000'000))
      ->excludes(budget);
  command
      ->add_option("--vary", tune.varied,
                   "A parameter, or a group of them such as rectify, that may change; repeat it for more. "
                   "Without it all numbers, switches and choices of the resolve may")
      ->allow_extra_args(false);
  command->add_option("--seed", tune.seed, "Another order of trying")->capture_default_str();
  command->add_option("--out", tune.preset, "The preset that is written, a .json file")->required();
  command->add_option("--glsl", tune.glsl, "Also write its resolve as one GLSL file");
  addForce(*command, tune.force);
  command->add_flag("--json", tune.json, "Print JSON");
  command->callback([&tune, &progress] { runTune(tune, std::cout, progress); });
}

} // namespace taa::cli
