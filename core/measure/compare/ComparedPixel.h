// All rows of a pixel beside those of what it is compared with. No GL.
#pragma once

#include "core/measure/compare/FrameBefore.h"
#include "core/taa/twin/Twin.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace taa {

/// The other side of a pixel.
struct ComparedPixel {
  int frame = 0, lane = 0;
  std::optional<glm::vec2> position{}; ///< along the motion: where it is read, px; nothing: at the pixel
  std::array<PartialValue, kIntermediateCount> other{};

  const PartialValue& of(IntermediateId id) const { return other[static_cast<std::size_t>(id)]; }
};

/// What a record says of a row, or why it says nothing.
PartialValue valueIn(const twin::PixelRecord& record, IntermediateId id);
/// The same at a position (px) between the records of the texels that Taps says.
PartialValue valueBetween(std::span<const twin::PixelRecord, 4> taps, const glm::vec2& position,
                          IntermediateId id);
/// What a row is more than on the other side.
PartialValue differenceOf(const twin::PixelRecord& now, const ComparedPixel& compared, IntermediateId id);

} // namespace taa
