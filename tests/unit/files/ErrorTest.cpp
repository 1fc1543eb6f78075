// What an error says, whatever a file brought into it.
#include "core/base/Error.h"
#include "core/base/Say.h"

#include <gtest/gtest.h>

#include <string>

namespace taa {

TEST(Error, IsOneLineWhateverAFileBroughtIntoIt) {
  const std::string name = "fan\ntaa-batch: all is well\x1b[2J";
  EXPECT_STREQ(Error(say<"cannot open %1: %2">(name, "it is a folder")).what(),
               "cannot open fan taa-batch: all is well?[2J: it is a folder");
  EXPECT_STREQ(Error(std::string("a\0b", 3)).what(), "a?b") << "nothing ends a sentence early";
}

TEST(Error, WithALogKeepsItsLines) {
  EXPECT_STREQ(Error::withLog("cannot compile a.frag:\n3: no such name \x1b").what(),
               "cannot compile a.frag:\n3: no such name ?");
}

} // namespace taa
