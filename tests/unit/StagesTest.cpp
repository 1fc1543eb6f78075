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
  std::size_t place = shader.find("void main()");
  ASSERT_NE(place, std::string::npos);
  for (const taa::StageInfo& stage :
       taa::kResolveStages.subspan(static_cast<std::size_t>(taa::Stage::Inputs))) {
    // The call of reproject(), measureNeighborhood(), blend_weight as blendWeight().
    std::string pattern = std::regex_replace(std::string(stage.id), std::regex("_"), "");
    std::smatch call;
    const std::string rest = shader.substr(place);
    ASSERT_TRUE(std::regex_search(rest, call, std::regex(pattern + "\\(", std::regex::icase))) << stage.id;
    place += static_cast<std::size_t>(call.position()) + 1;
  }
}

TEST(Stages, StandAtTheirNumbers) {
  for (std::size_t index = 0; index < taa::kStages.size(); ++index)
    EXPECT_EQ(static_cast<std::size_t>(taa::kStages[index].stage), index) << taa::kStages[index].id;
}

} // namespace
