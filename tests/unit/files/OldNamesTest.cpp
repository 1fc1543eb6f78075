// Names of earlier versions: the one that is meant is found, and the note says both.
#include "core/base/OldNames.h"

#include <gtest/gtest.h>

#include <array>

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
