// The table of labelled pixels, and what is counted of verdicts on them.
#include "tests/support/verdicts/VerdictLabels.h"

#include "core/scene/SceneSource.h"
#include "core/settings/Presets.h"
#include "tests/support/ErrorOf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

using taa::Stage;
using taa::VerdictKind;
using taa::test::JudgedLabel;
using taa::test::VerdictLabel;
using taa::test::VerdictShares;

namespace {

const std::string kHead = "scene,preset,frame,x,y,kind,stages,why\n";

std::string errorOfTable(const std::string& text) {
  return taa::test::errorOf([&] { taa::test::verdictLabelsFrom(text, "labels"); });
}

JudgedLabel judged(VerdictKind said, std::vector<Stage> stages, VerdictKind named, Stage stage) {
  VerdictLabel label;
  label.scene = "fan";
  label.preset = "minimal";
  label.frame = 7;
  label.pixel = {12, 34};
  label.kind = said;
  label.stages = std::move(stages);
  label.why = "a trail";
  return {label, named, stage};
}

std::vector<JudgedLabel> four() {
  return {judged(VerdictKind::None, {Stage::Reference}, VerdictKind::None, Stage::Reference),
          judged(VerdictKind::Ghost, {Stage::ValidateHistory, Stage::RectifyHistory}, VerdictKind::Ghost,
                 Stage::RectifyHistory),
          judged(VerdictKind::Ghost, {Stage::DilateMotion}, VerdictKind::Lag, Stage::DilateMotion),
          judged(VerdictKind::Blur, {Stage::SampleHistory}, VerdictKind::Blur, Stage::FilterCurrent)};
}

} // namespace

TEST(VerdictLabelsTable, HoldsPixelsOfAllScenesAndEightPresets) {
  const std::vector<VerdictLabel> labels = taa::test::verdictLabels();
  EXPECT_GE(labels.size(), 200u);
  std::set<std::string> scenes, presets;
  for (const VerdictLabel& label : labels) {
    scenes.insert(label.scene);
    presets.insert(label.preset);
  }
  std::set<std::string> builtin;
  for (const taa::BuiltinScene& scene : taa::builtinScenes()) builtin.insert(scene.id);
  EXPECT_EQ(scenes, builtin);
  EXPECT_GE(presets.size(), 8u);
  for (const std::string& id : presets) EXPECT_EQ(taa::preset(id).id, id);
}

TEST(VerdictLabelsTable, HoldsPixelsWithNothingWrongOfAllScenes) {
  std::set<std::string> scenes, healthy;
  int count = 0;
  for (const VerdictLabel& label : taa::test::verdictLabels()) {
    scenes.insert(label.scene);
    if (label.kind != VerdictKind::None) continue;
    healthy.insert(label.scene);
    ++count;
  }
  EXPECT_GE(count, 50);
  EXPECT_EQ(healthy, scenes);
}

TEST(VerdictLabelsTable, BlamesAStageWhereSomethingIsWrongAndOnlyThere) {
  for (const VerdictLabel& label : taa::test::verdictLabels()) {
    SCOPED_TRACE(label.scene + " " + label.preset + " " + std::to_string(label.pixel.x) + ", " +
                 std::to_string(label.pixel.y));
    const bool blames = std::ranges::find(label.stages, Stage::Reference) == label.stages.end();
    EXPECT_EQ(blames, label.kind != VerdictKind::None);
    EXPECT_LE(label.stages.size(), 3u);
    EXPECT_FALSE(label.why.empty());
    EXPECT_LT(label.pixel.x, taa::test::kLabelledSize.x);
    EXPECT_LT(label.pixel.y, taa::test::kLabelledSize.y);
  }
}

TEST(VerdictLabelsTable, IsReadColumnByColumn) {
  const std::vector<VerdictLabel> labels = taa::test::verdictLabelsFrom(
      kHead + "fan,minimal,7,12,34,ghost,validate_history|rectify_history,a trail, red\n", "labels");
  ASSERT_EQ(labels.size(), 1u);
  const VerdictLabel& label = labels.front();
  EXPECT_EQ(label.scene, "fan");
  EXPECT_EQ(label.preset, "minimal");
  EXPECT_EQ(label.frame, 7);
  EXPECT_EQ(label.pixel, glm::ivec2(12, 34));
  EXPECT_EQ(label.kind, VerdictKind::Ghost);
  EXPECT_EQ(label.stages, (std::vector<Stage>{Stage::ValidateHistory, Stage::RectifyHistory}));
  EXPECT_EQ(label.why, "a trail, red");
}

TEST(VerdictLabelsTable, ThatIsWrongIsRefusedWithItsLine) {
  EXPECT_NE(errorOfTable("scene\n").find("the first line must be"), std::string::npos);
  EXPECT_EQ(errorOfTable(kHead + "fan,minimal,7,12,34,haze,blend,why\n"),
            "labels:2: there is no kind of verdict \"haze\"");
  EXPECT_EQ(errorOfTable(kHead + "fan,minimal,7,12,34,ghost,blending,why\n"),
            "labels:2: there is no stage \"blending\"");
  EXPECT_EQ(errorOfTable(kHead + "fan,minimal,-7,12,34,ghost,blend,why\n"), "labels:2: \"-7\" is no number");
  EXPECT_NE(errorOfTable(kHead + "fan,minimal\n").find("labels:2: "), std::string::npos);
}

TEST(VerdictLabelsTable, CountsKindsAndStagesApart) {
  const VerdictShares shares = taa::test::sharesRight(four());
  EXPECT_DOUBLE_EQ(shares.kind, 0.75);
  EXPECT_DOUBLE_EQ(shares.stage, 0.75);
  EXPECT_DOUBLE_EQ(shares.faultsStage, 2.0 / 3.0);
  EXPECT_EQ(taa::test::sharesRight({}).kind, 0.0);
}

TEST(VerdictLabelsTable, IsAPageOfConfusionsAndMistakes) {
  const std::string page = taa::test::confusionsPage(four());
  EXPECT_NE(page.find("| Ghost |  | 1 |  |  |  |  |  |  | 1 | 100.0 % |"), std::string::npos) << page;
  EXPECT_NE(page.find("kind right in 75.0 % of them and the stage in 75.0 %"), std::string::npos) << page;
  EXPECT_NE(page.find("| fan | minimal | 7 | 12, 34 | a trail | blur, `sample_history` | blur, "
                      "`filter_current` |"),
            std::string::npos)
      << page;
  EXPECT_EQ(page.find("none, `reference` |"), std::string::npos) << "what is right is no mistake";
}
