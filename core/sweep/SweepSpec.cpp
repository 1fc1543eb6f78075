#include "core/sweep/SweepSpec.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/Text.h"
#include "core/base/json/Json.h"
#include "core/base/json/JsonFields.h"
#include "core/base/json/LimitedJson.h"
#include "core/measure/Flicker.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Presets.h"
#include "core/sweep/MetricsOfFrames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

namespace taa {

namespace fs = std::filesystem;

namespace {

constexpr int kSweepFormat = 1;
constexpr int kMinSweepSide = 4, kMaxSweepSide = 16384;
constexpr std::array<std::string_view, 12> kSweepKeys{
    "format", "sources", "settings",         "set",           "parameters", "cameras", "frames",
    "size",   "metrics", "referenceSamples", "flickerFrames", "pareto"};
constexpr std::array<std::string_view, 3> kSettingsKeys{"name", "preset", "set"};
constexpr std::array<std::string_view, 4> kRangeKeys{"from", "to", "steps", "scale"};
/// What says how much of old history stays, the best first.
constexpr std::array<std::string_view, 3> kGhostMetrics{"ghostEnergy", "errorGhost", "rmse"};

/// Calls `read` with each entry of the list and its place; there is one at least.
template <typename Read>
void eachEntry(const Json& list, const std::string& place, Read read) {
  requireList(list, place, kMaxSweepEntries);
  if (list.empty()) throw Error(say<"\"%1\" is empty; name what to go over">(place));
  for (std::size_t index = 0; index < list.size(); ++index) read(list[index], elementOf(place, index));
}

std::vector<std::string> textsOf(const Json& list, const std::string& place) {
  std::vector<std::string> texts;
  eachEntry(list, place,
            [&](const Json& entry, const std::string& at) { texts.push_back(textOf(entry, at)); });
  return texts;
}

/// `shape`: as the file has it, "[first, last]".
glm::ivec2 twoNumbers(const Json& list, const std::string& place, const char* shape, int least, int most) {
  if (!list.is_array() || list.size() != 2) throw Error(say<"\"%1\" wants %2">(place, shape));
  return {static_cast<int>(integerOf(list[0], elementOf(place, 0), least, most)),
          static_cast<int>(integerOf(list[1], elementOf(place, 1), least, most))};
}

void assignAll(Settings& settings, const Json& list, const std::string& place) {
  eachEntry(list, place, [&](const Json& entry, const std::string& at) {
    try {
      applyAssignment(settings, textOf(entry, at));
    } catch (const Error& error) {
      throw Error(say<"\"%1\": %2">(at, error.what()));
    }
  });
}

/// As --set has it: "0.1", "on", "clamp".
std::string assignedText(const Json& value, const std::string& place) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  return shortestText(numberOf(value, place));
}

bool isNumberRow(const Parameter& row) {
  return row.kind == ParameterKind::Number || row.kind == ParameterKind::Integer;
}

/// As the row holds them, each once. Throws Error.
std::vector<double> heldValues(const Parameter& row, const std::vector<double>& given) {
  std::vector<double> values;
  for (const double value : given) {
    const double held = isNumberRow(row) ? parseValue(row, shortestText(value)) : value;
    if (std::ranges::find(values, held) == values.end()) values.push_back(held);
  }
  return values;
}

std::vector<double> rangeSteps(const Json& range, const std::string& place, const Parameter& row) {
  requireKeys(range, place, kRangeKeys);
  if (!isNumberRow(row)) throw Error(say<"\"%1\" is no number: list its values">(place));
  const double from = numberOf(requireField(range, place, "from"), pathOf(place, "from"));
  const double to = numberOf(requireField(range, place, "to"), pathOf(place, "to"));
  const auto steps = integerOf(requireField(range, place, "steps"), pathOf(place, "steps"), 2,
                               static_cast<long long>(kMaxSweepEntries));
  const Json* const scale = findField(range, "scale");
  const std::string how = scale ? textOf(*scale, pathOf(place, "scale")) : "linear";
  if (how != "linear" && how != "log") throw Error(say<"\"%1\" is linear or log">(pathOf(place, "scale")));
  if (how == "log" && (from <= 0.0 || to <= 0.0))
    throw Error(say<"\"%1\" goes by a factor, which wants numbers above 0">(place));
  return valuesBetween(row, from, to, static_cast<int>(steps), how == "log");
}

/// All that a choice or a switch has.
std::vector<double> everyValue(const Parameter& row, const std::string& place) {
  if (isNumberRow(row))
    throw Error(say<"\"%1\" is a number: list its values, or give from, to and steps">(place));
  std::vector<double> values;
  for (double value = row.minimum; value <= row.maximum; ++value) values.push_back(value);
  return values;
}

SweepRange rangeEntry(const std::string& path, const Json& value) {
  const std::string place = "parameters." + path;
  SweepRange range{&parameter(path), {}};
  std::vector<double> values;
  if (value.is_object())
    values = rangeSteps(value, place, *range.row);
  else if (value == "all")
    values = everyValue(*range.row, place);
  else
    eachEntry(value, place, [&](const Json& entry, const std::string& at) {
      values.push_back(parseValue(*range.row, assignedText(entry, at)));
    });
  range.values = heldValues(*range.row, values);
  return range;
}

fs::path placedBelow(const fs::path& folder, const std::string& name) {
  return fs::path(name).is_absolute() ? fs::path(name) : (folder / name).lexically_normal();
}

Preset presetBelow(const fs::path& folder, const std::string& name) {
  return preset(name.ends_with(".json") ? placedBelow(folder, name).string() : name);
}

SweepSettings settingsEntry(const Json& entry, const std::string& place, const fs::path& folder) {
  if (entry.is_string()) return {entry.get<std::string>(), presetBelow(folder, entry).settings};
  requireKeys(entry, place, kSettingsKeys);
  const Json* const base = findField(entry, "preset");
  SweepSettings made{
      textOf(requireField(entry, place, "name"), pathOf(place, "name")),
      presetBelow(folder, base ? textOf(*base, pathOf(place, "preset")) : "balanced").settings};
  if (const Json* const set = findField(entry, "set")) assignAll(made.settings, *set, pathOf(place, "set"));
  return made;
}

Metric metricOfSpec(const std::string& id, const std::string& place) {
  if (const std::optional<Metric> metric = findMetric(id)) return *metric;
  std::vector<std::string> known;
  for (const MetricInfo& info : kMetrics) known.emplace_back(info.id);
  throw Error(say<"\"%1\": there is no metric \"%2\"; there are %3">(place, shownText(id), joined(known)));
}

void readAxes(const Json& json, SweepSpec& spec, const fs::path& folder) {
  for (const std::string& name : textsOf(requireField(json, "", "sources"), "sources"))
    spec.sources.push_back({name, isBuiltinScene(name) ? fs::path(name) : placedBelow(folder, name)});
  if (const Json* const settings = findField(json, "settings"))
    eachEntry(*settings, "settings", [&](const Json& entry, const std::string& at) {
      spec.settings.push_back(settingsEntry(entry, at, folder));
    });
  else
    spec.settings.push_back({"balanced", preset("balanced").settings});
  std::set<std::string> names;
  for (const SweepSettings& each : spec.settings)
    if (!names.insert(each.name).second) throw Error(say<"two of \"settings\" are called \"%1\"">(each.name));
  if (const Json* const set = findField(json, "set"))
    for (SweepSettings& each : spec.settings) assignAll(each.settings, *set, "set");
  if (const Json* const ranges = findField(json, "parameters")) {
    requireObject(*ranges, "parameters");
    for (const auto& [path, value] : ranges->items()) spec.ranges.push_back(rangeEntry(path, value));
  }
  // Keys come sorted; the table's order is that of the stages.
  std::ranges::sort(spec.ranges, {}, &SweepRange::row);
  if (const Json* const cameras = findField(json, "cameras")) spec.cameras = textsOf(*cameras, "cameras");
}

void readMetrics(const Json& json, SweepSpec& spec) {
  if (const Json* const samples = findField(json, "referenceSamples"); samples && *samples == 0)
    spec.referenceSamples = 0;
  else if (samples)
    spec.referenceSamples =
        static_cast<int>(integerOf(*samples, "referenceSamples", kMinReferenceSamples, kMaxReferenceSamples));
  if (const Json* const frames = findField(json, "flickerFrames"))
    spec.flickerFrames =
        static_cast<int>(integerOf(*frames, "flickerFrames", kMinFlickerFrames, kMaxFlickerFrames));
  spec.metrics = metricsThere(spec.referenceSamples, {OverTime::Flicker});
  if (const Json* const metrics = findField(json, "metrics")) {
    spec.metrics.clear();
    for (const std::string& id : textsOf(*metrics, "metrics")) {
      const Metric metric = metricOfSpec(id, "metrics");
      if (metricInfo(metric).needsReference && spec.referenceSamples == 0)
        throw Error(say<"the metric %1 needs a reference, and \"referenceSamples\" is 0">(id));
      if (std::ranges::find(spec.metrics, metric) == spec.metrics.end()) spec.metrics.push_back(metric);
    }
  }
  spec.tradeOff = defaultTradeOff(spec.metrics);
  if (const Json* const pareto = findField(json, "pareto")) {
    const std::vector<std::string> two = textsOf(*pareto, "pareto");
    if (two.size() != 2) throw Error(say<"\"%1\" wants two metrics">("pareto"));
    spec.tradeOff = {metricOfSpec(two[0], "pareto"), metricOfSpec(two[1], "pareto")};
  }
  for (const Metric metric : spec.tradeOff)
    if (std::ranges::find(spec.metrics, metric) == spec.metrics.end())
      throw Error(say<"\"pareto\" names %1, which is not among \"metrics\"">(metricInfo(metric).id));
}

SweepSpec specFromJson(const Json& json, const fs::path& folder) {
  requireKeys(json, "", kSweepKeys);
  requireFormat(json, kSweepFormat);
  SweepSpec spec;
  readAxes(json, spec, folder);
  const glm::ivec2 frames =
      twoNumbers(requireField(json, "", "frames"), "frames", "[first, last]", 0, kMaxSweepFrame);
  if (frames.y < frames.x) throw Error(say<"\"frames\": the last frame is before the first">());
  spec.first = frames.x;
  spec.last = frames.y;
  if (const Json* const size = findField(json, "size"))
    spec.size = twoNumbers(*size, "size", "[width, height]", kMinSweepSide, kMaxSweepSide);
  readMetrics(json, spec);
  if (spec.pointCount() > kMaxSweepPoints)
    throw Error(say<"it has more than the %1 points allowed: make several of it">(kMaxSweepPoints));
  return spec;
}

} // namespace

std::size_t SweepSpec::pointCount() const {
  // Factors are kMaxSweepEntries at most: no product overflows before it is seen to be too large.
  std::size_t count = sources.size() * settings.size() * cameras.size();
  for (const SweepRange& range : ranges) {
    if (count > kMaxSweepPoints) break;
    count *= range.values.size();
  }
  return count;
}

std::vector<double> valuesBetween(const Parameter& row, double from, double to, int steps, bool isByFactor) {
  std::vector<double> values;
  for (int step = 0; step < steps; ++step) {
    const double share = static_cast<double>(step) / (steps - 1);
    double value = isByFactor ? from * std::pow(to / from, share) : from + share * (to - from);
    if (step == steps - 1) value = to;
    values.push_back(row.kind == ParameterKind::Integer ? std::round(value) : value);
  }
  return heldValues(row, values);
}

std::array<Metric, 2> defaultTradeOff(const std::vector<Metric>& there) {
  const auto isThere = [&](Metric metric) { return std::ranges::find(there, metric) != there.end(); };
  std::array<Metric, 2> both{there.front(), there.back()};
  for (const std::string_view id : kGhostMetrics)
    if (const std::optional<Metric> metric = findMetric(id); metric && isThere(*metric)) {
      both[0] = *metric;
      break;
    }
  if (isThere(Metric::Flicker)) both[1] = Metric::Flicker;
  return both;
}

SweepSpec sweepSpecFromText(const std::string& text, const std::string& place, const fs::path& folder) {
  try {
    if (text.size() > kMaxSweepBytes)
      throw Error(say<"it has %1 bytes, more than the %2 allowed">(text.size(), kMaxSweepBytes));
    return specFromJson(parseLimited(text), folder);
  } catch (const Error& error) {
    throw Error(say<"cannot read the sweep %1: %2">(place, error.what()));
  }
}

SweepSpec readSweepSpec(const fs::path& file) {
  return sweepSpecFromText(readFile(file, kMaxSweepBytes), file.string(), file.parent_path());
}

} // namespace taa
