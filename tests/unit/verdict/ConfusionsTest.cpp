// What is counted of verdicts on labelled pixels, and the page of the manual that says it.
#include "tests/manual/Confusions.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

using taa::JudgedLabel;
using taa::Stage;
using taa::VerdictKind;
using taa::VerdictLabel;
using taa::VerdictShares;

namespace {

JudgedLabel judged(VerdictKind said, std::vector<Stage> stages, VerdictKind named, Stage stage) {
  VerdictLabel label;
  label.scene = "fan";
  label.preset = "minimal";
  label.frame = 7;
  label.pixel = {12, 34};
  label.kind = said;
  label.stages = std::move(stages);
  label.why = "a trail";
  return {label, named, stage, {}};
}

std::vector<JudgedLabel> four() {
  return {judged(VerdictKind::None, {Stage::Reference}, VerdictKind::None, Stage::Reference),
          judged(VerdictKind::Ghost, {Stage::ValidateHistory, Stage::RectifyHistory}, VerdictKind::Ghost,
                 Stage::RectifyHistory),
          judged(VerdictKind::Ghost, {Stage::DilateMotion}, VerdictKind::Lag, Stage::DilateMotion),
          judged(VerdictKind::Blur, {Stage::SampleHistory}, VerdictKind::Blur, Stage::FilterCurrent)};
}

} // namespace

TEST(Confusions, CountKindsAndStagesApart) {
  std::vector<JudgedLabel> judged = four();
  judged[1].remedy = {"validate.depth=on", 20.0, 2.0, 9.0, 8.0};
  judged[2].remedy = {"validate.depth=on", 20.0, 21.0, 9.0, 8.0}; // it trembles less
  const VerdictShares shares = taa::sharesRight(judged);
  EXPECT_DOUBLE_EQ(shares.kind, 0.75);
  EXPECT_DOUBLE_EQ(shares.stage, 0.75);
  EXPECT_DOUBLE_EQ(shares.faultsKind, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(shares.faultsStage, 2.0 / 3.0);
  EXPECT_EQ(shares.tried, 2u) << "nothing was tried on the third fault";
  EXPECT_DOUBLE_EQ(shares.corrected, 0.5);
  EXPECT_EQ(taa::sharesRight({}).kind, 0.0);
}

TEST(Confusions, AreATableWithEveryMistake) {
  std::vector<JudgedLabel> judged = four();
  judged[1].remedy = {"validate.depth=on", 20.0, 2.0, 9.0, 8.0};
  judged[2].remedy = {"rectify.method=clamp", 20.0, 21.0, 9.0, 8.0};
  const std::string text = taa::confusionsText(judged);
  EXPECT_NE(text.find("| Ghost |  | 1 |  |  |  |  |  |  | 1 | 100.0 % |"), std::string::npos) << text;
  EXPECT_NE(text.find("kind right in 75.0 % of 4 labelled pixels and the stage in 75.0 %"),
            std::string::npos);
  EXPECT_NE(text.find("tried on 2 of these; the first lowers the pixel's error in 50.0 %"), std::string::npos)
      << text;
  EXPECT_NE(taa::confusionsText(four()).find("Remedies have not been tried on them."), std::string::npos);
  EXPECT_NE(text.find("| fan | minimal | 7 | 12, 34 | a trail | blur, `sample_history` | blur, "
                      "`filter_current` |"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("none, `reference` |"), std::string::npos) << "what is right is no mistake";
  EXPECT_NE(text.find("| a trail | `rectify.method=clamp` |"), std::string::npos) << text;
  EXPECT_EQ(text.find("| a trail | `validate.depth=on` |"), std::string::npos) << "it mends";
  EXPECT_NE(text.find("| Ghost | 2 | 1 | 1 | 0 |\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("| Blur | 0 |"), std::string::npos) << "nothing was tried on it";
  judged[2].remedy = {"", 20.0, 20.0, 9.0, 9.0};
  EXPECT_NE(taa::confusionsText(judged).find("| Ghost | 2 | 1 | 0 | 1 |\n"), std::string::npos);
}
