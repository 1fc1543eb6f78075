// taa-batch doctor: its exit codes, what it prints, and the page it writes.
#include "core/base/Files.h"
#include "tests/support/Batch.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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

TEST(BatchDoctorMistakes, AreTheCallersOrTheWorlds) {
  expectUsageError({"doctor", "builtin:nothing"}, {"builtin:nothing"});
  expectUsageError({"doctor", "builtin:fan", "--frames", "1"}, {"--frames"});
  expectUsageError({"doctor", "builtin:fan", "--lane", "balanced", "--lane", "minimal"}, {"--lane", "one"});
  expectFailure({"doctor", "absent.gltf"}, {"absent.gltf"});
}
