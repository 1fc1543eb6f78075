// The worst pixels of a shot's frame, and what taa-batch says of the whole picture.
#include "core/base/Error.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"
#include "tests/support/SmallInspector.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

using nlohmann::json;
using taa::Image;
using taa::IntermediateId;
using taa::WorstPixel;
using namespace taa::test::small;

class WorstOfShotTest : public InspectorTest {};

TEST_F(WorstOfShotTest, AreWhereTheRowIsLargest) {
  const auto inspector = opened();
  inspector->shot().seek(5);
  EXPECT_THROW(inspector->worst().of({}), taa::Error) << "there is no reference yet";
  inspector->reference().refine(4);
  const Image error = inspector->views().image(IntermediateId::referenceErrorAbs);
  const std::vector<WorstPixel> worst = inspector->worst().of({.count = 3, .apartPx = 4});
  ASSERT_EQ(worst.size(), 3u);
  EXPECT_EQ(worst[0].badness, *std::ranges::max_element(error.pixels));
  for (const WorstPixel& found : worst) EXPECT_EQ(found.badness, *error.at(found.pixel.x, found.pixel.y));
}

TEST_F(WorstOfShotTest, OfARejectReasonAreThoseItRejects) {
  const auto inspector = opened();
  inspector->shot().seek(5);
  const Image reasons = inspector->views().image(IntermediateId::rejectReason);
  const float reason = *std::ranges::max_element(reasons.pixels);
  ASSERT_GT(reason, 0.0f) << "the fan uncovers what is behind it";
  const taa::WorstQuestion question{.row = IntermediateId::rejectReason,
                                    .category = static_cast<int>(reason)};
  for (const bool hasReference : {false, true}) {
    if (hasReference) inspector->reference().refine(4);
    const std::vector<WorstPixel> worst = inspector->worst().of(question);
    ASSERT_FALSE(worst.empty());
    for (const WorstPixel& found : worst) EXPECT_EQ(*reasons.at(found.pixel.x, found.pixel.y), reason);
    EXPECT_EQ(worst[0].badness > 1e-6f, hasReference) << "by the error, where it is known";
  }
}

TEST_F(WorstOfShotTest, RejectedAndClippedPixelsAreGoneThroughAndWhatThereIsNotIsSaid) {
  const auto inspector = opened();
  inspector->shot().seek(5);
  const Image reasons = inspector->views().image(IntermediateId::rejectReason);
  const Image clips = inspector->views().image(IntermediateId::clipAmount);
  const auto next = [&](taa::WorstStep step, std::optional<glm::ivec2> after = {}) {
    return inspector->worst().next(IntermediateId::resolved, 0, after, step);
  };
  const taa::FoundWorst rejected = next(taa::WorstStep::Rejected);
  EXPECT_GT(*reasons.at(rejected.worst.pixel.x, rejected.worst.pixel.y), 0.0f);
  const taa::FoundWorst clipped = next(taa::WorstStep::Clipped);
  EXPECT_EQ(*clips.at(clipped.worst.pixel.x, clipped.worst.pixel.y), *std::ranges::max_element(clips.pixels));
  ASSERT_GT(clipped.count, 1);
  const taa::FoundWorst second = next(taa::WorstStep::Clipped, clipped.worst.pixel);
  EXPECT_EQ(second.number, 2);
  EXPECT_LE(second.worst.badness, clipped.worst.badness);
  try {
    next(taa::WorstStep::NoNumber);
    FAIL() << "a sound frame has numbers alone";
  } catch (const taa::Error& error) {
    EXPECT_STREQ(error.what(), "no pixel of Resolved is NaN or infinite in this frame");
  }
}

TEST_F(WorstOfShotTest, NaNIsFoundWhereItIs) {
  taa::Settings settings;
  taa::applyAssignment(settings, "fault.nan=on");
  const auto inspector = opened({settings});
  inspector->shot().seek(5);
  const taa::FoundWorst found =
      inspector->worst().next(IntermediateId::resolved, 0, {}, taa::WorstStep::NoNumber);
  const glm::ivec2 pixel = found.worst.pixel;
  EXPECT_TRUE(std::isnan(*inspector->views().image(IntermediateId::resolved).at(pixel.x, pixel.y)));
}

TEST_F(WorstOfShotTest, TheNextOneIsOfTheSameCategory) {
  const auto inspector = opened();
  inspector->shot().seek(5);
  const Image reasons = inspector->views().image(IntermediateId::rejectReason);
  const taa::FoundWorst first = inspector->worst().next(IntermediateId::rejectReason, 0, {});
  ASSERT_TRUE(first.question.category);
  EXPECT_EQ(*reasons.at(first.worst.pixel.x, first.worst.pixel.y),
            static_cast<float>(*first.question.category));
  const taa::FoundWorst second = inspector->worst().next(IntermediateId::rejectReason, 0, first.worst.pixel);
  EXPECT_EQ(second.question.category, first.question.category);
  EXPECT_EQ(second.number, first.count > 1 ? 2 : 1);
  inspector->reference().refine(4);
  EXPECT_EQ(inspector->worst().next(IntermediateId::motion, 0, {}).question.row,
            IntermediateId::referenceErrorAbs)
      << "a motion is not wrong by itself";
}

// Each category that is in the picture once, in the order of their numbers from the first on.
TEST_F(WorstOfShotTest, GoesThroughTheCategoriesThatThereAre) {
  taa::Settings settings;
  taa::applyAssignment(settings, "validate.object=on");
  const auto inspector = opened({settings});
  inspector->shot().seek(5);
  std::set<float> expected;
  for (const float reason : inspector->views().image(IntermediateId::rejectReason).pixels)
    if (reason > 0.0f) expected.insert(reason);
  ASSERT_GE(expected.size(), 2u) << "edges of blades are rejected by depth and by object, or off the screen";
  std::optional<glm::ivec2> after;
  std::vector<float> seen;
  for (std::size_t step = 0; step <= expected.size(); ++step) {
    const taa::FoundWorst found =
        inspector->worst().next(IntermediateId::rejectReason, 0, after, taa::WorstStep::Category);
    EXPECT_EQ(found.number, 1) << "the worst of its category";
    seen.push_back(static_cast<float>(found.question.category.value()));
    after = found.worst.pixel;
  }
  std::vector<float> order(expected.begin(), expected.end());
  order.push_back(order.front());
  EXPECT_EQ(seen, order);
  inspector->reference().refine(4);
  EXPECT_THROW(inspector->worst().next(IntermediateId::referenceError, 0, {}, taa::WorstStep::Category),
               taa::Error)
      << "an error has none";
}

TEST_F(WorstOfShotTest, TheBatchCountsAllPixelsAndSplitsTheError) {
  const std::vector<std::string> command = {taa::test::binary("taa-batch").string(),
                                            "verdict",
                                            "builtin:fan",
                                            "--size",
                                            "48x27",
                                            "--frame",
                                            "6",
                                            "--reference-samples",
                                            "4",
                                            "--worst",
                                            "2",
                                            "--json"};
  const taa::test::ProcessResult result = taa::test::runProcess(command);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json lane = json::parse(result.out)["lanes"][0];
  for (const char* row : {"verdictMap", "geometryVerdict", "rejectReason"}) {
    std::size_t pixels = 0;
    for (const json& category : lane[row]) pixels += category["pixels"].get<std::size_t>();
    EXPECT_EQ(pixels, std::size_t(kWidth) * kHeight) << row;
  }
  const auto inspector = opened();
  inspector->shot().seek(6);
  inspector->overTime().refine({taa::OverTime::Parts}, 4);
  const Image ghost = inspector->views().image(IntermediateId::errorGhost);
  const json error = lane["errors"]["errorGhost"];
  ASSERT_EQ(error["worst"].size(), 2u);
  const int x = error["worst"][0]["pixel"][0], y = error["worst"][0]["pixel"][1];
  EXPECT_EQ(error["worst"][0]["error"].get<float>(), std::fabs(*ghost.at(x, y)));
  // By every row of amounts against the reference that a key goes through in the window.
  for (const char* row :
       {"referenceErrorAbs", "relativeError", "flip", "ssimMap", "ghost", "flicker", "errorGhost", "errorLag",
        "errorBlur", "errorAliasing", "errorRectification", "errorOlder"})
    EXPECT_TRUE(lane["errors"].contains(row)) << row;
  EXPECT_EQ(lane["errors"].size(), 12u) << lane["errors"].dump();
}
