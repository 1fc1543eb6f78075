// Fields of rows made by hand: what is found, by what, and what is not.
#include "core/base/Search.h"

#include "tests/support/ErrorOf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

using namespace taa;

namespace {

const std::vector<GlossaryRow> kWords = readGlossary("| word | also | means |\n|---|---|---|\n"
                                                     "| box | AABB, bounding box | bounds |\n"
                                                     "| motion vector, motion | velocity | where from |\n"
                                                     "| lane | | settings |\n");

const SearchedRow kRow{
    .label = "Box kind",
    .id = "neighborhood.boxKind",
    .group = "Neighborhood",
    .choices = {{"minMax", "Min-max", "From the smallest sample."},
                {"variance", "Variance", "Mean ± γ deviations (Salvi 2016); clips fireflies."}},
    .text = "What blocks history that is far off."};

std::optional<SearchHit> found(const std::string& wanted, const SearchedRow& row = kRow) {
  return Search(wanted, kWords).find(row);
}

} // namespace

TEST(Search, SaysByWhatARowIsFound) {
  EXPECT_EQ(found("box"), (SearchHit{FoundBy::Label}));
  EXPECT_EQ(found("KIND"), (SearchHit{FoundBy::Label}));
  EXPECT_EQ(found("neighborhood.boxK"), (SearchHit{FoundBy::Id}));
  EXPECT_EQ(found("variance"), (SearchHit{FoundBy::Choice, "Variance"}));
  EXPECT_EQ(found("min max"), (SearchHit{FoundBy::Choice, "Min-max"}));
  EXPECT_EQ(found("salvi"), (SearchHit{FoundBy::Choice, "Variance"}));
  EXPECT_EQ(found("blocks"), (SearchHit{FoundBy::Text}));
  EXPECT_EQ(found("AABB"), (SearchHit{FoundBy::Synonym, "box"}));
}

TEST(Search, WantsEveryWordAndSaysTheWeakestHit) {
  EXPECT_EQ(found("box variance"), (SearchHit{FoundBy::Choice, "Variance"}));
  EXPECT_EQ(found("box history"), (SearchHit{FoundBy::Text}));
  EXPECT_EQ(found("box nonsense"), std::nullopt);
  EXPECT_EQ(found("bounding box"), (SearchHit{FoundBy::Synonym, "box"}));
  EXPECT_EQ(found("AABB variance"), (SearchHit{FoundBy::Synonym, "box"}))
      << "a synonym within what was typed";
  EXPECT_EQ(found("velocity"), std::nullopt) << "another thing's";
}

TEST(Search, FindsWordsFromTheirBeginningAndLongOnesWithinNames) {
  EXPECT_EQ(found("lock"), std::nullopt) << "blocks is another word";
  EXPECT_EQ(found("ox"), std::nullopt);
  EXPECT_EQ(found("borhood"), (SearchHit{FoundBy::Id}));
  EXPECT_EQ(found("kind", {.label = "x", .id = "a.boxKind"}), (SearchHit{FoundBy::Id}))
      << "begins at a capital";
  EXPECT_EQ(found("r2", {.label = "FSR2"}), std::nullopt);
  EXPECT_EQ(found("r2", {.label = "R2"}), (SearchHit{FoundBy::Label}));
}

TEST(Search, LeavesEndingsAndCapitalsOut) {
  EXPECT_EQ(found("boxes", {.label = "Boxe"}), (SearchHit{FoundBy::Label}));
  EXPECT_EQ(found("clipping"), (SearchHit{FoundBy::Choice, "Variance"}));
  EXPECT_EQ(found("sharpening", {.label = "Sharpen"}), (SearchHit{FoundBy::Label}));
  EXPECT_EQ(found("fireflies"), (SearchHit{FoundBy::Choice, "Variance"}));
  EXPECT_EQ(found("ÜBER Γ", {.label = "Über γ"}), (SearchHit{FoundBy::Label}));
}

TEST(Search, KnowsASynonymWhileItIsTyped) {
  EXPECT_EQ(found("aa"), std::nullopt);
  EXPECT_EQ(found("aab"), (SearchHit{FoundBy::Synonym, "box"}));
  const SearchedRow motion{.label = "Motion", .id = "motion"};
  EXPECT_EQ(found("veloc", motion), (SearchHit{FoundBy::Synonym, "motion"})) << "no row says motion vector";
}

TEST(Search, KnowsAssignments) {
  EXPECT_EQ(found("neighborhood.boxKind = vari"), (SearchHit{FoundBy::Id}));
  EXPECT_EQ(found("neighborhood.boxKind=nobody"), std::nullopt);
  EXPECT_EQ(found("weight.alpha=0.1", {.label = "α", .id = "weight.alpha"}), (SearchHit{FoundBy::Id}));
  EXPECT_EQ(found("boxKind=minMax"), std::nullopt) << "a path is whole";
}

TEST(Search, OfNothingFindsAll) {
  EXPECT_TRUE(Search("  ", kWords).isEmpty());
  EXPECT_EQ(found(" "), (SearchHit{}));
}

TEST(Glossary, IsReadFromItsTable) {
  ASSERT_EQ(kWords.size(), 3u);
  EXPECT_EQ(kWords[0], (GlossaryRow{{"box"}, {"AABB", "bounding box"}}));
  EXPECT_EQ(kWords[2], (GlossaryRow{{"lane"}, {}}));
  EXPECT_EQ(test::errorOf([] { readGlossary("# G\n\n| word | also | means |\n|---|---|---|\n| a | b |\n"); }),
            "glossary, line 5: a row has three columns: word, also, means");
}

// A name that stands for two things finds what the reader did not mean.
TEST(Glossary, OfTheManualHasEachNameOnce) {
  std::vector<std::string> names;
  for (const GlossaryRow& row : glossary()) {
    EXPECT_FALSE(row.words.empty());
    for (const auto& some : {row.words, row.others})
      for (const std::string& name : some) {
        EXPECT_EQ(std::ranges::count(names, name), 0) << name;
        names.push_back(name);
      }
  }
  EXPECT_GT(names.size(), 60u);
}
