// Settings to run a test over, made from the parameter table.
#include "tests/support/frames/Variants.h"

#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <random>
#include <utility>

namespace taa::test {

namespace {

// What draws the scene differently does not concern the resolve.
// Colors that are no numbers are not compared.
bool concernsResolve(const Parameter& row) {
  return row.effect != Effect::Inputs && row.path != "fault.nan";
}

std::vector<double> values(const Parameter& row) {
  if (row.kind == ParameterKind::Choice || row.kind == ParameterKind::Toggle) {
    std::vector<double> all;
    for (double value = row.minimum; value <= row.maximum; ++value) all.push_back(value);
    return all;
  }
  return {row.minimum, row.maximum};
}

} // namespace

std::string flags(const Settings& settings) {
  std::string text;
  for (const std::string& assignment : differences(settings, Settings{}))
    text += (text.empty() ? "--set " : " --set ") + assignment;
  return text.empty() ? "defaults" : text;
}

std::vector<Variant> eachChoice() {
  std::vector<Variant> variants{{"defaults", {}}};
  for (const Parameter& row : parameters()) {
    if (!concernsResolve(row)) continue;
    for (const double value : values(row)) {
      Settings settings;
      row.set(settings, value);
      if (settings == Settings{}) continue;
      variants.push_back({flags(settings), settings});
    }
  }
  for (const float scale : {0.5f, 0.67f, 0.75f})
    for (const double kernel : values(parameter("current.upsample"))) {
      Settings settings;
      settings.inputs.renderScale = scale;
      parameter("current.upsample").set(settings, kernel);
      variants.push_back({flags(settings), settings});
    }
  return variants;
}

std::vector<Variant> presetsAndChoices() {
  std::vector<Variant> variants;
  for (const Preset& preset : wholePresets()) variants.push_back({preset.id, preset.settings});
  for (Variant& variant : eachChoice()) variants.push_back(std::move(variant));
  return variants;
}

std::vector<Variant> partOf(const std::vector<Variant>& variants, std::size_t part) {
  std::vector<Variant> some;
  for (std::size_t index = part; index < variants.size(); index += kParts) some.push_back(variants[index]);
  return some;
}

Settings otherJitter() {
  Settings settings;
  applyAssignment(settings, "jitter.period=8");
  return settings;
}

Settings randomSettings(std::uint32_t seed) {
  std::mt19937 random(seed);
  Settings settings;
  for (const Parameter& row : parameters()) {
    // Without TAA most of the others would not be seen.
    // Faults make boxes that are none and colors that are no numbers: each is tried alone.
    if (!concernsResolve(row) || row.effect == Effect::Whole || row.stage == Stage::Faults) continue;
    const double share = static_cast<double>(random()) / 4294967296.0;
    const bool isNumber = row.kind == ParameterKind::Number;
    const double span = row.maximum - row.minimum;
    row.set(settings, row.minimum + (isNumber ? span * share : static_cast<int>((span + 1.0) * share)));
  }
  const double share = static_cast<double>(random()) / 4294967296.0;
  if (seed % 2) settings.inputs.renderScale = static_cast<float>(0.5 + 0.5 * share);
  return settings;
}

std::vector<Variant> randomCombinations() {
  std::vector<Variant> combinations;
  for (std::uint32_t seed = 100; seed < 300; ++seed) {
    const Settings settings = randomSettings(seed);
    combinations.push_back({flags(settings), settings});
  }
  return combinations;
}

} // namespace taa::test
