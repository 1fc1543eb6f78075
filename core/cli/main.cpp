// taa-batch: the core without a window. The command line, and how the program ends.
#include "core/base/Error.h"
#include "core/base/NumberText.h"
#include "core/base/ShownText.h"
#include "core/cli/Commands.h"
#include "core/cli/EmptyValues.h"
#include "core/cli/LessonsOptions.h"
#include "core/cli/ShotOptions.h"
#include "core/cli/SweepOptions.h"
#include "core/cli/Terminal.h"
#include "core/doctor/Diagnosis.h"
#include "core/inspect/Comparison.h"
#include "core/measure/Flicker.h"
#include "core/measure/Metrics.h"
#include "core/scene/ShotChoice.h"
#include "core/verdict/lineage/Lineage.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <csignal>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace {

using namespace taa::cli;

constexpr int kWorldsFault = 1;
constexpr int kUsage = 2;
constexpr int kContradicted = 3; // import --check: pixels say something else than what is stated
constexpr int kUnhealthy = 3;    // doctor: something is wrong
constexpr int kMistaken = 3;     // lessons --check: something does not hold
constexpr int kSignalled = 128;  // and the number of SIGINT or SIGTERM, as a shell reports it

volatile std::sig_atomic_t interrupted = 0; // the signal; 0: none came

/// One line on a terminal that follows the work and is wiped at the end; silent where stderr is no terminal.
class ProgressLine {
 public:
  ProgressLine() : isTerminal_(::isatty(STDERR_FILENO) == 1) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() {
    if (isTerminal_) std::cerr << "\r\033[K" << std::flush;
  }
  bool show(std::string_view what, int done, int total) const {
    if (isTerminal_) std::cerr << "\r\033[K" << what << ": " << done << " of " << total << std::flush;
    return interrupted == 0;
  }

 private:
  bool isTerminal_;
};

/// As CLI::Range, which lets NaN pass.
CLI::Validator numberFrom(double least, double most) {
  return {[least, most](std::string& text) -> std::string {
            double value = 0.0;
            const char* const end = text.data() + text.size();
            const auto [rest, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc() && rest == end && value >= least && value <= most) return {};
            return "\"" + text + "\" is not a number from " + taa::shortestText(least) + " to " +
                   taa::shortestText(most);
          },
          "FLOAT"};
}

void addList(CLI::App& app, ListArguments& list) {
  CLI::App* command = app.add_subcommand("list", "Say what there is");
  command->add_option("WHAT", list.what, "intermediates, parameters, presets or scenes")
      ->required()
      ->check(CLI::IsMember({"intermediates", "parameters", "presets", "scenes"}));
  command->add_flag("--json", list.json, "Print JSON");
  command->callback([&list] { runList(list, std::cout); });
}

void addComparing(CLI::App& command, RenderArguments& render) {
  command.add_option("--compare", render.compare,
                     "What each is compared with, " + std::string(taa::kComparisonHelp) +
                         "; an exr has the values of the differences then");
  command.add_option("--compare-as", render.compareAs,
                     "Of png and gif: how both are shown: wipe, which it is without this, first, other or "
                     "difference");
  command
      .add_option("--divider", render.divider, "Where a wipe goes over to the other side, share of the width")
      ->check(numberFrom(0.0, 1.0))
      ->capture_default_str();
  command.add_option("--other-style", render.otherStyle, "As --style, of the other side; repeat it for more")
      ->allow_extra_args(false);
}

void addConventions(CLI::App& command, RenderArguments& render) {
  command.add_option("--like", render.like,
                     "Of a capture: the engine whose conventions and formats it is written in, which are "
                     "this program's without it: taa-inspector, unreal, unity, godot, bevy, three, babylon, "
                     "fsr, xess, streamline, metalfx or blender");
  command
      .add_option("--set-convention", render.conventions,
                  "Of a capture: key=value on top of --like, for example motion.unit=ndc; repeat it for more")
      ->allow_extra_args(false);
}

void addRender(CLI::App& app, RenderArguments& render, const taa::Progress& progress) {
  CLI::App* command = app.add_subcommand("render", "Render frames and write their intermediates to files");
  addShotOptions(*command, render.shot);
  command->add_option("--frames", render.frames, "A..B, both included, or one frame; else the session's");
  command->add_option("--out", render.folder, "Folder of the files; made where it is missing")->required();
  command
      ->add_option("--emit", render.emit,
                   "Intermediates, with commas between (see list intermediates), or all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command
      ->add_option("--format", render.format,
                   "exr: frame.0007.exr with a part for each intermediate; png: what a view shows, a file "
                   "for each; gif: the same as one animation for each; capture: capture.json and raw planes, "
                   "which every command takes as a source")
      ->check(CLI::IsMember({"exr", "png", "gif", "capture"}))
      ->capture_default_str();
  addReferenceSamples(*command, render.referenceSamples,
                      "of references that are emitted, 4 to 1024; a capture has one only where this is said");
  addConventions(*command, render);
  command
      ->add_option("--style", render.style,
                   "How png and gif show values: low=, high=, exposure=, channels=, map=, marks=, clipped=, "
                   "rejected=, outlines= or arrows=; repeat it for more")
      ->allow_extra_args(false);
  addComparing(*command, render);
  command->add_option("--fps", render.framesPerSecond, "Frames a second of a gif; else the scene's")
      ->check(numberFrom(0.1, 1000.0));
  addForce(*command, render.force);
  command->add_flag("--json", render.json, "Print JSON instead of the names of the files");
  command->add_flag(
      "--verbose", render.verbose,
      "Say on standard error what the scene draws and how much memory it takes, before the frames are "
      "rendered");
  command->callback([command, &render, &progress] {
    render.isReferenceAsked = command->count("--reference-samples") > 0;
    runRender(render, std::cout, progress);
  });
}

void addProbe(CLI::App& app, ProbeArguments& probe, const taa::Progress& progress) {
  CLI::App* command = app.add_subcommand(
      "probe",
      "Print every intermediate at one pixel of one frame, or how their values are spread over a region");
  addShotOptions(*command, probe.shot);
  command->add_option("--frame", probe.frame, "Number of the frame, from 0; else the session's")
      ->check(CLI::Range(0, taa::kMaxShotFrames - 1));
  command->add_option("--pixel", probe.pixel, "X,Y; 0,0 is the top left");
  command
      ->add_option("--find", probe.find,
                   "In place of --pixel: the worst pixel whose history is rejected, the one whose history is "
                   "moved farthest (clipped), or the first one that is NaN or infinite in the output (nan)")
      ->check(CLI::IsMember({"rejected", "clipped", "nan"}));
  command->add_option("--region", probe.region,
                      "X,Y,WxH in place of --pixel: least and greatest value, mean, deviation, percentiles "
                      "and histogram of each row there, and how many are NaN, infinite or absent");
  command
      ->add_option("--emit", probe.emit,
                   "Of a region: intermediates, with commas between (see list intermediates), or all; else "
                   "those of the frame's own resolve")
      ->delimiter(',')
      ->allow_extra_args(false);
  addReferenceSamples(*command, probe.referenceSamples,
                      "of the reference, where --emit names rows of it, 4 to 1024");
  command->add_flag("--json", probe.json, "Print JSON");
  command->add_flag("--what-if", probe.whatIf,
                    "Also print the pixel under every rectification, box, history filter and preset");
  command->add_option(
      "--compare", probe.compare,
      "Also print each row of what the pixel is compared with, and their difference: "
      "preset:NAME, frame:N, frame:-N for N frames before, or motion:-1 for the frame before, "
      "where the pixel came from");
  command->callback([&probe, &progress] { runProbe(probe, std::cout, progress); });
}

void addLineage(CLI::App& app, LineageArguments& lineage, const taa::Progress& progress) {
  CLI::App* command = app.add_subcommand(
      "lineage", "Print which samples of the frames before one pixel of one frame is made of");
  addShotOptions(*command, lineage.shot);
  command->add_option("--frame", lineage.frame, "Number of the frame, from 0; else the session's")
      ->check(CLI::Range(0, taa::kMaxShotFrames - 1));
  command->add_option("--pixel", lineage.pixel, "X,Y; 0,0 is the top left")->required();
  command->add_option("--frames", lineage.frames, "How many frames are followed back, with the frame itself")
      ->check(CLI::Range(1, taa::kMaxLineageFrames))
      ->capture_default_str();
  command->add_flag("--json", lineage.json, "Print JSON");
  command->callback([&lineage, &progress] { runLineage(lineage, std::cout, progress); });
}

void addVerdict(CLI::App& app, VerdictArguments& verdict, const taa::Progress& progress) {
  CLI::App* command = app.add_subcommand(
      "verdict",
      "Say what is wrong with one pixel of one frame, since when, and because of what; without a pixel where "
      "history was rightly kept or removed, let through or thrown away, what the error is made of, and the "
      "worst pixels of each");
  addShotOptions(*command, verdict.shot);
  command->add_option("--frame", verdict.frame, "Number of the frame, from 0; else the session's")
      ->check(CLI::Range(0, taa::kMaxShotFrames - 1));
  CLI::Option* pixel = command->add_option("--pixel", verdict.pixel, "X,Y; 0,0 is the top left");
  command->add_option("--worst", verdict.worst, "Without a pixel: worst pixels of each, 0 to 1000")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str()
      ->excludes(pixel);
  addReferenceSamples(*command, verdict.samples, "of the references that it is held against, 4 to 1024");
  command
      ->add_flag("--remedies", verdict.remedies,
                 "Also try what may mend it, and print the best with their costs")
      ->needs(pixel);
  command->add_flag("--json", verdict.json, "Print JSON");
  command->callback([&verdict, &progress] { runVerdict(verdict, std::cout, progress); });
}

void addDoctor(CLI::App& app, DoctorArguments& doctor, const taa::Progress& progress, bool& isUnhealthy) {
  CLI::App* command = app.add_subcommand("doctor", "Say what is wrong with jitter, depth and motion vectors "
                                                   "of an engine's frames, region by region, and what "
                                                   "to change; ends with 3 where something is");
  addShotOptions(*command, doctor.shot);
  command->add_option("--frames", doctor.frames, "How many frames are examined, from frame 0 on")
      ->check(CLI::Range(taa::doctor::kLeastDoctorFrames, taa::doctor::kMaxDoctorFrames))
      ->capture_default_str();
  command->add_option("--html", doctor.html,
                      "Also write all of it as one page of HTML, without scripts, to put into a bug tracker");
  command->add_option("--baseline", doctor.baseline,
                      "A JSON file of findings that are known: where there are no others, it ends with 0");
  command->add_option("--write-baseline", doctor.writtenBaseline,
                      "Also write all that is found as such a file, and end with 0");
  command->add_option("--mended", doctor.mended,
                      "Also look at the frames with what was found made right: what is found then, how far "
                      "both are from the reference, and in this folder pictures and settings of them, as a "
                      "preset to compare with");
  addForce(*command, doctor.force);
  command->add_flag("--json", doctor.json, "Print JSON");
  command->callback(
      [&doctor, &progress, &isUnhealthy] { isUnhealthy = !runDoctor(doctor, std::cout, progress); });
}

void addTrace(CLI::App& app, TraceArguments& trace, const taa::Progress& progress) {
  CLI::App* command = app.add_subcommand("trace", "Print intermediates at pixels over frames, as CSV");
  addShotOptions(*command, trace.shot);
  command->add_option("--pixel", trace.pixels, "X,Y; 0,0 is the top left; repeat it for more")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--frames", trace.frames, "A..B, both included, or one frame")->required();
  command
      ->add_option(
          "--emit", trace.emit,
          "Intermediates, with commas between (see list intermediates), or all of the resolve's; those "
          "of the reference are drawn where they are named")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  addReferenceSamples(*command, trace.referenceSamples, "of rows of the reference that are named, 4 to 1024");
  command->add_flag("--surface", trace.surface, "Follow the surfaces seen at the pixels in the first frame");
  auto* json = command->add_flag("--json", trace.json, "Print JSON");
  command->add_flag("--csv", trace.csv, "Print CSV, as without it")->excludes(json);
  command->callback([&trace, &progress] { runTrace(trace, std::cout, progress); });
}

void addProfile(CLI::App& app, ProfileArguments& profile, const taa::Progress& progress) {
  CLI::App* command = app.add_subcommand(
      "profile", "Print the time of each pass and of each stage of the resolve, and the memory in use");
  addShotOptions(*command, profile.shot);
  command->add_option("--frames", profile.frames, "A..B, both included, from 1")->capture_default_str();
  command->add_flag("--json", profile.json, "Print JSON");
  command->callback([&profile, &progress] { runProfile(profile, std::cout, progress); });
}

void addMetrics(CLI::App& app, MetricsArguments& metrics, const taa::Progress& progress) {
  CLI::App* command = app.add_subcommand(
      "metrics", "Print RMSE and PSNR of frames against a supersampled reference, and what the resolve did");
  addShotOptions(*command, metrics.shot);
  command->add_option("--frames", metrics.frames, "A..B, both included, or one frame")->required();
  addReferenceSamples(*command, metrics.referenceSamples, "of the reference, 4 to 1024; 0: draw none");
  command->add_flag(
      "--flicker", metrics.flicker,
      "Also measure how much each pixel changes over the last frames, followed along its motion: "
      "more than its reference does, which is drawn for those frames too, or with "
      "--reference-samples 0 in all");
  command->add_flag(
      "--parts", metrics.parts,
      "Also split the error into ghost, lag, blur, aliasing, rectification and what is older than "
      "those frames, and count where history was rightly removed, let through or thrown away");
  command
      ->add_option("--metrics", metrics.named,
                   "Measure these alone, with commas between; hdrFlip, which takes seconds a frame, is "
                   "measured only where it is named")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--flicker-frames", metrics.flickerFrames,
                   "Frames that flicker and parts are taken over, 2 to 64")
      ->check(CLI::Range(taa::kMinFlickerFrames, taa::kMaxFlickerFrames))
      ->capture_default_str();
  command->add_flag("--json", metrics.json, "Print JSON");
  command->add_flag("--csv", metrics.csv, "Print comma-separated values, a line for each frame and lane");
  command->callback([&metrics, &progress] { runMetrics(metrics, std::cout, progress); });
}

void addGlsl(CLI::App& app, GlslArguments& glsl) {
  CLI::App* command = app.add_subcommand(
      "glsl",
      "Write the resolve of some settings, and what is shown of it, as one GLSL file that needs nothing "
      "else; its head says how to use it");
  command->add_option("--preset", glsl.preset, "A preset (see list presets) or a .json file")
      ->capture_default_str();
  command->add_option("--set", glsl.assignments, "path=value (see list parameters); repeat it for more")
      ->allow_extra_args(false);
  command->add_option("--out", glsl.file, "The file; standard output when it is left out");
  addForce(*command, glsl.force);
  command->callback([&glsl] { runGlsl(glsl, std::cout); });
}

void addImport(CLI::App& app, ImportArguments& import, const taa::Progress& progress, bool& isContradicted) {
  CLI::App* command = app.add_subcommand("import", "Say what a folder of an engine's frames is, by names, "
                                                   "side files and pixels, and write it as a capture");
  command->add_option("FOLDER", import.folder, "Holds pictures (EXR, PNG, HDR, TIFF, DDS), or capture.json")
      ->required();
  command->add_option(
      "--like", import.like,
      "A starting point to begin with: unreal, unity, godot, bevy, three, babylon, fsr, xess, "
      "streamline, metalfx, blender or taa-inspector");
  command
      ->add_option("--set", import.assignments,
                   "key=value of a convention, which is then not questioned; repeat it for more")
      ->allow_extra_args(false);
  CLI::Option* out = command->add_option(
      "--out", import.out,
      "Folder of capture.json. Planes stay where they are when that is below it, and are linked or copied "
      "into it otherwise");
  command
      ->add_flag("--check", import.check,
                 "Write nothing, and end with 3 where pixels contradict a convention that is stated")
      ->excludes(out);
  addForce(*command, import.force);
  command->add_flag("--json", import.json, "Print JSON");
  command->callback([&import, &progress, &isContradicted] {
    isContradicted = runImport(import, std::cout, progress) && import.check;
  });
}

/// CLI11 only says that a command is missing when the word in its place is none.
void requireCommand(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  const auto isMeant = [argv](const CLI::App* command) { return command->get_name() == argv[1]; };
  if (!app.get_subcommands(isMeant).empty()) return;
  throw UsageError(
      "there is no command \"" + std::string(argv[1]) +
      "\"; there are list, render, probe, lineage, verdict, doctor, trace, profile, metrics, sweep, "
      "tune, glsl, import and lessons");
}

/// In the form of the program's own sentences, with the command whose help says more.
std::string refusalOf(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  const std::string command = commands.empty() ? std::string() : commands.front()->get_name() + " ";
  return std::string(error.what()) + "; taa-batch " + command + "--help says what there is";
}

int run(int argc, char** argv) {
  CLI::App app(
      "Renders frames through TAA, exports any intermediate and answers questions about pixels, without a "
      "window.",
      "taa-batch");
  app.set_version_flag("--version", TAA_VERSION);
  app.require_subcommand(1);
  ListArguments list;
  RenderArguments render;
  ProbeArguments probe;
  LineageArguments lineage;
  VerdictArguments verdict;
  DoctorArguments doctor;
  bool isUnhealthy = false;
  TraceArguments trace;
  ProfileArguments profile;
  MetricsArguments metrics;
  GlslArguments glsl;
  ImportArguments import;
  bool isContradicted = false;
  SweepArguments sweep;
  bool hasFailed = false;
  TuneArguments tune;
  LessonsArguments lessons;
  bool isMistaken = false;
  const ProgressLine line;
  const taa::Progress progress = [&line](std::string_view what, int done, int total) {
    return line.show(what, done, total);
  };
  addList(app, list);
  addRender(app, render, progress);
  addProbe(app, probe, progress);
  addLineage(app, lineage, progress);
  addVerdict(app, verdict, progress);
  addDoctor(app, doctor, progress, isUnhealthy);
  addTrace(app, trace, progress);
  addProfile(app, profile, progress);
  addMetrics(app, metrics, progress);
  addGlsl(app, glsl);
  addImport(app, import, progress, isContradicted);
  addSweep(app, sweep, progress, hasFailed);
  addTune(app, tune, progress);
  addLessons(app, lessons, progress, isMistaken);
  refuseEmptyValues(app);
  requireCommand(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error); // --help, --version
    throw UsageError(refusalOf(app, error));
  }
  if (!std::cout.flush()) throw taa::Error("cannot write the result to standard output");
  if (hasFailed) return kWorldsFault;
  if (isUnhealthy) return kUnhealthy;
  if (isMistaken) return kMistaken;
  return isContradicted ? kContradicted : 0;
}

} // namespace

int main(int argc, char** argv) {
  for (const int each : {SIGINT, SIGTERM}) std::signal(each, [](int number) { interrupted = number; });
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    tellFailure(error.what());
    return kUsage;
  } catch (const taa::Cancelled&) {
    tellFailure("interrupted; the files written so far are whole");
    return kSignalled + (interrupted != 0 ? interrupted : SIGINT);
  } catch (const std::exception& error) {
    tellFailure(taa::shownReason(error));
    return kWorldsFault;
  }
}
