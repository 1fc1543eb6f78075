// What the resolve of a frame was given, as the CPU twin reads it.
#pragma once

#include "core/gl/Texture.h"
#include "core/render/FrameInputs.h"
#include "core/taa/History.h"
#include "core/taa/twin/Twin.h"

#include <cstdint>
#include <functional>

namespace taa {

enum class TwinReading : std::uint8_t {
  Whole, ///< downloaded now: the textures may go
  Parts  ///< tile by tile where the twin looks: the textures must stay as long as it does
};

/// Empty where there is no texture.
twin::Texels twinTexels(const gl::Texture& texture, TwinReading reading);
/// All but what it resolved to. `previous`: the history it was resolved on, or nothing.
twin::Inputs twinInputs(const FrameInputs& inputs, const History* previous, TwinReading reading);
/// In parts, of inputs that are drawn where they are read: `readDrawn` reads a part of one of their textures.
twin::Inputs
twinInputs(const FrameInputs& inputs, const History* previous,
           const std::function<Image(const gl::Texture& texture, const gl::Rect& part)>& readDrawn);

} // namespace taa
