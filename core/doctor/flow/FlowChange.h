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

/// By frame, of those whose squares of the regions that are refuted are enough to tell.
std::map<int, std::optional<PictureChange>> changesOf(const std::vector<Refuted>& refuted,
                                                      const FlowSeen& seen, const glm::ivec2& sizePx,
                                                      double tolerancePx);
/// Whether nearly all frames zoom; a sentence on how, and another one on what else is lacking where they
/// do not; empty where nearly all frames follow no such change.
bool areZooms(const std::map<int, std::optional<PictureChange>>& changes, const glm::ivec2& sizePx);
std::string zoomText(const std::map<int, std::optional<PictureChange>>& changes);
std::string changeText(const std::map<int, std::optional<PictureChange>>& changes, const FrameNames& names);

} // namespace taa::doctor
