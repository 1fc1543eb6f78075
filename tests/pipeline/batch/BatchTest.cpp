// taa-batch as users and scripts meet it: the real program, its files, its words and its exit codes.
#include "tests/support/Batch.h"
#include "core/base/Files.h"
#include "core/io/FrameFile.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/ChannelNames.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <regex>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
using nlohmann::json;
using taa::test::batch;
using taa::test::expectFailure;
using taa::test::expectUsageError;
using taa::test::joined;
using taa::test::ProcessResult;

namespace {

/// render builtin:fan, small, into a folder.
ProcessResult render(const fs::path& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"render", "builtin:fan", "--size", "64x36", "--out", folder.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return batch(arguments);
}

/// A folder of the test's own that is not there yet.
fs::path freshFolder() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = taa::test::temporaryFolder() / test->name();
  fs::remove_all(folder);
  return folder;
}

std::vector<std::string> fileNames(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

float floatOf(const json& value) {
  if (value.is_number()) return value.get<float>();
  if (value == "nan") return std::numeric_limits<float>::quiet_NaN();
  return (value == "inf" ? 1.0f : -1.0f) * std::numeric_limits<float>::infinity();
}

} // namespace

TEST(BatchList, PrintsEveryRowOfEveryTableAsJson) {
  const std::vector<std::pair<std::string, std::size_t>> tables = {{"intermediates", taa::kIntermediateCount},
                                                                   {"parameters", taa::parameters().size()},
                                                                   {"presets", taa::builtinPresets().size()},
                                                                   {"scenes", taa::builtinScenes().size()}};
  for (const auto& [what, count] : tables) {
    const ProcessResult result = batch({"list", what, "--json"});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(json::parse(result.out).size(), count) << what;
  }
}

TEST(BatchList, GivesIntermediatesInTheOrderOfTheTable) {
  const json list = json::parse(batch({"list", "intermediates", "--json"}).out);
  for (std::size_t index = 0; index < taa::kIntermediateCount; ++index) {
    const taa::Intermediate& row = taa::kIntermediates[index];
    EXPECT_EQ(list[index]["id"], row.name);
    EXPECT_EQ(list[index]["unit"], row.unit);
    EXPECT_EQ(list[index]["channels"].size(), static_cast<std::size_t>(row.channels));
    EXPECT_EQ(list[index]["description"], row.description);
  }
}

TEST(BatchList, GivesParametersThatSetAccepts) {
  taa::Settings settings;
  for (const json& row : json::parse(batch({"list", "parameters", "--json"}).out)) {
    const std::string path = row["path"], value = row["default"];
    EXPECT_NO_THROW(taa::applyAssignment(settings, path + "=" + value));
  }
  EXPECT_TRUE(settings == taa::Settings{});
}

TEST(BatchList, PrintsOneLineForEachRowToPeople) {
  const ProcessResult result = batch({"list", "intermediates"});
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(result.out, '\n')), taa::kIntermediateCount);
  EXPECT_TRUE(result.out.starts_with("color ")) << result.out;
}

/// Of whoever changes tables.
ProcessResult manual(const std::string& folder) {
  return taa::test::runProcess({taa::test::binary("taa_manual").string(), "pages", folder});
}

TEST(BatchManual, WritesThePagesThatTheTablesKnow) {
  const fs::path folder = taa::test::temporaryFolder() / "manual";
  fs::create_directories(folder);
  const ProcessResult result = manual(folder.string());
  EXPECT_EQ(result.exitCode, 0) << result.err;
  std::string files;
  for (const char* page : {"coverage", "settings", "intermediates", "presets", "scenes", "capturekeys",
                           "confusions", "faults"}) {
    const fs::path file = folder / (std::string(page) + ".md");
    files += file.string() + "\n";
    ASSERT_TRUE(fs::exists(file)) << file;
    EXPECT_TRUE(taa::readFile(file).starts_with("# ")) << file;
  }
  EXPECT_EQ(result.out, files);
  EXPECT_EQ(manual((folder / "absent").string()).exitCode, 1);
}

/// As the program's help lists them.
std::vector<std::string> commandsOf(std::string help) {
  help.erase(0, help.find("\nSubcommands:"));
  std::vector<std::string> names;
  const std::regex name(R"(\n  (\w+) )");
  for (std::sregex_iterator found(help.begin(), help.end(), name), end; found != end; ++found)
    names.push_back((*found)[1]);
  return names;
}

TEST(Batch, ExplainsEveryCommand) {
  const std::string manual = taa::readFile("resources/manual/batch.md");
  const ProcessResult all = batch({"--help"});
  EXPECT_EQ(all.exitCode, 0);
  EXPECT_EQ(all.err, "");
  EXPECT_NE(all.out.find("Usage: taa-batch"), std::string::npos) << all.out;
  const std::vector<std::string> commands = commandsOf(all.out);
  EXPECT_GE(commands.size(), 14u) << all.out;
  for (const std::string& command : commands) {
    const ProcessResult result = batch({command, "--help"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.out.find("Usage: taa-batch " + command), std::string::npos) << result.out;
    EXPECT_EQ(result.err, "");
    EXPECT_NE(manual.find("$B " + command + " "), std::string::npos) << command << " is not in the manual";
  }
  EXPECT_EQ(batch({"--version"}).out, TAA_VERSION "\n");
}

TEST(Batch, NamesWhatThereIsWhenTheCallerIsWrong) {
  expectUsageError({}, {"subcommand", "taa-batch --help"});
  expectUsageError({"probe", "builtin:fan"},
                   {"one of --pixel, --find, --region and --where", "taa-batch probe --help"});
  expectUsageError({"list", "scenes", "--nope\x1b[31m\ntaa-batch: well"}, {"--nope?[31m taa-batch: well"});
  expectUsageError({"paint"}, {"paint", "render"});
  expectUsageError({"list", "lights"}, {"intermediates", "presets"});
  const std::vector<std::string> call = {"render", "builtin:fan", "--frames", "0", "--out", "/nowhere"};
  expectUsageError(joined(call, {"--emit", "resolved,velocity"}), {"velocity", "motion"});
  expectUsageError(joined(call, {"--set", "rectify.methid=clamp"}), {"rectify.methid", "rectify.method"});
  expectUsageError(joined(call, {"--set", "rectify.method=squash"}), {"squash", "clamp"});
  expectUsageError(joined(call, {"--set", "rectify.method"}), {"rectify.method"});
  expectUsageError(joined(call, {"--preset", "splendid"}), {"splendid", "balanced"});
  expectUsageError(joined(call, {"--lane", "splendid"}), {"splendid", "balanced"});
  expectUsageError(joined(call, {"--lane", "balanced", "--preset", "balanced"}), {"--lane", "--preset"});
  expectUsageError(joined(call, {"--size", "720p"}), {"720p", "1280x720"});
  expectUsageError(joined(call, {"--format", "bmp"}), {"exr", "png"});
  expectUsageError(joined(call, {"--checkpoints", "-1"}), {"--checkpoints"});
  expectUsageError({"render", "builtin:fan", "--out", "/nowhere", "--frames", "7..3"}, {"7..3"});
  expectUsageError({"probe", "builtin:fan", "--frame", "0", "--pixel", "middle"}, {"middle", "412,207"});
  expectUsageError({"probe", "builtin:fan", "--frame", "-1", "--pixel", "0,0"}, {"--frame"});
}

TEST(Batch, RefusesWhatContradictsARegion) {
  const std::vector<std::string> call = {"probe", "builtin:fan", "--frame", "0"};
  expectUsageError(joined(call, {"--region", "1,2"}), {"1,2", "40,20,64x36"});
  expectUsageError(joined(call, {"--region", "1,2,3x4", "--pixel", "1,2"}), {"one of --pixel"});
  expectUsageError(joined(call, {"--region", "1,2,3x4", "--what-if"}), {"--what-if", "region"});
  expectUsageError(joined(call, {"--pixel", "1,2", "--emit", "alpha"}), {"--emit", "region"});
  expectUsageError(joined(call, {"--find", "ghosts"}), {"ghosts", "rejected"});
}

TEST(Batch, RefusesASixthLane) {
  std::vector<std::string> arguments = {"render", "builtin:fan", "--frames", "0", "--out", "/nowhere"};
  for (int lane = 0; lane < 6; ++lane) arguments.insert(arguments.end(), {"--lane", "balanced"});
  expectUsageError(arguments, {"6 times", "5 lanes"});
}

using BatchTest = taa::test::GlTest;

TEST_F(BatchTest, SaysWhatIsWrongWithTheWorld) {
  const fs::path folder = freshFolder();
  const std::vector<std::string> end = {"--size", "16x16", "--out", folder.string()};
  expectFailure(joined({"render", "/nowhere/a.glb", "--frames", "0"}, end), {"/nowhere/a.glb"});
  const std::vector<std::string> fan = joined({"render", "builtin:fan"}, end);
  expectFailure(joined(fan, {"--frames", "0", "--preset", "/nowhere/a.json"}), {"/nowhere/a.json"});
  EXPECT_FALSE(fs::exists(folder)) << "nothing is made before it is known that it can be filled";
}

TEST_F(BatchTest, SaysThatTheCallAsksForWhatIsNotThere) {
  const fs::path folder = freshFolder();
  const std::vector<std::string> out = {"--out", folder.string()};
  expectUsageError(joined({"render", "builtin:nothing", "--frames", "0"}, out), {"nothing", "fan", "fence"});
  const std::vector<std::string> fan = joined({"render", "builtin:fan", "--size", "16x16"}, out);
  expectUsageError(joined(fan, {"--frames", "0..99999"}), {"99999", "frames 0 to"});
  expectUsageError(joined(fan, {"--frames", "3", "--length", "3"}), {"no frame 3", "frames 0 to 2"});
  expectUsageError(joined(fan, {"--frames", "0", "--length", "0"}), {"--length", "1", "100000"});
  expectUsageError(joined(fan, {"--frames", "0", "--fps", "nan"}), {"--fps", "nan", "1000"});
  expectUsageError(joined(fan, {"--frames", "0", "--divider", "nan"}), {"--divider", "nan"});
  // Whatever command it is asked of.
  for (const auto& [flag, value, reason] : std::vector<std::tuple<std::string, std::string, std::string>>{
           {"--camera", "drone", "no camera \"drone\" in builtin:fan"},
           {"--animation", "walk", "builtin:fan has one animation"},
           {"--hide", "sail", "no object is called \"sail\""},
           {"--isolate", "sail", "no object is called \"sail\""},
           {"--motion-mode", "sail=none", "no object is called \"sail\""},
           {"--class", "sail=still", "no object is called \"sail\""},
           {"--restart", "99998", "frame 99998: the shot has frames 0 to"}}) {
    expectUsageError(joined(fan, {"--frames", "0", flag, value}), {flag, reason});
    expectUsageError({"doctor", "builtin:fan", "--size", "16x16", "--frames", "2", flag, value},
                     {flag, reason});
  }
  expectUsageError(joined(fan, {"--frames", "0", "--restart", "-1"}),
                   {"--restart", "Value -1 not in range", "99999"});
  for (const std::string flag : {"--camera-path", "--camera", "--session", "--preset"})
    expectUsageError(joined(fan, {"--frames", "0", flag, ""}), {flag, "its value is empty"});
  expectUsageError({"doctor", "builtin:fan", "--baseline", ""}, {"--baseline", "its value is empty"});
  expectUsageError({"lessons", ""}, {"its value is empty"});
  expectUsageError(joined({"render", "builtin:fan", "--size", "3x3", "--frames", "0"}, out),
                   {"--size", "3x3", "4 to 32768"});
  const std::string source = "builtin:fan";
  for (const std::string command : {"probe", "lineage", "verdict"})
    expectUsageError({command, source, "--size", "16x16", "--frame", "0", "--pixel", "16,0"},
                     {"16,0", "outside the picture"});
  EXPECT_FALSE(fs::exists(folder)) << "nothing is made before it is known that it can be filled";
}

TEST_F(BatchTest, SaysHowTheValuesOfARegionAreSpread) {
  const std::vector<std::string> shot = {"builtin:fan", "--size", "64x36", "--frame", "3", "--json"};
  const ProcessResult region =
      batch(joined(joined({"probe"}, shot), {"--region", "10,8,1x1", "--emit", "alpha,color,rejectReason"}));
  ASSERT_EQ(region.exitCode, 0) << region.err;
  const json rows = json::parse(region.out)["lanes"][0]["rows"];
  const json pixel = json::parse(batch(joined(joined({"probe"}, shot), {"--pixel", "10,8"})).out)["lanes"][0];
  EXPECT_EQ(rows.size(), 3u);
  const json& alpha = rows["alpha"]["channels"][0];
  for (const char* figure : {"min", "max"})
    EXPECT_EQ(alpha[figure], pixel["values"]["alpha"]["V"]) << "of one pixel";
  EXPECT_EQ(alpha["count"], 1);
  EXPECT_EQ(alpha["deviation"], 0.0);
  EXPECT_EQ(rows["color"]["channels"][2]["name"], "B");
  EXPECT_EQ(rows["color"]["channels"][2]["percentiles"]["50"], pixel["values"]["color"]["B"]);
  EXPECT_EQ(rows["rejectReason"]["categories"].size(), 1u);
}

TEST_F(BatchTest, SaysThatTheFolderCannotBeMade) {
  const fs::path file = taa::test::temporaryFolder() / "a file";
  taa::writeFile(file, "x");
  const ProcessResult result = render(file, {"--frames", "0"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.err.find(file.string()), std::string::npos) << result.err;
  EXPECT_EQ(taa::readFile(file), "x");
}

TEST_F(BatchTest, WritesAFileForEachFrameWithAPartForEachIntermediate) {
  const fs::path folder = freshFolder() / "made";
  const ProcessResult result = render(folder, {"--frames", "1..2", "--emit", "all", "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "") << "no progress where there is no terminal";
  EXPECT_EQ(fileNames(folder), (std::vector<std::string>{"frame.0001.exr", "frame.0002.exr"}));
  const json report = json::parse(result.out);
  EXPECT_EQ(report["frames"], json::array({1, 2}));
  EXPECT_EQ(report["size"], json::array({64, 36}));
  EXPECT_EQ(report["files"][1], (folder / "frame.0002.exr").string());
  std::vector<std::string> ids;
  for (const taa::Intermediate& row : taa::kResolveRows) ids.emplace_back(row.name);
  EXPECT_EQ(taa::partNames(folder / "frame.0002.exr"), ids);
  EXPECT_EQ(taa::readPartAttribute(folder / "frame.0002.exr", "color", "taa:frame"), "2");
}

TEST_F(BatchTest, PrintsTheFilesItWrote) {
  const fs::path folder = freshFolder();
  const ProcessResult result = render(folder, {"--frames", "0..1"});
  const std::string first = (folder / "frame.0000.exr").string(),
                    second = (folder / "frame.0001.exr").string();
  EXPECT_EQ(result.out, first + "\n" + second + "\n") << result.err;
  EXPECT_EQ(taa::partNames(first), std::vector<std::string>{"resolved"});
}

TEST_F(BatchTest, NamesPartsByLane) {
  const fs::path folder = freshFolder();
  const ProcessResult result = render(folder, {"--frames", "3", "--lane", "balanced", "--lane", "balanced",
                                               "--emit", "color,resolved", "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(taa::partNames(folder / "frame.0003.exr"),
            (std::vector<std::string>{"A.color", "A.resolved", "B.color", "B.resolved"}));
  EXPECT_EQ(json::parse(result.out)["lanes"].size(), 2u);
}

TEST_F(BatchTest, ReplacesNoFileUnlessItIsTold) {
  const fs::path folder = freshFolder();
  fs::create_directories(folder);
  const auto refused = [&](const std::vector<std::string>& more, const std::vector<std::string>& words) {
    const ProcessResult result = render(folder, more);
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(result.out, "");
    for (const std::string& word : words) EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
  };
  const std::vector<std::string> kept = {"frame.0002.exr", "frame.0003.exr", "frame.0001.alpha.png",
                                         "alpha.gif"};
  for (const std::string& name : kept) taa::writeFile(folder / name, "mine");
  const std::string first = (folder / "frame.0002.exr").string();
  refused({"--frames", "0..3"}, {"2 of 4", first, "--force"});
  refused({"--frames", "1", "--format", "png", "--emit", "resolved,alpha"},
          {"1 of 2", "frame.0001.alpha.png"});
  refused({"--frames", "0..1", "--format", "gif", "--emit", "alpha"}, {"alpha.gif is there", "--force"});
  for (const std::string& name : kept) EXPECT_EQ(taa::readFile(folder / name), "mine") << name;
  EXPECT_EQ(fileNames(folder).size(), kept.size()) << "nothing is rendered before it is known";
  ASSERT_EQ(render(folder, {"--frames", "0..2", "--force"}).exitCode, 0);
  EXPECT_EQ(taa::partNames(first), std::vector<std::string>{"resolved"});
}

TEST_F(BatchTest, WritesAPictureForEachIntermediate) {
  const fs::path folder = freshFolder();
  const ProcessResult result =
      render(folder, {"--frames", "0", "--format", "png", "--emit", "resolved,motion"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(fileNames(folder),
            (std::vector<std::string>{"frame.0000.motion.png", "frame.0000.resolved.png"}));
}

TEST_F(BatchTest, DrawsWhatIsComparedAsItIsAskedFor) {
  const fs::path folder = freshFolder();
  const auto drawn = [&](const std::vector<std::string>& more) {
    const ProcessResult result =
        render(folder, joined({"--frames", "4", "--format", "png", "--force"}, more));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(fileNames(folder), std::vector<std::string>{"frame.0004.resolved.png"});
    return taa::readFile(folder / "frame.0004.resolved.png");
  };
  const std::string first = drawn({}), sharp = drawn({"--preset", "sharp"});
  EXPECT_NE(first, sharp);
  const std::vector<std::string> preset = {"--compare", "preset:sharp", "--compare-as"};
  EXPECT_EQ(drawn(joined(preset, {"first"})), first);
  EXPECT_EQ(drawn(joined(preset, {"other"})), sharp);
  EXPECT_EQ(drawn(joined(preset, {"wipe", "--divider", "1"})), first);
  EXPECT_EQ(drawn(joined(preset, {"wipe", "--divider", "0"})), sharp);
  const std::string wipe = drawn({"--compare", "preset:sharp"});
  EXPECT_EQ(wipe, drawn(joined(preset, {"wipe", "--divider", "0.5"})));
  EXPECT_TRUE(wipe != first && wipe != sharp);
  EXPECT_NE(drawn(joined(preset, {"difference"})), wipe);
  EXPECT_NE(drawn({"--compare", "frame:-1", "--compare-as", "other"}), first);
  EXPECT_EQ(drawn({"--compare", "frame:4", "--compare-as", "other"}), first);
  EXPECT_NE(drawn({"--compare", "motion:-1", "--compare-as", "difference"}),
            drawn({"--compare", "frame:-1", "--compare-as", "difference"}));
  EXPECT_NE(drawn({"--compare", "reference", "--compare-as", "other", "--reference-samples", "4"}), first);
}

TEST(BatchMistakes, ComparingIsOfOnePictureAndWhatThereIs) {
  const auto expectWrong = [](const std::vector<std::string>& more, const std::vector<std::string>& words) {
    expectUsageError(joined({"render", "builtin:fan", "--frames", "0", "--out", "x"}, more), words);
  };
  expectWrong({"--format", "png", "--compare", "colour"}, {"--compare", "colour", "preset:NAME"});
  expectWrong({"--format", "png", "--compare", "preset:loud"}, {"loud", "balanced"});
  expectWrong({"--format", "png", "--compare", "color", "--compare-as", "sideways"}, {"sideways", "wipe"});
  expectWrong({"--compare", "color", "--compare-as", "wipe"}, {"wipe", "--format png"});
  expectWrong({"--compare", "alpha"}, {"resolved has 3 channels", "alpha 1"});
  expectWrong({"--format", "png", "--compare-as", "wipe"}, {"--compare"});
  expectWrong({"--format", "png", "--compare", "alpha", "--compare-as", "difference"},
              {"resolved has 3 channels", "alpha 1"});
  expectWrong({"--format", "png", "--compare", "color", "--lane", "sharp", "--lane", "stable"}, {"one lane"});
  expectWrong({"--format", "png", "--compare", "motion:-2"}, {"motion:-2", "motion:-1"});
  expectUsageError({"probe", "builtin:fan", "--frame", "0", "--pixel", "1,1", "--compare", "color"},
                   {"--compare", "preset"});
}

TEST_F(BatchTest, ProbesBothSidesOfWhatIsCompared) {
  const auto probed = [](const std::string& frame, const std::vector<std::string>& more) {
    const ProcessResult result = batch(joined({"probe", "builtin:fence", "--camera", "still", "--size",
                                               "64x36", "--pixel", "31,17", "--json", "--frame", frame},
                                              more));
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result.exitCode == 0 ? json::parse(result.out)["lanes"][0] : json();
  };
  const json before = probed("4", {}), sharp = probed("5", {"--preset", "sharp"});
  const json moved = probed("5", {"--compare", "motion:-1"})["compared"];
  EXPECT_EQ(moved["frame"], 4);
  EXPECT_EQ(moved["position"], (json{31.5, 17.5}));
  const json lane = probed("5", {"--compare", "preset:sharp"})["compared"];
  for (const char* row : {"color", "depthView", "motion", "resolved", "alpha"}) {
    EXPECT_EQ(moved["rows"][row]["other"], before["values"][row]) << row << ": nothing moves";
    EXPECT_EQ(lane["rows"][row]["other"], sharp["values"][row]) << row;
  }
  EXPECT_EQ(moved["rows"]["motion"]["difference"], (json{{"X", 0.0}, {"Y", 0.0}}));
  const json first = probed("0", {"--compare", "motion:-1"})["compared"]["rows"]["alpha"];
  EXPECT_TRUE(first["other"].is_null() && first["difference"].is_null());
  EXPECT_EQ(first["absence"], "no frame before");
}

TEST_F(BatchTest, ProbesWhatItExports) {
  const fs::path folder = freshFolder();
  const std::vector<std::string> choices = {"--set", "rectify.method=clamp", "--set", "space.color=rgb"};
  const taa::SpaceSettings space{taa::ColorSpace::Rgb};
  ASSERT_EQ(render(folder, joined({"--frames", "5", "--emit", "all"}, choices)).exitCode, 0);
  for (const char* place : {"0,0", "63,35", "31,17"}) {
    const ProcessResult result = batch(joined(
        {"probe", "builtin:fan", "--size", "64x36", "--frame", "5", "--pixel", place, "--json"}, choices));
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const json report = json::parse(result.out), &lane = report["lanes"][0];
    EXPECT_EQ(lane["settings"]["rectify"]["method"], "clamp");
    EXPECT_GE(lane["headline"].size(), 3u);
    EXPECT_TRUE(lane["stories"]["historyPosition"]["formula"].get<std::string>().starts_with("(")) << lane;
    for (const taa::Intermediate& row : taa::kResolveRows) {
      const std::string id(row.name);
      const std::vector<std::string> channels = taa::channelNames(row, space);
      EXPECT_FALSE(lane["stories"][id]["words"].get<std::string>().empty()) << id;
      const taa::Image image = taa::readPart(folder / "frame.0005.exr", id, channels);
      for (std::size_t channel = 0; channel < channels.size(); ++channel) {
        const float probed = floatOf(lane["values"][id][channels[channel]]);
        const float exported = image.at(report["pixel"][0], report["pixel"][1])[channel];
        EXPECT_EQ(std::bit_cast<std::uint32_t>(probed), std::bit_cast<std::uint32_t>(exported))
            << id << "." << channels[channel] << " at " << place << ": " << probed << ", " << exported;
      }
    }
  }
}

TEST_F(BatchTest, ShowsAPixelToPeople) {
  const ProcessResult result =
      batch({"probe", "builtin:fence", "--size", "64x36", "--frame", "2", "--pixel", "20,10"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  for (const taa::Intermediate& row : taa::kResolveRows)
    EXPECT_NE(result.out.find(std::string(row.label)), std::string::npos) << row.label;
  EXPECT_NE(result.out.find("\nFrames of samples now: N = "), std::string::npos) << "the headline";
  EXPECT_NE(result.out.find("      (20.5, 10.5) − ("), std::string::npos)
      << "the formula of the history position";
}

TEST(BatchMistakes, ReferencesHaveFourSamplesAtLeast) {
  expectUsageError({"metrics", "builtin:fan", "--frames", "0", "--reference-samples", "3"}, {"4 to 1024"});
  expectUsageError({"render", "builtin:fan", "--frames", "0", "--out", "x", "--emit", "reference",
                    "--reference-samples", "2000"},
                   {"2000", "4 to 1024"});
}

TEST_F(BatchTest, WritesTheReferenceWhereItIsEmitted) {
  const fs::path folder = freshFolder();
  const ProcessResult result = render(folder, {"--frames", "3", "--emit", "reference,output,referenceError",
                                               "--reference-samples", "4", "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["referenceSamples"], 4);
  const fs::path file = folder / "frame.0003.exr";
  EXPECT_EQ(taa::partNames(file), (std::vector<std::string>{"reference", "output", "referenceError"}));
  const taa::Image reference = taa::readPart(file, "reference", {"R", "G", "B"});
  const taa::Image output = taa::readPart(file, "output", {"R", "G", "B"});
  const taa::Image error = taa::readPart(file, "referenceError", {"V"});
  const auto luma = [](const float* c) { return (0.2126f * c[0] + 0.7152f * c[1]) + 0.0722f * c[2]; };
  for (int x = 0; x < 64; x += 7)
    EXPECT_EQ(error.at(x, 20)[0], luma(output.at(x, 20)) - luma(reference.at(x, 20))) << x;
}
