// Files that are there already are counted and refused unless they may be replaced.
#include "core/base/ExistingFiles.h"

#include "core/base/Files.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using taa::test::temporaryFolder;

namespace {

std::string refusal(const std::vector<fs::path>& paths) {
  return taa::test::errorOf([&] { taa::refuseToReplace(paths); });
}

} // namespace

TEST(ExistingFiles, AreThoseThatAreThereInTheirOrder) {
  const fs::path folder = temporaryFolder() / "existing";
  fs::create_directories(folder);
  const fs::path a = folder / "a", b = folder / "b", c = folder / "c", link = folder / "link";
  taa::writeFile(c, "x");
  taa::writeFile(a, "x");
  fs::create_symlink("nowhere", link);
  EXPECT_EQ(taa::existing({c, b, a, link, a / "below a file"}), (std::vector<fs::path>{c, a, link}));
}

TEST(ExistingFiles, AreNamedWithTheirNumberAndTheWayOut) {
  const fs::path file = temporaryFolder() / "mine", other = temporaryFolder() / "not there";
  taa::writeFile(file, "x");
  EXPECT_EQ(refusal({other}), "");
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({file}), file.string() + " is there already; --force replaces it");
  EXPECT_EQ(refusal({other, file, other}), "files that are there already: 1 of 3, the first is " +
                                               file.string() + "; --force replaces them");
}
