// What lies at the ends of depth: nothing that is drawn lies in the near plane over an area.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"

#include <cstddef>

namespace taa::doctor {

/// Pixels of all frames by the depth stored, which is reversed with its far plane at infinity.
struct DepthEnds {
  std::size_t atNear = 0, atFar = 0;     ///< exactly 1, exactly 0
  std::size_t nearHalf = 0, farHalf = 0; ///< between: above ½, up to ½
  std::size_t drawn = 0, drawnAtFar = 0; ///< by object numbers, where there are some
  float least = 1.0f;                    ///< of what lies between

  void add(const DoctorFrame& frame);
  std::size_t pixels() const { return atNear + atFar + nearHalf + farHalf; }
  /// Whether an area has the depth of the near plane and nothing that of the sky: what is not drawn has it.
  bool isSkyNear() const;
  /// Whether everything lies in the near plane but the sky.
  bool isAllNear() const;
  /// Whether nothing is drawn where object numbers say that something is.
  bool isDrawnFar() const;
  /// Whether most of what is drawn lies nearer than two near planes besides: no camera looks so.
  bool isTurned() const;
};

} // namespace taa::doctor
