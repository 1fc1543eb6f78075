// The table of labelled pixels, and that of verdicts on them.
#include "tests/manual/VerdictLabels.h"

#include "core/base/Files.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Presets.h"
#include "tests/manual/Confusions.h"
#include "tests/support/ErrorOf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

using taa::JudgedLabel;
using taa::Stage;
using taa::VerdictKind;
using taa::VerdictLabel;

namespace {

const std::string kHead = "scene,preset,frame,x,y,kind,stages,why\n";
const std::string kJudgedHead =
    "scene,preset,frame,x,y,kind,stages,named,stage,remedy,pixelBefore,pixelAfter,"
    "pictureBefore,pictureAfter,why\n";

std::string errorOfTable(const std::string& text) {
  return taa::test::errorOf([&] { taa::verdictLabelsFrom(text, "labels"); });
}

std::vector<VerdictLabel> labelTable() {
  const std::string path = "tests/support/verdicts/labels.csv";
  return taa::verdictLabelsFrom(taa::readFile(path), path);
}

} // namespace

TEST(VerdictLabelsTable, HoldsPixelsOfAllScenesAndEightPresets) {
  const std::vector<VerdictLabel> labels = labelTable();
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
  for (const VerdictLabel& label : labelTable()) {
    scenes.insert(label.scene);
    if (label.kind != VerdictKind::None) continue;
    healthy.insert(label.scene);
    ++count;
  }
  EXPECT_GE(count, 50);
  EXPECT_EQ(healthy, scenes);
}

TEST(VerdictLabelsTable, BlamesAStageWhereSomethingIsWrongAndOnlyThere) {
  for (const VerdictLabel& label : labelTable()) {
    SCOPED_TRACE(label.scene + " " + label.preset + " " + std::to_string(label.pixel.x) + ", " +
                 std::to_string(label.pixel.y));
    const bool blames = std::ranges::find(label.stages, Stage::Reference) == label.stages.end();
    EXPECT_EQ(blames, label.kind != VerdictKind::None);
    EXPECT_LE(label.stages.size(), 3u);
    EXPECT_FALSE(label.why.empty());
    EXPECT_LT(label.pixel.x, taa::kLabelledSize.x);
    EXPECT_LT(label.pixel.y, taa::kLabelledSize.y);
  }
}

TEST(VerdictLabelsTable, IsReadColumnByColumn) {
  const std::vector<VerdictLabel> labels = taa::verdictLabelsFrom(
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

TEST(VerdictLabelsTable, JudgedIsWrittenAsItIsRead) {
  const std::string line = "fan,minimal,7,12,34,ghost,validate_history|rectify_history,lag,rectify_history,"
                           "validate.depth=on rectify.method=clamp,20.50,1.25,9.00,9.50,a trail, red\n";
  const std::vector<JudgedLabel> judged = taa::judgedLabelsFrom(kJudgedHead + line, "judged");
  ASSERT_EQ(judged.size(), 1u);
  const JudgedLabel& entry = judged.front();
  EXPECT_EQ(entry.label.kind, VerdictKind::Ghost);
  EXPECT_EQ(entry.kind, VerdictKind::Lag);
  EXPECT_EQ(entry.stage, Stage::RectifyHistory);
  EXPECT_EQ(entry.remedy.changes, "validate.depth=on rectify.method=clamp");
  EXPECT_EQ(entry.remedy.pixelAfter, 1.25);
  EXPECT_EQ(entry.remedy.pictureBefore, 9.0);
  EXPECT_EQ(entry.label.why, "a trail, red");
  EXPECT_EQ(taa::judgedLabelsText(judged), kJudgedHead + line);
  EXPECT_EQ(taa::test::errorOf([] { taa::judgedLabelsFrom(kHead, "judged"); }).find("judged: the first"), 0u);
}

TEST(VerdictLabelsTable, JudgedHoldsAllLabels) {
  const std::vector<VerdictLabel> labels = labelTable();
  const std::vector<JudgedLabel> judged = taa::judgedLabels();
  ASSERT_EQ(judged.size(), labels.size());
  for (std::size_t at = 0; at < labels.size(); ++at) {
    const VerdictLabel &said = labels[at], &written = judged[at].label;
    SCOPED_TRACE(said.scene + " " + said.preset + ": " + said.why);
    EXPECT_EQ(written.scene, said.scene);
    EXPECT_EQ(written.preset, said.preset);
    EXPECT_EQ(written.frame, said.frame);
    EXPECT_EQ(written.pixel, said.pixel);
    EXPECT_EQ(written.kind, said.kind);
    EXPECT_EQ(written.stages, said.stages);
    EXPECT_EQ(written.why, said.why);
  }
}

TEST(VerdictLabelsTable, VerdictsNameKindAndStageRight) {
  const taa::VerdictShares shares = taa::sharesRight(taa::judgedLabels());
  EXPECT_GE(shares.kind, 0.95);
  EXPECT_GE(shares.stage, 0.90);
}

TEST(VerdictLabelsTable, FirstRemediesLowerTheErrorOfNineFaultsInTen) {
  const std::vector<JudgedLabel> judged = taa::judgedLabels();
  const auto faults = std::ranges::count_if(
      judged, [](const JudgedLabel& entry) { return entry.label.kind != VerdictKind::None; });
  const taa::VerdictShares shares = taa::sharesRight(judged);
  EXPECT_EQ(shares.tried, static_cast<std::size_t>(faults)) << "TAA_VERDICTS=write";
  EXPECT_GE(shares.corrected, 0.9);
}
