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
      "worth 2.5 equal frames, N says 3; noise of single samples keeps 12.5 % of its variance",
      "100 % samples of the last 2 frames",
      "its samples lie 0.375 px around its center; in frame 8 they were read around (12.25, 7.5), over 0.433 "
      "px"};
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
  EXPECT_EQ(said[0].substr(said[0].find("variance")), "variance, besides what rectification brings in");
  EXPECT_EQ(said[1],
            "25 % samples of the last 2 frames, 50 % put there by rectification, 12.5 % older, 6.3 % in "
            "pixels that hardly count, 6.3 % of nothing");
}

TEST(LineageWords, SpeakOfAPixelThatBegins) {
  Lineage lineage = known();
  lineage.frames.pop_back();
  EXPECT_EQ(lineageSentences(lineage)[1], "100 % samples of this frame");
}
