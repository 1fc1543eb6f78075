// A lineage in sentences.
#include "core/verdict/lineage/LineageWords.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace taa;

namespace {

Lineage known() {
  Lineage lineage;
  lineage.frame = 9;
  lineage.frames.resize(2);
  lineage.frames[1] = {.frame = 8, .place = {12.25, 7.5}, .spreadPx = 0.433};
  lineage.weight = 1.0;
  lineage.historyLength = 3.0;
  lineage.effectiveFrames = 2.5;
  lineage.variance = 0.125;
  lineage.radiusPx = 0.375;
  return lineage;
}

} // namespace

TEST(LineageWords, SayWorthPartsAndPlace) {
  const std::vector<std::string> expected{
      "averages as much as 2.5 equally weighted frames (the resolve counts N = 3); 12.5 % of the noise variance of single samples is left",
      "100 % samples of the last 2 frames",
      "its samples lie within 0.375 px (rms) of its center; in frame 8 history was gathered over 0.433 px around (12.25, 7.5)"};
  EXPECT_EQ(lineageSentences(known()), expected);
}

TEST(LineageWords, NamePartsThatAreNoSamples) {
  Lineage lineage = known();
  lineage.weight = 0.25;
  lineage.rectified = 0.5;
  lineage.older = 0.125;
  lineage.pruned = 0.0625;
  lineage.blank = 0.0625;
  const std::vector<std::string> said = lineageSentences(lineage);
  EXPECT_EQ(said[0].substr(said[0].find("variance")),
            "variance of single samples is left, besides what rectification brings in");
  EXPECT_EQ(
      said[1],
      "25 % samples of the last 2 frames, 50 % replaced by clipping, 12.5 % older, 6.3 % in discarded small weights, 6.3 % of nothing");
}

TEST(LineageWords, SpeakOfAPixelThatBegins) {
  Lineage lineage = known();
  lineage.frames.pop_back();
  EXPECT_EQ(lineageSentences(lineage)[1], "100 % samples of this frame");
}
