// Frames in a row that rows over time are made of, as far as they are made.
#pragma once

#include "core/measure/DrawnSurfaces.h"
#include "core/measure/Flicker.h"
#include "core/replay/TraceCursor.h"
#include "core/taa/Intermediates.h"
#include "core/verdict/parts/FrameErrors.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <map>
#include <span>

namespace taa {

struct FrameOverTime {
  FlickerFrame flicker; ///< its steps are those of the errors, too
  FrameErrors errors;
  int errorSamples = 0; ///< of the references that they are against; 0: there are none
};

/// The next frame needs one more.
struct FrameWindow {
  std::map<int, FrameOverTime> frames;
  std::map<int, Image> references; ///< scene-linear, of frames whose errors or whose next frame's are made
  int referenceSamples = 0;        ///< of those
  TraceCursor cursor;              ///< where the resolve has come to
  DrawnSurfaces seen;

  /// Gives up frames that are not among `first` to `last`.
  void keepOnly(int first, int last);
};

/// Bytes of main memory that the frames of one lane take for what is measured.
std::size_t windowBytes(const glm::ivec2& picturePx, int frames, std::span<const OverTime> kinds);

} // namespace taa
