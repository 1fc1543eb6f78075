// What a whole picture changes by, predicted from where its places were.
#include "core/doctor/flow/FlowChange.h"

#include "tests/support/doctor/FlowSquares.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::doctor {
namespace {

const glm::ivec2 kSizePx(320, 180);
constexpr double kTolerancePx = 0.5;

/// A picture that is 1 + `growth` times as large as the one before, turned clockwise by `turn` and shifted,
/// and whose motion given is (1, −2) everywhere; each `oddEvery`-th square moves by itself.
std::vector<FlowSquare> squaresOfPicture(double growth, double turn, const glm::dvec2& shift,
                                         std::size_t oddEvery = 1000) {
  std::vector<FlowSquare> out;
  for (int y = 20; y < kSizePx.y; y += 20)
    for (int x = 20; x < kSizePx.x; x += 40) {
      const glm::dvec2 now = glm::dvec2(x, y) - 0.5 * glm::dvec2(kSizePx) - shift;
      const double c = std::cos(-turn), s = std::sin(-turn);
      const glm::dvec2 before = glm::dvec2(c * now.x - s * now.y, s * now.x + c * now.y) / (1.0 + growth);
      FlowSquare square;
      square.pixel = {x, y};
      square.given = {1.0, -2.0};
      square.px = square.given + (now + shift - before);
      square.errorPx = 0.02;
      if (out.size() % oddEvery == oddEvery - 1) square.px += glm::dvec2(7.0, 5.0);
      out.push_back(square);
    }
  return out;
}

std::optional<PictureChange> changed(const std::vector<FlowSquare>& squares) {
  return changeOf(test::pointersTo(squares), kSizePx, kTolerancePx);
}

/// Of two frames, 3 and 4, all of whose squares are refuted.
struct Seen {
  std::vector<FlowPair> pairs;
  std::vector<Region> regions{Region()};

  Seen(std::vector<FlowSquare> third, std::vector<FlowSquare> fourth) {
    pairs.push_back({3, std::move(third), {}, {}, 0});
    pairs.push_back({4, std::move(fourth), {}, {}, 0});
  }
  PictureChanges changes() const {
    const FlowSeen seen{pairs, regions};
    return changesOf({wholePicture(seen)}, seen, kSizePx, kTolerancePx);
  }
};

} // namespace

TEST(FlowChange, IsWhatAPictureGrowsTurnsAndShiftsBy) {
  const auto change = changed(squaresOfPicture(0.07, -0.02, {1.5, -0.5}));
  ASSERT_TRUE(change);
  EXPECT_NEAR(change->growth, 0.07, 1e-9);
  EXPECT_NEAR(change->turn, -0.02, 1e-9);
  EXPECT_EQ(change->followed, change->squares);
  EXPECT_TRUE(change->isGood());
  EXPECT_FALSE(change->isZoom(kSizePx)); // it turns
}

TEST(FlowChange, IsNotThatOfWhatMovesByItself) {
  const auto change = changed(squaresOfPicture(0.05, 0.0, {0.0, 0.0}, 8));
  ASSERT_TRUE(change);
  EXPECT_NEAR(change->growth, 0.05, 1e-6);
  EXPECT_LT(change->followed, change->squares);
  EXPECT_TRUE(change->isZoom(kSizePx));
  const auto many = changed(squaresOfPicture(0.05, 0.0, {0.0, 0.0}, 2));
  ASSERT_TRUE(many);
  EXPECT_FALSE(many->isGood()); // half of all
}

TEST(FlowChange, IsNoneOfAFewSquaresNorOfAPictureThatShiftsAlone) {
  std::vector<FlowSquare> few = squaresOfPicture(0.05, 0.0, {0.0, 0.0});
  few.resize(11);
  EXPECT_FALSE(changed(few));
  const auto shifted = changed(squaresOfPicture(0.0, 0.0, {3.0, 0.0}));
  ASSERT_TRUE(shifted);
  EXPECT_FALSE(shifted->isZoom(kSizePx));
}

TEST(FlowChange, IsAZoomWhereNearlyAllFramesAre) {
  const auto zooming = squaresOfPicture(0.02, 0.0, {0.0, 0.0});
  const Seen both(zooming, squaresOfPicture(0.04, 0.0, {0.1, 0.0}));
  EXPECT_TRUE(areZooms(both.changes(), kSizePx));
  EXPECT_NE(zoomText(both.changes()).find("by 2 ± "), std::string::npos) << zoomText(both.changes());
  EXPECT_NE(zoomText(both.changes()).find("to 4 ± "), std::string::npos) << zoomText(both.changes());
  const Seen rolling(zooming, squaresOfPicture(0.0, 0.035, {0.0, 0.0}));
  EXPECT_FALSE(areZooms(rolling.changes(), kSizePx));
  const std::string text = changeText(rolling.changes(), FrameNames());
  EXPECT_NE(text.find("turns by 2.01°"), std::string::npos) << text;
  EXPECT_EQ(changeText(Seen(zooming, squaresOfPicture(0.02, 0.0, {0.0, 0.0}, 2)).changes(), FrameNames()),
            "");
}

} // namespace taa::doctor
