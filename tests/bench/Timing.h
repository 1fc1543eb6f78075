// How the benchmarks measure.
#pragma once

#include <chrono>
#include <functional>

namespace taa::bench {

/// How long `act` takes, s.
inline double seconds(const std::function<void()>& act) {
  const auto start = std::chrono::steady_clock::now();
  act();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace taa::bench
