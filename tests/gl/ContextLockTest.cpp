// Threads that draw take turns.
#include "core/gl/ContextLock.h"
#include "core/inspect/Inspector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <future>
#include <string_view>
#include <thread>
#include <vector>

using taa::gl::ContextLock;

TEST(ContextLock, IsOfOneThreadAtATime) {
  std::atomic<int> inside = 0, most = 0;
  const auto draw = [&] {
    ContextLock lock;
    for (int step = 0; step < 200; ++step) {
      most = std::max<int>(most, ++inside);
      std::this_thread::yield();
      --inside;
      lock.pass();
    }
  };
  { const std::jthread one(draw), two(draw), three(draw); }
  EXPECT_EQ(most, 1);
}

TEST(ContextLock, IsPassedToWhoWaits) {
  std::vector<int> order;
  std::atomic<bool> waits = false;
  std::jthread other;
  {
    ContextLock lock;
    other = std::jthread([&] {
      waits = true;
      const ContextLock its;
      order.push_back(1);
    });
    while (!waits) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(50)); // it has its number
    order.push_back(0);
    lock.pass();
    order.push_back(2);
  }
  other.join();
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2}));
}

TEST(ContextLock, IsOthersWhileItsOwnerRests) {
  ContextLock lock;
  bool hasDrawn = false;
  lock.restDuring([&] {
    std::async(std::launch::async, [&] {
      const ContextLock its;
      hasDrawn = true;
    }).get();
  });
  EXPECT_TRUE(hasDrawn);
}

TEST(ContextLock, ProgressAsksWhoReportsIt) {
  ContextLock lock;
  EXPECT_TRUE(lock.passing({})("", 0, 1));
  EXPECT_FALSE(lock.passing([](std::string_view, int, int) { return false; })("", 0, 1));
}

// Without turns llvmpipe of Mesa 22 ends the process here.
TEST(ContextLock, LetsTwoContextsDraw) {
  const auto draw = [] {
    ContextLock lock;
    taa::Inspector inspector;
    inspector.shot().setSize(96, 54);
    inspector.shot().open("builtin:fan");
    for (int frame = 0; frame < 40; ++frame) {
      inspector.shot().seek(frame);
      lock.pass();
    }
    return inspector.probes().probe(60, 20);
  };
  auto one = std::async(std::launch::async, draw), other = std::async(std::launch::async, draw);
  const taa::PixelRecord first = one.get(), second = other.get();
  EXPECT_EQ(0, std::memcmp(&first, &second, sizeof(first)));
}
