// Runs the tests that need a GL context, in the repository root.
#include "tests/support/Paths.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  std::filesystem::current_path(taa::test::rootFolder());
  ::setenv("TAA_PROGRAM_CACHE", "", 1); // what is tested is compiled
  return RUN_ALL_TESTS();
}
