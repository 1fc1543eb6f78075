// taa-batch sweep as users and scripts meet it: the real program, several of it at once, and one that is
// stopped.
#include "core/base/Files.h"
#include "core/sweep/SweepFolder.h"
#include "core/sweep/SweepPoints.h"
#include "core/sweep/SweepSpec.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using taa::test::ProcessResult;

/// 2 presets × 2 values.
constexpr const char* kSpec = R"({
  "format": 1,
  "sources": ["builtin:fan"],
  "settings": ["balanced", "minimal"],
  "parameters": {"weight.minimum": [0.05, 0.25]},
  "frames": [2, 3],
  "size": [48, 28],
  "metrics": ["rmse", "flicker"],
  "referenceSamples": 4,
  "flickerFrames": 2
})";

class SweepBatchTest : public taa::test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    folder_ = taa::test::temporaryFolder() / "sweep";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    taa::writeFile(spec(), kSpec);
  }
  fs::path spec() const { return folder_ / "spec.json"; }
  fs::path out(const std::string& name = "out") const { return folder_ / name; }
  static ProcessResult batch(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), taa::test::binary("taa-batch").string());
    return taa::test::runProcess(arguments);
  }
  ProcessResult sweep(const std::string& name = "out", const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"sweep", spec().string(), "--out", out(name).string(), "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return batch(arguments);
  }
  /// "computed/kept" of the points.
  static std::string counts(const ProcessResult& result) {
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const ordered_json json = ordered_json::parse(result.out);
    return json["computed"].dump() + "/" + json["kept"].dump();
  }
  std::string csv(const std::string& name = "out") const { return taa::readFile(out(name) / "sweep.csv"); }
  fs::path folder_;
};

} // namespace

TEST_F(SweepBatchTest, MeasuresAllPointsOnceAndMergesThem) {
  EXPECT_EQ(counts(sweep()), "4/0");
  const std::string first = csv();
  EXPECT_EQ(std::ranges::count(first, '\n'), 5);
  EXPECT_TRUE(first.starts_with("point,source,camera,settings,weight.minimum,rmse,flicker,pareto\n"))
      << first;
  EXPECT_EQ(counts(sweep()), "0/4");
  EXPECT_EQ(csv(), first);
}

// The same numbers as those of `metrics`, which shares nothing of sweeping but the measuring.
TEST_F(SweepBatchTest, MeasuresWhatMetricsMeasures) {
  sweep();
  const ordered_json metrics =
      ordered_json::parse(batch({"metrics", "builtin:fan", "--size", "48x28", "--frames", "2..3", "--preset",
                                 "minimal", "--set", "weight.minimum=0.25", "--reference-samples", "4",
                                 "--flicker", "--flicker-frames", "2", "--json"})
                              .out);
  const ordered_json table = ordered_json::parse(taa::readFile(out() / "sweep.json"));
  const ordered_json& point = table["points"][3];
  EXPECT_EQ(point["settings"], "minimal");
  EXPECT_EQ(point["parameters"]["weight.minimum"], "0.25");
  for (const char* metric : {"rmse", "flicker"})
    EXPECT_EQ(point["mean"][metric], metrics["lanes"][0]["mean"][metric]) << metric;
}

TEST_F(SweepBatchTest, ShardsMakeTheSameTablesAsOneProcess) {
  sweep("whole");
  EXPECT_EQ(counts(sweep("parts", {"--shard", "1/3"})), "1/0");
  EXPECT_EQ(counts(sweep("parts", {"--shard", "2/3"})), "1/0");
  EXPECT_EQ(counts(sweep("parts", {"--shard", "3/3"})), "2/0");
  EXPECT_EQ(csv("parts"), csv("whole"));
}

TEST_F(SweepBatchTest, ShardsShareAFolder) {
  std::vector<ProcessResult> results(2);
  std::vector<std::thread> threads;
  for (std::size_t shard = 0; shard < results.size(); ++shard)
    threads.emplace_back([&results, shard, this] {
      results[shard] = sweep("out", {"--shard", std::to_string(shard + 1) + "/2"});
    });
  for (std::thread& thread : threads) thread.join();
  for (const ProcessResult& result : results) {
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_EQ(counts(result), "2/0");
  }
  EXPECT_EQ(counts(sweep()), "0/4");
  EXPECT_EQ(csv().find(",\n"), std::string::npos) << "the last call's table has all:\n" << csv();
}

TEST_F(SweepBatchTest, ComputesWhatIsBrokenOrMissingAgain) {
  sweep();
  const std::string whole = csv();
  std::vector<fs::path> points;
  for (const fs::directory_entry& entry : fs::directory_iterator(out() / "points"))
    points.push_back(entry.path());
  ASSERT_EQ(points.size(), 4u);
  fs::remove(points[0]);
  taa::writeFile(points[1], taa::readFile(points[1]).substr(0, 100));
  EXPECT_EQ(counts(sweep()), "2/2");
  EXPECT_EQ(csv(), whole);
}

TEST_F(SweepBatchTest, ComputesOnlyWhatAChangedSpecAdds) {
  sweep();
  std::string more = kSpec;
  more.replace(more.find("0.25]"), 5, "0.25, 0.5]");
  taa::writeFile(spec(), more);
  EXPECT_EQ(counts(sweep()), "2/4");
}

TEST_F(SweepBatchTest, SaysWhatIsWrong) {
  std::string wrong = kSpec;
  wrong.replace(wrong.find("\"size\""), 6, "\"sizes\"");
  taa::writeFile(spec(), wrong);
  ProcessResult result = sweep();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.out, "");
  for (const char* word : {"spec.json", "sizes", "size"})
    EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
  EXPECT_FALSE(fs::exists(out()));
  EXPECT_EQ(sweep("out", {"--shard", "3/2"}).exitCode, 2);
  EXPECT_EQ(batch({"sweep", (folder_ / "absent.json").string(), "--out", out().string()}).exitCode, 1);
}

TEST_F(SweepBatchTest, GoesOnPastPointsThatFail) {
  std::string wrong = kSpec;
  wrong.replace(wrong.find("[\"builtin:fan\"]"), 15, "[\"absent.glb\", \"builtin:fan\"]");
  taa::writeFile(spec(), wrong);
  const ProcessResult result = sweep();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.err.find("point 0: "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("absent.glb"), std::string::npos) << result.err;
  const ordered_json json = ordered_json::parse(result.out);
  EXPECT_EQ(json["computed"], 4);
  EXPECT_EQ(json["failures"].size(), 4u);
}

// As soon as the first point lies there.
TEST_F(SweepBatchTest, LeavesAGoodFolderWhenItIsInterrupted) {
  std::string more = kSpec;
  more.replace(more.find("[0.05, 0.25]"), 12, R"({"from": 0, "to": 1, "steps": 60})");
  taa::writeFile(spec(), more);
  // A shell's own background processes do not hear SIGINT.
  const std::string script = R"sh(/usr/bin/env --default-signal=INT "${@:2}" &
    until [ -n "$(ls -A "$1/points" 2>/dev/null)" ] || ! kill -0 $!; do sleep 0.01; done
    kill -INT $!; wait $!)sh";
  const ProcessResult stopped = taa::test::runProcess({"/bin/bash", "-c", script, "bash", out().string(),
                                                       taa::test::binary("taa-batch").string(), "sweep",
                                                       spec().string(), "--out", out().string()});
  EXPECT_EQ(stopped.exitCode, 130) << stopped.err;
  const auto points = std::distance(fs::directory_iterator(out() / "points"), fs::directory_iterator());
  EXPECT_EQ(ordered_json::parse(taa::readFile(out() / "sweep.json"))["measured"], points);
  EXPECT_EQ(counts(sweep()), std::to_string(120 - points) + "/" + std::to_string(points));
}

// The example of the manual, as it stands there.
TEST_F(SweepBatchTest, TheExampleOfTheManualRuns) {
  const std::string page = taa::readFile("resources/manual/sweep.md");
  const std::size_t begin = page.find("```json\n");
  ASSERT_NE(begin, std::string::npos);
  const std::string example = page.substr(begin + 8, page.find("```", begin + 8) - begin - 8);
  ordered_json json = ordered_json::parse(example);
  EXPECT_GT(taa::sweepSpecFromText(example, "the manual's", "").pointCount(), 3u);
  // Its points, on a picture and frames that take no minute.
  json["size"] = {48, 28};
  json["frames"] = {2, 3};
  json["referenceSamples"] = 4;
  taa::writeFile(spec(), json.dump());
  const taa::SweepSpec read = taa::readSweepSpec(spec());
  EXPECT_EQ(counts(sweep()), std::to_string(read.pointCount()) + "/0");
  for (const taa::Metric metric : read.tradeOff)
    EXPECT_NE(page.find(taa::metricInfo(metric).id), std::string::npos) << "named as its trade-off";
}
