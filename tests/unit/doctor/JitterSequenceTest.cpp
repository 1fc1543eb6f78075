// What is wrong with a sequence of jitter by itself: on sequences whose mean, range and period are plain.
#include "core/doctor/jitter/JitterSequence.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace taa::doctor {
namespace {

using Jitters = std::map<int, glm::vec2>;

Jitters jittersOf(int frames, const std::function<glm::vec2(int)>& at) {
  Jitters out;
  for (int frame = 0; frame < frames; ++frame) out[frame] = at(frame);
  return out;
}

/// Four places at the centers of a pixel's quarters, scaled and moved.
glm::vec2 quarter(int frame, float scale = 1.0f, const glm::vec2& offset = glm::vec2(0.0f)) {
  const int place = frame % 4;
  return scale * glm::vec2(place % 2 == 0 ? -0.25f : 0.25f, place < 2 ? -0.25f : 0.25f) + offset;
}

std::string sequenceTold(const Jitters& jitters) {
  Diagnosis out;
  tellSequence(jitters, out);
  std::string text;
  for (const Finding& finding : out.findings) text += (text.empty() ? "" : ", ") + finding.id;
  return text;
}

} // namespace

TEST(JitterSequence, RepeatsAfterItsPeriod) {
  EXPECT_EQ(sequenceFacts(jittersOf(8, [](int f) { return quarter(f); })).period, 4);
  EXPECT_FALSE(sequenceFacts(jittersOf(7, [](int f) { return quarter(f); })).period); // not twice whole
  EXPECT_FALSE(sequenceFacts({}).period);
}

TEST(JitterSequence, HasItsMeanOverWholePeriods) {
  const SequenceFacts facts = sequenceFacts(jittersOf(10, [](int f) {
    return quarter(f, 1.0f, {0.25f, -0.125f});
  }));
  EXPECT_NEAR(facts.meanPx.x, 0.25, 1e-6);
  EXPECT_NEAR(facts.meanPx.y, -0.125, 1e-6);
}

TEST(JitterSequence, GoesBeyondHalfAPixelInAShareOfItsFrames) {
  // Doubled, x and y are exactly half a pixel, which is none too many; at 2.5 times all are beyond.
  EXPECT_EQ(sequenceFacts(jittersOf(8, [](int f) { return quarter(f, 2.0f); })).beyondShare, 0.0);
  const SequenceFacts far = sequenceFacts(jittersOf(8, [](int f) { return quarter(f, 2.5f); }));
  EXPECT_EQ(far.beyondShare, 1.0);
  EXPECT_NEAR(far.longestPx, 0.625, 1e-6);
}

TEST(JitterSequence, IsFaultyByItsMeanRangeOrPeriodAlone) {
  EXPECT_EQ(sequenceTold(jittersOf(16, [](int f) { return quarter(f); })), "");
  EXPECT_EQ(sequenceTold(jittersOf(16,
                                   [](int f) {
                                     return quarter(f, 0.5f, {0.25f, 0.125f});
                                   })),
            "jitterMean");
  EXPECT_EQ(sequenceTold(jittersOf(16, [](int f) { return quarter(f, 3.0f); })), "jitterOutside");
  EXPECT_EQ(sequenceTold(jittersOf(16, [](int f) { return quarter(f % 2 == 0 ? 0 : 3); })), "jitterShort");
}

// A wide filter may be meant: two of eight reach 0.53 px, the others stay within half a pixel.
TEST(JitterSequence, ThatReachesALittleFartherIsNotDecided) {
  Diagnosis out;
  tellSequence(jittersOf(16,
                         [](int f) {
                           return glm::vec2(f % 8 == 0 ? 0.53f : f % 8 == 1 ? -0.53f : 0.0f, quarter(f).y);
                         }),
               out);
  EXPECT_TRUE(out.isHealthy());
  ASSERT_EQ(out.parts.undecided().size(), 1u);
  EXPECT_EQ(out.parts.undecided()[0].faults, std::vector<Fault>{Fault::JitterOutside});
  EXPECT_NE(out.parts.undecided()[0].reason.find("0.53"), std::string::npos)
      << out.parts.undecided()[0].reason;
}

TEST(JitterSequence, HasItsMiddleBetweenItsExtremes) {
  const SequenceFacts facts = sequenceFacts(
      jittersOf(3, [](int f) { return glm::vec2(f == 0 ? -0.25f : 0.5f, 0.125f * static_cast<float>(f)); }));
  EXPECT_EQ(facts.middlePx, glm::dvec2(0.125, 0.125));
}

TEST(JitterSequence, OfAFewFramesHasAMeanWhereItsRangeLiesAroundIt) {
  const auto moved = [](int f) { return quarter(f, 0.1f + 0.01f * static_cast<float>(f), {0.25f, 0.125f}); };
  EXPECT_EQ(sequenceTold(jittersOf(7, moved)), "");
  EXPECT_EQ(sequenceTold(jittersOf(8, moved)), "jitterMean");
}

TEST(JitterSequence, OfAFewFramesIsNotDecidedWhereItsRangeLiesElsewhere) {
  // One of eight is far to the left: the range is around −0.05, the mean is 0.175 or, of sixteen, the same.
  const auto lopsided = [](int f) {
    return glm::vec2(f % 8 == 3 ? -0.4f : 0.25f + 0.001f * static_cast<float>(f), 0.0f);
  };
  Diagnosis few;
  tellSequence(jittersOf(8, lopsided), few);
  EXPECT_TRUE(few.isHealthy());
  ASSERT_EQ(few.parts.undecided().size(), 1u);
  EXPECT_EQ(few.parts.undecided()[0].faults, std::vector<Fault>{Fault::JitterMean});
  EXPECT_EQ(sequenceTold(jittersOf(16, lopsided)), "jitterMean");
}

// Two places have a mean that is none of the sequence's, were it longer.
TEST(JitterSequence, OfTwoPlacesIsTooShortAndNothingElse) {
  const auto two = [](int f) {
    return f % 2 == 0 ? glm::vec2(0.0f, -1.0f / 6.0f) : glm::vec2(-0.25f, 1.0f / 6.0f);
  };
  EXPECT_EQ(sequenceTold(jittersOf(14, two)), "jitterShort");
  EXPECT_EQ(sequenceTold(jittersOf(14, [&](int f) { return two(f) + glm::vec2(0.375f, 0.125f); })),
            "jitterShort, jitterMean");
}

TEST(JitterSequence, OfTwoPlacesIsShortWhateverPicturesHold) {
  const auto toldShort = [](const std::map<int, glm::vec2>& jitters) {
    Diagnosis out;
    tellShort(jitters, out);
    return out.findings.empty() ? std::string() : out.findings[0].id;
  };
  EXPECT_EQ(toldShort(jittersOf(8, [](int f) { return glm::vec2(f % 2 == 0 ? 0.25f : -0.25f, 0.0f); })),
            "jitterShort");
  EXPECT_EQ(toldShort(jittersOf(8, [](int f) { return glm::vec2(0.1f * static_cast<float>(f % 4), 0.0f); })),
            "");
  EXPECT_EQ(toldShort(jittersOf(8, [](int) { return glm::vec2(0.25f, 0.0f); })), "");
}

TEST(JitterSequence, IsNoneWhereItIsAlwaysTheSame) {
  EXPECT_EQ(sequenceTold(jittersOf(16, [](int) { return glm::vec2(0.4f, 0.0f); })), "");
}

} // namespace taa::doctor
