// What pictures of a world at rest are displaced by against their mean. One picture aliases, and what it is
// compared with aliases as well: thin lines stay on their pixels whatever the jitter. The mean of jittered
// pictures is one that was supersampled, whose slope says what a displacement changes.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"

#include <glm/vec2.hpp>

#include <map>
#include <vector>

namespace taa::doctor {

/// Gathers frames in their order, from the first one on for as long as the camera rests.
class RestingPictures {
 public:
  /// Frames are expected in their order. `isResting`: `now` shows what `before` does, but for the jitter.
  void add(const DoctorFrame& before, const DoctorFrame& now, bool isResting);
  /// px, of content, x right, y down: jitter less its mean, up to a factor that detail makes (1.2 for edges,
  /// more for thin lines), by frame. Least squares of luma against the slope of the mean. Empty where too few
  /// pictures rest, or they have too little detail.
  std::map<int, glm::vec2> displacementsPx() const;

 private:
  /// Luma at every place and left, right, above and below it, likewise ordered; and where something stands.
  struct Picture {
    int frame = 0;
    std::vector<float> luma;
    std::vector<bool> isDrawn;
  };
  static Picture pictureOf(const DoctorFrame& frame);

  std::vector<Picture> pictures_;
  bool hasMoved_ = false;
};

} // namespace taa::doctor
