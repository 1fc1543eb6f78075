// The changes that may help: against every kind of trouble, and of every setting.
#include "core/verdict/pixel/Cures.h"

#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

using taa::Settings;
using taa::VerdictKind;

namespace {

/// "path=value" of all that differs by one setting alone.
std::set<std::string> singleChanges(const std::vector<Settings>& cured, const Settings& settings) {
  std::set<std::string> changes;
  for (const Settings& one : cured)
    if (const auto all = differences(one, settings); all.size() == 1) changes.insert(all.front());
  return changes;
}

} // namespace

TEST(Cures, AreKnownAgainstEveryKindAndStayWithinEveryRange) {
  for (const taa::Preset& preset : taa::builtinPresets())
    for (const taa::VerdictKindInfo& info : taa::kVerdictKinds) {
      if (info.kind == VerdictKind::None) continue;
      SCOPED_TRACE(preset.id + std::string(" ") + std::string(info.id));
      const std::vector<Settings> likely = likelyCures(info.kind, preset.settings);
      EXPECT_GE(likely.size(), 5u);
      for (const Settings& one : likely)
        for (const std::string& change : differences(one, preset.settings)) {
          Settings read = preset.settings;
          EXPECT_NO_THROW(applyAssignment(read, change)) << "a value out of range is refused";
        }
    }
}

TEST(Cures, OtherwiseChangeEverySettingOfTheResolveThatHasAnEffect) {
  const Settings settings;
  const std::set<std::string> changes = singleChanges(otherCures(VerdictKind::Lag, settings), settings);
  for (const taa::Parameter& row : taa::parameters()) {
    const bool isOfResolve = row.stage >= taa::Stage::DilateMotion && row.stage <= taa::Stage::Blend &&
                             row.effect != taa::Effect::Inputs && row.effect != taa::Effect::Storage;
    const bool isChanged = std::ranges::any_of(
        changes, [&](const std::string& change) { return change.starts_with(std::string(row.path) + "="); });
    EXPECT_TRUE(isChanged || !isOfResolve || !isRelevant(row, settings)) << row.path;
    EXPECT_FALSE(isChanged && row.stage >= taa::Stage::Output) << row.path; // nor is a fault injected
  }
}

TEST(Cures, OfGhostsLetPixelsFollowTheirOwnMotion) {
  EXPECT_TRUE(singleChanges(likelyCures(VerdictKind::Ghost, {}), {}).contains("dilate.method=none"));
}

TEST(Cures, RepeatNoMisprint) {
  for (const std::string& change : singleChanges(otherCures(VerdictKind::Lag, {}), {}))
    EXPECT_EQ(change.find("AsPrinted"), std::string::npos) << change;
}

TEST(Cures, HalveAndDoubleNumbers) {
  Settings settings;
  settings.neighborhood.gamma = 1.25f;
  settings.rectify.flickerStrength = 0.0f;
  const std::set<std::string> changes = singleChanges(otherCures(VerdictKind::Lag, settings), settings);
  EXPECT_TRUE(changes.contains("neighborhood.gamma=0.625"));
  EXPECT_TRUE(changes.contains("neighborhood.gamma=2.5"));
  EXPECT_TRUE(changes.contains("rectify.flickerStrength=0.25")) << "a quarter of the range where it is 0";
}
