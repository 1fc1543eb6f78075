// Numbers and expressions of the stories, as text; for the files of ProbeStory, and numbers of other
// sentences.
#pragma once

#include "core/base/NumberText.h"
#include "core/story/ProbeStory.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace taa::story {

using Id = IntermediateId;

/// Of `digits` significant ones each.
std::string tupleText(const glm::vec2& v, int digits = 4);
std::string tupleText(const glm::vec3& v, int digits = 4);
/// "31.4 %"
std::string percentText(double share);
/// α without what is asked for because history was rejected.
float alphaBeforeRejection(const twin::PixelRecord& record);
/// Where the way leads that the clip amount is a share of: "the middle of the box".
std::string targetText(RectifyMethod method);
/// How many frames of the reference rate a step counts as (manual 13.19): eighths, 1/8 to 8.
double framesTaken(double stepSeconds, const WeightSettings& weight);

/// The pixel, and how its numbers are written.
struct Teller {
  const ProbedPixel& probed;
  int digits = 4;

  float value(Id id) const { return twin::at(probed.record, id).x; }
  glm::vec2 pair(Id id) const { return glm::vec2(twin::at(probed.record, id)); }
  glm::vec3 color(Id id) const { return glm::vec3(twin::at(probed.record, id)); }
  const Settings& settings() const { return probed.settings; }
  const twin::Details& details() const { return probed.details; }

  std::string number(double x) const { return numberText(x, digits); }
  std::string number(Id id) const { return number(static_cast<double>(value(id))); }
  std::string tuple(const glm::vec2& v) const { return tupleText(v, digits); }
  std::string tuple(const glm::vec3& v) const { return tupleText(v, digits); }
  std::string tuple(Id id) const { return tuple(color(id)); }
  std::string number(float x) const { return number(static_cast<double>(x)); }
  std::string percent(double share) const { return percentText(share); }
  std::string percent(Id id) const { return percent(static_cast<double>(value(id))); }
  /// "expression = value"
  std::string equals(const std::string& expression, Id id) const;
  /// How the twin made the row: all channels at once, or the first where they were not made alike; empty
  /// where it was not traced.
  struct Expression {
    std::string text;
    int channel = -1; ///< all
  };
  Expression expression(Id id, bool unfolds = false) const;
  /// "expression = value" of a channel.
  std::string formula(Id id, int channel = 0) const;
  /// `words` with the formula of the whole expression.
  RowStory story(const std::string& words, Id id, bool unfolds = false) const;

  /// A color in box space.
  glm::vec3 box(const glm::vec3& color) const;
  /// Name of a channel of box space: "Y".
  std::string channelName(int channel) const;
};

/// "max(a, b)"
std::string call(const std::string& function, std::initializer_list<std::string> arguments);
std::string call(const std::string& function, std::span<const std::string> arguments);
/// The color as it is mixed, before it is stored.
glm::vec3 mixedColor(const Teller& teller);
/// `words`, and what storing the color does to it.
std::string storedWords(const Teller& teller, const std::string& words);
/// An expression of the color, or of one channel of it, as it is stored: rounded.
std::string storedText(const Teller& teller, const std::string& expression, int channel = -1);
/// Label of the choice that the settings have.
std::string choiceLabel(std::string_view path, const Settings& settings);

// By stages; each tells nothing of rows of others.
RowStory inputStory(Id id, const Teller& teller);
RowStory sampleStory(Id id, const Teller& teller); ///< dilate and reproject
RowStory filterStory(Id id, const Teller& teller); ///< sample history and filter current
RowStory boxStory(Id id, const Teller& teller);    ///< neighborhood
RowStory rectifyStory(Id id, const Teller& teller);
RowStory lockStory(Id id, const Teller& teller); ///< what of rectification is taken back
RowStory validateStory(Id id, const Teller& teller);
RowStory weightStory(Id id, const Teller& teller);
RowStory dampingStory(Id id, const Teller& teller); ///< of the weight's rows those that are factors of it
RowStory blendStory(Id id, const Teller& teller);
RowStory outputStory(Id id, const Teller& teller);  ///< output and reference
RowStory flickerStory(Id id, const Teller& teller); ///< the rows that flicker is measured with
RowStory partsStory(Id id, const Teller& teller);   ///< those of parts of the error

} // namespace taa::story
