// What is lacking in the motion of a whole picture, measured: it grows, turns and shifts about its middle, as
// it does where a camera zooms, rolls or looks elsewhere, whatever the depth of what is seen.
#pragma once

#include "core/doctor/FrameNames.h"
#include "core/doctor/flow/Refuted.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace taa::doctor {

/// By least squares over the squares of a pair of frames, of what they move by less what is given.
struct PictureChange {
  double growth = 0.0;                   ///< 0.03: 3 % larger than in the frame before
  double turn = 0.0;                     ///< radians, clockwise as one sees it
  double error = 0.0;                    ///< standard error of both
  glm::dvec2 shiftPx{0.0};               ///< of the middle
  std::size_t squares = 0, followed = 0; ///< that were asked; that lie within the tolerance

  /// Whether nearly all follow it, and it is known well.
  bool isGood() const;
  /// Whether it grows or shrinks about its middle, and does no more.
  bool isZoom(const glm::ivec2& sizePx) const;
};
std::optional<PictureChange> changeOf(const std::vector<const FlowSquare*>& squares, const glm::ivec2& sizePx,
                                      double tolerancePx);

/// By frame; nothing of one whose squares lie in one place.
using PictureChanges = std::map<int, std::optional<PictureChange>>;
/// Of frames whose squares in the regions that are refuted are enough to tell.
PictureChanges changesOf(const std::vector<Refuted>& refuted, const FlowSeen& seen, const glm::ivec2& sizePx,
                         double tolerancePx);

/// Whether nearly all frames zoom.
bool areZooms(const PictureChanges& changes, const glm::ivec2& sizePx);
/// By how much, in a sentence. Expects zooms.
std::string zoomText(const PictureChanges& changes);
/// What is lacking in the frame in which that is most, in a sentence; empty where many frames follow no such
/// change.
std::string changeText(const PictureChanges& changes, const FrameNames& names);

} // namespace taa::doctor
