// Objects that have each other's motion, or one the place of another: of squares that are made up.
#include "core/doctor/flow/OtherObjects.h"

#include "core/doctor/flow/FlowCheck.h"

#include <gtest/gtest.h>

#include <algorithm>
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

// One is taken out of a list, and each behind it takes the transform of the one before it, for a frame.
TEST(SlippedFrames, AreThoseInWhichAListSlips) {
  constexpr int kObjects = 6, kSlips = 4;
  const auto placeOf = [](int object, int frame) {
    return glm::dvec2(30.0 + 25.0 * object, 40.0 + 8.0 * std::sin(object + 0.5 * frame));
  };
  std::vector<Region> regions(kObjects);
  const auto seenWith = [&](std::size_t slipping, std::vector<FlowPair>& pairs) {
    pairs.clear();
    for (int frame = 1; frame <= 8; ++frame) {
      FlowPair& pair = pairs.emplace_back();
      pair.frame = frame;
      for (int object = 0; object < kObjects; ++object) {
        regions[static_cast<std::size_t>(object)].objectId = static_cast<std::uint32_t>(object + 1);
        RegionMeans& means = pair.means[object];
        means.middle = placeOf(object, frame);
        const bool isSlipped = frame == kSlips && object >= kObjects - static_cast<int>(slipping);
        means.given = means.middle - placeOf(isSlipped ? object - 1 : object, frame - 1);
      }
    }
    return slippedFrames({pairs, regions});
  };
  std::vector<FlowPair> pairs;
  EXPECT_TRUE(seenWith(0, pairs).empty());
  EXPECT_TRUE(seenWith(2, pairs).empty()) << "two may be chance";
  const std::vector<SlippedFrame> slipped = seenWith(4, pairs);
  ASSERT_EQ(slipped.size(), 1u);
  EXPECT_EQ(slipped[0].frame, kSlips);
  ASSERT_EQ(slipped[0].regions.size(), 4u);
  EXPECT_EQ(slipped[0].regions[0], &regions[2]);
  EXPECT_EQ(slipped[0].told, 4u);
  EXPECT_EQ(slipped[0].example, &regions[5]);
  EXPECT_EQ(slipped[0].other, &regions[4]);
  EXPECT_LT(slipped[0].px, 1e-9);
  CaptureInfo captureInfo;
  captureInfo.sizePx = {256, 96};
  captureInfo.frameNames = FrameNames({1000, 1001, 1002, 1003, 1004, 1005, 1006, 1007, 1008});
  Diagnosis diagnosis;
  tellFlow({pairs, regions}, {pairs, regions}, {captureInfo}, diagnosis);
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_TRUE(
      diagnosis.findings[0].reason.starts_with("In frame 4 (number 1004) the motion given of 4 of 4 "))
      << diagnosis.findings[0].reason;
  // Wrong by something else: they lead to where nothing was.
  for (auto& [region, means] : pairs[kSlips - 1].means) means.given += glm::dvec2(11.0, 12.0);
  EXPECT_TRUE(slippedFrames({pairs, regions}).empty());
}

// The camera's way missing makes the wall look as if it had the other one's: one cause is told, and no more.
TEST_F(OtherObjects, AreNotToldWhereSomethingExplainsAll) {
  fill(exchangedPx);
  const FlowSeen seen{pairs_, regions_};
  CaptureInfo captureInfo;
  captureInfo.sizePx = {160, 96};
  for (const Confidence confidence : {Confidence::Sure, Confidence::Likely}) {
    Diagnosis diagnosis;
    diagnosis.sizePx = captureInfo.sizePx;
    Finding all;
    all.id = "motionWithoutCamera";
    all.isWholePicture = true;
    all.confidence = confidence;
    diagnosis.findings.push_back(all);
    tellFlow(seen, seen, {captureInfo}, diagnosis);
    EXPECT_EQ(std::ranges::count(diagnosis.findings, "motionOfAnotherObject", &Finding::id),
              confidence == Confidence::Sure ? 0 : 1);
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
