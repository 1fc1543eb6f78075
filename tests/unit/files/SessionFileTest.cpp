// Session files: what is written is read, and what is wrong is refused by name.
#include "core/io/SessionFile.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/picture/StyleText.h"
#include "core/report/CommandLine.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace taa;

namespace {

SessionFile sample() {
  SessionFile session;
  session.source = "builtin:fan";
  session.camera = "orbit";
  session.frame = 31;
  session.size = {640, 360};
  session.settings = {"fsr2", preset("fsr2").settings, preset("fsr2").settings};
  applyAssignment(session.settings.settings, "weight.minimum=0.0625");
  session.lanes = {{"my own", preset("minimal").settings, preset("sharp").settings}};
  session.motionModes = {{"rotor & hub", MotionMode::None}, {"a=b", MotionMode::CameraOnly}};
  session.checkpointsMiB = 256;
  session.window = R"({"shown":[3,4]})";
  return session;
}

std::string refusal(const std::string& text) {
  return test::errorOf([&] { sessionFromText(text, "a.taa.json"); });
}

/// The sample with a field changed; null: removed.
std::string changed(const std::string& key, const nlohmann::json& value) {
  nlohmann::json json = nlohmann::json::parse(sessionToText(sample()));
  if (value.is_null())
    json.erase(key);
  else
    json[key] = value;
  return json.dump();
}

/// A lane of it that is right but for one field.
nlohmann::json lane(const std::string& key = "preset", const nlohmann::json& value = "sharp") {
  nlohmann::json json{{"preset", "sharp"}, {"settings", nlohmann::json::object()}};
  json[key] = value;
  return json;
}

} // namespace

TEST(SessionFile, ReadsTheNamesOfTheVersionBeforeWithANote) {
  const nlohmann::json weight{{"most", 0.5}, {"least", 0.25}};
  const nlohmann::json rectify{{"mostSteps", 7}, {"leastStrength", 0.75}};
  const SessionFile session =
      sessionFromText(changed("settings", {{"weight", weight}, {"rectify", rectify}}), "a.taa.json");
  EXPECT_EQ(session.settings.settings.weight.sourceMax, 0.5f);
  EXPECT_EQ(session.settings.settings.weight.sourceMin, 0.25f);
  EXPECT_EQ(session.settings.settings.rectify.maxSteps, 7.0f);
  EXPECT_EQ(session.settings.settings.rectify.minStrength, 0.75f);
  EXPECT_EQ(session.notes.size(), 4u);
  EXPECT_EQ(session.notes.front(), "rectify.leastStrength is called rectify.minStrength now");
}

TEST(SessionFile, SaysAnOldNameOnceWhereverItStands) {
  const nlohmann::json old{{"weight", {{"most", 0.5}}}};
  nlohmann::json json = nlohmann::json::parse(sessionToText(sample()));
  json["settings"] = json["presetSettings"] = json["lanes"][0]["settings"] = old;
  const SessionFile session = sessionFromText(json.dump(), "a.taa.json");
  EXPECT_EQ(session.settings.presetSettings.weight.sourceMax, 0.5f);
  EXPECT_EQ(session.lanes.at(0).settings.weight.sourceMax, 0.5f);
  EXPECT_EQ(session.notes, std::vector<std::string>{"weight.most is called weight.sourceMax now"});
}

TEST(SessionFile, ReadsTheWindowOfTheVersionBeforeWithANote) {
  const nlohmann::json old{{"pins", {{{"x", 3}, {"y", 4}}}},
                           {"activePin", 0},
                           {"timeline", {{"figure", "meanAlpha"}, {"speed", 2}}},
                           {"probe", {{"pins", "of another part"}}}};
  const SessionFile session = sessionFromText(changed("window", old), "a.taa.json");
  const nlohmann::json now{{"probes", {{{"x", 3}, {"y", 4}}}},
                           {"activeProbe", 0},
                           {"timeline", {{"metric", "meanAlpha"}, {"speed", 2}}},
                           {"probe", {{"pins", "of another part"}}}};
  EXPECT_EQ(nlohmann::json::parse(session.window), now);
  const std::vector<std::string> notes{"pins is called probes now", "activePin is called activeProbe now",
                                       "timeline.figure is called timeline.metric now"};
  EXPECT_EQ(session.notes, notes);
}

TEST(SessionFile, BelievesTheNewNameWhereBothAreGiven) {
  const nlohmann::json both{{"pins", 1}, {"probes", 2}, {"timeline", 3}};
  const SessionFile session = sessionFromText(changed("window", both), "a.taa.json");
  EXPECT_EQ(nlohmann::json::parse(session.window), (nlohmann::json{{"probes", 2}, {"timeline", 3}}));
}

TEST(SessionFile, ReadsWhatItWrote) {
  const SessionFile want = sample(), is = sessionFromText(sessionToText(want), "it");
  EXPECT_EQ(is.source, want.source);
  EXPECT_EQ(is.camera, want.camera);
  EXPECT_EQ(is.frame, want.frame);
  EXPECT_EQ(is.size, want.size);
  EXPECT_EQ(is.settings.preset, "fsr2");
  EXPECT_EQ(is.settings.settings, want.settings.settings);
  EXPECT_EQ(is.settings.presetSettings, want.settings.presetSettings);
  ASSERT_EQ(is.lanes.size(), 1u);
  EXPECT_EQ(is.lanes[0].preset, "my own");
  EXPECT_EQ(is.lanes[0].settings, want.lanes[0].settings);
  EXPECT_EQ(is.lanes[0].presetSettings, want.lanes[0].presetSettings);
  ASSERT_EQ(is.motionModes.size(), 2u);
  for (const MotionOverride& mode : want.motionModes)
    EXPECT_NE(std::find(is.motionModes.begin(), is.motionModes.end(), mode), is.motionModes.end())
        << mode.node;
  EXPECT_EQ(is.checkpointsMiB, 256);
  EXPECT_EQ(is.window, want.window);
  EXPECT_EQ(sessionToText(is), sessionToText(want));
}

TEST(SessionFile, KeepsAFlownCameraAndWhatIsHidden) {
  SessionFile want = sample();
  want.track = CameraTrack{"Recorded 1", 2, {{{1.0, 2.0, 3.0}}, {{0.1, 0.25, 1e-9}}}};
  want.filter = {{"floor", "#3"}, {"rotor & hub"}};
  const SessionFile is = sessionFromText(sessionToText(want), "it");
  EXPECT_EQ(is.track, want.track);
  EXPECT_EQ(is.filter, want.filter);
  EXPECT_FALSE(sessionFromText(sessionToText(sample()), "it").track);
}

TEST(SessionFile, KeepsClassesAndRestarts) {
  SessionFile want = sample();
  want.objectClasses = {{"rotor & hub", ObjectClass::Character}, {"floor", ObjectClass::Still}};
  want.restarts = {12, 31};
  const SessionFile is = sessionFromText(sessionToText(want), "it");
  EXPECT_EQ(is.restarts, want.restarts);
  ASSERT_EQ(is.objectClasses.size(), 2u);
  for (const ClassOverride& given : want.objectClasses)
    EXPECT_EQ(std::ranges::count(is.objectClasses, given), 1) << given.object;
  EXPECT_TRUE(sessionFromText(sessionToText(sample()), "it").restarts.empty());
  const std::string line = renderCommand(want, {});
  EXPECT_NE(
      line.find(" --class 'rotor & hub=character' --class floor=still --restart 12 --restart 31 --frames 31"),
      std::string::npos)
      << line;
}

TEST(SessionFile, KeepsTheAnimationAndTheLength) {
  SessionFile want = sample();
  want.choice = {"walk", 1000};
  const SessionFile is = sessionFromText(sessionToText(want), "it");
  EXPECT_EQ(is.choice, want.choice);
  EXPECT_EQ(sessionFromText(sessionToText(sample()), "it").choice, ShotChoice{});
  EXPECT_NE(renderCommand(want, {}).find(" --animation walk --length 1000 "), std::string::npos);
}

TEST(SessionFile, RefusesByName) {
  const std::pair<std::string, std::string> cases[] = {
      {changed("frames", 1), "there is no key \"frames\"; near it is \"frame\""},
      {changed("format", 2), "its format is 2, this program reads 1"},
      {changed("source", nullptr), "the key \"source\" is missing"},
      {changed("source", 7), "\"source\" is not text"},
      {changed("source", ""), "\"source\" is empty"},
      {changed("source", std::string(5000, 'x')), "\"source\" is longer than 4096 bytes"},
      {changed("animation", 7), "\"animation\" is not text"},
      {changed("length", 100001), "\"length\" wants a whole number from 0 to 100000"},
      {changed("frame", -1), "\"frame\" wants a whole number from 0 to 1000000"},
      {changed("frame", 1.5), "\"frame\" wants a whole number from 0 to 1000000"},
      {changed("frame", 1e300), "\"frame\" wants a whole number from 0 to 1000000"},
      {changed("size", {1, 2, 3}), "\"size\" wants [width, height]"},
      {changed("size", {640, 99999}), "\"size[1]\" wants a whole number from 4 to 32768"},
      {changed("settings", 3), "\"settings\": cannot read settings: expected an object of groups"},
      {changed("settings", {{"weights", nlohmann::json::object()}}),
       "\"settings\": there is no parameter \"weights\"; near it are weight.mask, weight.source or "
       "weight.alpha"},
      {changed("presetSettings", {{"weight", {{"minimum", 7}}}}),
       "\"presetSettings\": cannot set weight.minimum to \"7\": give a number from 0 to 1"},
      {changed("lanes", {1}), "\"lanes[0]\" is not an object"},
      {changed("lanes", {1, 2, 3, 4, 5}), "\"lanes\" has 5 entries, more than the 4 allowed"},
      {changed("lanes", {lane(), lane("more", 1)}),
       "there is no key \"lanes[1].more\"; near it is \"preset\""},
      {changed("lanes", nlohmann::json::array({lane("preset", 3)})), "\"lanes[0].preset\" is not text"},
      {changed("lanes", nlohmann::json::array({lane("settings", 3)})),
       "\"lanes[0].settings\": cannot read settings: expected an object of groups"},
      {changed("motionModes", 3), "\"motionModes\" is not an object"},
      {changed("motionModes", {{"floor", 3}}), "\"motionModes.floor\" is not text"},
      {changed("classes", {{"a\nb", 3}}), "\"classes.a?b\" is not text"},
      {changed("restarts", 7), "\"restarts\" is not a list"},
      {changed("restarts", {1, -1}), "\"restarts[1]\" wants a whole number from 0 to 1000000"},
      {changed("hidden", "floor"), "\"hidden\" is not a list"},
      {changed("isolated", {"a", 7}), "\"isolated[1]\" is not text"},
      {changed("track", {{"name", "x"}, {"firstFrame", 0}}), "the key \"track.poses\" is missing"},
      {changed("track", {{"name", "x"}, {"firstFrame", 0}, {"poses", {{1, 2, 3, 4, 5}, {1, 2, 3, 4, "x"}}}}),
       "\"track.poses[1][4]\" is not a number"},
      {changed("checkpointsMiB", -5), "\"checkpointsMiB\" wants a whole number from 0 to 1048576"},
      {changed("window", 3), "\"window\" is not an object"},
      {"not JSON", "it is not JSON from line 1, column 2 on"},
      {"{\"format\": 1,\n", "it ends in line 2, column 1, before it is whole"},
      {"[]", "what the file holds is not an object"},
      {std::string(100000, '['), "it is nested deeper than 32 levels"},
  };
  for (const auto& [text, reason] : cases)
    EXPECT_EQ(refusal(text), "cannot open the session a.taa.json: " + reason);
  for (const auto& [key, value, word] :
       {std::tuple("motionModes", "sideways", "sideways"), // tables say the rest
        std::tuple("classes", "sky", "floor=sky")}) {
    const std::string said = refusal(changed(key, {{"floor", value}}));
    EXPECT_NE(said.find(word), std::string::npos) << said;
  }
}

TEST(SessionFile, SaysThatAPresetIsNotThere) {
  nlohmann::json json = nlohmann::json::parse(sessionToText(sample()));
  json["preset"] = "nope";
  json.erase("presetSettings");
  const SessionFile session = sessionFromText(json.dump(), "a.taa.json");
  EXPECT_EQ(session.settings.presetSettings, session.settings.settings);
  EXPECT_EQ(session.notes, std::vector<std::string>{
                               "there is no preset \"nope\"; the settings of the session are taken for it"});
}

TEST(SessionFile, AMissingParameterHasItsDefault) {
  const SessionFile session = sessionFromText(changed("settings", nlohmann::json::object()), "it");
  EXPECT_EQ(session.settings.settings, Settings{});
}

TEST(SessionFile, ASceneBesideItMovesWithIt) {
  const std::filesystem::path folder = test::temporaryFolder() / "moved";
  std::filesystem::create_directories(folder / "a/models");
  SessionFile session = sample();
  session.source = (folder / "a/models/ship.glb").string();
  writeSession(folder / "a/it.taa.json", session);
  EXPECT_NE(readFile(folder / "a/it.taa.json").find("\"models/ship.glb\""), std::string::npos);
  std::filesystem::remove_all(folder / "b");
  std::filesystem::rename(folder / "a", folder / "b");
  EXPECT_EQ(readSession(folder / "b/it.taa.json").source, (folder / "b/models/ship.glb").string());
  session.source = "/elsewhere/ship.glb";
  writeSession(folder / "b/it.taa.json", session);
  EXPECT_EQ(readSession(folder / "b/it.taa.json").source, "/elsewhere/ship.glb");
}

TEST(CommandLine, QuotesForAShell) {
  EXPECT_EQ(shellQuoted("builtin:fan"), "builtin:fan");
  EXPECT_EQ(shellQuoted("a b"), "'a b'");
  EXPECT_EQ(shellQuoted("it's $HOME"), "'it'\\''s $HOME'");
  EXPECT_EQ(shellQuoted(""), "''");
}

TEST(CommandLine, SaysWhatDiffersFromAPreset) {
  ViewStyle style = defaultStyle(intermediate(IntermediateId::alpha));
  style.high = 0.5f;
  EXPECT_EQ(renderCommand(sample(), {IntermediateId::alpha, style}),
            "taa-batch render builtin:fan --size 640x360 --camera orbit --preset fsr2 --set "
            "weight.minimum=0.0625 --motion-mode 'rotor & hub=none' --motion-mode a=b=cameraOnly --frames 31 "
            "--emit alpha --style high=0.5 --format png --out .");
}

TEST(CommandLine, SaysWhatIsComparedAndHow) {
  CommandView view{.comparison = {.kind = OtherKind::Preset, .preset = "sharp"}, .showing = Showing::Wipe};
  view.style = view.otherStyle = defaultStyle(intermediate(view.id));
  view.divider = 0.25;
  const auto end = [&] {
    const std::string line = renderCommand(sample(), view);
    return line.substr(line.find(" --emit"));
  };
  EXPECT_EQ(end(), " --emit resolved --compare preset:sharp --compare-as wipe --divider 0.25 --format png "
                   "--out .");
  view.showing = Showing::Difference;
  view.style = differenceStyle(intermediate(view.id));
  view.style.outlineObjects = true;
  EXPECT_EQ(end(), " --emit resolved --style outlines=on --compare preset:sharp --compare-as difference "
                   "--format png --out .");
  view.comparison = {.kind = OtherKind::Row, .id = IntermediateId::reference};
  view.showing = Showing::Other;
  view.style = view.otherStyle = defaultStyle(intermediate(view.id));
  view.otherStyle.exposure = 1.0f;
  view.referenceSamples = 256;
  EXPECT_EQ(end(), " --emit resolved --compare reference --compare-as other --other-style exposure=1 "
                   "--reference-samples 256 --format png --out .");
  view.showing = Showing::First;
  EXPECT_EQ(end(), " --emit resolved --format png --out .");
}

TEST(CommandLine, SaysWhereAFlownCameraRestsAndWhatIsHidden) {
  SessionFile session = sample();
  session.track = CameraTrack{"free", 0, {{{1.0f, 2.5f, -3.0f}, 90.0f, -10.0f, 60.0f}}};
  session.filter = {{"the floor"}, {"rotor"}};
  const std::string line = renderCommand(session, {});
  EXPECT_NE(line.find(" --camera-pose 1,2.5,-3,90,-10,60 --hide 'the floor' --isolate rotor "), line.npos)
      << line;
  EXPECT_EQ(line.find("--camera orbit"), line.npos);
  EXPECT_FALSE(needsCameraFile(session));
}

TEST(CommandLine, NamesTheFileOfAFlownPathAndTheSamplesOfAReference) {
  SessionFile session = sample();
  session.track = CameraTrack{"Recorded 1", 3, {CameraPose{}, CameraPose{.yaw = 20.0f}}};
  ASSERT_TRUE(needsCameraFile(session));
  CommandView view{IntermediateId::referenceError,
                   defaultStyle(intermediate(IntermediateId::referenceError))};
  view.referenceSamples = 16;
  const std::string line = renderCommand(session, view, "/tmp/a b/path.json");
  EXPECT_NE(line.find(" --camera-path '/tmp/a b/path.json' "), line.npos) << line;
  EXPECT_NE(line.find(" --emit referenceError --reference-samples 16"), line.npos) << line;
  EXPECT_EQ(renderCommand(session, {}).find("--reference-samples"), line.npos);
}

TEST(StyleText, ReadsWhatItWrote) {
  const ViewStyle base;
  ViewStyle style;
  style.low = -0.1f;
  style.exposure = 1.5f;
  style.green = false;
  style.map = ColorMap::Cyclic;
  style.markInvalid = false;
  ViewStyle read = base;
  for (const std::string& assignment : styleDifferences(style, base)) applyStyle(read, assignment);
  EXPECT_EQ(read, style);
  EXPECT_TRUE(styleDifferences(base, base).empty());
}

TEST(StyleText, SaysWhatItExpects) {
  ViewStyle style;
  for (const char* wrong : {"low=x", "low=nan", "channels=rgx", "map=pink", "marks=1", "gamma=2", "low", ""})
    EXPECT_THROW(applyStyle(style, wrong), Error) << wrong;
  EXPECT_EQ(style, ViewStyle{});
}
