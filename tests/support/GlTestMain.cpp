// Runs the tests that need a GL context, in the repository root.
#include "tests/support/Paths.h"

#include <gtest/gtest.h>

#include <filesystem>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  std::filesystem::current_path(taa::test::rootFolder());
  return RUN_ALL_TESTS();
}
