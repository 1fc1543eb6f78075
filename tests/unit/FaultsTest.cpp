// The table of faults: each is injected by settings that there are, taken back, and told from healthy ones.
#include "core/settings/Faults.h"

#include "core/base/Error.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace taa {
namespace {

TEST(Faults, StandInTheOrderOfTheirEnumWithAnIdOfTheirOwn) {
  std::set<std::string_view> ids;
  for (std::size_t index = 0; index < faultTable().size(); ++index) {
    const FaultInfo& info = faultTable()[index];
    EXPECT_EQ(static_cast<std::size_t>(info.fault), index) << info.id;
    EXPECT_TRUE(ids.insert(info.id).second) << info.id;
    EXPECT_EQ(&faultInfo(info.id), &info);
    EXPECT_FALSE(info.label.empty() || info.symptom.empty()) << info.id;
    EXPECT_TRUE(info.symptom.ends_with('.')) << info.id;
  }
  EXPECT_EQ(static_cast<std::size_t>(Fault::BoxOfCorners) + 1, faultTable().size());
  EXPECT_THROW(faultInfo("motionNegatedZ"), Error);
}

TEST(Faults, AreInjectedBySettingsAndTakenBack) {
  for (const FaultInfo& info : faultTable()) {
    Settings settings;
    settings.jitter.period = 8; // what has nothing to do with it
    const Settings healthy = settings;
    EXPECT_FALSE(isInjected(info.fault, settings)) << info.id;
    inject(info.fault, settings);
    EXPECT_TRUE(isInjected(info.fault, settings)) << info.id;
    EXPECT_FALSE(settings == healthy) << info.id;
    withdraw(info.fault, healthy, settings);
    EXPECT_TRUE(settings == healthy) << info.id;
  }
}

// Two that were set by the same values could not be told from each other.
TEST(Faults, DifferFromEachOther) {
  for (const FaultInfo& info : faultTable())
    for (const FaultInfo& other : faultTable()) {
      if (info.fault == other.fault) continue;
      Settings one, two;
      inject(info.fault, one);
      inject(other.fault, two);
      EXPECT_FALSE(one == two) << info.id << " and " << other.id;
    }
}

TEST(Faults, OfTheGroupAreToldAndTechniquesAreNot) {
  for (const FaultInfo& info : faultTable()) {
    Settings settings;
    inject(info.fault, settings);
    const bool isOfGroup = info.assignments.starts_with("fault.");
    EXPECT_EQ(isFaulty(settings), isOfGroup) << info.id;
    EXPECT_EQ(injectedFaults(settings).empty(), !isOfGroup) << info.id;
    clearFaults(settings);
    EXPECT_FALSE(isFaulty(settings)) << info.id;
  }
  Settings settings;
  applyAssignment(settings, "fault.region=sky");
  applyAssignment(settings, "fault.firstFrame=3");
  EXPECT_FALSE(isFaulty(settings)) << "where and when, but nothing";
  applyAssignment(settings, "fault.motionY=-1");
  EXPECT_EQ(injectedFaults(settings),
            (std::vector<std::string>{"fault.motionY=-1", "fault.region=sky", "fault.firstFrame=3"}));
}

TEST(Faults, AreNotInThePresets) {
  // The second rung of the notes on URP goes on over cuts until the third one adds the reset.
  for (const Preset& preset : builtinPresets())
    EXPECT_EQ(isFaulty(preset.settings), preset.id == "source003-2") << preset.id;
}

TEST(Faults, ExcludeEachOtherWhereTheyWantDifferentValues) {
  EXPECT_TRUE(excludeEachOther(Fault::JitterLate, Fault::JitterEarly));
  EXPECT_TRUE(excludeEachOther(Fault::MotionDoubled, Fault::MotionHalved));
  EXPECT_FALSE(excludeEachOther(Fault::MotionNegatedX, Fault::MotionNegated)) << "the same factor of x";
  EXPECT_FALSE(excludeEachOther(Fault::JitterNegatedY, Fault::MotionNegatedY));
  EXPECT_TRUE(excludeEachOther(Fault::SkyWithoutMotion, Fault::MotionNegatedY)) << "of the sky only";
  EXPECT_TRUE(excludeEachOther(Fault::MotionNegatedY, Fault::SkyWithoutMotion));
  EXPECT_FALSE(excludeEachOther(Fault::SkyWithoutMotion, Fault::JitterNegatedY)) << "jitter has no region";
  EXPECT_TRUE(excludeEachOther(Fault::ExposureStep, Fault::JitterNegatedY)) << "from frame 8 on";
  EXPECT_TRUE(excludeEachOther(Fault::JitterFrozen, Fault::OldTransformOnReturn)) << "in frame 12 only";
  EXPECT_FALSE(excludeEachOther(Fault::SkyWithoutMotion, Fault::DilatesFarthest));
}

} // namespace
TEST(Faults, OfHalfStrengthAreBetweenHealthyAndFaulty) {
  Settings settings;
  EXPECT_TRUE(injectHalf(Fault::MotionDoubled, settings));
  EXPECT_EQ(settings.fault.motionX, 1.5f);
  EXPECT_EQ(settings.fault.motionY, 1.5f);
  EXPECT_TRUE(injectHalf(Fault::ExposureStep, settings));
  EXPECT_EQ(settings.fault.exposure, 0.5f);
  EXPECT_EQ(settings.fault.firstFrame, 8); // when is no matter of strength
}

TEST(Faults, OfSignsAndChoicesHaveNoHalf) {
  const Settings healthy;
  Settings settings;
  for (const Fault fault : {Fault::MotionNegatedX, Fault::JitterLate, Fault::MotionShifted})
    EXPECT_FALSE(injectHalf(fault, settings)) << faultInfo(fault).id;
  EXPECT_TRUE(settings == healthy);
}

} // namespace taa
