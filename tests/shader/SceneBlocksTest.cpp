// The uniform blocks of the scene shaders lie in memory as C++ lays them out.
#include "core/gl/Program.h"
#include "shaders/shared/DrawBlock.h"
#include "shaders/shared/FrameBlock.h"
#include "shaders/shared/LightBlock.h"
#include "shaders/shared/MaterialBlock.h"
#include "tests/support/GlTest.h"

#include <cstddef>
#include <map>

namespace taa {
namespace {

using Offsets = std::map<std::string, int>;

class SceneBlocksTest : public test::GlTest {
 protected:
  static Offsets offsets(const std::string& block) {
    // Everything on, so that nothing is optimized away.
    const gl::Program program(gl::ShaderSource("scene/mesh.vert"),
                              gl::ShaderSource("scene/mesh.frag", "const int kTextures = 31;\n"
                                                                  "const int kDirectionalLights = 1;\n"
                                                                  "const int kNearLights = 1;\n"
                                                                  "const bool kMasked = true;\n"
                                                                  "const bool kLit = true;\n"),
                              "SceneBlocksTest");
    Offsets result;
    for (const auto& [name, offset] : program.blockOffsets(block)) result[name] = offset;
    return result;
  }
};

#define EXPECT_OFFSET(offsets, block, field)                                                                 \
  EXPECT_EQ((offsets).at(#field), static_cast<int>(offsetof(shared::block, field)))
#define EXPECT_ARRAY_OFFSET(offsets, block, field)                                                           \
  EXPECT_EQ((offsets).at(#field "[0]"), static_cast<int>(offsetof(shared::block, field)))

TEST_F(SceneBlocksTest, AgreeOnTheDraw) {
  const Offsets draw = offsets("DrawBlock");
  EXPECT_OFFSET(draw, DrawBlock, worldFromModel);
  EXPECT_OFFSET(draw, DrawBlock, normalFromModel);
  EXPECT_OFFSET(draw, DrawBlock, clipFromModel);
  EXPECT_OFFSET(draw, DrawBlock, previousClipFromModel);
  EXPECT_OFFSET(draw, DrawBlock, previousDepthRow);
  EXPECT_OFFSET(draw, DrawBlock, drawTerms);
}

TEST_F(SceneBlocksTest, AgreeOnTheLights) {
  const Offsets lights = offsets("LightBlock");
  EXPECT_ARRAY_OFFSET(lights, LightBlock, lightPosition);
  EXPECT_ARRAY_OFFSET(lights, LightBlock, lightDirection);
  EXPECT_ARRAY_OFFSET(lights, LightBlock, lightColor);
  EXPECT_ARRAY_OFFSET(lights, LightBlock, lightTerms);
}

TEST_F(SceneBlocksTest, AgreeOnTheMaterial) {
  const Offsets material = offsets("MaterialBlock");
  EXPECT_OFFSET(material, MaterialBlock, baseColor);
  EXPECT_OFFSET(material, MaterialBlock, emissive);
  EXPECT_OFFSET(material, MaterialBlock, surface);
  EXPECT_ARRAY_OFFSET(material, MaterialBlock, uvRows);
}

TEST_F(SceneBlocksTest, AgreeOnTheFrame) {
  const Offsets frame = offsets("FrameBlock");
  EXPECT_OFFSET(frame, FrameBlock, clipFromWorld);
  EXPECT_OFFSET(frame, FrameBlock, jitteredClipFromWorld);
  EXPECT_OFFSET(frame, FrameBlock, worldFromJitteredClip);
  EXPECT_OFFSET(frame, FrameBlock, viewFromWorld);
  EXPECT_OFFSET(frame, FrameBlock, previousClipFromWorld);
  EXPECT_OFFSET(frame, FrameBlock, previousViewFromWorld);
  EXPECT_OFFSET(frame, FrameBlock, sizePx);
  EXPECT_OFFSET(frame, FrameBlock, jitterPx);
  EXPECT_OFFSET(frame, FrameBlock, cameraPosition);
  EXPECT_OFFSET(frame, FrameBlock, depthTerms);
  EXPECT_OFFSET(frame, FrameBlock, skyZenith);
  EXPECT_OFFSET(frame, FrameBlock, skyHorizon);
  EXPECT_OFFSET(frame, FrameBlock, skyGround);
  EXPECT_OFFSET(frame, FrameBlock, sunDirection);
  EXPECT_OFFSET(frame, FrameBlock, sunColor);
  EXPECT_OFFSET(frame, FrameBlock, storage);
}

} // namespace
} // namespace taa
