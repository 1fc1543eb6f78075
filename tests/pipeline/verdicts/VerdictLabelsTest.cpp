// Verdicts on labelled pixels of all built-in scenes: as the committed table has them.
#include "tests/manual/VerdictLabels.h"
#include "core/base/Files.h"
#include "core/inspect/Inspector.h"
#include "core/inspect/RemedyTrial.h"
#include "core/measure/Metrics.h"
#include "core/settings/Lanes.h"
#include "core/settings/Presets.h"
#include "tests/manual/Confusions.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

/// "all" judges every label and tries what corrects it, ten minutes on two cores; "write" writes the table,
/// too.
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

taa::LabelRemedy firstRemedy(const taa::RemedyAnswer& answer) {
  taa::LabelRemedy first;
  first.pixelBefore = first.pixelAfter = 255.0 * answer.pixel.latest;
  if (answer.picture) first.pictureBefore = first.pictureAfter = 255.0 * answer.picture->error;
  // What the verdict names is told though nothing helps, and says so: no remedy then.
  if (answer.best.empty() || !isCorrection(answer.pixel, answer.best.front().pixel)) return first;
  const taa::TriedRemedy& best = answer.best.front();
  for (const std::string& change : best.remedy.changes)
    first.changes += (first.changes.empty() ? "" : " ") + change;
  first.pixelAfter = 255.0 * best.pixel.latest;
  if (best.picture) first.pictureAfter = 255.0 * best.picture->error;
  return first;
}

/// Of the pictures from a frame to another: root of the mean squared error of what a screen is sent.
double shownError(taa::Inspector& inspector, int first, int last) {
  double sum = 0.0, count = 0.0;
  for (int frame = first; frame <= last; ++frame) {
    inspector.shot().seek(frame);
    inspector.reference().refine(taa::kVerdictSamples);
    const taa::Image shown = taa::shownColors(inspector.views().image(taa::IntermediateId::resolved));
    const taa::Image reference = taa::shownColors(inspector.views().image(taa::IntermediateId::reference));
    for (std::size_t at = 0; at < shown.pixels.size(); ++at) {
      const double error = double(shown.pixels[at]) - double(reference.pixels[at]);
      sum += error * error;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

/// The pictures with the first remedy are no farther off than it says.
void expectCostAsSaid(taa::Inspector& inspector, const VerdictLabel& label, const taa::RemedyAnswer& answer) {
  if (answer.best.empty()) return;
  const taa::TriedRemedy& best = answer.best.front();
  ASSERT_TRUE(best.picture && answer.picture);
  inspector.shot().setLanes({best.remedy.settings});
  const int first = std::max(answer.first, label.frame - taa::kMeasuredFrames + 1);
  EXPECT_LE(shownError(inspector, first, label.frame), best.picture->error + 1e-6)
      << label.scene << " " << label.preset << ": " << testing::PrintToString(best.remedy.changes);
}

void judgeShot(const std::vector<VerdictLabel>& labels, std::vector<JudgedLabel>& judged) {
  const std::vector<std::string> presets = presetsOf(labels);
  ASSERT_LE(presets.size(), static_cast<std::size_t>(taa::kMaxLanes));
  std::vector<taa::Settings> lanes;
  for (const std::string& id : presets) {
    lanes.push_back(taa::preset(id).settings);
    lanes.back().inputs.shadows = taa::Shadows::None; // labels were given before the scenes had any
  }
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
      const taa::RemedyAnswer remedies = inspector.verdicts().remedies(question, answer);
      entry.remedy = firstRemedy(remedies);
      std::cout << label.scene << ' ' << label.preset << ' ' << label.pixel.x << ',' << label.pixel.y << ": "
                << entry.remedy.changes << ' ' << entry.remedy.pixelBefore << " → " << entry.remedy.pixelAfter
                << std::endl;
      expectCostAsSaid(inspector, label, remedies);
      inspector.shot().setLanes(lanes);
      inspector.shot().seek(label.frame);
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
  EXPECT_GE(taa::sharesRight(inOrder).corrected, 0.9) << "first remedies lower the pixel's error";
  if (isVerdictsRun("write")) {
    const auto path = taa::test::rootFolder() / taa::kJudgedLabelsFile;
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
