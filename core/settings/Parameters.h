// The one table of parameters: panel, JSON, --set, presets, GLSL, help and export headers are all derived
// from it.
#pragma once

#include "core/settings/Settings.h"
#include "core/settings/Stage.h"

#include <nlohmann/json_fwd.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

enum class ParameterKind : std::uint8_t { Choice, Toggle, Integer, Number };

/// A field of Settings, by where it lies in it.
struct Field {
  std::uint16_t offset; ///< bytes
  bool operator==(const Field&) const = default;
};

/// The fields that a choice, a switch or a number reads besides its own.
class Uses {
 public:
  template <std::same_as<Field>... Fields>
  constexpr explicit Uses(Fields... fields) : fields_{fields...}, count_(sizeof...(fields)) {}

  constexpr bool contains(Field field) const {
    return std::find(fields_.begin(), fields_.begin() + count_, field) != fields_.begin() + count_;
  }
  constexpr std::span<const Field> all() const { return std::span(fields_).first(count_); }

 private:
  std::array<Field, 6> fields_;
  std::size_t count_;
};

/// A technique: all that tables, panels and files know of it.
struct Choice {
  std::string_view id;    ///< in files and flags: "closest3x3"
  std::string_view label; ///< in the window: "Closest 3×3"
  std::string_view explanation;
  Uses uses; ///< settings that have an effect with this choice and none with choices that do not use them
  /// What carries it out, GLSL below shaders/taa and the same name in core/taa/twin: "clampToBox". Empty
  /// where nothing is done, and before the resolve, which has no twin.
  std::string_view function = {};
  /// By what weight that takes samples, where it does so for several choices: a function of the shaders or,
  /// of weights that are made once a frame, of core/taa/CurrentWeights.cpp. The twin's has the same
  /// name.
  std::string_view kernel = {};
};

/// What has to be done again when the parameter changes.
enum class Effect : std::uint8_t {
  Inputs,  ///< the scene is drawn differently (jitter, formats)
  Program, ///< a compile-time constant of the resolve
  Uniform, ///< a number in the resolve's settings block
  Storage, ///< the format of the history
  Whole,   ///< the scene is drawn differently, and a compile-time constant of the resolve
};

/// One row. Values travel as double: the enumerator's number, 0 or 1, an integer, or the float.
struct Parameter {
  std::string_view path; ///< "rectify.method"
  std::string_view label;
  Stage stage;
  ParameterKind kind;
  Effect effect;
  std::string_view unit = {};           ///< "px", "px²", "frames"; empty for none
  double minimum = 0.0, maximum = 1.0;  ///< of a choice by its choices
  std::span<const Choice> choices = {}; ///< Choice only
  std::string_view tooltip;             ///< what it does, in a sentence
  std::string_view formula = {};        ///< empty where there is none
  std::string_view source;              ///< row of the manual, and who
  Uses uses = Uses();                   ///< Toggle: where it is on; Number: below its maximum
  Field field;
  double (*get)(const Settings&);
  void (*set)(Settings&, double);
  Uses usesOtherwise = Uses(); ///< Toggle: where it is off; Number: at its maximum

  double defaultValue() const { return get(Settings{}); }
};

std::span<const Parameter> parameters();

/// The row of `path`, which may be one that the version before wrote. Throws Error that names the nearest
/// paths when there is none.
const Parameter& parameter(std::string_view path);

/// Whether the value of the row has any effect with these settings: no other row uses it, or one does that
/// has an effect itself and the value that uses it.
bool isRelevant(const Parameter& parameter, const Settings& settings);
/// That in a text: "path=choice|choice" or "path<number"; empty where it always has an effect.
std::string relevantWhen(const Parameter& parameter);

/// The value as files and flags write it: choice id, "on"/"off", integer, or the shortest decimal that reads
/// back.
std::string valueText(const Parameter& parameter, double value);
/// Reads what valueText writes. Throws Error naming path, text and what is allowed.
double parseValue(const Parameter& parameter, std::string_view text);
/// Applies "path=value". Throws Error. Returns a note where the path has another name by now.
std::vector<std::string> applyAssignment(Settings& settings, std::string_view assignment);
/// The assignments that turn `base` into `settings`.
std::vector<std::string> differences(const Settings& settings, const Settings& base);

/// {"jitter": {"sequence": "halton", …}, …}; every row.
nlohmann::json toJson(const Settings& settings);
/// Overwrites the rows that `json` names. Throws Error naming unknown keys and values out of range. Returns a
/// note for each path that has another name by now.
std::vector<std::string> fromJson(const nlohmann::json& json, Settings& settings);

bool operator==(const Settings& a, const Settings& b);

/// GLSL text: for each Program row `const int kRectifyMethod = 3;` and `const int kRectifyMethod_clamp = 1;`
/// for each choice (Toggles: `const bool kHistoryDering = true;`), `const bool kUpsampled`, whether the
/// inputs are smaller than the picture, then the uniform block `SettingsBlock` (binding 1, std140, instance
/// `settings`) with one float or int for each Uniform row, named like the constant: `settings.rectifyGamma`.
std::string glslPrelude(const Settings& settings);
/// What the prelude depends on: settings with equal keys share a program.
std::string programKey(const Settings& settings);
/// The bytes of SettingsBlock, a multiple of 16.
std::vector<std::byte> settingsBlock(const Settings& settings);

/// Whether two lanes can share one drawing of the scene: all rows that draw it differently are equal.
bool sameInputs(const Settings& a, const Settings& b);

} // namespace taa
