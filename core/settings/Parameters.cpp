#include "core/settings/Parameters.h"

#include "core/base/Error.h"
#include "core/base/NearestNames.h"
#include "core/base/NumberText.h"
#include "core/base/OldNames.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <system_error>

namespace taa {

namespace {

/// The refusal of a path that no parameter has, with the three that are spelled most like it.
std::string unknownPath(std::string_view path) {
  std::vector<std::string_view> paths;
  for (const Parameter& row : parameters()) paths.push_back(row.path);
  const std::vector<std::string_view> near = nearestNames(path, paths, 3);
  return say<"there is no parameter \"%1\"; near it are %2, %3 or %4">(shownText(path), near[0], near[1],
                                                                       near[2]);
}

/// Paths as earlier versions wrote them. They are read for one version more.
constexpr std::array<OldName, 4> kOldPaths{{{"rectify.mostSteps", "rectify.maxSteps"},
                                            {"rectify.leastStrength", "rectify.minStrength"},
                                            {"weight.most", "weight.sourceMax"},
                                            {"weight.least", "weight.sourceMin"}}};

std::string idsOf(const Parameter& row) {
  std::string ids;
  for (const Choice& choice : row.choices) ids += (ids.empty() ? "" : ", ") + std::string(choice.id);
  return ids;
}

[[noreturn]] void refuseValue(const Parameter& row, std::string_view given) {
  const std::string text = shownText(given);
  if (row.kind == ParameterKind::Choice)
    throw Error(say<"cannot set %1 to \"%2\": give one of %3">(row.path, text, idsOf(row)));
  if (row.kind == ParameterKind::Toggle)
    throw Error(say<"cannot set %1 to \"%2\": give on or off">(row.path, text));
  const std::string least = valueText(row, row.minimum), most = valueText(row, row.maximum);
  if (row.kind == ParameterKind::Integer)
    throw Error(say<"cannot set %1 to \"%2\": give an integer from %3 to %4">(row.path, text, least, most));
  throw Error(say<"cannot set %1 to \"%2\": give a number from %3 to %4">(row.path, text, least, most));
}

// Index of the choice, or −1.
int choiceIndex(const Parameter& row, std::string_view id) {
  const auto found = std::ranges::find(row.choices, id, &Choice::id);
  return found == row.choices.end() ? -1 : static_cast<int>(found - row.choices.begin());
}

double parseNumber(const Parameter& row, std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) refuseValue(row, text);
  // What is stored is a float; 0.1 must be the float 0.1 wherever it is compared.
  if (row.kind == ParameterKind::Number) value = static_cast<double>(static_cast<float>(value));
  if (row.kind == ParameterKind::Integer && value != std::floor(value)) refuseValue(row, text);
  if (!(value >= static_cast<double>(static_cast<float>(row.minimum)) && value <= row.maximum))
    refuseValue(row, text);
  return value;
}

// "rectify.method" → "RectifyMethod" or "rectifyMethod".
std::string joinedName(std::string_view path, bool capital) {
  std::string name;
  for (char letter : path) {
    if (letter == '.') {
      capital = true;
      continue;
    }
    name += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
    capital = false;
  }
  return name;
}

bool isProgramConstant(const Parameter& row) {
  return row.effect == Effect::Program || row.effect == Effect::Storage || row.effect == Effect::Whole;
}

bool changesDrawing(const Parameter& row) {
  return row.effect == Effect::Inputs || row.effect == Effect::Whole;
}

nlohmann::json jsonValue(const Parameter& row, double value) {
  switch (row.kind) {
  case ParameterKind::Choice:
    return valueText(row, value);
  case ParameterKind::Toggle:
    return value != 0.0;
  case ParameterKind::Integer:
    return static_cast<int>(value);
  case ParameterKind::Number:
    return nlohmann::json::parse(valueText(row, value)); // the shortest decimal, not the double's
  }
  return {};
}

// What the row uses at this value.
const Uses& usedBy(const Parameter& row, double value) {
  if (row.kind == ParameterKind::Choice) return row.choices[static_cast<std::size_t>(value)].uses;
  const bool isFirst = row.kind == ParameterKind::Toggle ? value != 0.0 : value < row.maximum;
  return isFirst ? row.uses : row.usesOtherwise;
}

bool usesEver(const Parameter& row, Field field) {
  return row.uses.contains(field) || row.usesOtherwise.contains(field) ||
         std::ranges::any_of(row.choices,
                             [field](const Choice& choice) { return choice.uses.contains(field); });
}

// The rows that use it with some value, from a table that is made once.
const std::vector<const Parameter*>& usersOf(const Parameter& row) {
  static const auto kUsers = [] {
    std::vector<std::vector<const Parameter*>> users;
    for (const Parameter& used : parameters()) {
      users.emplace_back();
      for (const Parameter& user : parameters())
        if (usesEver(user, used.field)) users.back().push_back(&user);
    }
    return users;
  }();
  return kUsers[static_cast<std::size_t>(&row - parameters().data())];
}

// With which values `user` uses the row: "path=choice|choice" or "path<number".
std::string condition(const Parameter& user, const Parameter& row) {
  const std::string path(user.path);
  if (user.kind == ParameterKind::Toggle) return path + (user.uses.contains(row.field) ? "=on" : "=off");
  if (user.kind != ParameterKind::Choice)
    return path + (user.uses.contains(row.field) ? "<" : "=") + valueText(user, user.maximum);
  std::string ids;
  for (const Choice& choice : user.choices)
    if (choice.uses.contains(row.field)) ids += (ids.empty() ? "" : "|") + std::string(choice.id);
  return path + "=" + ids;
}

/// Whether a parameter's path begins with it and a dot.
bool isGroup(std::string_view name) {
  return std::ranges::any_of(parameters(), [name](const Parameter& row) {
    return row.path.starts_with(name) && row.path.substr(name.size()).starts_with('.');
  });
}

double valueFromJson(const Parameter& row, const nlohmann::json& json) {
  if (row.kind == ParameterKind::Toggle && json.is_boolean()) return json.get<bool>() ? 1.0 : 0.0;
  if (row.kind == ParameterKind::Choice && json.is_string()) return parseValue(row, json.get<std::string>());
  const bool wantsNumber = row.kind == ParameterKind::Integer || row.kind == ParameterKind::Number;
  if (wantsNumber && json.is_number()) return parseNumber(row, json.dump());
  refuseValue(row, json.is_string() ? json.get<std::string>() : json.dump());
}

} // namespace

const Parameter& parameter(std::string_view path) {
  const auto rows = parameters();
  const OldName* old = findOldName(kOldPaths, path);
  const auto found = std::ranges::find(rows, old ? old->now : path, &Parameter::path);
  if (found == rows.end()) throw Error(unknownPath(path));
  return *found;
}

bool isRelevant(const Parameter& row, const Settings& settings) {
  const auto& users = usersOf(row);
  return users.empty() || std::ranges::any_of(users, [&](const Parameter* user) {
           return usedBy(*user, user->get(settings)).contains(row.field) && isRelevant(*user, settings);
         });
}

std::string relevantWhen(const Parameter& row) {
  std::string text;
  for (const Parameter* user : usersOf(row)) text += (text.empty() ? "" : " or ") + condition(*user, row);
  return text;
}

std::string valueText(const Parameter& row, double value) {
  switch (row.kind) {
  case ParameterKind::Choice:
    return std::string(row.choices[static_cast<std::size_t>(value)].id);
  case ParameterKind::Toggle:
    return value != 0.0 ? "on" : "off";
  case ParameterKind::Integer:
    return std::to_string(static_cast<long long>(value));
  case ParameterKind::Number:
    break;
  }
  return shortestText(static_cast<float>(value));
}

double parseValue(const Parameter& row, std::string_view text) {
  switch (row.kind) {
  case ParameterKind::Choice:
    if (const int index = choiceIndex(row, text); index >= 0) return index;
    refuseValue(row, text);
  case ParameterKind::Toggle:
    if (text == "on" || text == "true" || text == "1") return 1.0;
    if (text == "off" || text == "false" || text == "0") return 0.0;
    refuseValue(row, text);
  case ParameterKind::Integer:
  case ParameterKind::Number:
    return parseNumber(row, text);
  }
  refuseValue(row, text);
}

namespace {

/// What is said of a row that was found by this path; nothing where it is its own.
std::vector<std::string> notesOf(const Parameter& row, std::string_view path) {
  if (row.path == path) return {};
  return {oldNameNote({path, row.path})};
}

} // namespace

std::vector<std::string> applyAssignment(Settings& settings, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw Error(
        say<"cannot read \"%1\": write path=value, for example rectify.method=clamp">(shownText(assignment)));
  const std::string_view path = assignment.substr(0, equals);
  const Parameter& row = parameter(path);
  row.set(settings, parseValue(row, assignment.substr(equals + 1)));
  return notesOf(row, path);
}

std::vector<std::string> differences(const Settings& settings, const Settings& base) {
  std::vector<std::string> assignments;
  for (const Parameter& row : parameters())
    if (row.get(settings) != row.get(base))
      assignments.push_back(std::string(row.path) + "=" + valueText(row, row.get(settings)));
  return assignments;
}

nlohmann::json toJson(const Settings& settings) {
  nlohmann::json json;
  for (const Parameter& row : parameters()) {
    const std::size_t dot = row.path.find('.');
    json[std::string(row.path.substr(0, dot))][std::string(row.path.substr(dot + 1))] =
        jsonValue(row, row.get(settings));
  }
  return json;
}

std::vector<std::string> fromJson(const nlohmann::json& json, Settings& settings) {
  if (!json.is_object()) throw Error(say<"cannot read settings: expected an object of groups">());
  Settings changed = settings;
  std::vector<std::string> notes;
  for (const auto& [group, rows] : json.items()) {
    if (!rows.is_object())
      throw Error(say<"cannot read settings: \"%1\" is not a group of parameters">(shownText(group)));
    if (rows.empty() && !isGroup(group)) throw Error(unknownPath(group));
    for (const auto& [name, value] : rows.items()) {
      const std::string path = group + "." + name;
      const Parameter& row = parameter(path);
      addNotes(notes, notesOf(row, path));
      row.set(changed, valueFromJson(row, value));
    }
  }
  settings = changed;
  return notes;
}

bool operator==(const Settings& a, const Settings& b) {
  return std::ranges::all_of(parameters(), [&](const Parameter& row) { return row.get(a) == row.get(b); });
}

std::string glslPrelude(const Settings& settings) {
  std::string text;
  std::string block;
  for (const Parameter& row : parameters()) {
    const std::string name = "k" + joinedName(row.path, true);
    const int value = static_cast<int>(row.get(settings));
    if (isProgramConstant(row) && row.kind == ParameterKind::Toggle)
      text += "const bool " + name + " = " + (value ? "true" : "false") + ";\n";
    if (isProgramConstant(row) && row.kind == ParameterKind::Choice) {
      text += "const int " + name + " = " + std::to_string(value) + ";\n";
      for (std::size_t i = 0; i < row.choices.size(); ++i)
        text +=
            "const int " + name + "_" + std::string(row.choices[i].id) + " = " + std::to_string(i) + ";\n";
    }
    if (row.effect == Effect::Uniform)
      block += std::string(row.kind == ParameterKind::Integer ? "  int " : "  float ") +
               joinedName(row.path, false) + ";\n";
  }
  text += std::string("const bool kUpsampled = ") + (isUpsampled(settings) ? "true" : "false") + ";\n";
  return text + "layout(std140, binding = 1) uniform SettingsBlock {\n" + block + "} settings;\n";
}

std::string programKey(const Settings& settings) {
  std::string key = isUpsampled(settings) ? "upsampled " : "";
  for (const Parameter& row : parameters())
    if (isProgramConstant(row)) key += valueText(row, row.get(settings)) + " ";
  return key;
}

std::vector<std::byte> settingsBlock(const Settings& settings) {
  std::vector<std::byte> bytes;
  for (const Parameter& row : parameters()) {
    if (row.effect != Effect::Uniform) continue;
    const auto number = static_cast<float>(row.get(settings));
    const auto integer = static_cast<std::int32_t>(row.get(settings));
    const void* value = row.kind == ParameterKind::Integer ? static_cast<const void*>(&integer) : &number;
    bytes.resize(bytes.size() + 4);
    std::memcpy(bytes.data() + bytes.size() - 4, value, 4);
  }
  bytes.resize((bytes.size() + 15) / 16 * 16);
  return bytes;
}

bool sameInputs(const Settings& a, const Settings& b) {
  return std::ranges::all_of(
      parameters(), [&](const Parameter& row) { return !changesDrawing(row) || row.get(a) == row.get(b); });
}

} // namespace taa
