// Which pictures of a folder are one sequence, by the digits in their names.
#include "core/capture/import/FolderScan.h"

#include "core/capture/format/Manifest.h"
#include "tests/unit/capture/import/ImportFixtures.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace taa::capture {

namespace {

namespace fs = std::filesystem;
using Sequences = std::map<std::string, std::vector<int>>;

class FolderScanTest : public testing::Test {
 protected:
  FolderScanTest() { fs::remove_all(folder_); }

  /// Numbers by pattern of a folder that holds these files alone.
  Sequences sequencesOf(const std::vector<std::string>& files) const {
    fs::remove_all(folder_);
    for (const std::string& file : files) {
      fs::create_directories((folder_ / file).parent_path());
      writeExr(folder_ / file, {"R", "G", "B"}, {0.0f, 0.0f, 0.0f}, {1, 1});
    }
    Sequences found;
    for (const PictureSequence& sequence : scanFolder(folder_, {}).sequences)
      found[sequence.pattern] = sequence.numbers;
    return found;
  }

  fs::path folder_ = test::temporaryFolder() / "scanned";
};

} // namespace

TEST_F(FolderScanTest, TheNumberStandsAnywhereInTheName) {
  EXPECT_EQ(sequencesOf({"a.0007.exr", "a.0008.exr"}), (Sequences{{"a.{frame:4}.exr", {7, 8}}}));
  EXPECT_EQ(sequencesOf({"0007_color.exr", "0008_color.exr"}), (Sequences{{"{frame:4}_color.exr", {7, 8}}}));
  EXPECT_EQ(sequencesOf({"f9_color_1920x1080.exr", "f10_color_1920x1080.exr"}),
            (Sequences{{"f{frame}_color_1920x1080.exr", {9, 10}}}));
  EXPECT_EQ(sequencesOf({"v2_1_mv0.exr", "v2_2_mv0.exr", "v2_3_mv0.exr"}),
            (Sequences{{"v2_{frame}_mv0.exr", {1, 2, 3}}}));
}

// Eyes, layers and versions are fewer than frames.
TEST_F(FolderScanTest, OfSeveralThatChangeTheOneThatChangesMostCounts) {
  EXPECT_EQ(sequencesOf({"f01_eye0.exr", "f01_eye1.exr", "f02_eye0.exr", "f02_eye1.exr", "f03_eye0.exr",
                         "f03_eye1.exr"}),
            (Sequences{{"f{frame:2}_eye0.exr", {1, 2, 3}}, {"f{frame:2}_eye1.exr", {1, 2, 3}}}));
  EXPECT_EQ(sequencesOf({"eye0_f1.exr", "eye0_f2.exr", "eye1_f1.exr", "eye1_f2.exr"}),
            (Sequences{{"eye0_f{frame}.exr", {1, 2}}, {"eye1_f{frame}.exr", {1, 2}}}))
      << "of as many the last";
}

TEST_F(FolderScanTest, AFoldersNumberCountsWhereTheFileHasNone) {
  EXPECT_EQ(sequencesOf({"shot/3/color.exr", "shot/4/color.exr"}),
            (Sequences{{"shot/{frame}/color.exr", {3, 4}}}));
  EXPECT_EQ(sequencesOf({"take1/a.5.exr", "take2/a.5.exr", "take2/a.6.exr"}),
            (Sequences{{"take1/a.{frame}.exr", {5}}, {"take2/a.{frame}.exr", {5, 6}}}));
  EXPECT_EQ(sequencesOf({"color.exr"}), (Sequences{{"color.exr", {0}}}));
}

TEST_F(FolderScanTest, OfALongRowOfDigitsTheLastNineCount) {
  EXPECT_EQ(sequencesOf({"20261123000000001.exr", "20261123000000002.exr"}),
            (Sequences{{"20261123{frame:9}.exr", {1, 2}}}));
}

} // namespace taa::capture
