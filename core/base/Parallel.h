// Calls side by side, on as many processors as there are.
#pragma once

#include <OpenImageIO/parallel.h>

#include <cstdint>

namespace taa {

/// Calls work(i) for 0 ≤ i < count, each whenever a thread is free, and returns when all are done: for calls
/// that each take long, since OIIO::parallel_for() makes fewer than 16384 of them one after the other.
/// Expects `work` not to throw.
template <typename Work>
void parallelFor(int count, const Work& work) {
  OIIO::parallel_for_chunked(0, count, 1, [&work](std::int64_t first, std::int64_t end) {
    for (std::int64_t i = first; i < end; ++i) work(static_cast<int>(i));
  });
}

} // namespace taa
