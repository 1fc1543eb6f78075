#include "core/measure/compare/ComparedPixel.h"

#include "core/taa/twin/Known.h"

#include <cstddef>

namespace taa {

PartialValue valueIn(const twin::PixelRecord& record, IntermediateId id) {
  if (twin::isKnown(record, id)) return {twin::at(record, id)};
  return absentValue(isOfReference(id) ? Absence::NoReference : Absence::NoHistory);
}

PartialValue valueBetween(std::span<const twin::PixelRecord, 4> taps, const glm::vec2& position,
                          IntermediateId id) {
  Taps values;
  for (std::size_t tap = 0; tap < values.size(); ++tap) {
    const PartialValue value = valueIn(taps[tap], id);
    if (value.absence != Absence::None) return value;
    values[tap] = value.value;
  }
  return {valueBetween(intermediate(id), values, position)};
}

PartialValue differenceOf(const twin::PixelRecord& now, const ComparedPixel& compared, IntermediateId id) {
  return differenceOf(intermediate(id), valueIn(now, id), compared.of(id));
}

} // namespace taa
