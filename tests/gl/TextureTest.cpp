// Textures and passes: what goes in comes out, row 0 is the top.
#include "core/gl/Texture.h"

#include "core/gl/RenderPass.h"
#include "tests/support/CompareImages.h"
#include "tests/support/GlTest.h"
#include "tests/support/ShaderFolder.h"

#include <cstddef>
#include <utility>

using taa::Image;
using taa::gl::Format;
using taa::gl::Texture;
using taa::test::difference;

namespace {

// Every value is exact in every float format.
Image numbered(int width, int height, int channels) {
  Image image(width, height, channels);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<float>(i) - 8.0f;
  return image;
}

Image single(float value) {
  Image image(1, 1, 1);
  image.pixels[0] = value;
  return image;
}

// Draws gl_FragCoord.xy into `target`.
void drawCoordinates(const Texture& target, const taa::gl::RenderState& state) {
  const taa::test::ShaderFolder folder;
  folder.write("test.frag", "out vec2 o_position;\nvoid main() { o_position = gl_FragCoord.xy; }\n");
  const taa::gl::Program program(taa::gl::ShaderSource("include/fullscreen.vert"),
                                 taa::gl::ShaderSource("test.frag"), "coordinates");
  const taa::gl::Framebuffer framebuffer({{&target}}, nullptr, "coordinates");
  taa::gl::RenderPass pass(framebuffer, state, "coordinates");
  pass.program(program);
  pass.drawFullscreen();
}

} // namespace

using TextureTest = taa::test::GlTest;

TEST_F(TextureTest, GivesBackWhatWasUploaded) {
  for (const Format format :
       {Format::R16F, Format::RG16F, Format::RGBA16F, Format::R32F, Format::RG32F, Format::RGBA32F}) {
    const Image image = numbered(7, 3, taa::gl::channels(format));
    Texture texture({7, 3}, format, "test");
    texture.upload(image);
    EXPECT_EQ(difference(texture.download(), image), "");
    EXPECT_EQ(difference(texture.download({2, 1, 4, 2}), taa::test::crop(image, 2, 1, 4, 2)), "");
  }
}

TEST_F(TextureTest, GivesBackIntegersAndDepthExactly) {
  Texture ids({1, 1}, Format::R32UI, "ids");
  ids.upload(single(16777216.0f));
  EXPECT_EQ(ids.download().pixels[0], 16777216.0f);
  Texture depth({1, 1}, Format::Depth32F, "depth");
  depth.upload(single(0.1f));
  EXPECT_EQ(depth.download().pixels[0], 0.1f);
}

TEST_F(TextureTest, KeepsTheLayersOfAnArrayApart) {
  Texture texture({3, 2, 2}, Format::R32F, "layers");
  const Image first = numbered(3, 2, 1);
  Image second = first;
  for (float& value : second.pixels) value += 100.0f;
  texture.upload(first, 0);
  texture.upload(second, 1);
  EXPECT_EQ(difference(texture.download(0), first), "");
  EXPECT_EQ(difference(texture.download(1), second), "");
  EXPECT_EQ(texture.bytes(), 3u * 2u * 2u * 4u);
}

TEST_F(TextureTest, IsClearedInEveryLayer) {
  Texture texture({2, 2, 3}, Format::RG32F, "cleared");
  texture.clear(0.25f, -3.0f, 0.0f, 0.0f);
  for (int layer = 0; layer < 3; ++layer) {
    const Image image = texture.download(layer);
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(image.pixels[2 * i], 0.25f);
      EXPECT_EQ(image.pixels[2 * i + 1], -3.0f);
    }
  }
}

TEST_F(TextureTest, MovesWithItsContents) {
  Texture texture({1, 1}, Format::R32F, "moved");
  texture.upload(single(2.0f));
  const Texture other = std::move(texture);
  EXPECT_EQ(other.download().pixels[0], 2.0f);
  texture = Texture();
  EXPECT_FALSE(texture);
}

TEST_F(TextureTest, HoldsHalfFloatsOfElevenBits) {
  Texture texture({1, 1}, Format::R16F, "half");
  texture.upload(single(2049.0f)); // lies midway between 2048 and 2050
  const float stored = texture.download().pixels[0];
  EXPECT_TRUE(stored == 2048.0f || stored == 2050.0f) << stored;
  texture.upload(single(65504.0f));
  EXPECT_EQ(texture.download().pixels[0], 65504.0f);
}

// Manual, conventions: GL_UPPER_LEFT makes texture row 0 the top of the picture.
TEST_F(TextureTest, HasTheTopLeftPixelInItsFirstTexel) {
  Texture target({5, 4}, Format::RG32F, "coordinates");
  drawCoordinates(target, {});
  const Image image = target.download();
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x) {
      EXPECT_EQ(image.at(x, y)[0], static_cast<float>(x) + 0.5f);
      EXPECT_EQ(image.at(x, y)[1], static_cast<float>(y) + 0.5f);
    }
}

TEST_F(TextureTest, IsDrawnOnlyWithinTheScissor) {
  Texture target({5, 4}, Format::RG32F, "coordinates");
  target.clear(-1.0f, -1.0f, 0.0f, 0.0f);
  taa::gl::RenderState state;
  state.scissor = taa::gl::Rect{1, 0, 3, 2};
  drawCoordinates(target, state);
  const Image image = target.download();
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x) {
      const bool isInside = x >= 1 && x < 4 && y < 2;
      EXPECT_EQ(image.at(x, y)[0], isInside ? static_cast<float>(x) + 0.5f : -1.0f) << x << ", " << y;
    }
}
