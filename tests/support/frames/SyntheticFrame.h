// Hand-made inputs and history of the resolve, as images and as textures.
#pragma once

#include "core/render/FrameInputs.h"
#include "core/taa/TaaPass.h"
#include "core/taa/twin/Twin.h"

#include <cstdint>

namespace taa::test {

struct FrameShape {
  int width = 97, height = 61; ///< of the picture
  Precision inputs = Precision::Half;
  Precision history = Precision::Half;
  glm::ivec2 drawnPx{0}; ///< size of the inputs; 0: that of the picture
  int drawnWidth() const { return drawnPx.x > 0 ? drawnPx.x : width; }
  int drawnHeight() const { return drawnPx.y > 0 ? drawnPx.y : height; }
};

/// The shape with the drawn size and the history of `settings`.
FrameShape shapeFor(const Settings& settings, FrameShape shape = {});

/// A frame without history whose colors are all `color`, at 5 m, at rest, object 1.
twin::Inputs flatFrame(const FrameShape& shape, float color);

/// Random colors over nine decades, depths with sky and edges, motion of all sizes, and a history to match.
/// `wild`: with NaN, Inf, negative and overflowing colors, NaN and huge motion, and the mark of no previous.
/// All values are as the textures of `shape` hold them.
twin::Inputs randomFrame(const FrameShape& shape, std::uint32_t seed, bool wild);

/// Random colors at rest at 5 m: what a still camera sees.
twin::Inputs stillFrame(const FrameShape& shape, std::uint32_t seed);

/// Textures of the images, in the formats of `shape`.
FrameInputs upload(const twin::Inputs& images, const FrameShape& shape);

/// The images' history; empty textures when they have none.
History uploadHistory(const twin::Inputs& images, const FrameShape& shape);

/// Sets `images`' history to what a resolve left.
void downloadHistory(const History& history, twin::Inputs& images);

} // namespace taa::test
