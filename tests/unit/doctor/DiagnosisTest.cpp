// Parts that were examined have one status each, and what does not fit is never "nothing wrong".
#include "core/doctor/Diagnosis.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace taa::doctor {

// In either order: the part is open, and its one sentence says for what it is right.
TEST(ExaminedParts, AreUndecidedWhereTheyArePartlyRight) {
  ExaminedParts rightFirst, openFirst;
  rightFirst.addRight("Depth", "It makes the motion of what rests.");
  rightFirst.leaveOpen({"Depth", "the board's is not known", "Let it rest."});
  openFirst.leaveOpen({"Depth", "the board's is not known", "Let it rest."});
  openFirst.addRight("Depth", "It makes the motion of what rests.");
  for (const ExaminedParts& parts : {rightFirst, openFirst}) {
    EXPECT_TRUE(parts.right().empty());
    ASSERT_EQ(parts.undecided().size(), 1u);
    EXPECT_EQ(parts.undecided()[0].reason,
              "It makes the motion of what rests; not decided: the board's is not known");
  }
}

TEST(ExaminedParts, AreListedOnce) {
  ExaminedParts parts;
  parts.leaveOpen({"Jitter", "it is short", "Capture more.", {Fault::JitterShort}});
  parts.leaveOpen({"Jitter", "it is off", "Capture more.", {Fault::JitterShort, Fault::JitterMean}, true});
  ASSERT_EQ(parts.undecided().size(), 1u);
  const Undecided& jitter = parts.undecided()[0];
  EXPECT_EQ(jitter.reason, "it is short; it is off");
  EXPECT_EQ(jitter.capture, "Capture more.");
  EXPECT_EQ(jitter.faults, (std::vector<Fault>{Fault::JitterShort, Fault::JitterMean}));
  EXPECT_TRUE(jitter.isMisfit);
  // No faults named: all of the part.
  parts.leaveOpen({"Jitter", "it is unknown", ""});
  EXPECT_TRUE(parts.undecided()[0].faults.empty());
  parts.addRight("Exposure", "It does not step.");
  parts.addRight("Exposure", "It is constant.");
  ASSERT_EQ(parts.right().size(), 1u);
  EXPECT_EQ(parts.right()[0].sentence, "It does not step. It is constant.");
}

TEST(ExaminedParts, TakeBackWhatIsRightSinceALook) {
  ExaminedParts earlier;
  earlier.addRight("Jitter", "It fits.");
  ExaminedParts later = earlier;
  later.addRight("Jitter", "It is short.");
  later.addRight("Motion", "It fits.");
  later.keepRight(earlier);
  ASSERT_EQ(later.right().size(), 1u);
  EXPECT_EQ(later.right()[0].sentence, "It fits.");
}

TEST(Diagnosis, SaysThatNothingIsWrongOnlyWhereAllFits) {
  Diagnosis out;
  out.parts.leaveOpen({"Exposure", "too little is seen", ""});
  EXPECT_EQ(out.healthySentence(), "Nothing wrong was found.");
  out.parts.leaveOpen({"Jitter", "measured shifts are 0.609 px from those that are stated", "", {}, true});
  EXPECT_EQ(out.healthySentence(),
            "Nothing is wrong in what could be decided, but not everything fits: Jitter.");
  for (const char* name : {"a", "b", "c", "d"}) out.parts.leaveOpen({name, "it does not fit", "", {}, true});
  EXPECT_EQ(
      out.healthySentence(),
      "Nothing is wrong in what could be decided, but not everything fits: Jitter, a, b, c and 1 more.");
}

} // namespace taa::doctor
