// Work on the rows of a picture, on two cores where that pays.
#pragma once

#include <cstddef>
#include <system_error>
#include <thread>

namespace taa::capture {

/// Calls work(first, end) for all rows, in two halves at a time where there are many values. Expects `work`
/// not to throw and its rows not to depend on each other.
template <typename Work>
void forRows(int rows, std::size_t values, const Work& work) {
  constexpr std::size_t kWorthAThread = std::size_t(1) << 17;
  const int half = rows / 2;
  std::thread second;
  if (values >= kWorthAThread) {
    try {
      second = std::thread([&work, half, rows] { work(half, rows); });
    } catch (const std::system_error&) { // no more threads: all of it is done here
    }
  }
  const bool isShared = second.joinable();
  work(0, isShared ? half : rows);
  if (isShared) second.join();
}

} // namespace taa::capture
