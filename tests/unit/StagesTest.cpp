// The order of the stages is that of the shader.
#include "core/settings/Stage.h"

#include "core/base/Files.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <regex>
#include <string>
#include <vector>

namespace {

TEST(Stages, StandInTheOrderInWhichTheShaderRunsThem) {
  const std::string shader = taa::readFile(std::string(TAA_SOURCE_DIR) + "/shaders/taa/resolve.frag");
  const std::regex pattern(R"(stage_ends\(kStage_(\w+),)");
  std::vector<std::string> ran;
  for (std::sregex_iterator end(shader.begin(), shader.end(), pattern), last; end != last; ++end)
    ran.push_back((*end)[1]);
  ran.emplace_back("blend"); // ends with the shader itself
  std::vector<std::string> table;
  for (const taa::StageInfo& stage : taa::kResolveStages) table.emplace_back(stage.id);
  EXPECT_EQ(ran, table);
}

TEST(Stages, StandAtTheirNumbers) {
  for (std::size_t index = 0; index < taa::kStages.size(); ++index)
    EXPECT_EQ(static_cast<std::size_t>(taa::kStages[index].stage), index) << taa::kStages[index].id;
}

} // namespace
