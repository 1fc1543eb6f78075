// The share of pixels that stages changed.
#include "core/measure/StageShares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace taa;

TEST(StageShares, CountPixelsThatWereTouched) {
  std::vector<Image> rows;
  for (const IntermediateId id : shareRows()) {
    rows.emplace_back(2, 2, intermediate(id).channels);
    const bool restsAtOne = id == IntermediateId::onScreen || id == IntermediateId::blurTrust;
    std::ranges::fill(rows.back().pixels, restsAtOne ? 1.0f : 0.0f);
  }
  for (const StageShare& stage : sharesOf(rows, {})) EXPECT_EQ(stage.share, 0.0);
  const auto row = [&](IntermediateId id) -> Image& {
    return rows[static_cast<std::size_t>(std::ranges::find(shareRows(), id) - shareRows().begin())];
  };
  row(IntermediateId::dilatedMotion).at(0, 0)[1] = -1.0f;
  row(IntermediateId::onScreen).at(1, 1)[0] = 0.0f;
  row(IntermediateId::rejectReason).at(0, 1)[0] = 4.0f;
  row(IntermediateId::rejectReason).at(1, 1)[0] = 3.0f;
  row(IntermediateId::sharpenDetail).at(0, 0)[0] = -0.5f;
  row(IntermediateId::blurTrust).at(0, 0)[0] = 0.5f; // the same pixel
  row(IntermediateId::overlayAlpha).at(1, 0)[0] = 0.1f;
  const std::vector<StageShare> shares = sharesOf(rows, {});
  const auto share = [&](Stage stage) { return std::ranges::find(shares, stage, &StageShare::stage)->share; };
  EXPECT_EQ(share(Stage::DilateMotion), 0.25);
  EXPECT_EQ(share(Stage::Reproject), 0.25);
  EXPECT_EQ(share(Stage::RectifyHistory), 0.0);
  EXPECT_EQ(share(Stage::ValidateHistory), 0.5);
  EXPECT_EQ(share(Stage::Output), 0.5);
}

// All pixels of a wall that leans follow a neighbor, and none of them changes its motion by that.
TEST(StageShares, ANeighborOfTheSameMotionChangesNothing) {
  std::vector<Image> rows;
  for (const IntermediateId id : shareRows()) rows.emplace_back(2, 1, intermediate(id).channels);
  rows[0].pixels = {-3.0f, 0.5f, -3.02f, 0.5f};
  rows[1].pixels = {-3.02f, 0.5f, -3.04f, 0.5f};
  EXPECT_EQ(sharesOf(rows, {}).front().stage, Stage::DilateMotion);
  EXPECT_EQ(sharesOf(rows, {}).front().share, 0.0);
  rows[1].pixels = {-3.02f, 0.5f, 0.0f, 0.0f};
  EXPECT_EQ(sharesOf(rows, {}).front().share, 0.5);
  Settings half;
  half.inputs.renderScale = 0.5f;
  rows[1].pixels = {-6.0f, 1.0f, -3.02f, 0.5f}; // px of the picture
  EXPECT_EQ(sharesOf(rows, half).front().share, 0.5);
}
