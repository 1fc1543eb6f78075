// Sweeps that are stopped, shared, and go wrong: what is there is not computed again.
#include "core/sweep/SweepRun.h"

#include "core/base/Files.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using taa::Progress;
using taa::SweepPoint;
using taa::SweepReport;

namespace {

class SweepRun : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(path());
    folder_.emplace(path());
  }
  static fs::path path() { return taa::test::temporaryFolder() / "run"; }

  /// Twelve points.
  static taa::SweepSpec spec() {
    return taa::sweepSpecFromText(R"({"format": 1, "frames": [0, 0], "sources": ["builtin:fan"],
      "parameters": {"weight.alpha": {"from": 0, "to": 1, "steps": 12}}})",
                                  "it", "");
  }
  taa::MeasurePoint measure() {
    return [this](const SweepPoint& point, const Progress& progress) {
      taa::report(progress, "Measuring", 0, 1);
      computed_.push_back(point.index);
      return ordered_json{{"mean", {{"rmse", 0.5}}}};
    };
  }
  SweepReport run(const Progress& progress = {}, taa::SweepShard shard = {}) {
    return taa::runSweep({spec_, *folder_, shard}, measure(), progress);
  }
  std::vector<std::size_t> sorted() const {
    std::vector<std::size_t> points = computed_;
    std::ranges::sort(points);
    return points;
  }

  const taa::SweepSpec spec_ = spec();
  std::optional<taa::SweepFolder> folder_;
  std::vector<std::size_t> computed_;
};

const std::vector<std::size_t> kAll{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};

/// Each on a line of a file that all processes write to.
std::vector<std::size_t> linesOf(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::size_t> points;
  for (std::size_t point = 0; in >> point;) points.push_back(point);
  std::ranges::sort(points);
  return points;
}

} // namespace

TEST_F(SweepRun, ComputesEveryPointOnce) {
  const SweepReport first = run();
  EXPECT_EQ(computed_, kAll);
  EXPECT_EQ(first.points, 12u);
  EXPECT_EQ(first.computed, 12u);
  EXPECT_EQ(first.kept + first.failures.size(), 0u);
  const SweepReport second = run();
  EXPECT_EQ(computed_.size(), 12u);
  EXPECT_EQ(second.kept, 12u);
  EXPECT_EQ(second.computed, 0u);
}

TEST_F(SweepRun, GoesOnWhereItWasStopped) {
  int asked = 0;
  const Progress stopsInTheSixth = [&](std::string_view what, int, int) {
    return what.find("Measuring") == std::string_view::npos || ++asked < 6;
  };
  EXPECT_THROW(run(stopsInTheSixth), taa::Cancelled);
  EXPECT_EQ(computed_.size(), 5u);
  const SweepReport rest = run();
  EXPECT_EQ(rest.kept, 5u);
  EXPECT_EQ(rest.computed, 7u);
  EXPECT_EQ(sorted(), kAll);
}

TEST_F(SweepRun, SaysHowManyPointsWereThere) {
  run({}, {1, 4});
  std::vector<std::string> said;
  run([&](std::string_view what, int done, int total) {
    said.push_back(std::string(what) + " " + std::to_string(done) + "/" + std::to_string(total));
    return true;
  });
  EXPECT_EQ(said[12], "Points, 3 of them were there 3/12");
  EXPECT_EQ(said[13], "Points, 3 of them were there (Measuring: 0 of 1) 3/12");
  EXPECT_EQ(said.back(), "Points, 3 of them were there 12/12");
}

TEST_F(SweepRun, DoesItsShardAlone) {
  EXPECT_EQ(run({}, {2, 3}).points, 4u);
  EXPECT_EQ(computed_, (std::vector<std::size_t>{4, 5, 6, 7}));
  EXPECT_EQ(run().computed, 8u);
}

TEST_F(SweepRun, GoesOnPastAPointThatFails) {
  const taa::MeasurePoint failing = [](const SweepPoint& point, const Progress&) -> ordered_json {
    if (point.index % 4 == 1) throw taa::Error("no such camera");
    return {{"mean", ordered_json::object()}};
  };
  const SweepReport report = taa::runSweep({spec_, *folder_}, failing, {});
  EXPECT_EQ(report.computed, 9u);
  ASSERT_EQ(report.failures.size(), 3u);
  EXPECT_EQ(report.failures[1].point, 5u);
  EXPECT_EQ(report.failures[1].reason, "no such camera");
  EXPECT_EQ(run().computed, 3u) << "they are tried again";
}

// Shards of one folder, one of which is killed: what it left is what is missing.
TEST_F(SweepRun, IsSharedByProcessesAndSurvivesThatOneIsKilled) {
  const fs::path log = taa::test::temporaryFolder() / "computed.txt";
  fs::remove(log);
  const auto logging = [&](bool dies) {
    return [&log, dies, count = 0](const SweepPoint& point, const Progress&) mutable {
      if (dies && ++count == 3) ::kill(::getpid(), SIGKILL); // in the midst of its third
      std::ofstream(log, std::ios::app) << point.index << '\n';
      return ordered_json{{"mean", ordered_json::object()}};
    };
  };
  std::vector<::pid_t> children;
  for (std::size_t shard = 1; shard <= 3; ++shard) {
    children.push_back(::fork());
    if (children.back() != 0) continue;
    taa::runSweep({spec_, *folder_, {shard, 3}}, logging(shard == 1), {});
    ::_exit(0);
  }
  for (const ::pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(child == children[0] || status == 0);
  }
  EXPECT_EQ(taa::runSweep({spec_, *folder_}, logging(false), {}).computed, 2u);
  EXPECT_EQ(linesOf(log), kAll);
}
