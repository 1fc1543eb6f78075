// Settings are measured on another thread, and nothing of what nobody wants any more arrives.
#include "app/background/SweepWork.h"

#include "core/base/Error.h"
#include "tests/app/WindowFixture.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

using taa::LaneMetrics;
using taa::Progress;
using taa::SettingsMeasured;
using taa::ShotSweepRequest;
using taa::app::SweepWork;
using taa::app::test::waitFor;

namespace {

/// What arrived.
struct Heard {
  explicit Heard(SweepWork& work) {
    QObject::connect(&work, &SweepWork::measured,
                     [this](std::size_t index, const LaneMetrics&) { measured.push_back(index); });
    QObject::connect(&work, &SweepWork::ended, [this](const QString& error) { ends.push_back(error); });
  }
  std::vector<std::size_t> measured;
  std::vector<QString> ends;
};

ShotSweepRequest requestOf(std::size_t count) {
  ShotSweepRequest request;
  request.shots.resize(1);
  request.settings.resize(count);
  return request;
}

void measureAll(const ShotSweepRequest& request, const SettingsMeasured& measured, const Progress& progress) {
  for (std::size_t index = 0; index < request.settings.size(); ++index) {
    taa::report(progress, "Measuring", static_cast<int>(index), static_cast<int>(request.settings.size()));
    measured(index, {});
  }
}

} // namespace

TEST(SweepWork, MeasuresOnAnotherThread) {
  std::thread::id thread;
  SweepWork work(
      [&](const ShotSweepRequest& request, const SettingsMeasured& measured, const Progress& progress) {
        thread = std::this_thread::get_id();
        measureAll(request, measured, progress);
      });
  Heard heard(work);
  work.begin(requestOf(3));
  EXPECT_TRUE(work.isRunning());
  ASSERT_TRUE(waitFor([&] { return !work.isRunning(); }));
  EXPECT_EQ(heard.measured, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(heard.ends, std::vector<QString>{QString()});
  EXPECT_NE(thread, std::this_thread::get_id());
}

TEST(SweepWork, SaysWhatWentWrong) {
  SweepWork work([](const ShotSweepRequest&, const SettingsMeasured&, const Progress&) {
    throw taa::Error("there is no such frame");
  });
  Heard heard(work);
  work.begin(requestOf(1));
  ASSERT_TRUE(waitFor([&] { return !work.isRunning(); }));
  EXPECT_EQ(heard.ends, std::vector<QString>{"there is no such frame"});
}

TEST(SweepWork, EndsAtOnceWhenItIsCancelled) {
  std::atomic<bool> hasBegun = false, isStopped = false;
  SweepWork work([&](const ShotSweepRequest&, const SettingsMeasured& measured, const Progress& progress) {
    hasBegun = true;
    try {
      while (true) taa::report(progress, "Measuring", 0, 1);
    } catch (const taa::Cancelled&) {
      isStopped = true;
      measured(0, {}); // too late
      throw;
    }
  });
  Heard heard(work);
  work.begin(requestOf(1));
  ASSERT_TRUE(waitFor([&] { return hasBegun.load(); }));
  work.cancel();
  EXPECT_FALSE(work.isRunning());
  EXPECT_EQ(heard.ends, std::vector<QString>{QString()});
  ASSERT_TRUE(waitFor([&] { return isStopped.load(); }));
  QTest::qWait(30);
  EXPECT_TRUE(heard.measured.empty());
  EXPECT_EQ(heard.ends.size(), 1u);
}

TEST(SweepWork, WaitsAtItsEndForItsThread) {
  std::atomic<bool> isStopped = false;
  std::atomic<bool> hasBegun = false;
  {
    SweepWork work([&](const ShotSweepRequest&, const SettingsMeasured&, const Progress& progress) {
      hasBegun = true;
      try {
        while (true) taa::report(progress, "Measuring", 0, 1);
      } catch (const taa::Cancelled&) {
        isStopped = true;
      }
    });
    work.begin(requestOf(1));
    ASSERT_TRUE(waitFor([&] { return hasBegun.load(); }));
  }
  EXPECT_TRUE(isStopped);
}
