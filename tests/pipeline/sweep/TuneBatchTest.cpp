// taa-batch tune as users and scripts meet it.
#include "core/base/Files.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/sweep/tune/ShotTune.h"
#include "core/taa/GlslExport.h"
#include "tests/support/Batch.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using taa::test::ProcessResult;

class TuneBatchTest : public taa::test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    folder_ = taa::test::temporaryFolder() / "tune";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  fs::path preset() const { return folder_ / "better.json"; }
  ProcessResult tune(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {taa::test::binary("taa-batch").string(),
                                          "tune",
                                          "builtin:fan",
                                          "--size",
                                          "48x28",
                                          "--frames",
                                          "2..3",
                                          "--reference-samples",
                                          "4",
                                          "--flicker-frames",
                                          "2",
                                          "--out",
                                          preset().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return taa::test::runProcess(arguments);
  }
  void expectUsage(const std::vector<std::string>& more, const std::string& word) const {
    const ProcessResult result = tune(more);
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(preset()));
  }
  fs::path folder_;
};

const std::vector<std::string> kTwoRows{"--goal",   "rmse=1,flicker=0.5",
                                        "--vary",   "weight.minimum",
                                        "--vary",   "rectify.method",
                                        "--set",    "weight.minimum=0.9",
                                        "--budget", "30",
                                        "--json"};

} // namespace

TEST_F(TuneBatchTest, FindsBetterSettingsAndSaysTheWay) {
  const ProcessResult result = tune(kTwoRows);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const ordered_json json = ordered_json::parse(result.out);
  EXPECT_DOUBLE_EQ(json["startGoal"].get<double>(), 1.5);
  ASSERT_FALSE(json["steps"].empty()) << "a frame of nine tenths is as if there were no TAA";
  double goal = 1.5;
  taa::Settings settings = taa::preset("balanced").settings;
  applyAssignment(settings, "weight.minimum=0.9");
  for (const ordered_json& step : json["steps"]) {
    EXPECT_LT(step["goal"].get<double>(), goal);
    goal = step["goal"];
    applyAssignment(settings, step["change"].get<std::string>());
  }
  EXPECT_EQ(json["bestGoal"].get<double>(), goal);
  EXPECT_TRUE(taa::preset(preset().string()).settings == settings);
  double sum = 0.0;
  for (const ordered_json& term : json["goal"])
    sum += term["weight"].get<double>() * term["best"].get<double>() / term["start"].get<double>();
  EXPECT_NEAR(sum, goal, 1e-12);
}

TEST_F(TuneBatchTest, GoesTheSameWayTwice) {
  const ordered_json first = ordered_json::parse(tune(kTwoRows).out);
  fs::remove(preset());
  const ordered_json second = ordered_json::parse(tune(kTwoRows).out);
  EXPECT_EQ(first["steps"], second["steps"]);
  EXPECT_EQ(first["evaluations"], second["evaluations"]);
}

TEST_F(TuneBatchTest, WritesTheResolveAsGlslToo) {
  const fs::path glsl = folder_ / "better.frag";
  const ProcessResult result = tune(
      {"--goal", "rmse=1,cost=0.1", "--vary", "rectify.method", "--budget", "3", "--glsl", glsl.string()});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(taa::readFile(glsl), taa::exportedGlsl(taa::preset(preset().string()).settings, "better"));
  EXPECT_NE(result.out.find(preset().string() + "\n" + glsl.string() + "\n"), std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("cost"), std::string::npos);
}

// The window tunes by tuneShot(), on a thread of its own.
TEST_F(TuneBatchTest, PrintsTheFiguresOfTheWindow) {
  taa::ShotTuneRequest window;
  window.shot.source = "builtin:fan";
  window.shot.size = {48, 28};
  window.start = taa::preset("balanced").settings;
  window.tuning = {"rmse=1,flicker=0.5", {"weight.minimum", "rectify.method"}, {6, 7, {}, 4}, 5, 24};
  taa::TuneWay way;
  const auto keepLast = [&way](const taa::TuneWay& told) { way = told; };
  std::async(std::launch::async, [&] { taa::tuneShot(window, keepLast, {}); }).get();
  const ProcessResult result = taa::test::runProcess({taa::test::binary("taa-batch").string(),
                                                      "tune",
                                                      window.shot.source,
                                                      "--size",
                                                      "48x28",
                                                      "--frames",
                                                      "6..7",
                                                      "--reference-samples",
                                                      "4",
                                                      "--goal",
                                                      window.tuning.goal,
                                                      "--vary",
                                                      "weight.minimum",
                                                      "--vary",
                                                      "rectify.method",
                                                      "--seed",
                                                      "5",
                                                      "--budget",
                                                      "24",
                                                      "--json",
                                                      "--out",
                                                      preset().string()});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const ordered_json json = ordered_json::parse(result.out);
  EXPECT_EQ(json["startGoal"], way.result.startGoal);
  EXPECT_EQ(json["bestGoal"], way.result.goal);
  EXPECT_EQ(json["evaluations"], way.result.evaluations);
  EXPECT_EQ(json["complete"], way.result.isComplete);
  ASSERT_FALSE(way.result.steps.empty());
  ASSERT_EQ(json["steps"].size(), way.result.steps.size());
  for (std::size_t step = 0; step < way.result.steps.size(); ++step) {
    EXPECT_EQ(json["steps"][step]["change"], way.result.steps[step].change);
    EXPECT_EQ(json["steps"][step]["goal"], way.result.steps[step].goal);
  }
  EXPECT_TRUE(taa::preset(preset().string()).settings == way.result.settings);
}

TEST_F(TuneBatchTest, SaysWhatBecameWorse) {
  const std::vector<std::string> sharp{"--goal", "sharpness=1", "--vary", "current", "--budget", "12"};
  const ProcessResult kept = tune(sharp);
  ASSERT_EQ(kept.exitCode, 0) << kept.err;
  EXPECT_NE(kept.out.find("rmse"), std::string::npos) << "what the goal does not count is told\n" << kept.out;
  EXPECT_NE(kept.out.find("flicker"), std::string::npos) << kept.out;
  EXPECT_EQ(kept.out.find("worse"), std::string::npos) << kept.out;
  fs::remove(preset());
  const ordered_json traded = ordered_json::parse(tune(taa::test::joined(sharp, {"--trade", "--json"})).out);
  ASSERT_FALSE(traded["worse"].empty());
  for (const ordered_json& guarded : traded["guarded"]) {
    const double rise = guarded["best"].get<double>() / guarded["start"].get<double>() - 1.0;
    for (const ordered_json& worse : traded["worse"])
      if (worse["metric"] == guarded["metric"]) {
        EXPECT_NEAR(worse["rise"].get<double>(), rise, 1e-9);
      }
  }
}

TEST_F(TuneBatchTest, NeverEndsWorseThanItBegan) {
  const ordered_json json = ordered_json::parse(
      tune({"--goal", "flicker=1,rmse=1", "--vary", "history", "--budget", "12", "--json"}).out);
  EXPECT_LE(json["bestGoal"].get<double>(), json["startGoal"].get<double>());
  EXPECT_LE(json["evaluations"].get<int>(), 12);
}

TEST_F(TuneBatchTest, SaysWhatIsWrong) {
  expectUsage({"--goal", "rsme=1"}, "rsme");
  expectUsage({"--goal", "rmse=1", "--vary", "jitter.period"}, "jitter.period");
  expectUsage({"--goal", "rmse=1", "--lane", "balanced", "--lane", "minimal"}, "one lane");
  taa::writeFile(preset(), "{}");
  const ProcessResult there = tune({"--goal", "rmse=1", "--budget", "1"});
  EXPECT_EQ(there.exitCode, 1);
  EXPECT_NE(there.err.find("--force"), std::string::npos) << there.err;
  EXPECT_EQ(taa::readFile(preset()), "{}");
}

TEST_F(TuneBatchTest, SaysWhereAMetricIsNotKnown) {
  const ProcessResult result = taa::test::runProcess(
      {taa::test::binary("taa-batch").string(), "tune", "builtin:fan", "--size", "48x28", "--frames", "0",
       "--goal", "flicker=1", "--reference-samples", "4", "--out", preset().string()});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.err.find("flicker is not known"), std::string::npos) << result.err;
}
