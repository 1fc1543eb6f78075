// What the centers of pixels show, drawn from the source of a shot's frames.
#pragma once

#include "core/gl/Texture.h"
#include "core/probe/SurfaceSteps.h"
#include "core/render/FrameInputs.h"
#include "core/render/FrameRequest.h"
#include "core/render/FrameSource.h"

#include <glm/vec2.hpp>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace taa {

/// What the centers of a frame's pixels show, as drawSteps() draws it. Throws Error.
SeenSurfaces drawSurfaces(FrameSource& frames, const FrameRequest& ofLane, int frame);

/// A frame and what was seen in it.
using DrawnSurfaces = std::optional<std::pair<int, SeenSurfaces>>;

/// surfaceSteps() to a frame from the one before, of what `ofLane` draws: as for the reference, but through
/// the centers of the pixels. A capture shows the samples it was taken with instead. `last`: what was drawn
/// last for steps, which is used again. Throws Error.
Image drawSteps(FrameSource& frames, const FrameRequest& ofLane, int frame, DrawnSurfaces& last);

/// The same where somebody looks: of parts of frames, each drawn as far as it was looked at. Needs the
/// current context for its whole life. Not for captures, which show all or nothing.
class SurfaceParts {
 public:
  SurfaceParts(FrameSource& frames, const FrameRequest& ofLane);

  /// Says which parts of a frame will be looked at: what is looked at of one is drawn with all of it.
  void expect(int frame, std::vector<gl::Rect> parts) { expected_[frame] = std::move(parts); }
  /// surfaceSteps() of a part of a frame that does not start history, or does: then nothing was seen before.
  /// `drawn`: what it may draw into. Throws Error.
  Image steps(int frame, const gl::Rect& part, bool isStart, FrameInputs& drawn);
  /// The object that a pixel shows. Likewise.
  int object(int frame, const glm::ivec2& pixel, FrameInputs& drawn);

 private:
  const SeenSurfaces& seen(int frame, const gl::Rect& part, FrameInputs& drawn);

  FrameSource& frames_;
  FrameRequest request_;
  std::multimap<int, SeenSurfaces> seen_;         // by frame; what was looked at, and around it
  std::map<int, std::vector<gl::Rect>> expected_; // likewise
};

/// The steps of a part of a frame that starts history: none of what is seen was seen before.
Image firstSteps(const SeenSurfaces& seen, const gl::Rect& part);

} // namespace taa
