// What the import page makes of answers of the pixels and of what is set by hand.
#include "app/importing/Answers.h"
#include "app/importing/ImportState.h"

#include "core/base/Error.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace taa::app {
namespace {

capture::Hypothesis answer(const std::string& assignment, double residual) {
  capture::Hypothesis hypothesis;
  hypothesis.text = assignment;
  if (!assignment.empty()) hypothesis.assignments = {assignment};
  hypothesis.isStatable = !assignment.empty();
  hypothesis.residual = residual;
  return hypothesis;
}

capture::Finding finding(const std::string& path, bool isSure,
                         const std::vector<capture::Hypothesis>& answers) {
  capture::Finding out;
  out.question = path;
  out.path = path;
  out.isSure = isSure;
  out.hypotheses = answers;
  return out;
}

/// Scale 1 is what conventions begin with.
const capture::Finding kAsStated =
    finding("motion.scaleX", true, {answer("motion.scaleX=1", 10.0), answer("motion.scaleX=-1", 40.0)});
const capture::Finding kAtRest =
    finding("motion.scaleX", true, {answer("", 10.0), answer("motion.scaleX=1", 20.0)});

} // namespace

TEST(ImportAnswers, ThatNothingMovesContradictsWhateverIsStated) {
  EXPECT_FALSE(agrees(kAtRest.hypotheses[0], {}));
  EXPECT_EQ(verdictOn(&kAtRest, {}), Verdict::Contradicted);
  EXPECT_EQ(verdictOn(&kAsStated, {}), Verdict::Sure);
}

TEST(ImportAnswers, OfTwoQuestionsTheOneThatLeavesMoreDoubtCounts) {
  const capture::Finding isOpen = finding("motion.scaleX", false, {answer("motion.scaleX=1", 10.0)});
  for (const auto& findings : {std::vector{kAsStated, kAtRest}, std::vector{kAtRest, kAsStated}})
    EXPECT_EQ(verdictOn(findingOf(findings, "motion.scaleX", {}), {}), Verdict::Contradicted);
  for (const auto& findings : {std::vector{kAsStated, isOpen}, std::vector{isOpen, kAsStated}})
    EXPECT_EQ(verdictOn(findingOf(findings, "motion.scaleX", {}), {}), Verdict::NotSure);
  EXPECT_EQ(findingOf({kAsStated}, "motion.unit", {}), nullptr);
}

TEST(ImportState, KeepsWhatWasSetByHandForTheNextGuess) {
  ImportState state = withAssignments({}, {"motion.unit=uv", "motion.scaleX=1"});
  EXPECT_EQ(state.changed, std::set<std::string>{"motion.unit"}) << "the scale was 1 before";
  EXPECT_EQ(assignmentsOf(state), std::vector<std::string>{"motion.unit=uv"});
  EXPECT_EQ(startedLike(state, ""), state);
  state = startedLike(state, "three");
  EXPECT_EQ(state.conventions, capture::startingPoint("three").conventions);
  EXPECT_TRUE(assignmentsOf(state).empty());
  EXPECT_THROW(static_cast<void>(withAssignments(state, {"motion.unit=miles"})), Error);
}

TEST(ImportState, PlanesThatAreStatedStayWhereAnEngineIsBegunWith) {
  ImportState state = withPlane({}, capture::PlaneKind::Motion, "dmv_{frame:4}.exr:G,B");
  state = startedLike(withAssignments(state, {"motion.unit=uv"}), "three");
  EXPECT_EQ(assignmentsOf(state), std::vector<std::string>{"plane.motion=dmv_{frame:4}.exr:G,B"});
  EXPECT_TRUE(assignmentsOf(withPlane(state, capture::PlaneKind::Motion, "")).empty()) << "as it is found";
}

TEST(ImportState, NotesOfTheFileSayWhatIsOtherThanGuessed) {
  capture::Manifest manifest;
  manifest.notes = {"guessed"};
  EXPECT_EQ(withNoteOfChanges(manifest, {}).notes, manifest.notes);
  manifest.conventions.motion.unit = capture::ScreenUnit::Uv;
  EXPECT_EQ(withNoteOfChanges(manifest, {}).notes,
            (std::vector<std::string>{"guessed", "set by hand after that: motion.unit=uv"}));
}

} // namespace taa::app
