// Which settings make frames right: faults are taken back, other mistakes undone.
#include "core/doctor/Mending.h"

#include "core/settings/Faults.h"
#include "core/settings/Parameters.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

using Words = std::vector<std::string>;

Finding found(const char* id, const Words& mending = {}) {
  Finding out;
  out.id = id;
  out.mending = mending;
  return out;
}

RegionPlace placeOfShare(double share, std::uint32_t objectId = 0, bool isSky = false) {
  RegionPlace out;
  out.share = share;
  out.objectId = objectId;
  out.isSky = isSky;
  return out;
}

Settings with(const Words& assignments) {
  Settings out;
  for (const std::string& assignment : assignments) applyAssignment(out, assignment);
  return out;
}

} // namespace

TEST(Mending, TakesBackEachFaultOfTheTable) {
  for (const FaultInfo& info : faultTable()) {
    Settings settings;
    inject(info.fault, settings);
    const Mended out = mended({found(std::string(info.id).c_str())}, settings, Settings{});
    EXPECT_EQ(differences(out.settings, Settings{}), Words()) << info.id;
    EXPECT_EQ(out.findings, std::vector<std::size_t>{0}) << info.id;
  }
}

TEST(Mending, TakesBackWhatMakesTheSameFramesUnderAnotherName) {
  const Settings settings = with({"fault.previousAge=2"});
  const Mended out =
      mended({found("motionDoubled", {"fault.motionX=0.5", "fault.motionY=0.5"})}, settings, {});
  EXPECT_EQ(differences(out.settings, Settings{}), Words());
}

TEST(Mending, LeavesFaultsOfOtherParts) {
  const Settings settings = with({"fault.motionY=-1", "fault.jitter=negated", "fault.region=sky"});
  const Mended out = mended({found("motionNegatedY")}, settings, {});
  EXPECT_EQ(differences(out.settings, Settings{}), (Words{"fault.jitter=negated", "fault.region=sky"}));
  EXPECT_EQ(mended({found("motionNegatedY"), found("jitterNegated")}, settings, {}).findings.size(), 2u);
}

TEST(Mending, LeavesWhatThePresetDoes) {
  Settings preset;
  inject(Fault::AlphaOne, preset);
  Settings settings = preset;
  inject(Fault::MotionNegatedX, settings);
  const Mended out = mended({found("motionNegatedX"), found("alphaOne")}, settings, preset);
  EXPECT_EQ(differences(out.settings, preset), Words());
  EXPECT_EQ(out.findings, std::vector<std::size_t>{0});
}

TEST(Mending, UndoesWhatWasNotInjected) {
  const Mended out = mended({found("jitterNegated", {"fault.jitter=negated"}),
                             found("skyWithoutMotion", {"fault.motion=cameraOnly", "fault.region=sky"})},
                            {}, {});
  EXPECT_EQ(differences(out.settings, Settings{}),
            (Words{"fault.jitter=negated", "fault.motion=cameraOnly", "fault.region=sky"}));
  EXPECT_EQ(out.findings.size(), 2u);
}

TEST(Mending, MendsTheFirstOfTwoThatExcludeEachOther) {
  const Mended places = mended({found("motionNegatedY", {"fault.motionY=-1"}),
                                found("skyWithoutMotion", {"fault.motion=cameraOnly", "fault.region=sky"})},
                               {}, {});
  EXPECT_EQ(places.findings, std::vector<std::size_t>{0});
  EXPECT_EQ(differences(places.settings, Settings{}), Words{"fault.motionY=-1"});
  const Mended values = mended(
      {found("motionDoubled", {"fault.motionX=0.5"}), found("motionNegatedX", {"fault.motionX=-1"})}, {}, {});
  EXPECT_EQ(values.findings, std::vector<std::size_t>{0});
  const Mended none = mended({found("depthLinear")}, {}, {});
  EXPECT_TRUE(none.findings.empty());
  EXPECT_EQ(differences(none.settings, Settings{}), Words());
}

TEST(Mending, SaysThePlaceOfAFinding) {
  Finding finding;
  EXPECT_EQ(placeSettings(finding), Words()) << "the whole picture";
  finding.regions = {placeOfShare(0.1, 7)};
  EXPECT_EQ(placeSettings(finding), (Words{"fault.region=object", "fault.object=7"}));
  finding.regions = {placeOfShare(0.2, 0, true)};
  EXPECT_EQ(placeSettings(finding), Words{"fault.region=sky"});
  finding.regions = {placeOfShare(0.2)};
  EXPECT_FALSE(placeSettings(finding)) << "a part that no number says";
  mendBy({"fault.motionY=-1"}, finding);
  EXPECT_EQ(finding.mending, Words());
  mendEverywhereBy({"fault.motionY=-1"}, finding);
  EXPECT_EQ(finding.mending, Words{"fault.motionY=-1"});
  finding.regions = {placeOfShare(0.3), placeOfShare(0.25)};
  EXPECT_EQ(placeSettings(finding), Words()) << "most of the picture";
}

} // namespace taa::doctor
