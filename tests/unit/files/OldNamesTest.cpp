// Names of earlier versions: the one that is meant is found, and the note says both.
#include "core/base/OldNames.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

using namespace taa;

namespace {

constexpr std::array<OldName, 2> kSampleNames{{{"a.old", "a.new"}, {"b", "c"}}};

} // namespace

TEST(OldNames, AreFoundByTheirWholeName) {
  EXPECT_EQ(findOldName(kSampleNames, "a.old"), &kSampleNames[0]);
  EXPECT_EQ(findOldName(kSampleNames, "b"), &kSampleNames[1]);
  for (const char* other : {"a.new", "old", "a", "a.old2", ""})
    EXPECT_EQ(findOldName(kSampleNames, other), nullptr) << other;
}

TEST(OldNames, AreNotedWithTheNewOne) {
  EXPECT_EQ(oldNameNote(kSampleNames[0]), "a.old is called a.new now");
}

TEST(OldNames, AreSaidOnce) {
  std::vector<std::string> notes{"x"};
  addNotes(notes, {"y", "x", "y"});
  addNotes(notes, {"z", "y"});
  EXPECT_EQ(notes, (std::vector<std::string>{"x", "y", "z"}));
}
