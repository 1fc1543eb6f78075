// Verdicts and remedies on the command line: the figures that the window shows.
#include "core/io/FrameJson.h"
#include "core/settings/Parameters.h"
#include "tests/support/Batch.h"
#include "tests/support/SmallInspector.h"

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

using nlohmann::json;
using taa::floatText;
using taa::RemedyMeasure;
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
  EXPECT_EQ(value.dump(), floatText(static_cast<float>(expected)));
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
    taa::Settings settings;
    for (const std::string& change : kChanges) applyAssignment(settings, change);
    const auto inspector = opened({settings});
    inspector->shot().seek(kFrame);
    const taa::VerdictQuestion question{.frame = kFrame, .pixel = kWrong};
    answer_ = inspector->verdicts().of(question);
    remedies_ = inspector->verdicts().remedies(question, answer_.verdict);
  }
  taa::VerdictAnswer answer_;
  taa::RemedyAnswer remedies_;
};

TEST_F(VerdictCommandTest, PrintsWhatTheFacadeConcludes) {
  const taa::test::ProcessResult result = taa::test::batch(taa::test::joined(command(), {"--json"}));
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json lane = json::parse(result.out)["lanes"][0];
  EXPECT_EQ(lane["sentence"], answer_.sentence);
  EXPECT_EQ(lane["kind"], taa::kVerdictKinds[static_cast<std::size_t>(answer_.verdict.kind)].id);
  EXPECT_EQ(lane["stage"], taa::stageInfo(answer_.verdict.stage).id);
  expectValue(lane["error"], answer_.verdict.error);
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
    expectPixel(best["pixel"], remedies_.best[at].pixel);
    expectPicture(best["picture"], remedies_.best[at].picture);
  }
}

TEST_F(VerdictCommandTest, PrintsTheSameToPeople) {
  const taa::test::ProcessResult result = taa::test::batch(command());
  ASSERT_EQ(result.exitCode, 0) << result.err;
  ASSERT_FALSE(remedies_.best.empty());
  const RemedyMeasure &pixel = remedies_.best[0].pixel, &picture = *remedies_.best[0].picture;
  const auto text = [](double value) { return floatText(static_cast<float>(value)); };
  for (const std::string& words :
       {answer_.sentence, remedies_.best[0].remedy.changes[0],
        "pixel: error " + text(pixel.error) + ", its change " + text(pixel.errorChange),
        "picture: error " + text(picture.error) + ", flicker " + text(picture.flicker) + ", ghost " +
            text(picture.ghost) + ", sharpness " + text(picture.sharpness)})
    EXPECT_NE(result.out.find(words), std::string::npos) << words << "\n" << result.out;
}
