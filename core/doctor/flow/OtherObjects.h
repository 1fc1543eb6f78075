// Motion of another object: a transform or a vector that was looked up where another one is kept.
#pragma once

#include "core/doctor/flow/Refuted.h"

#include <vector>

namespace taa::doctor {

enum class OtherObjectKind : std::uint8_t {
  Motion, ///< it has the motion of the other one
  Place,  ///< it is said to come from where the other one was
};

/// A region whose motion pictures refute, and whose it is instead.
struct OfOtherObject {
  const Region* region = nullptr;
  const Region* other = nullptr;
  OtherObjectKind kind = OtherObjectKind::Motion;
  std::size_t frames = 0, asked = 0; ///< in which it is so, of those that say
  double px = 0.0;                   ///< to that
};

/// Of objects by their number. Motion is compared without the camera's, where that is known.
std::vector<OfOtherObject> ofOtherObjects(const std::vector<Refuted>& refuted, const FlowSeen& seen);

} // namespace taa::doctor
