// Sentences with places in them.
#include "core/base/Say.h"

#include <gtest/gtest.h>

#include <string>

namespace {

using taa::say;

} // namespace

TEST(Say, PutsItsArgumentsWhereTheTextHasPlaces) {
  const std::string file = "fan.glb";
  EXPECT_EQ(say<"nothing to put in">(), "nothing to put in");
  EXPECT_EQ(say<"%1 has %2 frames, 31 % of them kept">(file, 240),
            "fan.glb has 240 frames, 31 % of them kept");
  EXPECT_EQ(say<"%2 before %1, and %2 again">("one", "two"), "two before one, and two again");
  EXPECT_EQ(say<"%1">("%1 %2 stays as it is"), "%1 %2 stays as it is");
}
