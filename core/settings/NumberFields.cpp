#include "core/settings/NumberFields.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace taa {

const float* fieldOf(const Parameter& number, const Settings& settings) {
  assert(number.kind == ParameterKind::Number);
  const auto* bytes = reinterpret_cast<const std::byte*>(&settings);  // NOLINT: Field says where a field lies
  return reinterpret_cast<const float*>(bytes + number.field.offset); // NOLINT
}

const Parameter* numberAt(const float* field, const Settings& settings) {
  const auto row = std::ranges::find_if(parameters(), [&](const Parameter& each) {
    return each.kind == ParameterKind::Number && fieldOf(each, settings) == field;
  });
  return row == parameters().end() ? nullptr : &*row;
}

} // namespace taa
