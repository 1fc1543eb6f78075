// taa-batch verify on this driver, and probe --where: the real program, its words and its exit codes.
#include "core/base/Files.h"
#include "tests/support/Batch.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"
#include "tests/support/ShaderFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using nlohmann::json;
using taa::test::batch;
using taa::test::expectUsageError;
using taa::test::ProcessResult;

class VerifyBatchTest : public taa::test::GlTest {};

// All presets: what a user sends of a driver. Alone it goes over whole frames of a scene with every preset.
TEST_F(VerifyBatchTest, FindsNothingOutsideOnThisDriver) {
  const ProcessResult result = batch({"verify", "--json"});
  EXPECT_EQ(result.exitCode, 0) << result.err << result.out;
  const json report = json::parse(result.out);
  EXPECT_EQ(report.at("outside"), 0);
  EXPECT_EQ(report.at("open"), 0);
  EXPECT_GT(report.at("values"), 90'000'000);
  EXPECT_GT(report.at("rows").size(), 70u);
  if (isExact()) {
    EXPECT_EQ(report.at("bitEqual"), report.at("values"));
  }
}

TEST_F(VerifyBatchTest, SaysWhichValuesAShaderGetsWrong) {
  const taa::test::ShaderFolder shaders;
  shaders.replace("taa/blend_weight.glsl", "1.0 / (x.historyLength + 1.0)", "1.0 / (x.historyLength + 1.01)");
  const ProcessResult result =
      batch({"verify", "builtin:fan", "--size", "64x36", "--preset", "balanced", "--frames", "2"});
  EXPECT_EQ(result.exitCode, 3) << result.err;
  EXPECT_NE(result.out.find("values lie outside of what GLSL allows, in 1 of"), result.out.npos)
      << result.out;
  EXPECT_NE(result.out.find("alphaBase, channel 0, pixel "), result.out.npos) << result.out;
}

TEST_F(VerifyBatchTest, MapsANumberOverThePicture) {
  const fs::path picture = taa::test::temporaryFolder() / "gamma.png";
  fs::remove(picture);
  const std::vector<std::string> call{"probe",   "builtin:fan", "--size",  "64x36",
                                      "--frame", "6",           "--where", "neighborhood.gamma"};
  const ProcessResult told = batch(call);
  EXPECT_EQ(told.exitCode, 0) << told.err;
  EXPECT_TRUE(told.out.starts_with("γ 1 → 1.1 moves luma in ")) << told.out;
  const ProcessResult result = batch(taa::test::joined(call, {"--picture", picture.string(), "--json"}));
  EXPECT_EQ(result.exitCode, 0) << result.err;
  const json where = json::parse(result.out).at("where");
  EXPECT_GT(where.at("share"), 0.0);
  EXPECT_LT(where.at("share"), 1.0);
  EXPECT_GE(where.at("largestLuma"), where.at("meanLuma"));
  EXPECT_TRUE(taa::readFile(picture.string(), 1 << 20).starts_with("\x89PNG"));
  expectUsageError({"probe", "builtin:fan", "--frame", "6", "--where", "neighborhood.gama"},
                   {"--where", "neighborhood.gamma"});
  expectUsageError(
      {"probe", "builtin:fan", "--frame", "6", "--where", "neighborhood.gamma", "--pixel", "1,1"},
      {"one of --pixel"});
}
