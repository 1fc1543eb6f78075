// Faults of jitter are named, in painted frames whose pictures keep theirs while what is stated changes.
#include "core/doctor/jitter/JitterCheck.h"

#include "tests/support/doctor/PaintedFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::doctor {
namespace {

constexpr int kFrames = 8;

/// What is stated at a frame.
using Stated = std::function<glm::vec2(int frame)>;

glm::vec2 trueJitterAt(int frame) {
  return test::paintedFrame({}, frame).jitterPx;
}

Diagnosis diagnosisOf(const Stated& stated, const test::PaintedShot& shot = {}) {
  return examine(test::paintedExamination(
      shot, kFrames, [stated](DoctorFrame& frame) { frame.jitterPx = stated(frame.frame); }));
}

/// All that is found.
std::string told(const Diagnosis& diagnosis) {
  std::string text;
  for (const Finding& finding : diagnosis.findings) text += (text.empty() ? "" : ", ") + finding.id;
  return text;
}

} // namespace

// Wrong jitter makes all motion look wrong; nothing is said of motion, which is right.
TEST(JitterCheck, NamesWhatIsStatedAndNothingElse) {
  const auto of = [](const std::function<glm::vec2(const glm::vec2&)>& change) {
    return told(diagnosisOf([change](int frame) { return change(trueJitterAt(frame)); }));
  };
  EXPECT_EQ(of([](const glm::vec2& j) { return j; }), "");
  EXPECT_EQ(of([](const glm::vec2& j) { return glm::vec2(-j.x, j.y); }), "jitterNegatedX");
  EXPECT_EQ(of([](const glm::vec2& j) { return glm::vec2(j.x, -j.y); }), "jitterNegatedY");
  EXPECT_EQ(of([](const glm::vec2& j) { return -j; }), "jitterNegated");
  EXPECT_EQ(of([](const glm::vec2& j) { return glm::vec2(j.y, j.x); }), "jitterSwapped");
  EXPECT_EQ(of([](const glm::vec2& j) { return 2.0f * j; }), "jitterDoubled");
  EXPECT_EQ(of([](const glm::vec2& j) { return 0.5f * j; }), "jitterHalved");
  EXPECT_EQ(of([](const glm::vec2&) { return glm::vec2(0.0f); }), "jitterNotReported");
}

TEST(JitterCheck, NamesFactorsBetweenByTheirNumber) {
  const Diagnosis diagnosis = diagnosisOf([](int frame) { return 1.5f * trueJitterAt(frame); });
  ASSERT_EQ(told(diagnosis), "jitterDoubled");
  EXPECT_EQ(diagnosis.findings[0].name, "Jitter reported 1.5 times as large as it is");
}

// On no list: what is nearest there is 0.75.
TEST(JitterCheck, MeasuresAFactorThatNoListHas) {
  const Diagnosis diagnosis = diagnosisOf([](int frame) { return 0.8f * trueJitterAt(frame); });
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  EXPECT_EQ(diagnosis.findings[0].name.substr(0, 19), "Jitter reported 0.8") << diagnosis.findings[0].name;
}

// An engine that divides y by the width, and one with a factor of no reason.
TEST(JitterCheck, MeasuresAFactorForEachAxis) {
  constexpr float kWide = 160.0f / 96.0f; // of the painted pictures
  const auto ofY = [](float factor) {
    return diagnosisOf([factor](int frame) { return trueJitterAt(frame) * glm::vec2(1.0f, factor); });
  };
  const Diagnosis ofSides = ofY(1.0f / kWide);
  ASSERT_EQ(told(ofSides), "jitterOfAxis");
  EXPECT_EQ(ofSides.findings[0].name.substr(0, 17), "y of jitter repor") << ofSides.findings[0].name;
  EXPECT_NE(ofSides.findings[0].reason.find("the picture's width over its height: y is divided by the wrong"),
            std::string::npos)
      << ofSides.findings[0].reason;
  const Diagnosis ofNone = ofY(0.3f);
  ASSERT_EQ(told(ofNone), "jitterOfAxis");
  EXPECT_EQ(ofNone.findings[0].reason.find("the picture's"), std::string::npos) << ofNone.findings[0].reason;
}

TEST(JitterCheck, NamesAFrameLateOrEarly) {
  EXPECT_EQ(told(diagnosisOf([](int frame) { return trueJitterAt(frame == 0 ? 7 : frame - 1); })),
            "jitterLate");
  EXPECT_EQ(told(diagnosisOf([](int frame) { return trueJitterAt(frame + 1); })), "jitterEarly");
}

TEST(JitterCheck, NamesTwoThingsAtOnce) {
  const Diagnosis diagnosis =
      diagnosisOf([](int frame) { return -trueJitterAt(frame == 0 ? 7 : frame - 1); });
  ASSERT_EQ(told(diagnosis), "jitterNegated, jitterLate");
  for (const Finding& finding : diagnosis.findings)
    EXPECT_TRUE(finding.correction.empty()) << "no setting undoes both";
  EXPECT_EQ(told(diagnosisOf([](int frame) {
              const glm::vec2 next = trueJitterAt(frame + 1);
              return glm::vec2(next.y, next.x);
            })),
            "jitterSwapped, jitterEarly");
}

TEST(JitterCheck, NamesJitterThatIsNotApplied) {
  test::PaintedShot still;
  still.isJittered = false;
  EXPECT_EQ(told(diagnosisOf(trueJitterAt, still)), "jitterNotApplied");
}

// An interface without jitter rests, and what it lies over shifts.
TEST(JitterCheck, LeavesOpenWhetherWhatRestsHasJitter) {
  const auto toldBeside = [](std::size_t shiftingParts) {
    JitterEvidence evidence;
    for (int frame = 0; frame < kFrames; ++frame) evidence.stated[frame] = trueJitterAt(frame);
    for (int frame = 1; frame < kFrames; ++frame) {
      evidence.shifts.push_back({frame, glm::vec2(0.0f)});
      evidence.world.emplace_back(jitterTrials(test::kPaintedPx).size(), 1.0);
      evidence.world.back()[kNotAppliedTrial] = 0.1;
    }
    evidence.parts = 40;
    evidence.shiftingParts = shiftingParts;
    CaptureInfo captureInfo;
    captureInfo.sizePx = test::kPaintedPx;
    Diagnosis out;
    const JitterOutcome outcome = tellJitter(evidence, {captureInfo}, out);
    EXPECT_EQ(outcome.isOpen, out.findings.empty());
    const auto open = std::ranges::find(out.parts.undecided(), std::string("Jitter"), &Undecided::question);
    EXPECT_EQ(open != out.parts.undecided().end(), outcome.isOpen);
    if (open != out.parts.undecided().end()) {
      EXPECT_EQ(open->faults.back(), Fault::InterfaceBefore);
    }
    return told(out);
  };
  EXPECT_EQ(toldBeside(0), "jitterNotApplied");
  EXPECT_EQ(toldBeside(3), "jitterNotApplied");
  EXPECT_EQ(toldBeside(4), "");
}

// Frame against frame nothing is clear where pictures alias; their mean is.
TEST(JitterCheck, AsksTheMeanOfPicturesThatRest) {
  test::PaintedShot shot;
  shot.cameraPx = shot.boardPx = glm::dvec2(0.0);
  const auto toldOf = [&](float stated) {
    JitterEvidence evidence;
    std::optional<DoctorFrame> before;
    for (int frame = 0; frame < 2 * kFrames; ++frame) {
      DoctorFrame now = test::paintedFrame(shot, frame);
      now.jitterPx.x *= stated;
      evidence.stated[frame] = now.jitterPx;
      if (before) evidence.add({now, *before, nullptr});
      before = std::move(now);
    }
    // What fits a little better is no explanation.
    for (TrialLuma& pair : evidence.world) {
      std::ranges::fill(pair, 1.0);
      pair.back() = 0.9;
    }
    for (JitterEvidence::Shift& shift : evidence.shifts) shift.px += glm::vec2(0.1f, -0.1f);
    CaptureInfo captureInfo;
    captureInfo.sizePx = test::kPaintedPx;
    Diagnosis out;
    const JitterOutcome outcome = tellJitter(evidence, {captureInfo}, out);
    EXPECT_FALSE(outcome.isOpen);
    return told(out);
  };
  EXPECT_EQ(toldOf(1.0f), "");
  EXPECT_EQ(toldOf(-1.0f), "jitterNegatedX");
}

TEST(JitterCheck, CountsThePartsThatShift) {
  const auto partsOf = [](bool isJittered, bool isMoving = false) {
    test::PaintedShot shot;
    shot.isJittered = isJittered;
    if (!isMoving) shot.cameraPx = shot.boardPx = glm::dvec2(0.0);
    JitterEvidence evidence;
    for (int frame = 1; frame < kFrames; ++frame) {
      DoctorFrame before = test::paintedFrame(shot, frame - 1), now = test::paintedFrame(shot, frame);
      before.jitterPx = trueJitterAt(frame - 1);
      now.jitterPx = trueJitterAt(frame);
      evidence.add({now, before, nullptr});
    }
    return std::pair(evidence.parts, evidence.shiftingParts);
  };
  const auto [parts, shifting] = partsOf(true);
  EXPECT_GT(parts, 30u);
  EXPECT_GT(shifting, parts / 2);
  EXPECT_EQ(partsOf(false).second, 0u);
  EXPECT_EQ(partsOf(true, true).first, 0u) << "motion says what rests on the screen";
}

// Depth shifts with the jitter where surfaces are drawn with it, whatever is seen on them.
TEST(JitterCheck, AsksDepthWhetherSurfacesAreJittered) {
  const auto areJittered = [](bool isJittered) {
    JitterEvidence evidence;
    std::optional<DoctorFrame> before;
    for (int frame = 0; frame < kFrames; ++frame) {
      test::PaintedShot shot;
      shot.isJittered = isJittered;
      DoctorFrame now = test::paintedFrame(shot, frame);
      // A ground that rises to the right, in waves.
      for (int y = 0; y < now.depth.height; ++y)
        for (int x = 0; x < now.depth.width; ++x) *now.depth.at(x, y) = 0.02f + 0.01f * *now.luma.at(x, y);
      now.luma = asDepthPicture(now);
      now.jitterPx = trueJitterAt(frame);
      evidence.stated[frame] = now.jitterPx;
      if (before) evidence.add({now, *before, nullptr});
      before = std::move(now);
    }
    return areSurfacesJittered(evidence);
  };
  EXPECT_TRUE(areJittered(true));
  EXPECT_FALSE(areJittered(false));
}

TEST(JitterCheck, SaysThatTexturesAreReadWithoutJitter) {
  JitterEvidence evidence;
  for (int frame = 0; frame < kFrames; ++frame) evidence.stated[frame] = trueJitterAt(frame);
  const std::vector<JitterTrial> trials = jitterTrials(test::kPaintedPx);
  for (int frame = 1; frame < kFrames; ++frame) {
    evidence.shifts.push_back({frame, glm::vec2(0.0f)});
    evidence.world.emplace_back(trials.size(), 1.0);
    evidence.world.back()[kNotAppliedTrial] = 0.1;
  }
  CaptureInfo captureInfo;
  captureInfo.sizePx = test::kPaintedPx;
  for (const bool areSurfaces : {false, true}) {
    Diagnosis out;
    tellJitter(evidence, {captureInfo, true, {}, [&] { return areSurfaces; }}, out);
    EXPECT_EQ(told(out), areSurfaces ? "" : "jitterNotApplied");
    EXPECT_EQ(out.notes.size(), areSurfaces ? 1u : 0u);
  }
}

TEST(JitterCheck, NamesJitterThatIsAlwaysTheSame) {
  test::PaintedShot still;
  still.isJittered = false;
  EXPECT_EQ(told(diagnosisOf([](int) { return glm::vec2(0.25f, 0.0f); }, still)), "jitterFrozen");
  EXPECT_EQ(told(diagnosisOf([](int) { return glm::vec2(0.0f); }, still)), ""); // there is none
}

TEST(JitterCheck, SaysWhatPicturesShow) {
  const Diagnosis diagnosis = diagnosisOf([](int frame) { return -trueJitterAt(frame); });
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  const Finding& finding = diagnosis.findings[0];
  EXPECT_EQ(finding.confidence, Confidence::Sure);
  // The longest jitter of the eight is that of frame 7, Halton (1/16, 8/9) less a half.
  EXPECT_NE(finding.change.find("you pass (0.438, -0.389); the pictures show (-0.438, 0.389)"),
            std::string::npos)
      << finding.change;
  EXPECT_EQ(finding.residuals.front().id, "opposite");
  EXPECT_TRUE(finding.residuals.front().isBest);
}

TEST(JitterCheck, IsUnsureWithoutCameras) {
  Examination examination = test::paintedExamination({}, kFrames, [](DoctorFrame& frame) {
    frame.jitterPx = -frame.jitterPx;
    frame.previousClipFromClip.reset();
  });
  examination.known.camera = false;
  const Diagnosis diagnosis = examine(examination);
  ASSERT_FALSE(diagnosis.findings.empty());
  EXPECT_EQ(diagnosis.findings[0].id, "jitterNegated");
  EXPECT_EQ(diagnosis.findings[0].confidence, Confidence::Likely);
}

TEST(JitterCheck, NotesAFirstFrameWithoutJitter) {
  const Diagnosis diagnosis = examine(test::paintedExamination({}, kFrames, [](DoctorFrame& frame) {
    if (frame.frame > 0) return;
    test::PaintedShot still;
    still.isJittered = false;
    frame = test::paintedFrame(still, 0);
  }));
  EXPECT_TRUE(diagnosis.isHealthy());
  ASSERT_FALSE(diagnosis.notes.empty());
  EXPECT_NE(diagnosis.notes[0].find("first frame is not jittered"), std::string::npos);
}

} // namespace taa::doctor
