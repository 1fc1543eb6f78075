// Tables of sweeps, of numbers that were written by hand.
#include "core/sweep/SweepTable.h"

#include "core/base/Files.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

class SweepTable : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(path());
    folder_.emplace(path());
  }
  static fs::path path() { return taa::test::temporaryFolder() / "table"; }
  /// Two shots of three points.
  static taa::SweepSpec spec() {
    return taa::sweepSpecFromText(R"({"format": 1, "frames": [0, 1], "sources": ["builtin:fan", "b, c.glb"],
      "metrics": ["psnr", "flicker"], "pareto": ["psnr", "flicker"],
      "parameters": {"weight.alpha": [0.25, 0.5, 1]}})",
                                  "it", "");
  }
  void keep(std::size_t point, const ordered_json& psnr, const ordered_json& flicker) const {
    const taa::PointKey key(taa::SweepGround(spec_).inputs(spec_, taa::sweepPoint(spec_, point)));
    folder_->keep(key, {{"mean", {{"psnr", psnr}, {"flicker", flicker}}}});
  }
  std::string csv() const { return taa::sweepCsv(spec_, taa::sweepRows(spec_, *folder_)); }

  const taa::SweepSpec spec_ = spec();
  std::optional<taa::SweepFolder> folder_;
};

} // namespace

TEST_F(SweepTable, HasARowForEachPointMeasuredOrNot) {
  keep(0, 30.5, 0.25);
  keep(1, "inf", nullptr);
  EXPECT_EQ(csv(), "point,source,camera,settings,weight.alpha,psnr,flicker,pareto\n"
                   "0,builtin:fan,,balanced,0.25,30.5,0.25,1\n"
                   "1,builtin:fan,,balanced,0.5,inf,,0\n"
                   "2,builtin:fan,,balanced,1,,,\n"
                   "3,\"b, c.glb\",,balanced,0.25,,,\n"
                   "4,\"b, c.glb\",,balanced,0.5,,,\n"
                   "5,\"b, c.glb\",,balanced,1,,,\n");
}

// PSNR is better the higher it is.
TEST_F(SweepTable, MarksTheFrontOfEachShot) {
  keep(0, 30, 0.25);
  keep(1, 20, 0.5); // beaten by the first
  keep(2, 40, 0.5);
  keep(3, 10, 0.75); // of another shot
  std::vector<bool> isOnFront;
  for (const taa::SweepRow& row : taa::sweepRows(spec_, *folder_)) isOnFront.push_back(row.isOnFront);
  EXPECT_EQ(isOnFront, (std::vector<bool>{true, false, true, true, false, false}));
}

TEST_F(SweepTable, IsAlsoWrittenAsJson) {
  keep(2, 40, 0.5);
  const std::vector<fs::path> files = taa::writeSweepTables(spec_, *folder_);
  EXPECT_EQ(files, (std::vector<fs::path>{path() / "sweep.csv", path() / "sweep.json"}));
  EXPECT_EQ(taa::readFile(files[0]), csv());
  const ordered_json json = ordered_json::parse(taa::readFile(files[1]));
  EXPECT_EQ(json["measured"], 1);
  EXPECT_EQ(json["pareto"], (ordered_json{"psnr", "flicker"}));
  EXPECT_EQ(json["metrics"][0]["unit"], "dB");
  ASSERT_EQ(json["points"].size(), 6u);
  const ordered_json& point = json["points"][2];
  EXPECT_EQ(point["parameters"]["weight.alpha"], "1");
  EXPECT_EQ(point["mean"]["psnr"], 40);
  EXPECT_EQ(point["pareto"], true);
  EXPECT_TRUE(fs::exists(path() / "points" / point["file"].get<std::string>()));
  EXPECT_TRUE(json["points"][0]["mean"].is_null());
}
