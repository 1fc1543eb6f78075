// Motion of another object: a transform or a vector that was looked up where another one is kept.
#pragma once

#include "core/doctor/flow/Refuted.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace taa::doctor {

enum class OtherObjectKind : std::uint8_t {
  Motion, ///< it has the motion of the other one
  Place,  ///< it is said to come from where the other one was
};

/// A region whose motion is wrong, and whose it is instead.
struct OfOtherObject {
  const Region* region = nullptr;
  const Region* other = nullptr;
  OtherObjectKind kind = OtherObjectKind::Motion;
  std::size_t frames = 0, asked = 0; ///< in which it is so, of those that say
  double px = 0.0;                   ///< to that
};

/// Of objects by their number. One that pictures do not refute itself, as nothing of it can be followed, is
/// told only beside one that they do: its motion may be right, and that of two things. What one moves by is
/// what its squares do, else its middle; it is compared without the camera's motion, where that is known.
std::vector<OfOtherObject> ofOtherObjects(const std::vector<Refuted>& refuted, const FlowSeen& seen);

/// A frame in which objects take each other's transforms, as a list of them slips by one.
struct SlippedFrame {
  int frame = 0;
  std::vector<const Region*> regions;                ///< whose motion is wrong there
  std::size_t told = 0;                              ///< of these: leads to where another one was
  const Region *example = nullptr, *other = nullptr; ///< one of them, and that other one
  double px = 0.0;                                   ///< to that, in the middle
};

/// By the centroids of objects that no border cuts: three or more, and nearly all that do not move as given.
std::vector<SlippedFrame> slippedFrames(const FlowSeen& seen);

} // namespace taa::doctor
