// Ghost energy of pictures made by hand.
#include "core/measure/compare/GhostEnergy.h"

#include "core/measure/Metrics.h"
#include "tests/unit/compare/Pictures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using taa::ghostEnergy;
using taa::ghostMap;
using taa::Image;
using namespace taa::test;

namespace {

constexpr int kWide = 12, kHigh = 6;

Image flat(const glm::vec3& color) {
  return flatPicture(kWide, kHigh, color);
}

/// Where history came from: so far to the left.
Image fromTheLeft(float px) {
  Image positions(kWide, kHigh, 2);
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x) {
      positions.at(x, y)[0] = float(x) + 0.5f - px;
      positions.at(x, y)[1] = float(y) + 0.5f;
    }
  return positions;
}

double energyOf(const Image& shown, const Image& reference, const Image& before, float px = 0.0f) {
  return ghostEnergy(ghostMap({shown, reference, before, fromTheLeft(px)}));
}

} // namespace

TEST(GhostEnergy, IsThePartOfTheErrorTowardsWhatWasShown) {
  const Image gray = flat(glm::vec3(0.25f)), white = flat(glm::vec3(1.0f));
  EXPECT_EQ(energyOf(gray, gray, white), 0.0) << "no error, no ghost";
  EXPECT_NEAR(energyOf(flat(glm::vec3(0.4375f)), gray, white), 0.1875, 1e-6) << "a quarter of white is left";
  EXPECT_NEAR(energyOf(white, gray, white), 0.75, 1e-6) << "all of it";
  EXPECT_EQ(energyOf(flat(glm::vec3(0.125f)), gray, white), 0.0) << "wrong, but away from what was shown";
  EXPECT_NEAR(energyOf(white, gray, flat(glm::vec3(0.5f))), 0.25, 1e-6) << "no more than what was shown had";
}

TEST(GhostEnergy, LeavesOutWhatGoesAnotherWay) {
  const Image gray = flat(glm::vec3(0.25f)), red = flat({1.0f, 0.25f, 0.25f});
  EXPECT_EQ(energyOf(flat({0.25f, 0.5f, 0.25f}), gray, red), 0.0) << "too green, and red was shown";
  // Too yellow: red's part of it is the ghost, over three channels.
  EXPECT_NEAR(energyOf(flat({0.5f, 0.5f, 0.25f}), gray, red), 0.25 / std::sqrt(3.0), 1e-6);
}

TEST(GhostEnergy, LeavesOutWhatABlurMakes) {
  const Image sharp = stepPicture(kWide, kHigh, 6);
  const Image blurred = pictureOf(kWide, kHigh, [](int x, int) {
    return glm::vec3(x == 5 ? 0.25f : x == 6 ? 0.75f : x < 5 ? 0.0f : 1.0f);
  });
  EXPECT_EQ(energyOf(blurred, sharp, blurred), 0.0) << "it was as blurred before";
  EXPECT_GT(taa::pictureError(blurred, sharp).rmse, 0.1) << "else nothing was tested";
}

TEST(GhostEnergy, ReadsWhatWasShownAtTheHistoryPosition) {
  // A white bar at columns 2 and 3; what is left of it is shown 3 columns to the right.
  const auto bar = [](int first, float value) {
    return pictureOf(kWide, kHigh,
                     [=](int x, int) { return glm::vec3(x == first || x == first + 1 ? value : 0.0f); });
  };
  const Image black = flat(glm::vec3(0.0f)), trail = bar(5, 0.5f), before = bar(2, 1.0f);
  EXPECT_EQ(energyOf(trail, black, before), 0.0) << "nothing was shown there";
  EXPECT_NEAR(energyOf(trail, black, before, 3.0f), 0.5 * std::sqrt(2.0 / kWide), 1e-6);
  const Image map = ghostMap({trail, black, before, fromTheLeft(2.5f)});
  EXPECT_NEAR(*map.at(5, 2), 0.5, 1e-6) << "between two white pixels";
  EXPECT_NEAR(*map.at(6, 2), 0.5, 1e-6) << "half of a white pixel, and half was kept";
  EXPECT_EQ(*map.at(4, 2), 0.0f) << "no error";
}

TEST(GhostEnergy, IsNothingWhereHistoryCameFromOutside) {
  const Image gray = flat(glm::vec3(0.25f)), white = flat(glm::vec3(1.0f));
  EXPECT_EQ(energyOf(white, gray, white, 12.5f), 0.0);
  Image unknown(kWide, kHigh, 2);
  unknown.pixels.assign(unknown.pixels.size(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(ghostEnergy(ghostMap({white, gray, white, unknown})), 0.0);
}

TEST(GhostEnergy, IsNeverAboveTheError) {
  const auto pattern = [](int shift, float contrast) {
    return pictureOf(kWide, kHigh, [=](int x, int y) {
      return 0.5f + contrast * (patternColor(x + shift, y * 3 + shift) - 0.5f);
    });
  };
  const Image reference = pattern(0, 0.25f);
  for (const int shift : {1, 2, 5}) {
    const Image shown = pattern(shift, 1.0f);
    const Image map = ghostMap({shown, reference, pattern(2 * shift, 1.0f), fromTheLeft(0.5f)});
    double square = 0.0;
    for (int y = 0; y < kHigh; ++y)
      for (int x = 0; x < kWide; ++x) {
        const glm::vec3 off = glm::vec3(shown.texel(x, y) - reference.texel(x, y));
        const double error = double(off.x * off.x + off.y * off.y + off.z * off.z) / 3.0;
        ASSERT_LE(*map.at(x, y) * *map.at(x, y), error + 1e-6) << x << ", " << y;
        square += error;
      }
    EXPECT_GT(ghostEnergy(map), 0.01);
    EXPECT_LE(ghostEnergy(map), std::sqrt(square / (kWide * kHigh)));
  }
}
