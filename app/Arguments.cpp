#include "app/Arguments.h"

#include "app/panels/LowerArea.h"
#include "app/style/TextSize.h"
#include "app/views/ViewportMath.h"
#include "app/window/Dialogs.h"

#include "core/base/Error.h"
#include "core/base/ShownText.h"
#include "core/cli/Options.h"
#include "core/io/CameraTrackJson.h"
#include "core/lessons/Lesson.h"
#include "core/lessons/LessonText.h"
#include "core/replay/Checkpoints.h"
#include "core/scene/SceneCost.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Presets.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace taa::app {

namespace {

/// "1280x720" or "412,207".
glm::ivec2 parseNumbers(const std::string& option, const std::string& text, char separator, int least) {
  constexpr int kMost = 32768; // no driver draws a wider picture
  glm::ivec2 pair{0};
  const char* const end = text.data() + text.size();
  const auto [middle, firstError] = std::from_chars(text.data(), end, pair.x);
  const bool hasSecond = firstError == std::errc() && middle != end && *middle == separator;
  const auto [rest, secondError] = std::from_chars(hasSecond ? middle + 1 : end, end, pair.y);
  const auto isIn = [&](int number) { return number >= least && number <= kMost; };
  if (secondError != std::errc() || rest != end || !isIn(pair.x) || !isIn(pair.y))
    throw CLI::ValidationError(
        option, "wants two whole numbers from " + std::to_string(least) + " to " + std::to_string(kMost) +
                    " like " + (separator == 'x' ? "1280x720" : "412,207") + ", not \"" + text + "\"");
  return pair;
}

/// In the order of Overlay; the grid is on anyway.
const std::vector<std::string>& overlayNames() {
  static const std::vector<std::string> names = {"clipping", "rejection", "outlines", "arrows"};
  return names;
}

/// Ids of windowFigures().
const std::vector<std::string>& figureNames() {
  static const std::vector<std::string> names = {"view-a",      "view-b",  "view-c",  "view-d",
                                                 "color-space", "verdict", "plots",   "jitter",
                                                 "weights",     "lineage", "profiler"};
  return names;
}

struct Texts {
  std::string windowSize, size, pixel, theme, cameraPose, cameraPath;
  std::vector<std::string> views, comparisons, overlays;
  std::string showing, lesson;
  int textPercent = 0;
  int frame = -1, checkpoints = -1;
  int sceneMillions = kDefaultSceneMillions, sceneMiB = kDefaultSceneMiB;
  double zoom = 0.0;
  bool fresh = false;
};

/// Whether only options were given that leave open what is shown.
bool leavesOpenWhatToShow(const CLI::App& app) {
  return std::ranges::all_of(app.get_options(), [](const CLI::Option* option) {
    const std::string name = option->get_name();
    return option->count() == 0 || name == "--theme" || name == "--shaders" || name == "--timing" ||
           name == "--text-size" || name.starts_with("--scene-");
  });
}

void addOptions(CLI::App& app, Arguments& arguments, Texts& texts) {
  app.add_option(
      "SOURCE", arguments.source,
      "A glTF file (.gltf, .glb), builtin:NAME, the folder or the .json of a captured sequence, "
      "or a session (.taa.json); without one, and without options that say what to show, what was open when "
      "the program was closed, or builtin:fan");
  app.add_flag("--fresh", texts.fresh, "Do not go on from what was open when the program was closed");
  app.add_option("--screenshot", arguments.screenshot,
                 "Write a picture of the whole window to FILE and end; needs no display")
      ->type_name("FILE");
  app.add_flag("--force", arguments.force, "Let that picture replace a file that is there");
  app.add_option("--window-size", texts.windowSize, "Size of that window, 1600x900 without it")
      ->type_name("WxH");
  app.add_option("--frame", texts.frame, "Go to frame N and pause")
      ->type_name("N")
      ->check(CLI::Range(0, kMaxShotFrames - 1));
  app.add_option("--pixel", texts.pixel, "Probe this pixel")->type_name("X,Y");
  app.add_option("--zoom", texts.zoom, "Screen pixels for each pixel, around the probe")
      ->type_name("Z")
      ->check(CLI::Range(kMinZoom, kGreatestZoom));
  app.add_option("--view", texts.views,
                 "Show this intermediate; given again, in the next of up to four views")
      ->type_name("ID")
      ->allow_extra_args(false); // else it would take the source, too
  app.add_option("--compare", texts.comparisons,
                 "Compare view A with " + std::string(kComparisonHelp) +
                     "; given again, the next view; \"nothing\" leaves one out")
      ->type_name("WHAT")
      ->allow_extra_args(false);
  app.add_option("--compare-as", texts.showing, "How both are shown: wipe, first, other or difference")
      ->type_name("HOW");
  app.add_option("--overlay", texts.overlays,
                 "Lay this over the pictures: clipping, rejection, outlines, arrows")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->check(CLI::IsMember(overlayNames()));
  app.add_option("--size", texts.size, "Render size")->type_name("WxH");
  app.add_option("--checkpoints", texts.checkpoints,
                 "Memory for the histories that are kept to go back in time; 1024 without it")
      ->type_name("MiB")
      ->check(CLI::Range(0, kMaxCheckpointMiB));
  app.add_option("--scene-triangles", texts.sceneMillions,
                 "Triangles that a scene may draw, its instances counted, millions; one with more is not "
                 "opened; " +
                     std::to_string(kDefaultSceneMillions) + " without it")
      ->type_name("MILLIONS")
      ->check(CLI::Range(1, kMaxSceneMillions));
  app.add_option("--scene-memory", texts.sceneMiB,
                 "Memory for the buffers and textures of a scene; " + std::to_string(kDefaultSceneMiB) +
                     " without it")
      ->type_name("MiB")
      ->check(CLI::Range(1, kMaxSceneMiB));
  app.add_option("--preset", arguments.preset, "Settings to start with: a preset or a .json file")
      ->type_name("NAME");
  app.add_option("--camera", arguments.camera, "Camera or camera path to start with")->type_name("NAME");
  app.add_option("--theme", texts.theme, "Look of the window: dark, light or system")
      ->type_name("NAME")
      ->check(CLI::IsMember({"dark", "light", "system"}));
  std::vector<std::string> pages;
  for (int page = 0; page < kLowerPageCount; ++page)
    pages.push_back(lowerPageId(static_cast<LowerPage>(page)).toStdString());
  for (const char* page : {"colorspace", "whatif", "sensitivity", "scene", "learn"}) pages.emplace_back(page);
  app.add_option(
         "--panel", arguments.panel,
         "Show this page above the timeline, or of the probe, too, or the scene's tree in place of the "
         "pipeline")
      ->type_name("NAME")
      ->check(CLI::IsMember(pages));
  app.add_option("--dialog", arguments.dialog, "Open this in the picture of --screenshot, too")
      ->type_name("NAME")
      ->check(CLI::IsMember(dialogNames()));
  app.add_option(
         "--figure", arguments.figure,
         "Write this figure of the window with its caption instead of the window, as PNG or, where the file "
         "of "
         "--screenshot ends so, SVG")
      ->type_name("NAME")
      ->check(CLI::IsMember(figureNames()));
  app.add_option("--lesson", texts.lesson, "Open this step of a lesson, the first without a number")
      ->type_name("ID[:STEP]");
  app.add_option("--text-size", texts.textPercent,
                 "Size of the window's text, percent; as it was left without it")
      ->type_name("PERCENT")
      ->check(CLI::Range(kMinTextPercent, kMaxTextPercent));
  app.add_option("--shaders", arguments.shaders,
                 "Read the shaders from this folder, a copy of shaders/, and again when one is saved")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory);
  app.add_flag("--timing", arguments.timing,
               "Say on stderr how long after the start the first picture was there");
}

void addSceneOptions(CLI::App& app, Arguments& arguments, Texts& texts) {
  CLI::Option* pose =
      app.add_option("--camera-pose", texts.cameraPose,
                     "Look from x,y,z,yaw,pitch, or with the field of view after them; degrees")
          ->type_name("POSE");
  app.add_option("--camera-path", texts.cameraPath, "Look through a recorded path")
      ->type_name("FILE")
      ->excludes(pose);
  app.add_option("--animation", arguments.choice.animation,
                 "Of a file with several: play this one, by its name, or all; the first without it")
      ->type_name("NAME");
  app.add_option("--length", arguments.choice.frames,
                 "How many frames the shot has; as many as the scene's own without it")
      ->type_name("N")
      ->check(CLI::Range(1, kMaxShotFrames));
  app.add_option("--hide", arguments.filter.hidden,
                 "Do not draw the objects of this name and what is below them; repeat it for more")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app.add_option("--isolate", arguments.filter.isolated,
                 "Draw only the objects of this name and what is below them; repeat it for more")
      ->type_name("NAME")
      ->allow_extra_args(false);
}

/// "first-ghost:2". Throws Error where there is no such lesson or step.
void readLesson(const std::string& text, Arguments& arguments) {
  const std::size_t colon = text.find(':');
  arguments.lesson = text.substr(0, colon);
  const std::vector<Lesson>& lessons = builtinLessons();
  const auto lesson = std::ranges::find(lessons, arguments.lesson, &Lesson::id);
  if (lesson == lessons.end())
    throw Error("--lesson: there is no lesson \"" + shownText(arguments.lesson) +
                "\"; taa-batch lessons lists them");
  const int steps = static_cast<int>(lesson->steps.size());
  if (colon != text.npos) arguments.lessonStep = wholeNumberFrom(text.substr(colon + 1), 1, steps);
  if (!arguments.frame && !arguments.screenshot.empty())
    arguments.frame = lesson->steps[static_cast<std::size_t>(arguments.lessonStep) - 1].state.shot.frame;
}

/// What is the call's own fault is said before a window is made.
void checkNames(const Arguments& arguments) {
  if (!arguments.preset.empty() && !arguments.preset.ends_with(".json")) preset(arguments.preset);
  if (isBuiltinScene(arguments.source)) requireBuiltinScene(arguments.source);
}

void readTexts(const Texts& texts, Arguments& arguments) {
  checkNames(arguments);
  if (!texts.windowSize.empty())
    arguments.windowSize = parseNumbers("--window-size", texts.windowSize, 'x', 100);
  if (!texts.size.empty()) arguments.size = parseNumbers("--size", texts.size, 'x', 4);
  if (!texts.pixel.empty()) arguments.pixel = parseNumbers("--pixel", texts.pixel, ',', 0);
  if (texts.frame >= 0) arguments.frame = texts.frame;
  if (texts.checkpoints >= 0) arguments.checkpoints = texts.checkpoints;
  if (!texts.lesson.empty()) readLesson(texts.lesson, arguments);
  if (texts.textPercent > 0) arguments.textPercent = texts.textPercent;
  arguments.sceneBudget = sceneBudget(texts.sceneMillions, texts.sceneMiB);
  if (!texts.cameraPath.empty())
    arguments.track = readCameraTrack(texts.cameraPath);
  else if (!texts.cameraPose.empty())
    arguments.track = CameraTrack{kFreeCamera, 0, {parseCameraPose(texts.cameraPose)}};
  if (texts.zoom > 0) arguments.zoom = texts.zoom;
  ThemeChoice theme{};
  if (!texts.theme.empty() && parseTheme(QString::fromStdString(texts.theme), theme)) arguments.theme = theme;
  if (texts.views.size() > 4 || texts.comparisons.size() > 4)
    throw taa::Error("--view, --compare: there are four views, A to D");
  for (const std::string& name : texts.views) arguments.views.push_back(intermediateNamed(name));
  for (const std::string& text : texts.comparisons) arguments.comparisons.push_back(parseComparison(text));
  if (!texts.showing.empty()) arguments.showing = showingNamed(texts.showing);
  for (const std::string& name : texts.overlays)
    for (std::size_t index = 0; index < overlayNames().size(); ++index)
      if (overlayNames()[index] == name) arguments.overlays.push_back(static_cast<Overlay>(index));
}

EarlyEnd refusal(const std::string& sentence) {
  return {2, "taa-inspector: " + shownLine(sentence) + "\n"};
}

} // namespace

std::optional<EarlyEnd> parseArguments(int argc, const char* const* argv, Arguments& arguments) {
  CLI::App app("Steps temporal anti-aliasing frame by frame and shows everything it computes.",
               "taa-inspector");
  app.set_version_flag("--version", TAA_VERSION);
  Texts texts;
  addOptions(app, arguments, texts);
  addSceneOptions(app, arguments, texts);
  cli::refuseEmptyValues(app);
  try {
    app.parse(argc, argv);
    readTexts(texts, arguments);
    arguments.reopens = !texts.fresh && leavesOpenWhatToShow(app);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0)
      return refusal(std::string(error.what()) + "; taa-inspector --help says what there is");
    std::ostringstream out;
    app.exit(error, out, out); // --help, --version
    return EarlyEnd{0, out.str()};
  } catch (const Error& error) {
    return refusal(error.what());
  }
  return {};
}

} // namespace taa::app
