// Values of conventions as texts and back, by the row of the table.
#pragma once

#include "core/base/NumberText.h"
#include "core/capture/format/Conventions.h"

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace taa::capture {

/// Throws Error naming path, text and what is allowed.
[[noreturn]] void refuseValue(const Convention& row, std::string_view text);

/// The number of a choice. Throws Error.
std::size_t choiceIndex(const Convention& row, std::string_view text);
bool parseToggle(const Convention& row, std::string_view text);
/// Finite, within the row's limits, whole where the row wants it. Throws Error.
double parseNumber(const Convention& row, std::string_view text);

template <typename Value>
std::string valueText(const Convention& row, const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return std::string(row.choices[static_cast<std::size_t>(value)].id);
  else if constexpr (std::same_as<Value, bool>)
    return value ? "on" : "off";
  else
    return decimalText(static_cast<double>(value));
}
template <typename Value>
std::string valueText(const Convention& row, const std::optional<Value>& value) {
  return value ? valueText(row, *value) : "none";
}

template <typename Value>
void assignValue(const Convention& row, std::string_view text, Value& value) {
  if constexpr (std::is_enum_v<Value>)
    value = static_cast<Value>(choiceIndex(row, text));
  else if constexpr (std::same_as<Value, bool>)
    value = parseToggle(row, text);
  else
    value = static_cast<Value>(parseNumber(row, text));
}
template <typename Value>
void assignValue(const Convention& row, std::string_view text, std::optional<Value>& value) {
  if (text == "none") {
    value.reset();
    return;
  }
  Value given{};
  assignValue(row, text, given);
  value = given;
}

} // namespace taa::capture
