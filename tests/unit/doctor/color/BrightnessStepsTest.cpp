// Steps of brightness are measured exactly where all light changes by one factor, and told of no light that
// shines on a part.
#include "core/doctor/color/BrightnessSteps.h"

#include "core/doctor/examination/Doctor.h"
#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kFrames = 8, kStep = 5;

/// Luma of so many times the light.
float brighter(float luma, float factor) {
  const float light = factor * luma / (1.0f - luma);
  return light / (1.0f + light);
}

void brighten(DoctorFrame& frame, float factor, int fromColumn = 0) {
  for (int y = 0; y < frame.luma.height; ++y)
    for (int x = fromColumn; x < frame.luma.width; ++x)
      *frame.luma.at(x, y) = brighter(*frame.luma.at(x, y), factor);
}

test::PaintedShot restingShot() {
  test::PaintedShot out;
  out.cameraPx = out.boardPx = {0.0, 0.0};
  out.isJittered = false;
  return out;
}

BrightnessEvidence evidenceOf(const test::PaintedShot& shot, float factor, int fromColumn = 0) {
  BrightnessEvidence out;
  for (int frame = 1; frame < kFrames; ++frame) {
    DoctorFrame now = test::paintedFrame(shot, frame), before = test::paintedFrame(shot, frame - 1);
    if (frame >= kStep) brighten(now, factor, fromColumn);
    if (frame > kStep) brighten(before, factor, fromColumn);
    out.add({now, before});
  }
  return out;
}

std::string toldOf(const test::PaintedShot& shot, float factor, int fromColumn = 0) {
  Diagnosis out;
  tellBrightness(evidenceOf(shot, factor, fromColumn), {}, out);
  std::string text;
  for (const Finding& finding : out.findings)
    text += finding.id + (finding.isWholePicture ? " everywhere" : "");
  return text;
}

} // namespace

TEST(BrightnessSteps, AreMeasuredInStops) {
  const BrightnessEvidence evidence = evidenceOf(restingShot(), 2.0f);
  ASSERT_EQ(evidence.pairs.size(), static_cast<std::size_t>(kFrames - 1));
  for (const BrightnessPair& pair : evidence.pairs) {
    EXPECT_NEAR(pair.stops, pair.frame == kStep ? 1.0 : 0.0, 1e-5) << pair.frame;
    EXPECT_EQ(pair.isChange(), pair.frame == kStep);
    EXPECT_TRUE(pair.isEven());
    EXPECT_NEAR(pair.stepped, 0.0, 1e-6);
  }
}

TEST(BrightnessSteps, AreToldOfTheWholePictureWhileItMoves) {
  EXPECT_EQ(toldOf({}, 2.0f), "exposureStep everywhere");
  EXPECT_EQ(toldOf({}, 0.8f), "exposureStep everywhere");
  EXPECT_EQ(toldOf({}, 1.0f), "");
}

TEST(BrightnessSteps, AreNotToldOfALightOnAPart) {
  EXPECT_EQ(toldOf({}, 2.0f, test::kPaintedPx.x / 3), "");
}

// Where it changes little it looks even; where it changes much it does not.
TEST(BrightnessSteps, AreNotToldOfALightThatFlickers) {
  const auto flickering = [](int frame, float much) {
    DoctorFrame out = test::paintedFrame(restingShot(), frame);
    const float stops = frame == 3 ? 0.15f : frame == kStep ? much : 0.0f;
    for (int y = 0; y < out.luma.height; ++y)
      for (int x = 0; x < out.luma.width; ++x) {
        const float near = 0.7f + 0.6f * static_cast<float>(x) / static_cast<float>(out.luma.width);
        *out.luma.at(x, y) = brighter(*out.luma.at(x, y), std::exp2(stops * near));
      }
    return out;
  };
  const auto steps = [&](float much) {
    BrightnessEvidence out;
    for (int frame = 1; frame < kFrames; ++frame)
      out.add({flickering(frame, much), flickering(frame - 1, much)});
    return out.steps().size();
  };
  EXPECT_EQ(steps(0.0f), 2u) << "on and off";
  EXPECT_EQ(steps(1.0f), 0u);
}

TEST(BrightnessSteps, SayAtWhichFrame) {
  Diagnosis out;
  tellBrightness(evidenceOf(restingShot(), 0.5f), {}, out);
  ASSERT_EQ(out.findings.size(), 1u);
  EXPECT_NE(out.findings[0].reason.find("-1 stops at frame 5"), std::string::npos) << out.findings[0].reason;
  ASSERT_EQ(out.findings[0].residuals.size(), 2u);
  EXPECT_LT(out.findings[0].residuals[0].value, out.findings[0].residuals[1].value);
}

TEST(BrightnessSteps, TakenOffLeaveTheFramesThatThereWereWithout) {
  const test::PaintedShot shot;
  const FrameReader stepping = [&](int frame) {
    DoctorFrame out = test::paintedFrame(shot, frame);
    if (frame >= 3) brighten(out, 2.0f);
    if (frame >= 5) brighten(out, 0.25f);
    return out;
  };
  EXPECT_TRUE(evidenceOf(restingShot(), 1.0f).stepped().empty());
  const FrameReader even = withBrightness(stepping, {{3, 1.0}, {5, -1.0}});
  for (const int frame : {2, 3, 4, 5, 9}) {
    const DoctorFrame expected = test::paintedFrame(shot, frame), seen = even(frame);
    for (int y = 0; y < expected.luma.height; ++y)
      for (int x = 0; x < expected.luma.width; ++x)
        ASSERT_NEAR(*seen.luma.at(x, y), *expected.luma.at(x, y), 1e-5) << frame << " " << x << " " << y;
  }
}

// In every pair of frames: as they are, neither fault leaves less than what is stated.
TEST(BrightnessSteps, HideNoOtherFault) {
  const auto found = [](const test::FrameFault& fault) {
    constexpr int kManyFrames = 16;
    const Diagnosis diagnosis = examine(test::paintedExamination({}, kManyFrames, [&](DoctorFrame& frame) {
      fault(frame);
      if (frame.frame % 2 == 1) brighten(frame, 2.0f);
    }));
    std::string ids;
    for (const Finding& finding : diagnosis.findings) ids += finding.id + " ";
    return ids;
  };
  EXPECT_EQ(found([](DoctorFrame& frame) { frame.jitterPx = -frame.jitterPx; }),
            "jitterNegated exposureStep ");
  EXPECT_EQ(found([](DoctorFrame& frame) {
              test::changeMotion(frame, test::kBoardId,
                                 [](const glm::vec2& motion) { return glm::vec2(motion.x, -motion.y); });
            }),
            "motionNegatedY exposureStep ");
}

TEST(BrightnessSteps, OfABlackPictureAreNotDecided) {
  Diagnosis out;
  tellBrightness(evidenceOf(restingShot(), 0.0f), {}, out); // black from the step on
  EXPECT_TRUE(out.findings.empty());
  BrightnessEvidence black;
  DoctorFrame now = test::paintedFrame({}, 1), before = test::paintedFrame({}, 0);
  brighten(now, 0.0f);
  brighten(before, 0.0f);
  black.add({now, before});
  Diagnosis open;
  tellBrightness(black, {}, open);
  ASSERT_EQ(open.parts.undecided().size(), 1u);
  EXPECT_EQ(open.parts.undecided()[0].faults, std::vector<Fault>{Fault::ExposureStep});
}

// Each reading makes other steps of the same numbers.
TEST(BrightnessSteps, AreThoseOfPreExposureThatIsStatedWrongly) {
  constexpr int kExposedFrames = 10;
  CaptureInfo captureInfo;
  captureInfo.conventions.emplace().color.preExposed = true;
  const auto stops = [](int frame) { return 0.4 * std::sin(1.7 * frame) + 0.05 * frame; };
  for (int frame = 0; frame < kExposedFrames; ++frame)
    captureInfo.preExposure[frame] = std::exp2(stops(frame));
  const auto nameOf = [&](const std::function<double(int)>& light) {
    BrightnessEvidence evidence;
    for (int frame = 1; frame < kExposedFrames; ++frame)
      evidence.pairs.push_back({frame, light(frame) - light(frame - 1), 48, 48, 0.1, 0.01});
    Diagnosis out;
    tellBrightness(evidence, captureInfo, out);
    return out.findings.empty() ? std::string() : out.findings[0].name;
  };
  EXPECT_EQ(nameOf([&](int frame) { return stops(frame + 1) - stops(frame); }),
            "Pre-exposure stated a frame late");
  EXPECT_EQ(nameOf([&](int frame) { return stops(frame - 1) - stops(frame); }),
            "Pre-exposure stated a frame early");
  EXPECT_EQ(nameOf([&](int frame) { return -stops(frame); }), "Pre-exposure that is not in color");
  EXPECT_EQ(nameOf([&](int frame) { return -2.0 * stops(frame); }), "Pre-exposure the other way around");
  EXPECT_EQ(nameOf([](int frame) { return 0.3 * std::cos(2.3 * frame); }),
            std::string(faultInfo(Fault::ExposureStep).label))
      << "of another cause";
  captureInfo.conventions->color.preExposed = false;
  EXPECT_EQ(nameOf(stops), "Pre-exposure in color, which is stated to have none");
}

} // namespace taa::doctor
