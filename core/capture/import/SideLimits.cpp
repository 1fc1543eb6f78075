#include "core/capture/import/SideLimits.h"

#include "core/base/Say.h"
#include "core/capture/format/ManifestChecks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace taa::capture {

namespace {

bool isCameraMatrix(const std::optional<StatedMatrix>& matrix) {
  return matrix &&
         std::ranges::all_of(*matrix, [](double element) { return std::abs(element) <= kMaxMatrixElement; });
}

/// Whether there were such matrices.
bool leaveOutMatrices(CapturedFrame& frame) {
  const bool hasSome = frame.view || frame.projection;
  if (!hasSome || (isCameraMatrix(frame.view) && isCameraMatrix(frame.projection))) return false;
  frame.view.reset();
  frame.projection.reset();
  return true;
}

bool leaveOutJitter(CapturedFrame& frame) {
  if (std::abs(frame.jitter.x) <= kMaxStatedJitter && std::abs(frame.jitter.y) <= kMaxStatedJitter)
    return false;
  frame.jitter = {0.0, 0.0};
  return true;
}

bool doTimesRise(const std::vector<CapturedFrame>& frames) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::optional<double>& seconds = frames[i].seconds;
    if (!seconds || !(std::abs(*seconds) <= kMaxSeconds)) return false;
    if (i > 0 && *seconds <= *frames[i - 1].seconds) return false;
  }
  return true;
}

} // namespace

void keepWithinLimits(std::vector<CapturedFrame>& frames, const std::string& file,
                      std::vector<std::string>& unsure) {
  std::size_t withoutMatrices = 0, withoutJitter = 0;
  for (CapturedFrame& frame : frames) {
    if (leaveOutMatrices(frame)) ++withoutMatrices;
    if (leaveOutJitter(frame)) ++withoutJitter;
  }
  if (withoutMatrices > 0)
    unsure.push_back(say<"matrices of %1 of %2 frames in %3 are not used: a view or a projection stands "
                         "alone, or has numbers that no camera has">(withoutMatrices, frames.size(), file));
  if (withoutJitter > 0)
    unsure.push_back(say<"the jitter of %1 of %2 frames in %3 is not used: it is beyond any picture">(
        withoutJitter, frames.size(), file));
  const bool hasTimes =
      std::ranges::any_of(frames, [](const CapturedFrame& frame) { return frame.seconds.has_value(); });
  if (!hasTimes || doTimesRise(frames)) return;
  for (CapturedFrame& frame : frames) frame.seconds.reset();
  unsure.push_back(
      say<"the times in %1 are not used: some frames have none, or they do not rise from frame to frame">(
          file));
}

} // namespace taa::capture
