// Text in columns.
#include "core/cli/Table.h"

#include <gtest/gtest.h>

#include <sstream>

TEST(Table, AlignsColumnsByWhatIsSeen) {
  std::ostringstream out;
  taa::cli::printTable(out, {{"α", "1", ""}, {"length", "22", "frames"}}, "  ");
  EXPECT_EQ(out.str(), "  α       1\n  length  22  frames\n");
}
