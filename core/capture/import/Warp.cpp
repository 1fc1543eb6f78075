#include "core/capture/import/Warp.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/decode/Rows.h"
#include "core/capture/import/FrameSamples.h"
#include "core/render/FrameInputs.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taa::capture {

namespace {

/// Where in the picture before a pixel's surface was; the pixel's own place where it was nowhere.
glm::vec2 placeBefore(const DecodedFrame& frame, const DecodedFrame& previous, int x, int y) {
  const glm::vec2 place = glm::vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5f;
  const glm::vec2 step = previous.jitterPx - frame.jitterPx;
  if (frame.motion.empty()) return place + step;
  const float* motion = frame.motion.at(x, y);
  const float longest = std::max(std::abs(motion[0]), std::abs(motion[1]));
  return longest < kNoPreviousPosition ? place - glm::vec2(motion[0], motion[1]) + step : place;
}

} // namespace

WarpedPair warpedPair(const DecodedFrame& frame, const DecodedFrame& previous) {
  if (frame.color.width != previous.color.width || frame.color.height != previous.color.height ||
      frame.color.empty())
    throw Error(say<"frames of different sizes cannot be compared">());
  WarpedPair out;
  out.current = comparedLuma(frame.color);
  const Image before = comparedLuma(previous.color);
  out.warped = Image(before.width, before.height, 1);
  out.difference = out.warped;
  forRows(before.height, before.pixels.size(), [&](int first, int end) {
    for (int y = first; y < end; ++y)
      for (int x = 0; x < before.width; ++x) {
        const float moved = betweenPixels(before, placeBefore(frame, previous, x, y));
        *out.warped.at(x, y) = moved;
        *out.difference.at(x, y) = std::abs(*out.current.at(x, y) - moved);
      }
  });
  double sum = 0.0;
  for (const float value : out.difference.pixels) sum += static_cast<double>(value);
  out.residual = 1000.0 * sum / static_cast<double>(out.difference.pixels.size());
  return out;
}

} // namespace taa::capture
