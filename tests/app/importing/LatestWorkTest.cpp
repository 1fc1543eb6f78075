// Of what is asked for while a thread is at work only the last is done.
#include "app/background/LatestWork.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>
#include <vector>

using taa::app::LatestWork;

TEST(LatestWork, DoesTheLastOfWhatWaits) {
  std::promise<void> begun, ended;
  std::atomic<bool> wasStopped = false;
  std::vector<int> done; // by the thread of `work` alone, until it has ended
  LatestWork work;
  work.post([&](const LatestWork::IsWanted& isWanted) {
    begun.set_value();
    while (isWanted()) std::this_thread::yield();
    wasStopped = true;
  });
  begun.get_future().wait();
  std::promise<void> posted;
  std::future<void> allPosted = posted.get_future();
  work.post([&](const auto&) {
    allPosted.wait(); // whichever of these is begun, the others were asked for by then
    done.push_back(1);
  });
  work.post([&](const auto&) { done.push_back(2); });
  work.post([&](const auto& isWanted) {
    done.push_back(isWanted() ? 3 : 0);
    ended.set_value();
  });
  posted.set_value();
  ended.get_future().wait();
  EXPECT_TRUE(wasStopped);
  ASSERT_FALSE(done.empty());
  EXPECT_EQ(done.back(), 3);
}

TEST(LatestWork, EndsWithWhatIsUnderWay) {
  std::promise<void> begun;
  bool wasStopped = false;
  {
    LatestWork work;
    work.post([&](const LatestWork::IsWanted& isWanted) {
      begun.set_value();
      while (isWanted()) std::this_thread::yield();
      wasStopped = true;
    });
    begun.get_future().wait();
  }
  EXPECT_TRUE(wasStopped);
}

TEST(LatestWork, DoesNothingThatWasCancelled) {
  std::promise<void> begun, cancelled, ended;
  std::future<void> isCancelled = cancelled.get_future();
  std::atomic<int> done = 0;
  LatestWork work;
  work.post([&](const auto&) {
    begun.set_value();
    isCancelled.wait();
  });
  begun.get_future().wait();
  work.post([&](const auto&) { ++done; });
  work.cancel();
  cancelled.set_value();
  work.post([&](const auto&) { ended.set_value(); });
  ended.get_future().wait();
  EXPECT_EQ(done, 0);
}
