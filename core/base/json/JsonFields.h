// Fields of a JSON file that nobody has looked at, each with the path that messages name: "frames[3].jitter".
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace taa {

/// "planes" and "color" are "planes.color"; nothing and "size" are "size".
std::string pathOf(const std::string& place, std::string_view key);
/// "frames" and 3 are "frames[3]".
std::string elementOf(const std::string& place, std::size_t index);
/// As sentences call a path, in quotation marks; of an empty one that of the whole file in words.
std::string placeName(const std::string& place);

/// All throw Error that names `place`.
void requireObject(const nlohmann::json& value, const std::string& place);
void requireList(const nlohmann::json& value, const std::string& place, std::size_t most);
/// Of an object. An unknown key is named with the known ones that are spelled most like it.
void requireKeys(const nlohmann::json& object, const std::string& place,
                 std::span<const std::string_view> known);
/// Null where the key is not there.
const nlohmann::json* findField(const nlohmann::json& object, std::string_view key);
/// `place` is a view: with a temporary as reference g++ 14 takes the field, a reference too, for dangling.
const nlohmann::json& requireField(const nlohmann::json& object, std::string_view place,
                                   std::string_view key);

/// Of an object, its "format".
void requireFormat(const nlohmann::json& object, int known);

std::string textOf(const nlohmann::json& value, const std::string& place);
bool toggleOf(const nlohmann::json& value, const std::string& place);
double numberOf(const nlohmann::json& value, const std::string& place);
/// Whole, `least` to `most`.
long long integerOf(const nlohmann::json& value, const std::string& place, long long least, long long most);

} // namespace taa
