// taa-batch profile and metrics: their numbers as JSON, CSV and text, and what they need.
#include "core/measure/Metrics.h"
#include "tests/support/Batch.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

using nlohmann::json;
using taa::test::batch;
using taa::test::expectUsageError;
using taa::test::joined;
using taa::test::ProcessResult;

class BatchProfile : public taa::test::GlTest {};

TEST_F(BatchProfile, PrintsPassesStagesAndMemory) {
  const ProcessResult result =
      batch({"profile", "builtin:fan", "--size", "64x36", "--frames", "1..3", "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json profile = json::parse(result.out);
  std::vector<std::string> names;
  for (const json& pass : profile["passes"]) {
    names.push_back(pass["name"]);
    EXPECT_EQ(pass["ms"].size(), 3u) << pass;
    EXPECT_GE(pass["medianMs"].get<double>(), 0.0) << pass;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"Shadows, as the sun sees them", "G-buffer", "Sky", "Resolve",
                                             "Between the passes"}));
  EXPECT_EQ(profile["stages"]["stages"].size(), 9u);
  EXPECT_GT(profile["stages"]["wholeMs"].get<double>(), 0.0);
  for (const json& stage : profile["stages"]["stages"]) {
    ASSERT_EQ(stage["rangeMs"].size(), 2u) << stage;
    const double ms = stage["ms"], low = stage["rangeMs"][0], high = stage["rangeMs"][1];
    const bool isAbove = ms > high - ms && ms > ms - low;
    EXPECT_EQ(stage["isAboveNoise"].get<bool>(), isAbove) << stage;
    EXPECT_EQ(stage["note"].get<std::string>().empty(), isAbove) << stage;
    EXPECT_LE(low, high) << stage;
  }
  EXPECT_GT(profile["checkpointBytes"].get<double>(), 0.0);
  EXPECT_TRUE(profile["timing"] == "finish" || profile["timing"] == "queries");
  const ProcessResult text = batch({"profile", "builtin:fan", "--size", "64x36", "--frames", "2"});
  EXPECT_EQ(text.exitCode, 0) << text.err;
  for (const char* word : {"G-buffer", "Neighborhood", "All cheapest", "timed by"})
    EXPECT_NE(text.out.find(word), std::string::npos) << text.out;
}

TEST(BatchMistakes, ProfileStartsFromFrameOneAndTakesOneLane) {
  expectUsageError({"profile", "builtin:fan", "--frames", "0..3"}, {"--frames 0..3", "from 1"});
  expectUsageError({"profile", "builtin:fan", "--lane", "balanced", "--lane", "sharp"}, {"one lane"});
}

class BatchMetrics : public taa::test::GlTest {};

TEST_F(BatchMetrics, PrintsMetricsOfEachFrameAndLane) {
  const std::vector<std::string> command = {
      "metrics", "builtin:fan",         "--size", "64x36", "--frames", "2..4", "--lane", "balanced", "--lane",
      "minimal", "--reference-samples", "8"};
  const ProcessResult result = batch(joined(command, {"--json"}));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["referenceSamples"], 8);
  const auto isUsual = [](const taa::MetricInfo& info) { return !info.isOverTime && !info.isCostly; };
  EXPECT_EQ(report["metrics"].size(), static_cast<std::size_t>(std::ranges::count_if(taa::kMetrics, isUsual)))
      << "nothing over time, and nothing costly, unless it is asked for";
  ASSERT_EQ(report["lanes"].size(), 2u);
  for (const json& lane : report["lanes"]) {
    ASSERT_EQ(lane["frames"].size(), 3u);
    double sum = 0.0;
    for (const json& frame : lane["frames"]) sum += frame["rmse"].get<double>();
    EXPECT_GT(sum, 0.0);
    EXPECT_DOUBLE_EQ(lane["mean"]["rmse"].get<double>(), sum / 3.0);
    EXPECT_GT(lane["frames"][1]["psnr"].get<double>(), 5.0);
  }
  const ProcessResult csv = batch(joined(command, {"--csv"}));
  ASSERT_EQ(csv.exitCode, 0) << csv.err;
  EXPECT_TRUE(csv.out.starts_with("frame,lane,preset,meanAlpha,rejected,clipped,")) << csv.out;
  EXPECT_EQ(std::ranges::count(csv.out, '\n'), 1 + 2 * 3);
  const std::string first = report["lanes"][0]["frames"][0]["rmse"].dump();
  EXPECT_NE(csv.out.find(first), std::string::npos) << "the same number, " << first;
}

TEST_F(BatchMetrics, PrintsFlickerOverTheLastFramesWhenAskedTo) {
  const std::vector<std::string> command = {"metrics", "builtin:fan", "--size",           "32x18", "--frames",
                                            "0..2",    "--flicker",   "--flicker-frames", "2"};
  const ProcessResult result = batch(joined(command, {"--reference-samples", "4", "--json"}));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["flickerFrames"], 2);
  const json& frames = report["lanes"][0]["frames"];
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_TRUE(frames[0]["flicker"].is_null()) << "nothing was seen before";
  EXPECT_GT(frames[2]["flicker"].get<double>(), 0.0);
  EXPECT_GE(frames[2]["deviationOverTime"].get<double>(), frames[2]["flicker"].get<double>());
  const double mean = report["lanes"][0]["mean"]["flicker"];
  EXPECT_DOUBLE_EQ(mean, (frames[1]["flicker"].get<double>() + frames[2]["flicker"].get<double>()) / 2.0);
  const ProcessResult alone = batch(joined(command, {"--reference-samples", "0", "--csv"}));
  ASSERT_EQ(alone.exitCode, 0) << alone.err;
  EXPECT_NE(alone.out.find(",deviationOverTime\n"), std::string::npos) << alone.out;
  EXPECT_EQ(alone.out.find("flicker"), std::string::npos) << "it needs a reference";
}

TEST_F(BatchMetrics, SplitsTheErrorWhenAskedTo) {
  const std::vector<std::string> command = {"metrics",  "builtin:fan", "--size",  "32x18",
                                            "--frames", "0..2",        "--parts", "--reference-samples"};
  const ProcessResult result = batch(joined(command, {"4", "--json"}));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json report = json::parse(result.out);
  const json frames = report["lanes"][0]["frames"];
  EXPECT_EQ(frames[0]["errorBlur"], 0.0) << "history starts";
  EXPECT_GT(frames[2]["errorBlur"].get<double>(), 0.0);
  EXPECT_FALSE(frames[2].contains("flicker")) << "nobody asked for it";
  for (const json& frame : frames) {
    double share = 0.0;
    for (const char* category : {"rightlyKept", "historyRemoved", "historyLetThrough", "historyThrownAway"})
      share += frame[category].get<double>();
    EXPECT_NEAR(share, 100.0, 1e-9);
  }
  EXPECT_EQ(batch(joined(command, {"0"})).exitCode, 2) << "it needs a reference";
}

TEST_F(BatchMetrics, MeasuresThoseThatAreNamedAlone) {
  const std::vector<std::string> command = {
      "metrics", "builtin:fan",         "--size", "32x18", "--frames", "2", "--flicker-frames",
      "2",       "--reference-samples", "4"};
  const ProcessResult result = batch(joined(command, {"--metrics", "hdrFlip,ghostEnergy,flip", "--json"}));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json report = json::parse(result.out);
  ASSERT_EQ(report["metrics"].size(), 3u);
  EXPECT_EQ(report["metrics"][0]["id"], "flip") << "in the order of the table";
  const json& frame = report["lanes"][0]["frames"][0];
  EXPECT_GT(frame["flip"].get<double>(), 0.0);
  EXPECT_GE(frame["hdrFlip"].get<double>(), 0.0);
  EXPECT_GE(frame["ghostEnergy"].get<double>(), 0.0);
  EXPECT_FALSE(frame.contains("rmse"));
}

TEST(BatchMistakes, MetricsHaveNamesAndWhatTheyNeed) {
  const std::vector<std::string> command = {"metrics", "builtin:fan", "--frames", "0", "--metrics"};
  expectUsageError(joined(command, {"flop"}), {"--metrics", "flop", "hdrFlip"});
  expectUsageError(joined(command, {"flip", "--reference-samples", "0"}), {"flip", "reference"});
  expectUsageError(joined(command, {"flip", "--flicker"}), {"--metrics", "--flicker"});
}

TEST_F(BatchMetrics, ComparesWithNothingWhereNoSamplesAreWanted) {
  const ProcessResult result =
      batch({"metrics", "builtin:fan", "--size", "64x36", "--frames", "3", "--reference-samples", "0"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.out.find("rmse"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("historyLength (frames)"), std::string::npos) << result.out;
}
