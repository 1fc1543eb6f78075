// Everything at a probe over the frames in which it is known. Frame n is a function, so what was seen
// of it stays true until settings, scene, size or camera change. No GL.
#pragma once

#include "core/probe/Probe.h"
#include "core/taa/twin/Twin.h"

#include <cstdint>
#include <map>
#include <vector>

namespace taa {

struct TraceSample {
  glm::ivec2 pixel{0}; ///< where the probe was
  twin::PixelRecord record{};
};

class PixelTrace {
 public:
  void add(int frame, const TraceSample& sample);
  /// Null where it is not known.
  const TraceSample* at(int frame) const;
  /// By frame, rising.
  const std::map<int, TraceSample>& samples() const { return samples_; }
  void clear() { samples_.clear(); }

 private:
  std::map<int, TraceSample> samples_;
};

/// Frames from `first` to `last` that are not known.
std::vector<int> missingFrames(const PixelTrace& trace, int first, int last);

/// α of the frames up to `frame`, oldest first: as far back as they are known without a gap, to where history
/// started or was dropped (α = 1), `most` at most. Empty where `frame` is not known.
std::vector<double> alphasUpTo(const PixelTrace& trace, int frame, int most);

/// Whether both probes ask for the same values: what was found out about their surfaces does not count, nor
/// the frame of one that stays on its pixel.
bool isSamePlace(const Probe& a, const Probe& b);

/// A probe of which something was seen.
struct ProbeTrace {
  Probe probe;
  PixelTrace trace;
};

/// What was at a probe in an exact frame.
struct TraceDelivery {
  Probe probe; ///< with its anchor
  int frame = 0;
  TraceSample sample;
  std::uint64_t shotVersion = 0; ///< see Status; the sample is true while it is the same
};

} // namespace taa
