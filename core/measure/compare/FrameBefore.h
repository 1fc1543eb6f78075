// A row of the frame before, read where each pixel of this frame came from, and what it is less than now. No
// GL.
//
// The place is the history position q of the row historyPosition (manual §5). Values are read bilinearly, as
// a + f·(b − a) along x and then y, so that a constant and a move by whole pixels keep their bits. The
// nearest texel alone is read of indices and masks, and where one of the four stands for nothing: the sky in
// a depth, what has no previous position in a motion.
#pragma once

#include "core/base/Image.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <string>

namespace taa {

/// Why there is no value.
enum class Absence : std::uint8_t {
  None, ///< there is one
  FirstFrame,
  Cut,
  NoHistory,   ///< a row that tells of history, of a frame that has none
  NoReference, ///< a row of the reference, of a frame that has none
  NoPreviousPosition,
  OffScreen
};
/// "off screen", …; empty where there is one.
std::string absenceText(Absence absence);

/// A value of a row, missing channels 0; NaN where there is none.
struct PartialValue {
  glm::vec4 value{0.0f};
  Absence absence = Absence::None;
};
PartialValue absentValue(Absence absence);

/// Values of a part of a picture, NaN where there are none, and there an Absence as a number in `absence`, of
/// one channel; empty: there are values everywhere.
struct PartialImage {
  Image values, absence;
};
PartialImage absentImage(const Intermediate& row, const glm::ivec2& sizePx, Absence absence);
/// Columns and rows from `firstPx` on.
PartialImage partOf(const PartialImage& image, const glm::ivec2& firstPx, const glm::ivec2& sizePx);

/// Why nothing can be read at a pixel's history position; NaN is off screen. `dilatedMotion`: of that pixel.
Absence absenceAt(const glm::vec2& historyPosition, const glm::vec2& dilatedMotion,
                  const glm::ivec2& picturePx);

/// The texels around a position: (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1) from firstTap() on, the
/// nearest ones inside the picture.
using Taps = std::array<glm::vec4, 4>;
glm::ivec2 firstTap(const glm::vec2& position);
/// What they give at the position (px).
glm::vec4 valueBetween(const Intermediate& row, const Taps& taps, const glm::vec2& position);

/// The row at the history positions of the frame after it; all of one size, values with the row's channels.
PartialImage rowBefore(const Intermediate& row, const Image& before, const Image& historyPosition,
                       const Image& dilatedMotion);

/// `now` less `other`. There is none where either is absent, or has no previous position.
PartialValue differenceOf(const Intermediate& row, const PartialValue& now, const PartialValue& other);
PartialImage differenceOf(const Intermediate& row, const PartialImage& now, const PartialImage& other);

} // namespace taa
