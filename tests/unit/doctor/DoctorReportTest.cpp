// What the doctor says as text and as JSON: the same in both, and whole.
#include "core/report/doctor/DoctorReport.h"

#include "core/report/doctor/DoctorPage.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <string>

namespace taa {
namespace {

doctor::Diagnosis diagnosis() {
  doctor::Diagnosis out;
  out.frames = 8;
  out.pairs = 7;
  doctor::Finding finding;
  finding.id = "motionNegatedY";
  finding.name = "Motion's y negated";
  finding.confidence = doctor::Confidence::Likely;
  finding.regions = {{"object 2 (board)", 3, {70, 40, 106, 76}, {88, 58}, 0.125}};
  finding.reason = "It fits.";
  finding.measure = "mean difference of luma, × 1000";
  finding.residuals = {{"mirroredY", "y negated", 4.25, false, true},
                       {"asGiven", "as given", 61.5, true, false}};
  finding.symptom = "Ghosts.";
  finding.change = "Negate y.";
  finding.alike = {"motionNegated"};
  out.findings = {finding};
  out.parts.leaveOpen(
      {"Motion of the sky", "it has no detail", "Capture clouds.", {Fault::SkyWithoutMotion}});
  out.parts.addRight("Jitter", "Jitter is right.");
  out.notes = {"The first frame is not jittered."};
  return out;
}

} // namespace

TEST(DoctorReport, SaysAllInPlainText) {
  EXPECT_EQ(doctorText(diagnosis(), "shot"), R"(shot: 8 frames, 7 pairs compared

1. Motion's y negated (likely): object 2 (board)
  Seen as: Ghosts.
  Change: Negate y.
  Evidence: It fits.
  Look at: frame 3, pixel 88, 58
  mean difference of luma, × 1000:
      4.25  y negated  ← fits
      61.5  as given  ← what is stored

Right
  Jitter is right.

Not decided by these frames
  Motion of the sky: it has no detail. Capture clouds.

Notes
  The first frame is not jittered.
)");
}

TEST(DoctorReport, HasNoTableWhereNothingWasCompared) {
  doctor::Diagnosis plain = diagnosis();
  plain.findings[0].residuals.clear();
  const std::string text = doctorText(plain, "shot");
  EXPECT_EQ(text.find("mean difference"), std::string::npos);
  EXPECT_NE(text.find("pixel 88, 58\n\nRight"), std::string::npos) << text;
}

TEST(DoctorReport, SaysNumbersOfFrames) {
  doctor::Diagnosis numbered = diagnosis();
  numbered.frameNames = doctor::FrameNames({1001, 1002, 1003, 1004, 1005, 1006, 1007, 1008, 1009});
  numbered.first = 1;
  const std::string text = doctorText(numbered, "shot");
  EXPECT_TRUE(text.starts_with("shot: 8 frames (numbers 1002 to 1009), 7 pairs compared\n")) << text;
  EXPECT_NE(text.find("Look at: frame 3 (number 1004), pixel"), std::string::npos) << text;
  EXPECT_NE(doctorHtml(numbered, "shot").find("largest in frame 3 (number 1004)"), std::string::npos);
  const auto region = doctorJson(numbered, "shot")["findings"][0]["regions"][0];
  EXPECT_EQ(region["frame"], 3);
  EXPECT_EQ(region["number"], 1004);
}

TEST(DoctorReport, SaysSoWhereNothingIsWrong) {
  doctor::Diagnosis healthy;
  EXPECT_EQ(doctorText(healthy, "shot"), "shot: 0 frames, 0 pairs compared\nNothing wrong was found.\n");
  EXPECT_TRUE(doctorJson(healthy, "shot")["healthy"]);
}

// What contradicts what is stated is no "nothing wrong", in no form of the report.
TEST(DoctorReport, SaysWhatDoesNotFitWhereNothingIsWrong) {
  doctor::Diagnosis misfit;
  misfit.parts.leaveOpen({"Jitter", "measured shifts are 0.609 px from those that are stated", "", {}, true});
  const std::string sentence = "Nothing is wrong in what could be decided, but not everything fits: Jitter.";
  EXPECT_EQ(doctorText(misfit, "shot").find("Nothing wrong"), std::string::npos);
  EXPECT_NE(doctorText(misfit, "shot").find(sentence), std::string::npos);
  EXPECT_NE(doctorHtml(misfit, "shot").find("<p>" + sentence + "</p>"), std::string::npos);
  EXPECT_FALSE(doctorJson(misfit, "shot")["healthy"]);
  EXPECT_TRUE(doctorJson(misfit, "shot")["undecided"][0]["misfit"]);
}

// A report goes to others: it says the folder's name, and not where it lies.
TEST(DoctorReport, IsOfAFolderByItsName) {
  for (const char* source : {"/home/somebody/frames/corridor", "/home/somebody/frames/corridor/"}) {
    EXPECT_TRUE(doctorText({}, source).starts_with("corridor: ")) << source;
    EXPECT_EQ(doctorJson({}, source)["source"], "corridor");
    EXPECT_NE(doctorHtml({}, source).find("<title>What the doctor says of corridor</title>"),
              std::string::npos);
    EXPECT_EQ(doctorHtml({}, source).find("somebody"), std::string::npos);
  }
  EXPECT_EQ(reportedName("builtin:fan"), "builtin:fan");
}

TEST(DoctorReport, SaysTheSameInJson) {
  EXPECT_EQ(
      doctorJson(diagnosis(), "shot").dump(),
      R"j({"source":"shot","frames":8,"pairs":7,"healthy":false,"findings":[{"id":"motionNegatedY",)j"
      R"j("name":"Motion's y negated","sure":false,"known":false,"wholePicture":false,"regions":[{"name":)j"
      R"j("object 2 (board)","frame":3,"box":[70,40,106,76],"pixel":[88,58],"share":0.125}],)j"
      R"j("reason":"It fits.","measure":"mean difference of luma, × 1000","residuals":[{"id":)j"
      R"j("mirroredY","text":"y negated","value":4.25,"given":false,"best":true},{"id":"asGiven",)j"
      R"j("text":"as given","value":61.5,"given":true,"best":false}],"symptom":"Ghosts.","change":)j"
      R"j("Negate y.","mending":[],"alike":["motionNegated"]}],"undecided":[{"question":"Motion of the sky",)j"
      R"j("reason":"it has no detail","capture":"Capture clouds.","misfit":false,"faults":["skyWithoutMotion"]}],)j"
      R"j("right":["Jitter is right."],"notes":["The first frame is not jittered."]})j");
}

} // namespace taa
