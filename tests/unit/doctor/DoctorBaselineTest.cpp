// Known findings: what a file of them says, which findings they cover, and which are news.
#include "core/report/doctor/DoctorBaseline.h"

#include "core/base/Error.h"
#include "core/report/doctor/DoctorReport.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace taa {
namespace {

doctor::Finding findingIn(const std::string& id, const std::vector<std::string>& regions) {
  doctor::Finding finding;
  finding.id = id;
  finding.name = id;
  finding.isWholePicture = regions.empty();
  for (const std::string& name : regions) {
    doctor::RegionPlace place;
    place.name = name;
    finding.regions.push_back(place);
  }
  return finding;
}

doctor::Diagnosis wrongIn(const std::vector<doctor::Finding>& findings) {
  doctor::Diagnosis diagnosis;
  diagnosis.findings = findings;
  return diagnosis;
}

std::string refusal(const std::string& text) {
  try {
    baselineFromText(text, "known.json");
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

} // namespace

TEST(DoctorBaseline, ListsEachRegionOnce) {
  const doctor::Diagnosis diagnosis =
      wrongIn({findingIn("motionZero", {"the sky", "object 7"}), findingIn("motionZero", {"the sky"}),
               findingIn("jitterNegated", {})});
  EXPECT_EQ(baselineOf(diagnosis),
            (DoctorBaseline{{"jitterNegated", ""}, {"motionZero", "object 7"}, {"motionZero", "the sky"}}));
}

TEST(DoctorBaseline, IsReadAsItWasWritten) {
  const DoctorBaseline baseline{{"jitterNegated", ""}, {"motionZero", "object 7 (\"wheel\")"}};
  EXPECT_EQ(baselineFromText(baselineToText(baseline), "known.json"), baseline);
  EXPECT_TRUE(baselineFromText(baselineToText({}), "known.json").empty());
}

TEST(DoctorBaseline, CoversFindingsWhoseRegionsAreAllInIt) {
  const DoctorBaseline baseline{{"motionZero", "the sky"}, {"motionZero", "object 7"}};
  EXPECT_TRUE(isKnown(findingIn("motionZero", {"the sky"}), baseline));
  EXPECT_TRUE(isKnown(findingIn("motionZero", {"object 7", "the sky"}), baseline));
  EXPECT_FALSE(isKnown(findingIn("motionZero", {"the sky", "object 8"}), baseline));
  EXPECT_FALSE(isKnown(findingIn("motionHalved", {"the sky"}), baseline));
  EXPECT_FALSE(isKnown(findingIn("motionZero", {}), baseline)) << "it has grown to the whole picture";
}

TEST(DoctorBaseline, OfTheWholePictureCoversItsRegions) {
  const DoctorBaseline baseline{{"motionZero", ""}};
  EXPECT_TRUE(isKnown(findingIn("motionZero", {}), baseline));
  EXPECT_TRUE(isKnown(findingIn("motionZero", {"the sky"}), baseline));
}

TEST(DoctorBaseline, TellsNewsFromWhatIsKnown) {
  doctor::Diagnosis diagnosis =
      wrongIn({findingIn("motionZero", {"the sky"}), findingIn("jitterNegated", {})});
  EXPECT_TRUE(diagnosis.hasNews());
  markKnown(diagnosis, {{"motionZero", "the sky"}});
  EXPECT_TRUE(diagnosis.findings[0].isKnown);
  EXPECT_TRUE(diagnosis.hasNews());
  EXPECT_NE(doctorText(diagnosis, "s").find("motionZero (known)"), std::string::npos);
  EXPECT_EQ(doctorText(diagnosis, "s").find("jitterNegated (known)"), std::string::npos);
  markKnown(diagnosis, baselineOf(diagnosis));
  EXPECT_FALSE(diagnosis.hasNews());
  EXPECT_FALSE(diagnosis.isHealthy());
  EXPECT_NE(doctorText(diagnosis, "s").find("Nothing was found that is not known."), std::string::npos);
}

TEST(DoctorBaseline, SaysWhatIsWrongWithAFile) {
  const std::string no = "known.json is no baseline of the doctor: ";
  EXPECT_EQ(refusal("[1, 2"), no + "it ends in line 1, column 6, before it is whole");
  EXPECT_EQ(refusal("[]"), no + "what the file holds is not an object");
  EXPECT_EQ(refusal(R"({"know": []})"), no + "there is no key \"know\"; near it is \"known\"");
  EXPECT_EQ(refusal("{}"), no + "the key \"known\" is missing");
  EXPECT_EQ(refusal(R"({"known": 3})"), no + "\"known\" is not a list");
  EXPECT_EQ(refusal(R"({"known": [3]})"), no + "\"known[0]\" is not an object");
  EXPECT_EQ(refusal(R"({"known": [{"id": "motionZero"}]})"), no + "the key \"known[0].region\" is missing");
  EXPECT_EQ(refusal(R"({"known": [{"id": 3, "region": ""}]})"), no + "\"known[0].id\" is not text");
}

} // namespace taa
