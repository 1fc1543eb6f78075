// The last frames of a pixel's surface as other settings resolve them: no farther around it than its history
// reaches.
#pragma once

#include "core/base/Progress.h"
#include "core/gl/Rect.h"
#include "core/render/FrameInputs.h"
#include "core/replay/FrameMaker.h"
#include "core/taa/TaaPass.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <map>
#include <vector>

namespace taa {

/// Frames in a row, their inputs drawn once for all settings. Needs the current context for its whole life.
class PartlyResolved {
 public:
  /// Frames from `first` on, of the lane that is the only one of `state`. `wanted`: a pixel of each frame
  /// that is looked at, the last one's too. Throws Error, Cancelled.
  PartlyResolved(const ShotState& state, int first, const std::map<int, glm::ivec2>& wanted,
                 const Progress& progress);

  /// The wanted pixels by frame, scene-linear, resolved on `before`, the history of the frame before the
  /// first one (null: it starts history): the same bits as of whole pictures. `settings` draw the same
  /// inputs.
  std::map<int, glm::dvec3> colors(TaaPass& pass, const HistoryHandle& before, const Settings& settings,
                                   const Progress& progress);

 private:
  struct Frame {
    int number = 0;
    gl::Rect part; ///< pixels of the picture that are resolved
    FrameInputs inputs;
  };
  std::map<int, glm::ivec2> wanted_;
  std::vector<Frame> frames_; // latest first
  History made_, next_;
};

/// Pixels of the frame before that the history of a part may be read from, whatever the settings are: around
/// where the motion of what lies around it points to, and around the part itself.
gl::Rect historyReach(const FrameInputs& inputs, const gl::Rect& part);

} // namespace taa
