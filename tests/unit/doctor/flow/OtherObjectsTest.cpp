// Objects that have each other's motion, or one the place of another: of squares that are made up.
#include "core/doctor/flow/OtherObjects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kPairs = 8;
constexpr double kTolerancePx = 0.5;

/// Two objects and the ground, by their own ways over a camera's motion.
class OtherObjects : public testing::Test {
 protected:
  OtherObjects() : regions_(3) {
    for (std::size_t i = 0; i < regions_.size(); ++i)
      regions_[i].objectId = static_cast<std::uint32_t>(i + 1);
  }

  static glm::dvec2 cameraPx() { return {2.0, -0.5}; }
  static glm::dvec2 ownPx(RegionIndex region, int frame) {
    if (region == 0) return glm::dvec2(0.0); // the ground
    return region == 1 ? glm::dvec2(3.0, std::sin(0.7 * frame)) : glm::dvec2(-1.5 + 0.2 * frame, 4.0);
  }
  static glm::dvec2 placeOf(RegionIndex region, int frame) {
    if (region == 0) return {80.0, 48.0};
    return region == 1 ? glm::dvec2(40.0, 30.0) + 3.0 * frame : glm::dvec2(110.0 - 2.0 * frame, 60.0);
  }

  /// The two objects have each other's.
  static glm::dvec2 exchangedPx(RegionIndex region, int frame) {
    return cameraPx() + ownPx(region == 0 ? 0 : 3 - region, frame);
  }

  /// `given`: the motion that a region is said to have.
  template <typename Given>
  void fill(const Given& given, bool hasCamera = true) {
    pairs_.clear();
    for (int frame = 1; frame <= kPairs; ++frame) {
      FlowPair& pair = pairs_.emplace_back();
      pair.frame = frame;
      for (RegionIndex region = 0; region < 3; ++region) {
        pair.said[region] = 1.0;
        RegionMeans& means = pair.means[region];
        means.middle = placeOf(region, frame);
        means.given = given(region, frame);
        if (hasCamera) means.camera = cameraPx();
        for (int i = 0; i < 9; ++i) {
          FlowSquare square;
          square.region = region;
          square.px = cameraPx() + ownPx(region, frame);
          square.errorPx = 0.02;
          square.given = given(region, frame);
          square.leftAsGiven = glm::distance(square.px, square.given) > 0.1 ? 0.1 : 0.002;
          square.apart = square.leftAsGiven;
          square.left = 0.002;
          if (hasCamera) square.camera = cameraPx();
          pair.squares.push_back(square);
        }
      }
    }
  }
  std::vector<OfOtherObject> found() const {
    const FlowSeen seen{pairs_, regions_};
    return ofOtherObjects(refutedRegions(seen, kTolerancePx), seen);
  }

  std::vector<Region> regions_;
  std::vector<FlowPair> pairs_;
};

} // namespace

TEST_F(OtherObjects, AreFoundByTheirOwnMotion) {
  for (const bool hasCamera : {true, false}) {
    fill(exchangedPx, hasCamera);
    const std::vector<OfOtherObject> exchanged = found();
    ASSERT_EQ(exchanged.size(), 2u) << hasCamera;
    EXPECT_EQ(exchanged[0].region, &regions_[1]);
    EXPECT_EQ(exchanged[0].other, &regions_[2]);
    EXPECT_EQ(exchanged[1].region, &regions_[2]);
    EXPECT_EQ(exchanged[1].other, &regions_[1]);
    EXPECT_EQ(exchanged[0].kind, OtherObjectKind::Motion);
    EXPECT_EQ(exchanged[0].frames, exchanged[0].asked);
  }
}

// One is twice as far away: the same way in the world is half as long on the screen.
TEST_F(OtherObjects, AreFoundByTheirWayInTheWorld) {
  fill([](RegionIndex region, int frame) {
    if (region == 0) return cameraPx();
    return cameraPx() + (region == 1 ? 2.0 : 0.5) * ownPx(3 - region, frame);
  });
  EXPECT_TRUE(found().empty()) << "on the screen it is another one";
  for (FlowPair& pair : pairs_)
    for (const RegionIndex region : {0, 1, 2}) pair.means[region].distance = region == 2 ? 10.0 : 5.0;
  const std::vector<OfOtherObject> exchanged = found();
  ASSERT_EQ(exchanged.size(), 2u);
  EXPECT_EQ(exchanged[0].other, &regions_[2]);
  EXPECT_EQ(exchanged[1].other, &regions_[1]);
}

// One of them has no squares that can be followed: its middle says what it moves by.
TEST_F(OtherObjects, AreFoundByTheirMiddles) {
  fill(exchangedPx);
  glm::dvec2 at(60.0, 40.0);
  for (FlowPair& pair : pairs_) {
    std::erase_if(pair.squares, [](const FlowSquare& square) { return square.region == 2; });
    at += cameraPx() + ownPx(2, pair.frame);
    pair.means[2].middle = at;
  }
  const std::vector<OfOtherObject> exchanged = found();
  ASSERT_EQ(exchanged.size(), 2u);
  EXPECT_EQ(exchanged[0].other, &regions_[2]);
  EXPECT_EQ(exchanged[1].other, &regions_[1]);
}

// What nothing follows may rightly have the motion of something whose own is wrong.
TEST_F(OtherObjects, AreNotWhatNothingRefutes) {
  fill([](RegionIndex region, int frame) {
    if (region == 1) return glm::dvec2(-7.0 + 3.0 * (frame % 3), 9.0);
    return cameraPx() + ownPx(region == 2 ? 1 : region, frame);
  });
  for (FlowPair& pair : pairs_)
    std::erase_if(pair.squares, [](const FlowSquare& square) { return square.region == 2; });
  EXPECT_TRUE(found().empty());
}

TEST_F(OtherObjects, AreFoundByTheirPlace) {
  fill([](RegionIndex region, int frame) {
    if (region != 1) return cameraPx() + ownPx(region, frame);
    return placeOf(1, frame) - placeOf(2, frame - 1);
  });
  const std::vector<OfOtherObject> lost = found();
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].region, &regions_[1]);
  EXPECT_EQ(lost[0].other, &regions_[2]);
  EXPECT_EQ(lost[0].kind, OtherObjectKind::Place);
}

// Motion that is the camera's alone, or none, is that of the ground as well: it is no other object's.
TEST_F(OtherObjects, AreNotWhatRests) {
  for (const bool hasCamera : {true, false}) {
    fill([](RegionIndex region,
            int frame) { return region == 1 ? cameraPx() : cameraPx() + ownPx(region, frame); },
         hasCamera);
    EXPECT_TRUE(found().empty()) << hasCamera;
  }
  fill([](RegionIndex region, int frame) {
    return region == 1 ? glm::dvec2(0.0) : cameraPx() + ownPx(region, frame);
  });
  EXPECT_TRUE(found().empty());
}

} // namespace taa::doctor
