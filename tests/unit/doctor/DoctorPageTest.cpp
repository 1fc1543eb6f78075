// The page of what the doctor says: whole, and nothing that is fetched or run.
#include "core/report/doctor/DoctorPage.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace taa {
namespace {

doctor::Diagnosis shownDiagnosis() {
  doctor::Diagnosis out;
  out.frames = 8;
  out.pairs = 7;
  doctor::Finding finding;
  finding.name = "Motion's y negated";
  finding.confidence = doctor::Confidence::Likely;
  finding.regions = {{"object 2 (<board>)", 3, {70, 40, 106, 76}, {88, 58}, 0.125}};
  finding.reason = "It fits.";
  finding.measure = "mean difference of luma, × 1000";
  finding.residuals = {{"mirroredY", "y negated", 15.0, false, true},
                       {"asGiven", "as given", 60.0, true, false}};
  finding.symptom = "Ghosts.";
  finding.change = "Negate y.";
  out.findings = {finding};
  out.parts.leaveOpen({"Motion of the sky", "it has no detail", "Capture clouds."});
  out.parts.addRight("Jitter", "Jitter is right.");
  out.notes = {"The first frame is not jittered."};
  return out;
}

bool isIn(const std::string& page, const std::string& text) {
  return page.find(text) != std::string::npos;
}

} // namespace

TEST(DoctorPage, SaysAllThatIsSaid) {
  const std::string page = doctorHtml(shownDiagnosis(), "shot");
  for (const char* text :
       {"<h1>What the doctor says of shot</h1>", "8 frames, 7 pairs compared",
        "1. Motion's y negated (likely)", "largest in frame 3, pixels 70, 40 to 105, 75, for example 88, 58",
        "Ghosts.", "Negate y.", "It fits.", "mean difference of luma, × 1000", "y negated", "as given",
        "Motion of the sky: it has no detail. Capture clouds.", "Jitter is right.",
        "The first frame is not jittered."})
    EXPECT_TRUE(isIn(page, text)) << text;
}

TEST(DoctorPage, ShowsRegionsInTheFrameThatTheyAreIn) {
  doctor::Diagnosis shown = shownDiagnosis();
  const auto images = [](const std::string& page) {
    std::size_t count = 0;
    for (std::size_t at = page.find("<image"); at != page.npos; at = page.find("<image", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(images(doctorHtml(shown, "shot")), 0u) << "nothing was kept";
  shown.pictures[3] = Image(160, 96, 1);
  EXPECT_EQ(images(doctorHtml(shown, "shot")), 1u);
}

TEST(DoctorPage, SaysNoPixelsOfAWholeFrame) {
  doctor::Diagnosis shown = shownDiagnosis();
  shown.findings[0].regions[0].name = "frame 9";
  shown.findings[0].regions[0].isWholeFrame = true;
  const std::string page = doctorHtml(shown, "shot");
  EXPECT_TRUE(isIn(page, "<dd>frame 9</dd>"));
  EXPECT_FALSE(isIn(page, "largest in frame"));
}

TEST(DoctorPage, DrawsResidualsAsBarsByTheLargest) {
  const std::string page = doctorHtml(shownDiagnosis(), "shot");
  EXPECT_TRUE(isIn(page, "<tr class=\"fits\"><td>y negated</td><td>fits</td><td class=\"number\">15</td><td "
                         "class=\"bar\"><div class=\"bar\" style=\"width:25%\">"));
  EXPECT_TRUE(isIn(page, "style=\"width:100%\""));
}

TEST(DoctorPage, RunsAndFetchesNothing) {
  const std::string page = doctorHtml(shownDiagnosis(), "<script src=\"https://x\">");
  for (const char* text : {"<script", "<link", "<img", "<iframe", "url(", "@import"})
    EXPECT_FALSE(isIn(page, text)) << text;
  EXPECT_TRUE(isIn(page, "object 2 (&lt;board&gt;)"));
}

TEST(DoctorPage, SaysSoWhereNothingIsWrong) {
  EXPECT_TRUE(isIn(doctorHtml({}, "shot"), "<p>Nothing wrong was found.</p>"));
}

TEST(DoctorPage, OutlinesRegionsOverTheirPictures) {
  doctor::Diagnosis diagnosis = shownDiagnosis();
  diagnosis.sizePx = {160, 96};
  diagnosis.findings[0].regions[0].pixels = {{5, 10, 20}};
  EXPECT_TRUE(isIn(doctorHtml(diagnosis, "shot"),
                   "viewBox=\"0 0 160 96\"><path d=\"M10 5H20M10 5V6M20 5V6M10 6H20\"/>"));
  doctor::CorrectedLook look;
  look.corrected.findings = {0};
  look.pictures = {{0, 3, Image(2, 1, 3), Image(2, 1, 3)}};
  look.lastFrame = 7;
  look.givenPsnr = 24.5;
  look.correctedPsnr = 33.0;
  const std::string page = doctorHtml(diagnosis, "shot", &look);
  for (const char* text : {"href=\"data:image/png;base64,iVBOR", "Frame 3 as it is", "Frame 3 mended",
                           "PSNR of frame 7: 24.5 dB as it is, 33 dB mended", "Nothing wrong is found then."})
    EXPECT_TRUE(isIn(page, text)) << text;
}

} // namespace taa
