// What the probe tells, in another language: no word of it stays as it was.
#include "core/base/Say.h"
#include "core/settings/Presets.h"
#include "core/story/ProbeStory.h"
#include "tests/support/SmallInspector.h"

#include <cctype>
#include <string>
#include <string_view>

using namespace taa;
using StoryLanguageTest = taa::test::small::InspectorTest;

namespace {

/// Says everything in ⟦…⟧, what is put into a text as well.
struct Bracketed {
  Bracketed() { taa::setTranslate(inBrackets); }
  ~Bracketed() { taa::setTranslate(nullptr); }
  Bracketed(const Bracketed&) = delete;
  Bracketed& operator=(const Bracketed&) = delete;

  static std::string inBrackets(taa::Said, const char* text) { return "⟦" + std::string(text) + "⟧"; }
};

/// What is left of a text without all ⟦…⟧, which may lie in each other.
std::string outsideBrackets(std::string_view text) {
  constexpr std::string_view kOpen = "⟦", kClose = "⟧";
  std::string outside;
  int depth = 0;
  while (!text.empty()) {
    const bool opens = text.starts_with(kOpen), closes = text.starts_with(kClose);
    depth += opens ? 1 : closes ? -1 : 0;
    EXPECT_GE(depth, 0) << text;
    if (!opens && !closes && depth == 0) outside += text.front();
    text.remove_prefix(opens ? kOpen.size() : closes ? kClose.size() : 1);
  }
  EXPECT_EQ(depth, 0);
  return outside;
}

/// Names of channels have two letters at most.
bool hasWord(const std::string& text) {
  int letters = 0;
  for (const char character : text) {
    letters = std::isalpha(static_cast<unsigned char>(character)) != 0 ? letters + 1 : 0;
    if (letters == 3) return true;
  }
  return false;
}

} // namespace

TEST_F(StoryLanguageTest, EveryWordIsSaidInTheLanguageThatIsSet) {
  auto inspector = opened();
  inspector->shot().seek(6);
  for (const Preset& preset : wholePresets()) {
    inspector->shot().setSettings(preset.settings);
    const twin::PixelRecord record = inspector->probes().probe(30, 11);
    const twin::Details details = inspector->probes().details(30, 11);
    const ProbedPixel probed{
        record, details, inspector->shot().settings(), inspector->shot().info(), {30, 11}};
    const Bracketed language; // of the stories only: nothing is drawn meanwhile
    for (const Intermediate& row : kIntermediates) {
      const RowStory story = storyOf(row.id, probed);
      const std::string where = preset.id + " " + std::string(row.name) + ": ";
      EXPECT_TRUE(story.words.starts_with("⟦")) << where << story.words;
      EXPECT_FALSE(hasWord(outsideBrackets(story.words))) << where << story.words;
      EXPECT_FALSE(hasWord(outsideBrackets(story.subject))) << where << story.subject;
    }
  }
}
