// Sentences with places in them, as they are written and in another language.
#include "core/base/Say.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using taa::say;

/// Says in another language what the test gives it.
struct Language {
  explicit Language(taa::Translate translate) { taa::setTranslate(translate); }
  ~Language() { taa::setTranslate(nullptr); }
};

} // namespace

TEST(Say, PutsItsArgumentsWhereTheTextHasPlaces) {
  const std::string file = "fan.glb";
  EXPECT_EQ(say<"nothing to put in">(), "nothing to put in");
  EXPECT_EQ(say<"%1 has %2 frames, 31 % of them kept">(file, 240),
            "fan.glb has 240 frames, 31 % of them kept");
  EXPECT_EQ(say<"%2 before %1, and %2 again">("one", "two"), "two before one, and two again");
  EXPECT_EQ(say<"%1">("%1 %2 stays as it is"), "%1 %2 stays as it is");
}

TEST(Say, SaysItInTheLanguageThatIsSet) {
  const Language reversed([](taa::Said, const char* text) {
    const std::string read = text;
    return std::string(read.rbegin(), read.rend()).append(" %1");
  });
  EXPECT_EQ(say<"abc %1">("x"), "1% cba x");
}

TEST(Say, LabelsAreTextsOfTheLanguageToo) {
  EXPECT_EQ(taa::sayLabel("Catmull-Rom 5"), "Catmull-Rom 5");
  const Language brackets([](taa::Said kind, const char* text) {
    return (kind == taa::Said::Label ? "label " : "[") + std::string(text) + "]";
  });
  EXPECT_EQ(say<"by %1">(taa::sayLabel("Equal")), "[by label Equal]]");
}

TEST(Say, ATranslationThatAsksForMoreGetsNothing) {
  const Language wrong([](taa::Said, const char*) { return std::string("%1 %2 %9 %0 %"); });
  EXPECT_EQ(say<"only %1">("one"), "one %2 %9 %0 %");
}

TEST(Say, EveryTextIsKnownBeforeItIsSaid) {
  const std::vector<std::string> texts = taa::allSentences();
  EXPECT_TRUE(std::ranges::is_sorted(texts));
  EXPECT_EQ(std::ranges::count(texts, "this one is not said: %1"), 1);
  if (texts.empty()) {
    EXPECT_EQ(say<"this one is not said: %1">(1), "");
  }
}
