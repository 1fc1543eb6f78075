// Verdicts and remedies on the command line: the figures that the window shows.
#include "core/base/NumberText.h"
#include "core/explanation/RowFormatter.h"
#include "core/io/FrameJson.h"
#include "core/settings/Parameters.h"
#include "tests/support/Batch.h"
#include "tests/support/SmallInspector.h"

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using nlohmann::json;
using taa::RemedyMeasure;
using taa::shortestText;
using namespace taa::test::small;

namespace {

constexpr int kFrame = 14;
constexpr glm::ivec2 kWrong{15, 6}; ///< where a blade has been
const std::vector<std::string> kChanges{"rectify.method=none", "validate.depth=off"};

/// Of the pixel, with remedies.
std::vector<std::string> command() {
  std::vector<std::string> arguments{"verdict", "builtin:fan", "--size",  "48x27",
                                     "--frame", "14",          "--pixel", "15,6"};
  for (const std::string& change : kChanges) arguments.insert(arguments.end(), {"--set", change});
  arguments.emplace_back("--remedies");
  return arguments;
}

void expectValue(const json& value, double expected) {
  EXPECT_EQ(value.dump(), shortestText(static_cast<float>(expected)));
}

void expectPixel(const json& value, const RemedyMeasure& expected) {
  expectValue(value["error"], expected.error);
  expectValue(value["errorChange"], expected.errorChange);
}

void expectPicture(const json& value, const std::optional<RemedyMeasure>& expected) {
  ASSERT_TRUE(expected);
  expectValue(value["error"], expected->error);
  expectValue(value["flicker"], expected->flicker);
  expectValue(value["ghost"], expected->ghost);
  expectValue(value["sharpness"], expected->sharpness);
}

} // namespace

class VerdictCommandTest : public InspectorTest {
 protected:
  void SetUp() override {
    InspectorTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    static const auto both = askedOnce(); // trying remedies takes seconds
    answer_ = both.first;
    remedies_ = both.second;
  }
  taa::VerdictAnswer answer_;
  taa::RemedyAnswer remedies_;

 private:
  static std::pair<taa::VerdictAnswer, taa::RemedyAnswer> askedOnce() {
    taa::Settings settings;
    for (const std::string& change : kChanges) applyAssignment(settings, change);
    const auto inspector = opened({settings});
    inspector->shot().seek(kFrame);
    const taa::VerdictQuestion question{.frame = kFrame, .pixel = kWrong};
    const taa::VerdictAnswer answer = inspector->verdicts().of(question);
    return {answer, inspector->verdicts().remedies(question, answer)};
  }
};

TEST_F(VerdictCommandTest, PrintsWhatTheFacadeConcludes) {
  const taa::test::ProcessResult result = taa::test::batch(taa::test::joined(command(), {"--json"}));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json lane = json::parse(result.out)["lanes"][0];
  EXPECT_EQ(lane["sentence"], answer_.sentence);
  EXPECT_EQ(lane["kind"], taa::kVerdictKinds[static_cast<std::size_t>(answer_.verdict.kind)].id);
  EXPECT_EQ(lane["stage"], taa::stageInfo(answer_.verdict.stage).id);
  expectValue(lane["error"], answer_.verdict.error);
  EXPECT_EQ(lane["referenceSamples"], answer_.samples);
  ASSERT_TRUE(answer_.referenceError);
  expectValue(lane["referenceError"], *answer_.referenceError);
  EXPECT_EQ(lane["rows"].size(), answer_.verdict.rows.size());
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto at = static_cast<glm::length_t>(channel);
    expectValue(lane["resolved"][channel], answer_.error.resolved[at]);
    expectValue(lane["parts"]["errorGhost"][channel], of(answer_.error.sum, taa::ErrorPart::Ghost)[at]);
  }
  ASSERT_FALSE(remedies_.best.empty());
  EXPECT_EQ(lane["remedies"]["tried"], remedies_.tried);
  expectPixel(lane["remedies"]["pixel"], remedies_.pixel);
  expectPicture(lane["remedies"]["picture"], remedies_.picture);
  ASSERT_EQ(lane["remedies"]["best"].size(), remedies_.best.size());
  for (std::size_t at = 0; at < remedies_.best.size(); ++at) {
    const json& best = lane["remedies"]["best"][at];
    EXPECT_EQ(best["changes"], json(remedies_.best[at].remedy.changes));
    EXPECT_EQ(best["named"], remedies_.best[at].isNamed);
    EXPECT_EQ(best["costsPicture"], costsPicture(*remedies_.picture, *remedies_.best[at].picture));
    expectPixel(best["pixel"], remedies_.best[at].pixel);
    expectPicture(best["picture"], remedies_.best[at].picture);
  }
}

TEST_F(VerdictCommandTest, PrintsTheSameToPeople) {
  const taa::test::ProcessResult result = taa::test::batch(command());
  ASSERT_EQ(result.exitCode, 0) << result.err;
  ASSERT_FALSE(remedies_.best.empty());
  const RemedyMeasure &before = remedies_.pixel, &after = remedies_.best[0].pixel;
  const auto change = [](double from, double to) {
    return taa::numberText(255.0 * from, 3) + " → " + taa::numberText(255.0 * to, 3);
  };
  const auto psnr = [](const RemedyMeasure& picture) { return taa::numberText(psnrOf(picture), 4); };
  for (const std::string& words :
       {answer_.sentence, remedies_.best[0].remedy.changes[0],
        "pixel: error " + change(before.error, after.error) + ", in this frame " +
            change(before.latest, after.latest),
        "picture: PSNR " + psnr(*remedies_.picture) + " → " + psnr(*remedies_.best[0].picture) + " dB",
        remedyNote(remedies_.best[0], before, remedies_.picture),
        "Reference: " + std::to_string(answer_.samples) + " samples", std::string("Checked blind: ")})
    EXPECT_NE(result.out.find(words), std::string::npos) << words << "\n" << result.out;
}
