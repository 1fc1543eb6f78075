// Verdicts on labelled pixels of all built-in scenes: as the committed table has them.
#include "core/report/verdicts/VerdictLabels.h"
#include "core/base/Files.h"
#include "core/inspect/Inspector.h"
#include "core/report/verdicts/Confusions.h"
#include "core/settings/Lanes.h"
#include "core/settings/Presets.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

using taa::JudgedLabel;
using taa::VerdictLabel;

namespace {

/// "all" judges every label and tries what mends it, ten minutes on two cores; "write" writes the table, too.
bool isVerdictsRun(std::string_view wanted) {
  const char* run = std::getenv("TAA_VERDICTS");
  return run != nullptr && run == wanted;
}

using LabelKey = std::tuple<std::string, std::string, int, int, int>;

LabelKey keyOf(const VerdictLabel& label) {
  return {label.scene, label.preset, label.frame, label.pixel.x, label.pixel.y};
}

/// The first of each kind in two scenes that hold all but lag and highlights.
std::vector<VerdictLabel> sampled(const std::vector<VerdictLabel>& labels) {
  std::vector<VerdictLabel> chosen;
  std::set<taa::VerdictKind> kinds;
  for (const VerdictLabel& label : labels)
    if ((label.scene == "thin" || label.scene == "glass") && kinds.insert(label.kind).second)
      chosen.push_back(label);
  return chosen;
}

std::vector<VerdictLabel> chosenLabels() {
  const auto path = taa::test::rootFolder() / "tests/support/verdicts/labels.csv";
  const std::vector<VerdictLabel> labels = taa::verdictLabelsFrom(taa::readFile(path), path.string());
  return isVerdictsRun("all") || isVerdictsRun("write") ? labels : sampled(labels);
}

/// Labels whose references are the same.
std::map<std::pair<std::string, int>, std::vector<VerdictLabel>>
byShot(const std::vector<VerdictLabel>& labels) {
  std::map<std::pair<std::string, int>, std::vector<VerdictLabel>> groups;
  for (const VerdictLabel& label : labels) groups[{label.scene, label.frame}].push_back(label);
  return groups;
}

std::vector<std::string> presetsOf(const std::vector<VerdictLabel>& labels) {
  std::vector<std::string> presets;
  for (const VerdictLabel& label : labels)
    if (std::ranges::find(presets, label.preset) == presets.end()) presets.push_back(label.preset);
  return presets;
}

taa::LabelRemedy firstRemedy(taa::Inspector& inspector, const taa::VerdictQuestion& question,
                             const taa::PixelVerdict& verdict) {
  const taa::RemedyAnswer answer = inspector.verdicts().remedies(question, verdict);
  taa::LabelRemedy first;
  first.pixelBefore = first.pixelAfter = 255.0 * answer.pixel.latest;
  if (answer.picture) first.pictureBefore = first.pictureAfter = 255.0 * answer.picture->error;
  if (answer.best.empty()) return first;
  const taa::TriedRemedy& best = answer.best.front();
  for (const std::string& change : best.remedy.changes)
    first.changes += (first.changes.empty() ? "" : " ") + change;
  first.pixelAfter = 255.0 * best.pixel.latest;
  if (best.picture) first.pictureAfter = 255.0 * best.picture->error;
  return first;
}

void judgeShot(const std::vector<VerdictLabel>& labels, std::vector<JudgedLabel>& judged) {
  const std::vector<std::string> presets = presetsOf(labels);
  ASSERT_LE(presets.size(), static_cast<std::size_t>(taa::kMaxLanes));
  std::vector<taa::Settings> lanes;
  for (const std::string& id : presets) lanes.push_back(taa::preset(id).settings);
  taa::Inspector inspector;
  inspector.shot().setSize(taa::kLabelledSize.x, taa::kLabelledSize.y);
  inspector.shot().setLanes(lanes);
  inspector.shot().open("builtin:" + labels.front().scene);
  inspector.shot().seek(labels.front().frame);
  for (const VerdictLabel& label : labels) {
    const auto lane = std::ranges::find(presets, label.preset) - presets.begin();
    const taa::VerdictQuestion question{
        .frame = label.frame, .pixel = label.pixel, .lane = static_cast<int>(lane)};
    const taa::VerdictAnswer answer = inspector.verdicts().of(question);
    JudgedLabel entry{label, answer.verdict.kind, answer.verdict.stage, {}};
    if (label.kind != taa::VerdictKind::None) {
      entry.remedy = firstRemedy(inspector, question, answer.verdict);
      std::cout << label.scene << ' ' << label.preset << ' ' << label.pixel.x << ',' << label.pixel.y << ": "
                << entry.remedy.changes << ' ' << entry.remedy.pixelBefore << " → " << entry.remedy.pixelAfter
                << std::endl;
    }
    judged.push_back(entry);
    if (!entry.isKindRight() || !entry.isStageRight())
      std::cout << label.scene << ' ' << label.preset << ' ' << label.pixel.x << ',' << label.pixel.y << " ("
                << label.why << "): " << answer.sentence << std::endl;
  }
}

} // namespace

class VerdictLabels : public taa::test::GlTest {};

TEST_F(VerdictLabels, AreJudgedAsTheTableHasThem) {
  const std::vector<VerdictLabel> labels = chosenLabels();
  ASSERT_GE(labels.size(), 6u);
  std::map<LabelKey, JudgedLabel> found;
  for (const auto& [shot, group] : byShot(labels)) {
    std::vector<JudgedLabel> judged;
    judgeShot(group, judged);
    for (JudgedLabel& entry : judged) found[keyOf(entry.label)] = std::move(entry);
  }
  ASSERT_EQ(found.size(), labels.size());
  std::vector<JudgedLabel> inOrder;
  for (const VerdictLabel& label : labels) inOrder.push_back(found.at(keyOf(label)));
  EXPECT_GE(taa::sharesRight(inOrder).mended, 0.9) << "first remedies lower the pixel's error";
  if (isVerdictsRun("write")) {
    const auto path = taa::test::rootFolder() / "resources/verdicts/judged.csv";
    taa::writeFile(path, taa::judgedLabelsText(inOrder));
    return;
  }
  for (const JudgedLabel& expected : taa::judgedLabels()) {
    const auto entry = found.find(keyOf(expected.label));
    if (entry == found.end()) continue;
    SCOPED_TRACE(expected.label.scene + " " + expected.label.preset + ": " + expected.label.why);
    EXPECT_EQ(entry->second.kind, expected.kind);
    EXPECT_EQ(entry->second.stage, expected.stage);
    found.erase(entry);
  }
  EXPECT_TRUE(found.empty()) << "the table has no line of " << found.size() << " labels: TAA_VERDICTS=write";
}
