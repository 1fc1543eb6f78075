// Blocks of the resolve that C++ writes and GLSL reads: the same members at the same offsets on either side.
#include "core/gl/Program.h"
#include "core/settings/Parameters.h"
#include "shaders/shared/FaultBlock.h"
#include "shaders/shared/ResolveBlock.h"
#include "tests/support/GlTest.h"
#include "tests/support/ShaderFolder.h"

#include <cstddef>
#include <cstring>
#include <map>
#include <string>
#include <vector>

using Offsets = std::map<std::string, int>;

namespace {

// A program that includes `header` and reads `value`, so that the block is there.
Offsets offsetsInGlsl(const std::string& header, const std::string& block, const std::string& value,
                      const std::string& prelude = {}) {
  const taa::test::ShaderFolder folder;
  folder.write("test.frag", (header.empty() ? "" : "#include \"" + header + "\"\n") +
                                "out vec4 o_color;\nvoid main() { o_color = vec4(" + value + "); }\n");
  const taa::gl::Program program(taa::gl::ShaderSource("include/fullscreen.vert"),
                                 taa::gl::ShaderSource("test.frag", prelude), "blocks");
  const auto offsets = program.blockOffsets(block);
  return {offsets.begin(), offsets.end()};
}

} // namespace

#define MEMBER(Block, member)                                                                                \
  { #member, static_cast < int>(offsetof(Block, member)) }

using SharedBlocksTest = taa::test::GlTest;

TEST_F(SharedBlocksTest, ResolveBlockIsTheSameOnEitherSide) {
  using taa::shared::ResolveBlock;
  const Offsets expected{
      MEMBER(ResolveBlock, sizePx),          MEMBER(ResolveBlock, jitterPx),
      MEMBER(ResolveBlock, depthTerms),      MEMBER(ResolveBlock, currentWeights0),
      MEMBER(ResolveBlock, currentWeights1), MEMBER(ResolveBlock, currentWeights2),
      MEMBER(ResolveBlock, weightTerms),     MEMBER(ResolveBlock, state),
      MEMBER(ResolveBlock, spread),          MEMBER(ResolveBlock, renderSizePx),
      MEMBER(ResolveBlock, renderRatio),
  };
  EXPECT_EQ(offsetsInGlsl("shared/ResolveBlock.h", "ResolveBlock", "resolveBlock.depthTerms"), expected);
}

TEST_F(SharedBlocksTest, FaultBlockIsTheSameOnEitherSide) {
  using taa::shared::FaultBlock;
  const Offsets expected{
      MEMBER(FaultBlock, wrongPreviousClipFromWorld),
      MEMBER(FaultBlock, jitter),
      MEMBER(FaultBlock, motionTerms),
      MEMBER(FaultBlock, motionForm),
      MEMBER(FaultBlock, texels),
      MEMBER(FaultBlock, place),
      MEMBER(FaultBlock, rectangle),
      MEMBER(FaultBlock, colorTerms),
  };
  EXPECT_EQ(offsetsInGlsl("shared/FaultBlock.h", "FaultBlock", "fault.jitter"), expected);
}

TEST_F(SharedBlocksTest, SettingsBlockHoldsEachNumberWhereGlslReadsIt) {
  taa::Settings settings;
  settings.neighborhood.gamma = 1.5f;
  settings.validate.depthTolerance = 0.25f;
  settings.weight.alpha = 0.125f;
  settings.weight.minimum = 0.0625f;
  const Offsets offsets =
      offsetsInGlsl("", "SettingsBlock", "settings.weightAlpha", taa::glslPrelude(settings));
  const std::vector<std::byte> bytes = taa::settingsBlock(settings);
  const auto read = [&](const std::string& member) {
    float value = 0.0f;
    std::memcpy(&value, bytes.data() + offsets.at(member), sizeof(value));
    return value;
  };
  EXPECT_EQ(read("neighborhoodGamma"), 1.5f);
  EXPECT_EQ(read("validateDepthTolerance"), 0.25f);
  EXPECT_EQ(read("weightAlpha"), 0.125f);
  EXPECT_EQ(read("weightMinimum"), 0.0625f);
}
