// What became of cases that the doctor was tried on, and the table of them.
#include "tests/manual/DoctorCases.h"

#include "tests/support/ErrorOf.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace taa {
namespace {

JudgedCase caseWith(const std::vector<std::string>& named) {
  JudgedCase out;
  out.tried = {"builtin:fan", "pan", {240, 136}, 14, {Fault::JitterLate}, false};
  out.shows = true;
  out.named = named;
  return out;
}

} // namespace

TEST(DoctorCases, HaveTheirOutcomeByTheNames) {
  EXPECT_EQ(outcomeOf(caseWith({"jitterLate", "motionZero"})), CaseOutcome::First);
  EXPECT_EQ(outcomeOf(caseWith({"motionZero", "jitterLate"})), CaseOutcome::Later);
  EXPECT_EQ(outcomeOf(caseWith({"motionZero"})), CaseOutcome::Wrong);
  EXPECT_EQ(outcomeOf(caseWith({})), CaseOutcome::Silent);
  JudgedCase open = caseWith({});
  open.isOpen = true;
  EXPECT_EQ(outcomeOf(open), CaseOutcome::Undecided);
}

TEST(DoctorCases, AreNamedByAFaultThatMakesTheSameFrames) {
  JudgedCase judged = caseWith({"jitterNegated"});
  judged.same = {"jitterNegated"};
  EXPECT_EQ(outcomeOf(judged), CaseOutcome::First);
  EXPECT_TRUE(isNamed(Fault::JitterLate, judged));
}

TEST(DoctorCases, AtHalfStrengthAreNamedByAFactor) {
  JudgedCase judged = caseWith({"motionScaled"});
  judged.tried.faults = {Fault::MotionDoubled};
  EXPECT_EQ(outcomeOf(judged), CaseOutcome::Wrong);
  judged.tried.isHalf = true;
  EXPECT_EQ(outcomeOf(judged), CaseOutcome::First);
}

TEST(DoctorCases, AreReadAsTheyAreWritten) {
  JudgedCase pair = caseWith({"jitterLate", "motionZero"});
  pair.tried.faults = {Fault::JitterLate, Fault::MotionZero};
  pair.isOpen = true;
  const std::string line =
      "builtin:fan,pan,240x136,14,,jitterLate|motionZero,full,yes,jitterLate|motionZero,,yes\n";
  EXPECT_EQ(judgedCaseText(pair), line);
  JudgedCase healthy;
  healthy.tried = {"builtin:fan", "pan", {240, 136}, 12, {}, false, "godot"};
  const std::string second = "builtin:fan,pan,240x136,12,godot,,full,no,,,no\n";
  EXPECT_EQ(judgedCaseText(healthy), second);
  const std::vector<JudgedCase> read = judgedCasesFrom(judgedCasesHead() + line + second, "judged");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].tried, pair.tried);
  EXPECT_EQ(read[1].tried, healthy.tried);
  EXPECT_EQ(judgedCaseText(read[0]) + judgedCaseText(read[1]), line + second);
}

TEST(DoctorCases, ThatAreWrongAreRefusedWithTheirLine) {
  const auto errorOfLine = [](const std::string& line) {
    return test::errorOf([&] { judgedCasesFrom(judgedCasesHead() + line, "judged"); });
  };
  EXPECT_EQ(test::errorOf([] { judgedCasesFrom("source\n", "judged"); }).find("judged: the first line"), 0u);
  EXPECT_EQ(errorOfLine("builtin:fan,pan\n").find("judged:2"), 0u);
  EXPECT_NE(errorOfLine("builtin:fan,pan,240x136,14,,jitterLat,full,yes,,,no\n").find("jitterLate"),
            std::string::npos);
  EXPECT_NE(errorOfLine("builtin:fan,pan,wide,14,,,full,yes,,,no\n").find("no number"), std::string::npos);
  EXPECT_NE(errorOfLine("builtin:fan,pan,240x136,14,,,third,yes,,,no\n").find("third"), std::string::npos);
  EXPECT_NE(errorOfLine("builtin:fan,pan,240x136,14,,,full,maybe,,,no\n").find("maybe"), std::string::npos);
}

TEST(DoctorCases, OfTheManualAreRead) {
  EXPECT_FALSE(judgedCases().empty());
}

} // namespace taa
