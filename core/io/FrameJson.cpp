#include "core/io/FrameJson.h"

#include "core/base/NumberText.h"
#include "core/taa/ChannelNames.h"
#include "core/taa/twin/Known.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace taa {

using nlohmann::ordered_json;

namespace {

std::string_view kindName(ParameterKind kind) {
  constexpr std::array<std::string_view, 4> kNames = {"choice", "toggle", "integer", "number"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::string_view visualName(Visual visual) {
  constexpr std::array<std::string_view, 10> kNames = {"color",  "box",      "depth",  "scalar", "signed",
                                                       "vector", "position", "normal", "mask",   "index"};
  return kNames.at(static_cast<std::size_t>(visual));
}

/// {"rgb": ["R", "G", "B"], …}
ordered_json channelsBySpace(const Intermediate& row) {
  ordered_json json;
  Settings settings;
  const Parameter& color = parameter("space.color");
  for (std::size_t choice = 0; choice < color.choices.size(); ++choice) {
    color.set(settings, static_cast<double>(choice));
    json[std::string(color.choices[choice].id)] = channelNames(row, settings.space);
  }
  return json;
}

} // namespace

ordered_json floatJson(float value) {
  const std::string text = shortestText(value);
  if (!std::isfinite(value)) return text;
  // The double next to the short decimal prints as that decimal; the double of the float prints 17 digits.
  double shortest = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), shortest);
  return shortest;
}

ordered_json recordJson(const twin::PixelRecord& record, const SpaceSettings& space) {
  ordered_json json;
  for (const Intermediate& row : kIntermediates) {
    ordered_json& values = json[std::string(row.name)];
    if (!twin::isKnown(record, row.id)) continue;
    int channel = 0;
    for (const std::string& name : channelNames(row, space))
      values[name] = floatJson(twin::at(record, row.id)[channel++]);
  }
  return json;
}

ordered_json intermediateJson(const Intermediate& row) {
  ordered_json json = {{"id", row.name},
                       {"label", row.label},
                       {"stage", stageInfo(row.stage).id},
                       {"channels", channelNames(row, SpaceSettings{})},
                       {"unit", row.unit},
                       {"range", {floatJson(row.low), floatJson(row.high)}},
                       {"visual", visualName(row.visual)},
                       {"description", row.description}};
  if (row.visual == Visual::Box) json["channelsBySpace"] = channelsBySpace(row);
  return json;
}

ordered_json parameterJson(const Parameter& row) {
  ordered_json json = {
      {"path", row.path},           {"label", row.label}, {"stage", stageInfo(row.stage).id},
      {"kind", kindName(row.kind)}, {"unit", row.unit},   {"default", valueText(row, row.defaultValue())}};
  if (row.kind == ParameterKind::Choice) {
    json["choices"] = ordered_json::array();
    for (const Choice& choice : row.choices)
      json["choices"].push_back(
          {{"id", choice.id}, {"label", choice.label}, {"explanation", choice.explanation}});
  } else if (row.kind != ParameterKind::Toggle) {
    json["minimum"] = row.minimum;
    json["maximum"] = row.maximum;
  }
  json["tooltip"] = row.tooltip;
  json["formula"] = row.formula;
  json["source"] = row.source;
  json["relevantWhen"] = relevantWhen(row);
  return json;
}

} // namespace taa
