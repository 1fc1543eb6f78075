// Sweeps that are stopped, shared, and go wrong: each point is computed once.
#include "core/sweep/SweepRun.h"

#include "core/base/Files.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
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
      const std::lock_guard lock(mutex_);
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
  bool isClean() const { return fs::is_empty(path() / "claims"); }

  const taa::SweepSpec spec_ = spec();
  std::optional<taa::SweepFolder> folder_;
  std::mutex mutex_;
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
  EXPECT_EQ(first.kept + first.elsewhere + first.failures.size(), 0u);
  const SweepReport second = run();
  EXPECT_EQ(computed_.size(), 12u);
  EXPECT_EQ(second.kept, 12u);
  EXPECT_EQ(second.computed, 0u);
  EXPECT_TRUE(isClean());
}

TEST_F(SweepRun, GoesOnWhereItWasStopped) {
  int asked = 0;
  const Progress stopsInTheSixth = [&](std::string_view what, int, int) {
    return what.find("Measuring") == std::string_view::npos || ++asked < 6;
  };
  EXPECT_THROW(run(stopsInTheSixth), taa::Cancelled);
  EXPECT_EQ(computed_.size(), 5u);
  EXPECT_TRUE(isClean()) << "what was begun is given up";
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
  EXPECT_TRUE(isClean());
  EXPECT_EQ(run().computed, 3u) << "they are tried again";
}

TEST_F(SweepRun, LeavesWhatOthersAreAbout) {
  const taa::SweepGround ground(spec_);
  const auto claim =
      folder_->claim(taa::PointKey(ground.inputs(spec_, taa::sweepPoint(spec_, 7))), taa::kClaimTimeout);
  const SweepReport report = run();
  EXPECT_EQ(report.computed, 11u);
  EXPECT_EQ(report.elsewhere, 1u);
  EXPECT_EQ(std::ranges::count(computed_, 7u), 0);
}

TEST_F(SweepRun, IsSharedByThreads) {
  std::vector<SweepReport> reports(4);
  std::vector<std::thread> threads;
  for (SweepReport& report : reports) threads.emplace_back([&] { report = run(); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(sorted(), kAll);
  std::size_t sum = 0;
  for (const SweepReport& report : reports) sum += report.computed;
  EXPECT_EQ(sum, 12u);
  EXPECT_TRUE(isClean());
}

TEST_F(SweepRun, IsSharedByProcessesAndSurvivesThatOneIsKilled) {
  const fs::path log = taa::test::temporaryFolder() / "computed.txt";
  fs::remove(log);
  const auto logging = [&](bool dies) {
    return [&log, dies, count = 0](const SweepPoint& point, const Progress&) mutable {
      if (dies && ++count == 3) ::kill(::getpid(), SIGKILL); // in the midst of its third
      std::ofstream(log, std::ios::app) << point.index << '\n';
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      return ordered_json{{"mean", ordered_json::object()}};
    };
  };
  std::vector<::pid_t> children;
  for (const bool dies : {true, false, false}) {
    children.push_back(::fork());
    if (children.back() != 0) continue;
    taa::runSweep({spec_, *folder_}, logging(dies), {});
    ::_exit(0);
  }
  for (const ::pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(child == children[0] || status == 0);
  }
  taa::runSweep({spec_, *folder_}, logging(false),
                {}); // what the dead one left, unless somebody has it already
  EXPECT_EQ(linesOf(log), kAll);
  EXPECT_TRUE(isClean());
}
