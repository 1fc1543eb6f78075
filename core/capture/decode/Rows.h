// Work on the rows of a picture, on as many cores as there are where that pays.
#pragma once

#include <OpenImageIO/parallel.h>

#include <cstddef>
#include <cstdint>

namespace taa::capture {

/// Calls work(first, end) for all rows, in parts at a time where there are many values. Expects `work` not to
/// throw and its rows not to depend on each other.
template <typename Work>
void forRows(int rows, std::size_t values, const Work& work) {
  constexpr std::size_t kWorthAThread = std::size_t(1) << 17;
  if (values < kWorthAThread) {
    work(0, rows);
    return;
  }
  OIIO::parallel_for_chunked(0, rows, 0, [&work](std::int64_t first, std::int64_t end) {
    work(static_cast<int>(first), static_cast<int>(end));
  });
}

} // namespace taa::capture
