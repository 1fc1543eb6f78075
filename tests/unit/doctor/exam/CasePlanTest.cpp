// Which cases the doctor is tried on.
#include "tests/manual/CasePlan.h"

#include "core/settings/Presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace taa {
namespace {

CasePlan planOf(const std::vector<Fault>& faults) {
  CasePlan plan;
  plan.scenes = {"fan", "fence"};
  plan.cameras = {"pan", "orbit"};
  plan.faults = faults;
  return plan;
}

std::size_t countOf(const std::vector<PlannedCase>& cases, std::size_t faults, bool isHalf) {
  return static_cast<std::size_t>(std::ranges::count_if(cases, [&](const PlannedCase& one) {
    return one.tried.faults.size() == faults && one.tried.isHalf == isHalf;
  }));
}

} // namespace

TEST(CasePlan, HasAllKindsForEachSceneAndCamera) {
  const std::vector<PlannedCase> cases = plannedCases(planOf({Fault::MotionDoubled, Fault::JitterLate}));
  EXPECT_EQ(countOf(cases, 0, false), 4u);
  EXPECT_EQ(countOf(cases, 1, false), 8u);
  EXPECT_EQ(countOf(cases, 1, true), 4u); // a choice has no half
  EXPECT_EQ(countOf(cases, 2, false), 8u);
  EXPECT_TRUE(cases.front().tried.faults.empty());
  EXPECT_EQ(cases.front().path, "builtin:fan");
}

TEST(CasePlan, PairsFaultsOfTwoPartsThatGoTogether) {
  std::set<Fault> partners;
  for (const PlannedCase& one : plannedCases(planOf({Fault::MotionDoubled})))
    if (one.tried.faults.size() == 2) {
      EXPECT_NE(faultInfo(one.tried.faults[1]).part, FaultPart::Motion);
      EXPECT_NE(faultInfo(one.tried.faults[1]).part, FaultPart::Resolve);
      EXPECT_FALSE(excludeEachOther(one.tried.faults[0], one.tried.faults[1]));
      partners.insert(one.tried.faults[1]);
    }
  EXPECT_EQ(partners.size(), 4u);
}

TEST(CasePlan, TakesAllPresetsForEnginesOfScenesWhereThatIsAsked) {
  CasePlan plan = planOf({});
  plan.captures = {"/data/capture-three"};
  plan.healthy = false;
  EXPECT_TRUE(plannedCases(plan).empty());
  plan.presets = true;
  const std::vector<PlannedCase> cases = plannedCases(plan);
  EXPECT_EQ(cases.size(), 4 * builtinPresets().size());
  for (const PlannedCase& one : cases) EXPECT_FALSE(one.tried.preset.empty());
}

TEST(CasePlan, InjectsNothingIntoCapturesThatHasToBeDrawn) {
  CasePlan plan;
  plan.captures = {"/data/capture-three/"};
  plan.faults = {Fault::JitterNotApplied, Fault::JitterNegated};
  plan.pairs = false;
  const std::vector<PlannedCase> cases = plannedCases(plan);
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[1].tried.faults, std::vector<Fault>{Fault::JitterNegated});
  EXPECT_EQ(cases[1].tried.source, "capture-three");
  EXPECT_EQ(cases[1].path, "/data/capture-three/");
}

} // namespace taa
