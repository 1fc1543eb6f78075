// Rows of the frame before the one on show, each pixel where it came from
// (core/measure/compare/FrameBefore.h).
#pragma once

#include "core/gl/Texture.h"
#include "core/measure/compare/FrameBefore.h"
#include "core/picture/PictureSource.h"
#include "core/replay/Checkpoints.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <map>
#include <memory>
#include <utility>

namespace taa {

class ShotPlayer;
struct ShotState;

/// Why nothing of a row can be read in the frame before `frame`; None where something can.
Absence absenceBefore(const ShotState& state, int frame, IntermediateId id);

/// The rows that say where pixels came from.
inline constexpr IntermediateId kPlacesBefore[] = {IntermediateId::historyPosition,
                                                   IntermediateId::dilatedMotion};

/// Kept while neither frame changes. Expects sources along the motion whose frame is on show or a comparison
/// frame.
class RowsBefore {
 public:
  explicit RowsBefore(ShotPlayer& player) : player_(player) {}

  /// Of the whole picture.
  const PartialImage& values(const PictureSource& source);
  /// For the Visualizer: the row's channels, in the fourth one an Absence as a number. Valid until another is
  /// asked for.
  const gl::Texture& texture(const PictureSource& source);

 private:
  struct Origin {
    std::weak_ptr<const History> now, before; ///< of both frames; they may end meanwhile
    Settings settings;
    int frame = 0;
  };
  struct Kept {
    Origin origin;
    PartialImage values;
    gl::Texture texture; ///< made when first shown
  };
  bool isOf(const Origin& origin, const PictureSource& source) const;
  Kept& kept(const PictureSource& source);
  PartialImage made(const PictureSource& source);

  ShotPlayer& player_;
  std::map<std::pair<int, IntermediateId>, Kept> kept_; // by lane and row
};

} // namespace taa
