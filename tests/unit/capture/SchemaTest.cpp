// The schema of capture.json: as it lies beside the header, and of one mind with what is read.
#include "core/capture/format/Schema.h"
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/capture/format/Manifest.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace taa::capture {
namespace {

using nlohmann::json;

const json& schema() {
  static const json kSchema = json::parse(schemaText());
  return kSchema;
}

bool isOfType(const json& value, const json& types) {
  if (types.is_array())
    return std::ranges::any_of(types, [&](const json& type) { return isOfType(value, type); });
  const std::string type = types.get<std::string>();
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  return value.is_number();
}

bool accepts(const json& rule, const json& value);
bool acceptsText(const json& rule, const std::string& text);

bool acceptsObject(const json& rule, const json& value) {
  for (const json& key : rule.value("required", json::array()))
    if (!value.contains(key.get<std::string>())) return false;
  const json dependent = rule.value("dependentRequired", json::object());
  for (const auto& [key, others] : dependent.items())
    for (const json& other : others)
      if (value.contains(key) && !value.contains(other.get<std::string>())) return false;
  if (rule.contains("not") && accepts(rule["not"], value)) return false;
  const json schemas = rule.value("dependentSchemas", json::object());
  for (const auto& [key, other] : schemas.items())
    if (value.contains(key) && !accepts(other, value)) return false;
  for (const auto& [key, member] : value.items()) {
    if (rule.contains("propertyNames") && !acceptsText(rule["propertyNames"], key)) return false;
    const json properties = rule.value("properties", json::object());
    if (properties.contains(key) ? !accepts(properties[key], member)
                                 : rule.value("additionalProperties", json(true)) == false)
      return false;
  }
  return true;
}

bool acceptsList(const json& rule, const json& value) {
  if (value.size() < rule.value("minItems", std::size_t(0))) return false;
  if (value.size() > rule.value("maxItems", value.size())) return false;
  for (const json& item : value)
    if (rule.contains("items") && !accepts(rule["items"], item)) return false;
  return true;
}

bool acceptsText(const json& rule, const std::string& text) {
  if (rule.contains("maxLength") && text.size() > rule["maxLength"].get<std::size_t>()) return false;
  return !rule.contains("pattern") ||
         std::regex_search(text, std::regex(rule["pattern"].get<std::string>(), std::regex::ECMAScript));
}

/// As much of draft 2020-12 as the schema uses; lengths of texts are bytes here.
bool accepts(const json& rule, const json& value) {
  if (rule.contains("$ref")) {
    const std::string name = rule["$ref"].get<std::string>().substr(std::string("#/$defs/").size());
    if (!accepts(schema().at("$defs").at(name), value)) return false;
  }
  if (rule.contains("type") && !isOfType(value, rule["type"])) return false;
  if (rule.contains("const") && value != rule["const"]) return false;
  if (rule.contains("enum") && rule["enum"].find(value) == rule["enum"].end()) {
    bool isOne = false;
    for (const json& choice : rule["enum"]) isOne = isOne || choice == value;
    if (!isOne) return false;
  }
  if (rule.contains("anyOf")) {
    bool isAny = false;
    for (const json& other : rule["anyOf"]) isAny = isAny || accepts(other, value);
    if (!isAny) return false;
  }
  if (value.is_number() && rule.contains("minimum"))
    if (value < rule["minimum"] || value > rule["maximum"]) return false;
  if (value.is_string() && !acceptsText(rule, value)) return false;
  if (value.is_object()) return acceptsObject(rule, value);
  return !value.is_array() || acceptsList(rule, value);
}

bool isRead(const json& value) {
  try {
    parseManifest(value.dump(), "it");
  } catch (const Error&) {
    return false;
  }
  return true;
}

json smallest() {
  return {{"format", 1},
          {"size", {480, 270}},
          {"planes", {{"color", {{"file", "c.{frame}.exr"}}}}},
          {"frames", {{{"number", 0}, {"jitter", {0, 0.5}}}}}};
}

/// The smallest with one value elsewhere, by its JSON pointer.
json with(const char* place, const json& value) {
  json manifest = smallest();
  manifest[json::json_pointer(place)] = value;
  return manifest;
}

} // namespace

TEST(Schema, IsTheFileThatIsShipped) {
  if (readFile("resources/capture/capture.schema.json") == schemaText()) return;
  const std::filesystem::path made = std::filesystem::path(testing::TempDir()) / "capture.schema.json";
  writeFile(made, schemaText());
  ADD_FAILURE() << "resources/capture/capture.schema.json is old: put " << made << " there";
}

TEST(Schema, HasEveryConventionWithItsChoices) {
  for (const Convention& row : conventions()) {
    json::json_pointer place("/properties/conventions/properties");
    const std::string path(row.path);
    if (const std::size_t dot = path.find('.'); dot != std::string::npos)
      place = place / path.substr(0, dot) / "properties" / path.substr(dot + 1);
    else
      place /= path;
    ASSERT_TRUE(schema().contains(place)) << path;
    const json& rule = schema()[place];
    for (const ConventionChoice& choice : row.choices)
      EXPECT_TRUE(accepts(rule, std::string(choice.id))) << path << " " << choice.id;
    EXPECT_FALSE(accepts(rule, "something else")) << path;
    EXPECT_EQ(accepts(rule, 0.5),
              row.kind == ConventionKind::Number || row.kind == ConventionKind::OptionalNumber)
        << path;
    EXPECT_EQ(accepts(rule, true), row.kind == ConventionKind::Toggle) << path;
    EXPECT_EQ(accepts(rule, "none"),
              row.kind == ConventionKind::OptionalNumber || row.kind == ConventionKind::OptionalChoice)
        << path;
  }
}

TEST(Schema, TakesWhatIsRead) {
  std::vector<json> manifests = {
      smallest(),
      with("/$schema", "capture.schema.json"),
      with("/like", "babylon"),
      with("/conventions", {{"motion", {{"notWritten", 0}, {"fallback", "zero"}}}, {"rows", "bottomFirst"}}),
      with("/conventions", {"motion.notWritten=0", "motion.fallback=zero", "rows=bottomFirst"}),
      with("/planes/depth", {{"file", "d.raw"}, {"raw", "D32F"}, {"size", {480, 270}}, {"rowPitch", 1920}}),
      with("/planes/depth", {{"file", "d.exr"}, {"at", {40, 0}}}),
      with("/objects", {{"7", "door"}}),
      with("/planes/color/file", "...a/..b/{frame}.{frame:4}.exr"),
      with("/notes", {"A sentence."}),
  };
  for (const StartingPoint& point : startingPoints()) {
    Manifest manifest = parseManifest(smallest().dump(), "it");
    manifest.conventions = point.conventions;
    manifests.push_back(json::parse(manifestText(manifest)));
  }
  for (const json& manifest : manifests) {
    EXPECT_TRUE(accepts(schema(), manifest)) << manifest.dump();
    EXPECT_TRUE(isRead(manifest)) << manifest.dump();
  }
}

TEST(Schema, RefusesWhatIsNotRead) {
  for (const json& manifest : {
           json::object(),
           with("/format", 2),
           with("/size", {480}),
           with("/size", {480, 0}),
           with("/frames", json::array()),
           with("/frames/0/number", -1),
           with("/frames/0/jitter", {0, 0, 0}),
           with("/frames/0/view", json::array()),
           with("/frames/0/naem", ""),
           with("/like", "somebody"),
           with("/conventions", {{"motion", {{"direction", "there"}}}}),
           with("/conventions", {{"sound", json::object()}}),
           with("/planes/sound", {{"file", "s"}}),
           with("/planes/depth", {{"raw", "R32F"}}),
           with("/planes/depth", {{"file", "d"}, {"raw", "float"}}),
           with("/planes/depth", {{"file", "d"}, {"rowPitch", 4}}),
           with("/planes/depth", {{"file", "d"}, {"raw", "R32F"}, {"part", "x"}}),
           with("/planes/depth", {{"file", "d"}, {"raw", "R32F"}, {"channels", {"Z"}}}),
           with("/planes/color/file", ""),
           with("/planes/color/file", "/etc/passwd"),
           with("/planes/color/file", "C:/a.exr"),
           with("/planes/color/file", "a/"),
           with("/planes/color/file", "a\\b"),
           with("/planes/color/file", ".."),
           with("/planes/color/file", "a/../../b"),
           with("/planes/color/file", "{name}"),
           with("/planes/color/file", "{frame:0}"),
           with("/planes/color/file", "{frame"),
           with("/name", std::string(4097, 'x')),
           with("/objects", {{"0", "door"}}),
           with("/objects", {{"07", "door"}}),
           with("/frames/0/jitter", {0, 1e7}),
           with("/conventions", json::object({{"motion.unit", "uv"}})),
           with("/conventions", {"motion.unit"}),
           with("/conventions", {"motionXunit=uv"}),
           with("/conventions", {"motion.unit="}),
           with("/conventions", {7}),
           with("/conventions", "motion.unit=uv"),
       }) {
    EXPECT_FALSE(accepts(schema(), manifest)) << manifest.dump();
    EXPECT_FALSE(isRead(manifest)) << manifest.dump();
  }
}

} // namespace taa::capture
