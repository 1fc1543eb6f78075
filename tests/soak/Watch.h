// Ends the program when nothing has gone on for too long: a soak that hangs is a finding.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <utility>

namespace taa::soak {

class Watch {
 public:
  /// `again` says how to repeat it.
  explicit Watch(std::string again)
      : again_(std::move(again)), thread_([this](const auto& stop) { run(stop); }) {}

  void tick() { ++ticks_; }

 private:
  template <typename Stop>
  void run(const Stop& stop) {
    constexpr int kMaxSilence = 180; // s; sanitizers and a busy machine included
    long long seen = -1;
    for (int silent = 0; !stop.stop_requested(); std::this_thread::sleep_for(std::chrono::seconds(1))) {
      silent = ticks_ == seen ? silent + 1 : 0;
      seen = ticks_;
      if (silent < kMaxSilence) continue;
      std::fprintf(stderr, "FINDING: nothing goes on for %d s in %s, after the last line of its log\n",
                   kMaxSilence, again_.c_str());
      std::abort();
    }
  }

  std::string again_;
  std::atomic<long long> ticks_ = 0;
  std::jthread thread_; // ends before what it reads
};

} // namespace taa::soak
