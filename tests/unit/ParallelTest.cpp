// Calls side by side: all of them, each once, and by more than one thread where there are more.
#include "core/base/Parallel.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <set>
#include <thread>

using taa::parallelFor;

TEST(Parallel, MakesEachCallOnce) {
  std::array<std::atomic<int>, 100> calls{};
  parallelFor(100, [&](int i) { ++calls[static_cast<std::size_t>(i)]; });
  for (const std::atomic<int>& count : calls) EXPECT_EQ(count, 1);
  parallelFor(0, [](int) { ADD_FAILURE() << "there is none"; });
}

// Few calls that each take long are not left to one thread.
TEST(Parallel, SharesFewCallsAmongThreads) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "there is one processor";
  std::mutex mutex;
  std::set<std::thread::id> threads;
  parallelFor(8, [&](int) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_GT(threads.size(), 1u);
}
