// What a view shows of one frame, both of its sides included, for files.
#pragma once

#include "core/base/Progress.h"
#include "core/gl/Rect.h"
#include "core/inspect/Comparison.h"
#include "core/measure/compare/FrameBefore.h"
#include "core/picture/PictureSource.h"
#include "core/picture/ViewRequest.h"

#include <glm/vec2.hpp>

#include <optional>

namespace taa {

class Inspector;

/// Of any frame: what is compared moves with it, where it says no frame of its own.
struct PictureRequest {
  IntermediateId id = IntermediateId::resolved;
  ViewStyle style; ///< of the row; of a difference where that is shown
  ViewTransform transform;
  int width = 0, height = 0; ///< px that are drawn
  gl::Rect part{};           ///< of them, what the picture is; empty: all of them
  int lane = 0;
  std::optional<OtherSide> other{}; ///< needed by what `showing` says
  Showing showing = Showing::First;
  int divider = 0;           ///< of a wipe: so many columns at the left are of this side
  int referenceSamples = 64; ///< of the sides that are rows of the reference
};

/// Of the picture, px.
inline glm::ivec2 writtenSize(const PictureRequest& request) {
  return request.part.width > 0 ? glm::ivec2(request.part.width, request.part.height)
                                : glm::ivec2(request.width, request.height);
}

/// Whether the other side is seen.
inline bool showsOther(const PictureRequest& request) {
  return request.other && request.showing != Showing::First;
}

/// Lane and frame of a comparison, and its row, which is `id` where it says none. `presetLane`: the lane of
/// its preset.
OtherSide otherSideOf(const Comparison& comparison, IntermediateId id, int presetLane);

/// Where the other side is looked for while the inspector is at `frame` of `frameCount`.
PictureSource otherSource(const OtherSide& other, int frame, int frameCount);

/// Throws Error where there is no difference: one of the rows has more channels.
void checkDifference(IntermediateId id, IntermediateId other);

/// `first` in the columns left of `divider`, `other` in the rest; both have the same size.
Picture wiped(const Picture& first, const Picture& other, int divider);

/// Makes what it lacks first: the frame of the other side, references. Throws Error, Cancelled.
Picture shownPicture(Inspector& inspector, const PictureRequest& request, const Progress& progress = {});

/// The values of both sides' difference, of the whole picture, whatever is shown of them. Expects an other
/// side. As shownPicture().
PartialImage shownDifference(Inspector& inspector, const PictureRequest& request,
                             const Progress& progress = {});

} // namespace taa
