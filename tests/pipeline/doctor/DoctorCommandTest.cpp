// taa-batch doctor: its exit codes, what it prints, and the page it writes.
#include "core/base/Files.h"
#include "tests/support/Batch.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

using nlohmann::json;
using taa::test::batch;
using taa::test::expectFailure;
using taa::test::expectUsageError;
using taa::test::joined;
using taa::test::ProcessResult;

namespace {

const std::vector<std::string>& doctorCommand() {
  static const std::vector<std::string> kCommand = {
      "doctor", "builtin:gallery", "--camera", "orbit", "--size", "192x108", "--frames", "6", "--json"};
  return kCommand;
}

ProcessResult confusions(const std::vector<std::string>& options) {
  return taa::test::runProcess(joined({taa::test::binary("taa_manual").string(), "confusions"}, options));
}

} // namespace

class BatchDoctor : public taa::test::GlTest {};

TEST_F(BatchDoctor, EndsWithNothingWhereNothingIsWrong) {
  const ProcessResult result = batch(doctorCommand());
  ASSERT_EQ(result.exitCode, 0) << result.out << result.err;
  const json said = json::parse(result.out);
  EXPECT_TRUE(said["healthy"]);
  EXPECT_EQ(said["frames"], 6);
  EXPECT_TRUE(said["findings"].empty());
}

TEST_F(BatchDoctor, EndsWithThreeWhereSomethingIs) {
  const std::filesystem::path page = taa::test::temporaryFolder() / "doctor.html";
  const ProcessResult result =
      batch(joined(doctorCommand(), {"--set", "fault.motionShift=1", "--html", page.string()}));
  ASSERT_EQ(result.exitCode, 3) << result.out << result.err;
  const json said = json::parse(result.out);
  ASSERT_FALSE(said["findings"].empty());
  EXPECT_EQ(said["findings"][0]["id"], "motionShifted");
  EXPECT_NE(taa::readFile(page).find(said["findings"][0]["name"].get<std::string>().substr(0, 6)),
            std::string::npos);
  expectFailure(joined(doctorCommand(), {"--html", page.string()}), {"doctor.html", "--force"});
}

TEST_F(BatchDoctor, LooksAtTheFramesMended) {
  const std::filesystem::path folder = taa::test::temporaryFolder() / "mended";
  const std::vector<std::string> command =
      joined(doctorCommand(), {"--set", "fault.motionShift=1", "--mended", folder.string()});
  const ProcessResult result = batch(command);
  ASSERT_EQ(result.exitCode, 3) << result.out << result.err;
  const json corrected = json::parse(result.out)["mended"];
  EXPECT_EQ(corrected["findings"], json::array({"motionShifted"}));
  EXPECT_EQ(corrected["settings"], json::array({"fault.motionShift=0"}));
  EXPECT_TRUE(corrected["left"].empty());
  EXPECT_GT(corrected["psnr"]["mended"], corrected["psnr"]["given"]);
  for (const char* file : {"mended.json", "finding1-frame5-given.png", "finding1-frame5-mended.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
  expectFailure(command, {"mended.json", "--force"});
}

TEST_F(BatchDoctor, IsTriedOnCasesThatTheFileDoesNotHold) {
  const std::filesystem::path file = taa::test::temporaryFolder() / "judged.csv";
  const std::vector<std::string> options = {
      file.string(), "--scenes",       "gallery", "--cameras", "orbit",    "--faults", "motionShifted",
      "--kinds",     "healthy,single", "--size",  "192x108",   "--frames", "6"};
  const ProcessResult result = confusions(options);
  ASSERT_EQ(result.exitCode, 0) << result.out << result.err;
  EXPECT_EQ(taa::readFile(file),
            "source,camera,size,frames,preset,faults,strength,shows,named,same,open\n"
            "builtin:gallery,orbit,192x108,6,,,full,no,,,no\n"
            "builtin:gallery,orbit,192x108,6,,motionShifted,full,yes,motionShifted,,no\n");
  EXPECT_EQ(confusions(options).out, "2 cases, 2 there already\n");
}

TEST(BatchDoctorMistakes, AreTheCallersOrTheWorlds) {
  expectUsageError({"doctor", "builtin:nothing"}, {"\"nothing\"", "builtin:fan"});
  expectUsageError({"doctor", "builtin:fan", "--frames", "1"}, {"--frames"});
  expectUsageError({"doctor", "builtin:fan", "--lane", "balanced", "--lane", "minimal"}, {"--lane", "one"});
  expectFailure({"doctor", "absent.gltf"}, {"absent.gltf"});
  for (const auto& [option, value, word] :
       {std::array{"--scenes", "fam", "fam"}, std::array{"--faults", "jitterLat", "jitterLate"}}) {
    const ProcessResult result = confusions({"cases.csv", option, value});
    EXPECT_EQ(result.exitCode, 2);
    for (const char* told : {option, word}) EXPECT_NE(result.err.find(told), std::string::npos) << result.err;
  }
}
