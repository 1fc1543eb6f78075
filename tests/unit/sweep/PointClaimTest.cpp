// Claims on points: only one holds a point, and none is held by who is gone.
#include "core/sweep/PointClaim.h"

#include "core/base/Files.h"
#include "core/base/json/Json.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
using std::chrono::seconds;
using taa::ClaimOwner;
using taa::PointClaim;

namespace {

constexpr seconds kTimeout{60};

class PointClaims : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = taa::test::temporaryFolder() / "claims";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  std::optional<PointClaim> take(const std::string& name = "it") const {
    return PointClaim::take(folder_, name, kTimeout);
  }
  /// As somebody else left it, so many seconds ago.
  void leave(const std::string& file, const ClaimOwner& owner, seconds ago = seconds(0)) const {
    taa::writeFile(
        folder_ / file,
        taa::Json{{"host", owner.host}, {"process", owner.process}, {"started", owner.started}}.dump());
    fs::last_write_time(folder_ / file, fs::file_time_type::clock::now() - ago);
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  fs::path folder_;
};

/// One that has ended.
ClaimOwner endedProcess() {
  const ::pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return {taa::thisProcess().host, child, taa::thisProcess().started};
}

const ClaimOwner kElsewhere{"another host", 1, 1};

} // namespace

TEST_F(PointClaims, HoldAPointUntilTheyEnd) {
  std::optional<PointClaim> claim = take();
  ASSERT_TRUE(claim);
  EXPECT_FALSE(take());
  EXPECT_TRUE(take("another"));
  claim.reset();
  EXPECT_EQ(files(), 0u);
  EXPECT_TRUE(take());
}

TEST_F(PointClaims, ThatAreFinishedLeaveNothing) {
  leave("it-0", endedProcess());
  std::optional<PointClaim> claim = take();
  ASSERT_TRUE(claim);
  EXPECT_EQ(files(), 2u);
  claim->finish();
  EXPECT_EQ(files(), 0u);
}

TEST_F(PointClaims, OfAProcessThatEndedAreTakenOver) {
  leave("it-0", endedProcess());
  std::optional<PointClaim> claim = take();
  ASSERT_TRUE(claim);
  EXPECT_FALSE(take());
  // Given up, it is free again, and only once.
  claim.reset();
  const std::optional<PointClaim> again = take();
  ASSERT_TRUE(again);
  EXPECT_FALSE(take());
}

TEST_F(PointClaims, OfAProcessWhoseNumberIsUsedAgainAreTakenOver) {
  ClaimOwner before = taa::thisProcess();
  EXPECT_TRUE(isRunning(before));
  --before.started;
  EXPECT_FALSE(isRunning(before));
  leave("it-0", before);
  EXPECT_TRUE(take());
}

TEST_F(PointClaims, OfOtherHostsAreTakenOverAfterASilence) {
  leave("fresh-0", kElsewhere);
  EXPECT_FALSE(take("fresh"));
  leave("old-0", kElsewhere, 2 * kTimeout);
  EXPECT_TRUE(take("old"));
  // The one that counts is the last.
  leave("both-0", kElsewhere, 2 * kTimeout);
  leave("both-1", kElsewhere);
  EXPECT_FALSE(take("both"));
}

TEST_F(PointClaims, ThatNobodyFinishedWritingAreTakenOverAfterASilence) {
  taa::writeFile(folder_ / "it-0", "{\"host\": \"x");
  EXPECT_FALSE(take());
  fs::last_write_time(folder_ / "it-0", fs::file_time_type::clock::now() - 2 * kTimeout);
  EXPECT_TRUE(take());
}

TEST_F(PointClaims, AreStaleByTheProcessHereAndByTheTimeElsewhere) {
  const std::string here = taa::thisProcess().host;
  EXPECT_FALSE(isStale(taa::thisProcess(), here, 100 * kTimeout, kTimeout));
  EXPECT_TRUE(isStale(endedProcess(), here, seconds(0), kTimeout));
  EXPECT_FALSE(isStale(kElsewhere, here, kTimeout, kTimeout));
  EXPECT_TRUE(isStale(kElsewhere, here, kTimeout + seconds(1), kTimeout));
  EXPECT_FALSE(taa::isStale({}, here, seconds(0), kTimeout));
}

TEST_F(PointClaims, GiveASignOfLifeWhenTouched) {
  std::optional<PointClaim> claim = take();
  const fs::file_time_type before = fs::file_time_type::clock::now() - 2 * kTimeout;
  fs::last_write_time(folder_ / "it-0", before);
  claim->touch(); // within the second: nothing
  EXPECT_LT(fs::last_write_time(folder_ / "it-0"), before + kTimeout);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  claim->touch();
  EXPECT_GT(fs::last_write_time(folder_ / "it-0"), before + kTimeout);
}

TEST_F(PointClaims, AreHeldByOneOfManyThatAskAtOnce) {
  constexpr int kPoints = 40, kThreads = 8;
  // Every other point has been left by who is gone.
  const ClaimOwner ended = endedProcess();
  for (int point = 0; point < kPoints; point += 2) leave(std::to_string(point) + "-0", ended);
  std::vector<std::atomic<int>> holders(kPoints);
  std::vector<std::vector<PointClaim>> held(kThreads);
  std::vector<std::thread> threads;
  for (int thread = 0; thread < kThreads; ++thread)
    threads.emplace_back([&, thread] {
      for (int point = 0; point < kPoints; ++point)
        if (std::optional<PointClaim> claim = take(std::to_string(point))) {
          ++holders[static_cast<std::size_t>(point)];
          held[static_cast<std::size_t>(thread)].push_back(std::move(*claim));
        }
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::atomic<int>& count : holders) EXPECT_EQ(count, 1);
}
