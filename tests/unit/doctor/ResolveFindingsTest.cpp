// What the doctor says of outputs that are made by hand of painted frames: nothing where they are sound, and
// each mistake by its name.
#include "core/doctor/resolve/ResolveFindings.h"

#include "tests/support/doctor/PaintedResolve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

using test::PaintedResolve;
using test::PaintedShot;

constexpr int kResolvedFrames = 10;

PaintedShot wholePixelShot() {
  PaintedShot shot;
  shot.cameraPx = {3.0, -2.0};
  shot.boardPx = {1.0, 2.0};
  return shot;
}

ResolveEvidence evidenceOf(const std::vector<DoctorFrame>& frames) {
  ResolveEvidence out;
  for (std::size_t i = 0; i < frames.size(); ++i) out.add(frames[i], i > 0 ? &frames[i - 1] : nullptr);
  return out;
}

Diagnosis diagnosisOfResolve(const PaintedResolve& resolve, const PaintedShot& shot = wholePixelShot(),
                             bool areInputsRight = true) {
  Diagnosis out;
  tellResolve(evidenceOf(test::resolvedFrames(shot, kResolvedFrames, resolve)), areInputsRight, out);
  return out;
}

std::string namesOf(const Diagnosis& diagnosis) {
  std::string text;
  for (const Finding& finding : diagnosis.findings) text += (text.empty() ? "" : ", ") + finding.id;
  return text;
}

bool isCalledRight(const Diagnosis& diagnosis) {
  return std::ranges::any_of(diagnosis.parts.right(), [](const RightPart& right) {
    return right.sentence.find("as it should be") != std::string::npos;
  });
}

PaintedResolve with(float alpha) {
  PaintedResolve resolve;
  resolve.alpha = alpha;
  return resolve;
}

} // namespace

TEST(ResolveFindings, FindNothingWhereHistoryIsReadWhereItLies) {
  for (const float alpha : {0.05f, 0.1f, 0.2f, 0.5f}) {
    const Diagnosis diagnosis = diagnosisOfResolve(with(alpha));
    EXPECT_EQ(namesOf(diagnosis), "") << alpha;
  }
  const Diagnosis exact = diagnosisOfResolve(with(0.1f));
  ASSERT_EQ(exact.parts.right().size(), 1u);
  EXPECT_NE(exact.parts.right()[0].sentence.find("with α 0.1,"), std::string::npos)
      << exact.parts.right()[0].sentence;
}

TEST(ResolveFindings, NameAnAlphaThatIsStuck) {
  EXPECT_EQ(namesOf(diagnosisOfResolve(with(1.0f))), "alphaOne");
  EXPECT_EQ(namesOf(diagnosisOfResolve(with(0.0f))), "alphaZero");
}

TEST(ResolveFindings, SayThatNothingAccumulatesWithoutJitter) {
  PaintedShot shot = wholePixelShot();
  shot.isJittered = false;
  const Diagnosis diagnosis = diagnosisOfResolve(with(1.0f), shot);
  // Without jitter, history that is read where it lies is the frame itself: nothing tells α.
  EXPECT_EQ(namesOf(diagnosis), "");
}

TEST(ResolveFindings, NameAHistoryThatIsNotReprojected) {
  PaintedResolve inPlace, opposite;
  inPlace.motionFactor = 0.0f;
  opposite.motionFactor = -1.0f;
  EXPECT_EQ(namesOf(diagnosisOfResolve(inPlace)), "historyInPlace");
  EXPECT_EQ(namesOf(diagnosisOfResolve(opposite)), "historyOpposite");
}

TEST(ResolveFindings, NameAHistoryThatIsNotSwapped) {
  PaintedResolve resolve;
  resolve.isSwapped = false;
  EXPECT_EQ(namesOf(diagnosisOfResolve(resolve)), "historyNotSwapped");
}

// The mean over all frames is neither: half of them are right.
TEST(ResolveFindings, SayFromWhichFrameOnItIsWrong) {
  const auto toldOf = [](PaintedResolve resolve) {
    resolve.wrongFrom = 8;
    Diagnosis out;
    tellResolve(evidenceOf(test::resolvedFrames(wholePixelShot(), 16, resolve)), true, out);
    EXPECT_FALSE(isCalledRight(out));
    return out;
  };
  PaintedResolve notSwapped;
  notSwapped.isSwapped = false;
  const Diagnosis named = toldOf(notSwapped);
  ASSERT_EQ(namesOf(named), "historyNotSwapped");
  EXPECT_EQ(named.findings[0].reason.find("From frame 8 on "), 0u) << named.findings[0].reason;
  PaintedResolve changed = with(0.2f);
  changed.alphaBefore = 0.02f;
  const Diagnosis other = toldOf(changed);
  EXPECT_EQ(namesOf(other), "");
  EXPECT_FALSE(other.isMisfit()) << "settings may change";
  EXPECT_NE(other.parts.undecided()[0].reason.find("from frame 8 on with other settings"), std::string::npos)
      << other.parts.undecided()[0].reason;
  PaintedResolve half;
  half.motionFactor = 0.5f; // as no model has it
  const Diagnosis open = toldOf(half);
  EXPECT_EQ(namesOf(open), "");
  EXPECT_TRUE(open.isMisfit());
  EXPECT_NE(open.parts.undecided()[0].reason.find("up to frame 7 "), std::string::npos)
      << open.parts.undecided()[0].reason;
}

TEST(ResolveFindings, NameAHistoryThatGoesOnThroughACut) {
  PaintedResolve resolve;
  resolve.cut = 5;
  EXPECT_EQ(namesOf(diagnosisOfResolve(resolve)), "");
  EXPECT_TRUE(isCalledRight(diagnosisOfResolve(resolve)));
  resolve.resetsAtCuts = false;
  const Diagnosis diagnosis = diagnosisOfResolve(resolve);
  EXPECT_EQ(namesOf(diagnosis), "noResetAtCut");
  EXPECT_FALSE(isCalledRight(diagnosis)); // nothing is right beside a finding of it
}

TEST(ResolveFindings, NameWhatIsNoNumberAndStays) {
  PaintedResolve resolve;
  resolve.nanFrame = 4;
  const Diagnosis diagnosis = diagnosisOfResolve(resolve);
  ASSERT_EQ(namesOf(diagnosis), "nanKept");
  EXPECT_NE(diagnosis.findings[0].reason.find("at (40, 40)"), std::string::npos)
      << diagnosis.findings[0].reason;
  EXPECT_FALSE(isCalledRight(diagnosis));
  resolve.nanFrame = kResolvedFrames - 1; // once is no blob that stays
  EXPECT_EQ(namesOf(diagnosisOfResolve(resolve)), "");
}

TEST(ResolveFindings, HoldResidualsOfAllExplanationsSideBySide) {
  PaintedResolve resolve;
  resolve.motionFactor = 0.0f;
  const Diagnosis diagnosis = diagnosisOfResolve(resolve);
  ASSERT_EQ(diagnosis.findings.size(), 1u);
  const std::vector<Residual>& residuals = diagnosis.findings[0].residuals;
  ASSERT_GE(residuals.size(), 5u);
  EXPECT_EQ(residuals[0].id, "inPlace");
  EXPECT_TRUE(residuals[0].isBest);
  // A tenth of a frame is not rounded to halves by who made it by hand.
  EXPECT_LT(residuals[0].value, 0.5);
  for (std::size_t i = 1; i < residuals.size(); ++i) EXPECT_GE(residuals[i].value, residuals[i - 1].value);
}

TEST(ResolveFindings, WithholdWhatDoesNotFitExactlyWhereInputsAreWrong) {
  PaintedResolve resolve;
  resolve.motionFactor = 0.5f; // as no model has it
  const Diagnosis diagnosis = diagnosisOfResolve(resolve, wholePixelShot(), false);
  EXPECT_EQ(namesOf(diagnosis), "");
  ASSERT_EQ(diagnosis.parts.undecided().size(), 1u);
  EXPECT_EQ(diagnosis.parts.undecided()[0].capture, "Mend these first.");
}

TEST(ResolveFindings, SayWhyAnOutputOfAnotherSizeIsNotDecided) {
  std::vector<DoctorFrame> frames = test::resolvedFrames(wholePixelShot(), kResolvedFrames, {});
  for (DoctorFrame& frame : frames) frame.output = Image(2 * frame.output.width, 2 * frame.output.height, 3);
  Diagnosis out;
  tellResolve(evidenceOf(frames), true, out);
  EXPECT_EQ(namesOf(out), "");
  ASSERT_EQ(out.parts.undecided().size(), 1u);
  EXPECT_EQ(out.parts.undecided()[0].reason, "the output is larger than what is drawn");
}

} // namespace taa::doctor
