// Depth against the motion that it makes, of a ground that a camera passes sideways: made by hand.
#include "core/doctor/depth/DepthCheck.h"

#include <glm/mat4x4.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

using DepthChange = std::function<double(double depth)>;

/// Depths from 0.05 at the top to 0.35 at the bottom. The camera's way moves a picture by 40 px at depth 1.
DoctorFrame passingFrame(const DepthChange& stored, double slope = 0.003) {
  constexpr int kWidth = 160, kHeight = 100;
  constexpr float kShear = 0.5f; // of device coordinates: 40 px of 160
  DoctorFrame out;
  out.luma = out.depth = Image(kWidth, kHeight, 1);
  out.motionPx = Image(kWidth, kHeight, 2);
  glm::mat4 matrix(1.0f);
  matrix[2][0] = kShear;
  out.previousClipFromClip = matrix;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double depth = 0.05 + slope * y;
      *out.depth.at(x, y) = static_cast<float>(stored(depth));
      out.motionPx.at(x, y)[0] = static_cast<float>(-40.0 * depth);
    }
  return out;
}

Diagnosis diagnosisOf(const DoctorFrame& frame) {
  DepthEvidence evidence;
  evidence.add(frame);
  Diagnosis out;
  tellDepth(evidence, out);
  return out;
}

std::string foundIn(const DepthChange& stored) {
  const Diagnosis diagnosis = diagnosisOf(passingFrame(stored));
  return diagnosis.findings.empty() ? "" : diagnosis.findings[0].id;
}

} // namespace

TEST(DepthCheck, TakesTheDepthOfEachPixelFromItsMotion) {
  DepthEvidence evidence;
  evidence.add(passingFrame([](double depth) { return depth; }));
  ASSERT_GT(evidence.samples.size(), 1000u);
  for (const DepthSample& sample : evidence.samples) EXPECT_NEAR(sample.byMotion, sample.stored, 1e-6);
}

TEST(DepthCheck, NamesWhatIsWrong) {
  EXPECT_EQ(foundIn([](double depth) { return depth; }), "");
  EXPECT_EQ(foundIn([](double depth) { return 1.0 - depth; }), "depthReversed");
  EXPECT_EQ(foundIn([](double depth) { return 0.001 / depth; }), "depthLinear");
  EXPECT_EQ(foundIn([](double depth) { return 0.5 * depth; }), "nearPlaneWrong");
}

TEST(DepthCheck, SaysByHowMuchTheNearPlaneIsWrong) {
  const Diagnosis diagnosis = diagnosisOf(passingFrame([](double depth) { return 0.5 * depth; }));
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_NE(diagnosis.findings[0].change.find("0.5 times as far"), std::string::npos)
      << diagnosis.findings[0].change;
}

// What all else is looked at by, then: other mistakes are not another near plane.
TEST(DepthCheck, MendsDepthOfAnotherNearPlaneAlone) {
  const auto nearOf = [](const DepthChange& stored) {
    DepthEvidence evidence;
    evidence.add(passingFrame(stored));
    return otherNear(evidence);
  };
  const auto near = nearOf([](double depth) { return 0.37 * depth; });
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->factor, 1.0 / 0.37, 0.01);
  EXPECT_FALSE(nearOf([](double depth) { return depth; }));
  EXPECT_FALSE(nearOf([](double depth) { return 1.0 - depth; }));
  EXPECT_FALSE(nearOf([](double depth) { return 0.001 / depth; }));
}

// Everything half as far away moves as it would before a camera that has gone twice as far.
TEST(DepthCheck, LeavesOpenWhetherTheCameraWasAnother) {
  DepthEvidence evidence;
  evidence.add(passingFrame([](double depth) { return 0.5 * depth; }));
  Diagnosis out;
  tellDepth(evidence, out, {true, false, true});
  ASSERT_EQ(out.findings.size(), 1u);
  EXPECT_EQ(out.findings[0].id, "nearPlaneWrong");
  EXPECT_EQ(out.findings[0].confidence, Confidence::Likely);
  EXPECT_EQ(out.findings[0].alike, std::vector<std::string>{"cameraOfSecondView"});
  Diagnosis known;
  tellDepth(evidence, known);
  EXPECT_EQ(known.findings[0].confidence, Confidence::Sure);
  EXPECT_TRUE(known.findings[0].alike.empty());
}

TEST(DepthCheck, DoesNotDecideWhereDepthsAreAlike) {
  const Diagnosis diagnosis = diagnosisOf(passingFrame([](double depth) { return 0.5 * depth; }, 0.0));
  EXPECT_TRUE(diagnosis.isHealthy());
  EXPECT_EQ(diagnosis.parts.undecided().size(), 1u);
}

// Motion that is twice as long may ask for a distance; the values stored are none.
TEST(DepthCheck, TellsNoDistanceAgainstTheFormOfItsValues) {
  DepthEvidence evidence;
  evidence.add(passingFrame([](double depth) { return 0.01 / depth; }));
  ASSERT_TRUE(otherDepth(evidence));
  evidence.form = {.even = 300, .evenReciprocal = 12};
  EXPECT_FALSE(otherDepth(evidence));
  Diagnosis out;
  tellDepth(evidence, out);
  EXPECT_TRUE(out.isHealthy());
}

// Stated from −1 to 1, and stored from 0 to 1.
TEST(DepthCheck, NamesAnotherRange) {
  EXPECT_EQ(foundIn([](double depth) { return 0.5 + 0.5 * depth; }), "depthRange");
}

// A hundredth more than the nearest: too alike for anything but an exact fit.
TEST(DepthCheck, NamesWhatFitsExactlyThoughDepthsAreNearlyAlike) {
  EXPECT_EQ(diagnosisOf(passingFrame([](double depth) { return 0.5 * depth; }, 0.001)).findings.at(0).id,
            "nearPlaneWrong");
}

TEST(DepthCheck, TellsDistancesFromTheEyeFromThoseAlongTheAxis) {
  DepthEvidence evidence;
  for (int i = 0; i < 1000; ++i) {
    const double depth = 0.05 + 0.0003 * i, ray = 1.0 + 0.0005 * (i % 400);
    evidence.samples.push_back({depth / ray, depth, ray});
  }
  Diagnosis distances, device;
  tellDepth(evidence, distances, {.isDistance = true});
  ASSERT_EQ(distances.findings.size(), 1u);
  EXPECT_EQ(distances.findings[0].id, "depthAlong");
  EXPECT_NE(distances.findings[0].change.find("from the eye"), std::string::npos);
  tellDepth(evidence, device);
  EXPECT_TRUE(device.isHealthy()) << "device depth has no rays";
}

TEST(DepthCheck, LeavesOutWhatMovesByItself) {
  DoctorFrame frame = passingFrame([](double depth) { return depth; });
  for (std::size_t i = 1; i < frame.motionPx.pixels.size(); i += 2) frame.motionPx.pixels[i] = 0.5f;
  DepthEvidence evidence;
  evidence.add(frame);
  EXPECT_TRUE(evidence.samples.empty());
  EXPECT_EQ(diagnosisOf(frame).parts.undecided().size(), 1u);
}

// Nothing passes the camera sideways; what comes out from behind something tells which way around depth is.
TEST(DepthCheck, GoesByWhatHidesWhatWhereTheCameraDoesNotTell) {
  DepthEvidence evidence;
  evidence.order = {.nearer = 4, .farther = 396, .frames = 8};
  evidence.form = {.even = 300, .evenReciprocal = 12};
  Diagnosis reversed;
  tellDepth(evidence, reversed);
  ASSERT_EQ(reversed.findings.size(), 1u);
  EXPECT_EQ(reversed.findings[0].id, "depthReversed");
  EXPECT_NE(reversed.findings[0].reason.find("396 of 400"), std::string::npos) << reversed.findings[0].reason;
  EXPECT_TRUE(reversed.findings[0].alike.empty());
  EXPECT_TRUE(reversed.parts.undecided().empty());

  evidence.form = {.even = 12, .evenReciprocal = 300};
  Diagnosis linear;
  tellDepth(evidence, linear);
  ASSERT_EQ(linear.findings.size(), 1u);
  EXPECT_EQ(linear.findings[0].id, "depthLinear");

  evidence.form = {};
  Diagnosis either;
  tellDepth(evidence, either);
  ASSERT_EQ(either.findings.size(), 1u);
  EXPECT_EQ(either.findings[0].alike, std::vector<std::string>{"depthLinear"});
}

// Nothing moves at all.
TEST(DepthCheck, GoesByTheValuesStoredWhereNothingMoves) {
  const auto idOf = [](const DepthEvidence& evidence) {
    Diagnosis out;
    tellDepth(evidence, out);
    return out.findings.empty() ? "" : out.findings[0].id;
  };
  DepthEvidence reversed;
  reversed.form = {.even = 300, .evenReciprocal = 12};
  reversed.ends = {.atNear = 250, .nearHalf = 740, .farHalf = 10};
  EXPECT_EQ(idOf(reversed), "depthReversed");
  ASSERT_TRUE(otherDepth(reversed));
  EXPECT_EQ(otherDepth(reversed)->kind, RelationKind::Reversed);
  DepthEvidence linear;
  linear.form = {.even = 12, .evenReciprocal = 300};
  linear.ends = {.atNear = 250, .nearHalf = 40, .farHalf = 700, .least = 0.02f};
  EXPECT_EQ(idOf(linear), "depthLinear");
  ASSERT_TRUE(otherDepth(linear));
  EXPECT_NEAR(otherDepth(linear)->factor, 0.002, 1e-6); // 0.02 becomes a tenth
  // What hides what contradicts it.
  for (DepthEvidence* evidence : {&reversed, &linear}) {
    evidence->order = {.nearer = 396, .farther = 4, .frames = 8};
    EXPECT_EQ(idOf(*evidence), "");
    EXPECT_FALSE(otherDepth(*evidence));
  }
}

TEST(DepthCheck, LeavesTheScaleOpenWhereOnlyTheOrderIsSeen) {
  DepthEvidence evidence;
  evidence.order = {.nearer = 396, .farther = 4, .frames = 8};
  Diagnosis out;
  tellDepth(evidence, out);
  EXPECT_TRUE(out.isHealthy());
  EXPECT_EQ(out.parts.right().size(), 1u);
  ASSERT_EQ(out.parts.undecided().size(), 1u);
  EXPECT_EQ(out.parts.undecided()[0].faults, std::vector<Fault>{Fault::NearPlaneWrong});
}

TEST(DepthCheck, NamesANearPlaneThatIsNotTheProjections) {
  DepthEvidence evidence;
  evidence.factors = {2.0, 2.0, 2.0};
  Diagnosis out;
  EXPECT_TRUE(tellNear(evidence, out));
  ASSERT_EQ(out.findings.size(), 1u);
  EXPECT_EQ(out.findings[0].id, "nearPlaneWrong");
  EXPECT_NE(out.findings[0].change.find("0.5 times what is stated"), std::string::npos);
  evidence.factors = {1.0, 1.04, 1.0}; // rounding
  Diagnosis right;
  EXPECT_FALSE(tellNear(evidence, right));
  EXPECT_TRUE(right.isHealthy());
}

} // namespace taa::doctor
