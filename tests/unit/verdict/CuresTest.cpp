// The changes that may help: against every kind of trouble, and of every setting.
#include "core/verdict/pixel/Cures.h"

#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

using taa::Settings;
using taa::VerdictKind;

namespace {

/// "path=value" of all that differs by one setting alone.
std::set<std::string> changesByOne(const std::vector<Settings>& cured, const Settings& settings) {
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

TEST(Cures, ChangeEverySingleSettingOfTheResolveThatHasAnEffect) {
  const Settings settings;
  const std::set<std::string> changes = changesByOne(taa::singleChanges(settings), settings);
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
  EXPECT_TRUE(changesByOne(likelyCures(VerdictKind::Ghost, {}), {}).contains("dilate.method=none"));
}

TEST(Cures, RepeatNoMisprint) {
  for (const std::string& change : changesByOne(taa::singleChanges(Settings{}), {}))
    EXPECT_EQ(change.find("AsPrinted"), std::string::npos) << change;
}

TEST(Cures, HalveAndDoubleNumbers) {
  Settings settings;
  settings.neighborhood.gamma = 1.25f;
  settings.rectify.flickerStrength = 0.0f;
  const std::set<std::string> changes = changesByOne(taa::singleChanges(settings), settings);
  EXPECT_TRUE(changes.contains("neighborhood.gamma=0.625"));
  EXPECT_TRUE(changes.contains("neighborhood.gamma=2.5"));
  EXPECT_TRUE(changes.contains("rectify.flickerStrength=0.25")) << "a quarter of the range where it is 0";
}

// Every stage of every kind: what a sentence may be about can be changed, and is another value then.
TEST(Cures, OfWhatIsNamedAreSettingsOfTheTable) {
  for (const taa::VerdictKindInfo& info : taa::kVerdictKinds)
    for (const taa::StageInfo& stage : taa::kResolveStages) {
      taa::PixelVerdict verdict;
      verdict.kind = info.kind;
      verdict.stage = stage.stage;
      const auto named = namedSettings(verdict, Settings{});
      EXPECT_EQ(named.empty(), info.kind == VerdictKind::None) << stage.id;
      for (const std::string_view path : named) EXPECT_NO_THROW(taa::parameter(path)) << path;
      EXPECT_EQ(changesByOne(taa::singleChanges(named, {}), {}).empty(), named.empty()) << stage.id;
    }
}

TEST(Cures, NameWhatTheSentenceIsAbout) {
  taa::PixelVerdict verdict;
  verdict.kind = VerdictKind::Ghost;
  verdict.stage = taa::Stage::Reproject;
  EXPECT_EQ(namedSettings(verdict, {}), std::vector<std::string_view>{"reproject.method"});
  verdict.stage = taa::Stage::Inputs;
  EXPECT_EQ(namedSettings(verdict, {}), std::vector<std::string_view>{"inputs.motion"});
  verdict.stage = taa::Stage::ValidateHistory;
  verdict.rows = {{taa::IntermediateId::rejectReason, 3, {}, 4.0, {}}};
  EXPECT_EQ(namedSettings(verdict, {}), std::vector<std::string_view>{"validate.depth"}) << "the test itself";
  Settings off;
  off.jitter.taa = taa::Switch::Off;
  EXPECT_EQ(namedSettings(verdict, off), std::vector<std::string_view>{"taa.enabled"});
}

TEST(Cures, AccumulateWhereAPresetDoesNot) {
  for (const char* id : {"off", "source000-1", "source002-1"}) {
    const Settings settings = taa::preset(id).settings;
    EXPECT_TRUE(taa::accumulatesNothing(settings)) << id;
    EXPECT_FALSE(taa::accumulatingCures(settings).empty()) << id;
    for (const Settings& cure : taa::accumulatingCures(settings))
      EXPECT_FALSE(taa::accumulatesNothing(cure)) << id;
  }
  EXPECT_FALSE(taa::accumulatesNothing(Settings{}));
  EXPECT_TRUE(taa::accumulatingCures(Settings{}).empty());
}
