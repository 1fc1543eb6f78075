// Results of points in a folder: whole, of the inputs they are of, or not there.
#include "core/sweep/SweepFolder.h"

#include "core/base/Files.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using taa::PointKey;

namespace {

class SweepFolder : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(path()); }
  static fs::path path() { return taa::test::temporaryFolder() / "folder"; }
  const PointKey key_{ordered_json{{"source", "builtin:fan"}, {"settings", {"weight.alpha=0.5"}}}};
};

} // namespace

TEST_F(SweepFolder, GivesBackWhatWasKept) {
  const taa::SweepFolder folder(path());
  EXPECT_FALSE(folder.holds(key_));
  folder.keep(key_, {{"mean", {{"rmse", 0.25}}}});
  ASSERT_TRUE(folder.holds(key_));
  EXPECT_EQ((*folder.result(key_))["mean"]["rmse"], 0.25);
  EXPECT_EQ((*folder.result(key_))["inputs"], key_.inputs);
  EXPECT_TRUE(taa::SweepFolder(path()).holds(key_)) << "by another program, too";
}

TEST_F(SweepFolder, KnowsAPointByWhatItWasMadeFrom) {
  const taa::SweepFolder folder(path());
  folder.keep(key_, {{"mean", {}}});
  const PointKey other{ordered_json{{"source", "builtin:fan"}, {"settings", {"weight.alpha=0.25"}}}};
  EXPECT_NE(other.name, key_.name);
  EXPECT_FALSE(folder.holds(other));
  // Of the right name, and made from something else.
  fs::copy_file(folder.pointFile(key_), folder.pointFile(other));
  EXPECT_FALSE(folder.holds(other));
}

TEST_F(SweepFolder, TakesABrokenFileForNone) {
  const taa::SweepFolder folder(path());
  folder.keep(key_, {{"mean", {}}});
  const std::string whole = taa::readFile(folder.pointFile(key_));
  for (const std::string& broken : {whole.substr(0, whole.size() / 2), std::string(), std::string("[1]")}) {
    taa::writeFile(folder.pointFile(key_), broken);
    EXPECT_FALSE(folder.holds(key_)) << broken;
  }
  ordered_json newer = ordered_json::parse(whole);
  newer["format"] = 2;
  taa::writeFile(folder.pointFile(key_), newer.dump());
  EXPECT_FALSE(folder.holds(key_));
}

TEST_F(SweepFolder, SaysWhyItCannotBeMade) {
  taa::writeFile(path(), "a file");
  const std::string why = taa::test::errorOf([&] { taa::SweepFolder(path()).path(); });
  EXPECT_NE(why.find(path().string()), std::string::npos) << why;
  fs::remove(path());
}
