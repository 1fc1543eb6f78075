#include "core/base/json/JsonFields.h"

#include "core/base/Error.h"
#include "core/base/NearestNames.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace taa {

using nlohmann::json;

std::string pathOf(const std::string& place, std::string_view key) {
  return place.empty() ? std::string(key) : place + "." + std::string(key);
}

std::string elementOf(const std::string& place, std::size_t index) {
  return place + "[" + std::to_string(index) + "]";
}

std::string placeName(const std::string& place) {
  return place.empty() ? say<"what the file holds">() : "\"" + place + "\"";
}

void requireObject(const json& value, const std::string& place) {
  if (!value.is_object()) throw Error(say<"%1 is not an object">(placeName(place)));
}

void requireList(const json& value, const std::string& place, std::size_t most) {
  if (!value.is_array()) throw Error(say<"%1 is not a list">(placeName(place)));
  if (value.size() > most)
    throw Error(say<"%1 has %2 entries, more than the %3 allowed">(placeName(place), value.size(), most));
}

void requireKeys(const json& object, const std::string& place, std::span<const std::string_view> known) {
  requireObject(object, place);
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::string_view near = nearestNames(key, known, 1).front();
    throw Error(say<"there is no key \"%1\"; near it is \"%2\"">(pathOf(place, shownText(key)), near));
  }
}

const json* findField(const json& object, std::string_view key) {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

const json& requireField(const json& object, std::string_view place, std::string_view key) {
  requireObject(object, std::string(place));
  const json* const found = findField(object, key);
  if (!found) throw Error(say<"the key \"%1\" is missing">(pathOf(std::string(place), key)));
  return *found;
}

void requireFormat(const json& object, int known) {
  if (const json& format = requireField(object, "", "format"); format != known)
    throw Error(say<"its format is %1, this program reads %2">(shownText(format.dump()), known));
}

std::string textOf(const json& value, const std::string& place) {
  if (!value.is_string()) throw Error(say<"\"%1\" is not text">(place));
  return value.get<std::string>();
}

bool toggleOf(const json& value, const std::string& place) {
  if (!value.is_boolean()) throw Error(say<"\"%1\" is not true or false">(place));
  return value.get<bool>();
}

double numberOf(const json& value, const std::string& place) {
  if (!value.is_number()) throw Error(say<"\"%1\" is not a number">(place));
  return value.get<double>();
}

long long integerOf(const json& value, const std::string& place, long long least, long long most) {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(number >= static_cast<double>(least) && number <= static_cast<double>(most)) ||
      number != std::floor(number))
    throw Error(say<"\"%1\" wants a whole number from %2 to %3">(place, least, most));
  return static_cast<long long>(number);
}

} // namespace taa
