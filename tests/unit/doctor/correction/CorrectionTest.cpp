// Which settings make frames right: faults are taken back, other mistakes undone.
#include "core/doctor/Correction.h"

#include "core/settings/Faults.h"
#include "core/settings/Parameters.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

using Words = std::vector<std::string>;

Finding found(const char* id, const Words& correction = {}) {
  Finding out;
  out.id = id;
  out.correction = correction;
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

TEST(Correction, TakesBackEachFaultOfTheTable) {
  for (const FaultInfo& info : faultTable()) {
    Settings settings;
    inject(info.fault, settings);
    const Corrected out = corrected({found(std::string(info.id).c_str())}, settings, Settings{});
    EXPECT_EQ(differences(out.settings, Settings{}), Words()) << info.id;
    EXPECT_EQ(out.findings, std::vector<std::size_t>{0}) << info.id;
  }
}

TEST(Correction, TakesBackWhatMakesTheSameFramesUnderAnotherName) {
  const Settings settings = with({"fault.previousAge=2"});
  const Corrected out =
      corrected({found("motionDoubled", {"fault.motionX=0.5", "fault.motionY=0.5"})}, settings, {});
  EXPECT_EQ(differences(out.settings, Settings{}), Words());
}

TEST(Correction, LeavesFaultsOfOtherParts) {
  const Settings settings = with({"fault.motionY=-1", "fault.jitter=negated", "fault.region=sky"});
  const Corrected out = corrected({found("motionNegatedY")}, settings, {});
  EXPECT_EQ(differences(out.settings, Settings{}), (Words{"fault.jitter=negated", "fault.region=sky"}));
  EXPECT_EQ(corrected({found("motionNegatedY"), found("jitterNegated")}, settings, {}).findings.size(), 2u);
}

TEST(Correction, LeavesWhatThePresetDoes) {
  Settings preset;
  inject(Fault::AlphaOne, preset);
  Settings settings = preset;
  inject(Fault::MotionNegatedX, settings);
  const Corrected out = corrected({found("motionNegatedX"), found("alphaOne")}, settings, preset);
  EXPECT_EQ(differences(out.settings, preset), Words());
  EXPECT_EQ(out.findings, std::vector<std::size_t>{0});
}

TEST(Correction, UndoesWhatWasNotInjected) {
  const Corrected out =
      corrected({found("jitterNegated", {"fault.jitter=negated"}),
                 found("skyWithoutMotion", {"fault.motion=cameraOnly", "fault.region=sky"})},
                {}, {});
  EXPECT_EQ(differences(out.settings, Settings{}),
            (Words{"fault.jitter=negated", "fault.motion=cameraOnly", "fault.region=sky"}));
  EXPECT_EQ(out.findings.size(), 2u);
}

TEST(Correction, MendsTheFirstOfTwoThatExcludeEachOther) {
  const Corrected places =
      corrected({found("motionNegatedY", {"fault.motionY=-1"}),
                 found("skyWithoutMotion", {"fault.motion=cameraOnly", "fault.region=sky"})},
                {}, {});
  EXPECT_EQ(places.findings, std::vector<std::size_t>{0});
  EXPECT_EQ(differences(places.settings, Settings{}), Words{"fault.motionY=-1"});
  const Corrected values = corrected(
      {found("motionDoubled", {"fault.motionX=0.5"}), found("motionNegatedX", {"fault.motionX=-1"})}, {}, {});
  EXPECT_EQ(values.findings, std::vector<std::size_t>{0});
  const Corrected none = corrected({found("depthLinear")}, {}, {});
  EXPECT_TRUE(none.findings.empty());
  EXPECT_EQ(differences(none.settings, Settings{}), Words());
}

TEST(Correction, SaysThePlaceOfAFinding) {
  Finding finding;
  EXPECT_EQ(placeSettings(finding), Words()) << "the whole picture";
  finding.regions = {placeOfShare(0.1, 7)};
  EXPECT_EQ(placeSettings(finding), (Words{"fault.region=object", "fault.object=7"}));
  finding.regions = {placeOfShare(0.2, 0, true)};
  EXPECT_EQ(placeSettings(finding), Words{"fault.region=sky"});
  finding.regions = {placeOfShare(0.2)};
  EXPECT_FALSE(placeSettings(finding)) << "a part that no number says";
  correctBy({"fault.motionY=-1"}, finding);
  EXPECT_EQ(finding.correction, Words());
  correctEverywhereBy({"fault.motionY=-1"}, finding);
  EXPECT_EQ(finding.correction, Words{"fault.motionY=-1"});
  finding.regions = {placeOfShare(0.3), placeOfShare(0.25)};
  EXPECT_EQ(placeSettings(finding), Words()) << "most of the picture";
}

} // namespace taa::doctor
