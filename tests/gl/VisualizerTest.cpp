// Pictures of hand-made textures, byte for byte.
#include "core/picture/Visualizer.h"

#include "core/base/Error.h"
#include "core/base/Light.h"
#include "core/gl/RenderPass.h"
#include "core/picture/ColorMap.h"
#include "shaders/shared/ViewBlock.h"
#include "tests/support/GlTest.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using taa::ColorMap;
using taa::Image;
using taa::IntermediateId;
using taa::Picture;
using taa::ViewStyle;
using taa::ViewTransform;
using taa::Visual;
using Bytes = std::array<int, 4>;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// What the visualizer puts before its shader, for one of its variants: all of the block is in use.
constexpr std::string_view kPrelude =
    "layout(binding = 0) uniform sampler2DArray u_layer;\n"
    "#define fetch_layer(texel, layer) texelFetch(u_layer, ivec3(texel, layer), 0)\n"
    "#define fetch_minus fetch_layer\n"
    "#define fetch_rejectReason fetch_layer\n"
    "#define fetch_objectId fetch_layer\n"
    "const int kVisual_Color = 0, kVisual_Box = 1, kVisual_Depth = 2, "
    "kVisual_Signed = 4, kVisual_Vector = 5,\n"
    "  kVisual_Position = 6, kVisual_Normal = 7, kVisual_Index = 9;\n"
    "const int kVisual = 0, kChannels = 3, kAlone = -1, kMap = 0;\n"
    "const bool kMarksInvalid = true, kIsAveraged = true, kIsDifference = true,\n"
    "  kMarksClipped = true, kTintsRejected = true, kOutlines = true, "
    "kHasArrows = true,\n"
    "  kIsPartial = true, kIsMinusPartial = true, kHasVectors = true;\n"
    "const int kVisual_Scalar = 3;\n";

int byteOf(float linear) {
  return static_cast<int>(std::lround(255.0f * taa::srgbEncoded(linear)));
}

Bytes bytesOf(const std::array<float, 3>& linear) {
  return {byteOf(linear[0]), byteOf(linear[1]), byteOf(linear[2]), 255};
}

Bytes pixel(const Picture& picture, int x, int y = 0) {
  const std::uint8_t* rgba = picture.rgba.data() + (static_cast<std::size_t>(y) * picture.width + x) * 4;
  return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

taa::gl::Format formatFor(int channels) {
  return channels == 1   ? taa::gl::Format::R32F
         : channels == 2 ? taa::gl::Format::RG32F
                         : taa::gl::Format::RGBA32F;
}

class VisualizerTest : public taa::test::GlTest {
 protected:
  /// One row of texels, shown one to one.
  Picture show(const taa::Intermediate& row, const ViewStyle& style, const std::vector<glm::vec4>& texels) {
    const int width = static_cast<int>(texels.size());
    Image image(width, 1, row.channels == 3 ? 4 : row.channels);
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < image.channels; ++channel)
        image.at(x, 0)[channel] = texels[static_cast<std::size_t>(x)][channel];
    return show(row, style, image, {}, width, 1);
  }
  Picture show(const taa::Intermediate& row, const ViewStyle& style, const Image& image,
               const ViewTransform& transform, int width, int height) {
    taa::gl::Texture texture({.width = image.width, .height = image.height, .layers = 2},
                             formatFor(image.channels), "texels");
    texture.upload(Image(image.width, image.height, image.channels), 0);
    texture.upload(image, 1);
    return visualizer().draw(texture, 1, 0, row, style, transform, width, height);
  }
  static taa::Visualizer& visualizer() {
    static taa::Visualizer instance;
    return instance;
  }
  static const taa::Intermediate& row(IntermediateId id) { return taa::intermediate(id); }
  static taa::Intermediate rowShownAs(Visual visual, int channels) {
    taa::Intermediate row = taa::intermediate(IntermediateId::alpha);
    row.visual = visual;
    row.channels = channels;
    return row;
  }
};

} // namespace

// Rows that are read in place lie in all of these.
TEST_F(VisualizerTest, ShowsTexturesThatAreNoArraysAsTheirLayers) {
  using taa::gl::Format;
  struct Case {
    IntermediateId id;
    Format format;
    int first;
  };
  const Case cases[] = {
      {IntermediateId::color, Format::RGBA16F, 0},  {IntermediateId::motion, Format::RG16F, 0},
      {IntermediateId::depth, Format::Depth32F, 0}, {IntermediateId::objectId, Format::R32UI, 0},
      {IntermediateId::responsive, Format::RG8, 1}, {IntermediateId::objectClass, Format::RGBA16F, 3}};
  constexpr int kSide = 4;
  for (const auto& [id, format, first] : cases) {
    const int channels = taa::gl::channels(format);
    Image image(kSide, kSide, channels);
    for (int texel = 0; texel < kSide * kSide; ++texel) // 0 and 1, which all formats hold
      for (int channel = 0; channel < channels; ++channel)
        image.at(texel % kSide, texel / kSide)[channel] = static_cast<float>((texel + channel) % 2);
    taa::gl::Texture plain({kSide, kSide}, format, "plain");
    taa::gl::Texture layers({kSide, kSide, 2}, formatFor(channels), "layers");
    plain.upload(image);
    layers.upload(image, 1);
    const ViewStyle style = taa::defaultStyle(row(id));
    const Picture expected = visualizer().draw(layers, 1, first, row(id), style, {}, kSide, kSide);
    const Picture actual = visualizer().draw(plain, 0, first, row(id), style, {}, kSide, kSide);
    EXPECT_EQ(actual.rgba, expected.rgba) << row(id).name;
    EXPECT_NE(pixel(expected, 0), pixel(expected, 1)) << row(id).name << ": there is something to see";
  }
}

TEST_F(VisualizerTest, SubtractsAndOutlinesByTexturesThatAreNoArrays) {
  using taa::gl::Format;
  Image colors(4, 2, 4), objects(4, 2, 1);
  for (std::size_t index = 0; index < colors.pixels.size(); ++index)
    colors.pixels[index] = 0.125f * static_cast<float>(index % 7);
  for (std::size_t index = 0; index < objects.pixels.size(); ++index)
    objects.pixels[index] = static_cast<float>(index / 2);
  taa::gl::Texture plain({4, 2}, Format::RGBA16F, "plain"), layers({4, 2, 1}, Format::RGBA32F, "layers");
  taa::gl::Texture plainIds({4, 2}, Format::R32UI, "ids"), ids({4, 2, 1}, Format::R32F, "layers of ids");
  taa::gl::Texture zero({4, 2, 1}, Format::RGBA32F, "zero");
  plain.upload(colors);
  layers.upload(colors);
  plainIds.upload(objects);
  ids.upload(objects);
  zero.clear(0.0f, 0.0f, 0.0f, 0.0f);
  const taa::Intermediate& shown = row(IntermediateId::resolved);
  ViewStyle style = taa::differenceStyle(shown);
  style.outlineObjects = true;
  const auto draw = [&](const taa::gl::Texture& minus, const taa::gl::Texture& objectIds) {
    const taa::DrawnLayers drawn{.row = {&zero}, .minus = {&minus}, .objectId = {&objectIds}};
    return visualizer().draw(drawn, shown, style, {}, 4, 2).rgba;
  };
  EXPECT_EQ(draw(plain, plainIds), draw(layers, ids));
  EXPECT_NE(draw(plain, plainIds), draw(zero, ids));
}

TEST_F(VisualizerTest, DrawsCheckersWhereThereIsNoValue) {
  const auto textureOf = [](const std::vector<glm::vec4>& texels) {
    Image image(static_cast<int>(texels.size()), 1, 4);
    for (int x = 0; x < image.width; ++x)
      for (int channel = 0; channel < 4; ++channel)
        image.at(x, 0)[channel] = texels[static_cast<std::size_t>(x)][channel];
    taa::gl::Texture texture({.width = image.width, .height = 1, .layers = 1}, taa::gl::Format::RGBA32F,
                             "texels");
    texture.upload(image, 0);
    return texture;
  };
  const float no = 65504.0f; // the mark of what has no previous position
  const taa::gl::Texture row = textureOf({{1, 1, 0, 0}, {1, 1, 0, 0}, {no, no, 0, 0}, {1, 1, 0, 0}}),
                         minus = textureOf({{1, 1, 0, 0}, {1, 1, 0, 4}, {no, no, 0, 0}, {no, no, 0, 0}});
  const taa::Intermediate& motion = taa::intermediate(IntermediateId::motion);
  const ViewStyle style = taa::differenceStyle(motion);
  const taa::DrawnLayers drawn{.row = {&row}, .minus = {&minus, 0, 0, true}};
  const Picture picture = visualizer().draw(drawn, motion, style, {}, 4, 1);
  EXPECT_EQ(pixel(picture, 0), bytesOf(taa::mapColor(style.map, 0.5f))) << "there is no difference";
  const float dark = taa::kNothingLight[0];
  for (int x = 1; x < 4; ++x) EXPECT_EQ(pixel(picture, x), bytesOf({dark, dark, dark})) << x;
  const taa::DrawnLayers alone{.row = {&minus, 0, 0, true}};
  const Picture side = visualizer().draw(alone, motion, taa::defaultStyle(motion), {}, 4, 1);
  EXPECT_EQ(pixel(side, 1), bytesOf({dark, dark, dark}));
  EXPECT_NE(pixel(side, 0), pixel(side, 1));
}

TEST_F(VisualizerTest, SharesItsBlockWithTheShader) {
  const taa::gl::Program program(taa::gl::ShaderSource("include/fullscreen.vert"),
                                 taa::gl::ShaderSource("inspect/visualize.frag", kPrelude), "test");
  using taa::shared::ViewBlock;
  const std::vector<std::pair<std::string, std::size_t>> expected = {
      {"sizePx", offsetof(ViewBlock, sizePx)}, {"originPx", offsetof(ViewBlock, originPx)},
      {"range", offsetof(ViewBlock, range)},   {"channels", offsetof(ViewBlock, channels)},
      {"layer", offsetof(ViewBlock, layer)},   {"overlays", offsetof(ViewBlock, overlays)},
      {"above", offsetof(ViewBlock, above)},   {"below", offsetof(ViewBlock, below)},
      {"arrows", offsetof(ViewBlock, arrows)}, {"nothing", offsetof(ViewBlock, nothing)},
  };
  const auto offsets = program.blockOffsets("ViewBlock");
  EXPECT_EQ(offsets.size(), expected.size());
  for (const auto& [name, offset] : offsets)
    for (const auto& [field, place] : expected)
      if (name == field) {
        EXPECT_EQ(static_cast<std::size_t>(offset), place) << name;
      }
}

TEST_F(VisualizerTest, EncodesLightForTheScreen) {
  const Picture picture = show(row(IntermediateId::color), taa::defaultStyle(row(IntermediateId::color)),
                               {{0.0f, 0.25f, 1.0f, 1.0f}, {2.0f, 0.5f, 0.001f, 1.0f}});
  EXPECT_EQ(pixel(picture, 0), (Bytes{0, 137, 255, 255}));
  EXPECT_EQ(pixel(picture, 1), (Bytes{255, 188, 3, 255}));
}

TEST_F(VisualizerTest, ExposesBeforeTheRange) {
  ViewStyle style = taa::defaultStyle(row(IntermediateId::color));
  style.exposure = 2.0f;
  style.low = 1.0f;
  style.high = 3.0f;
  const Picture picture = show(row(IntermediateId::color), style, {{0.25f, 0.5f, 0.75f, 1.0f}});
  EXPECT_EQ(pixel(picture, 0), (Bytes{0, byteOf(0.5f), 255, 255}));
}

TEST_F(VisualizerTest, LeavesOutChannelsThatAreOff) {
  ViewStyle style;
  style.green = false;
  const Picture picture = show(row(IntermediateId::color), style, {{0.25f, 0.5f, 1.0f, 1.0f}});
  EXPECT_EQ(pixel(picture, 0), (Bytes{137, 0, 255, 255}));
}

TEST_F(VisualizerTest, ShowsASingleChannelAsGrayOrThroughAMap) {
  ViewStyle style;
  style.red = style.blue = false;
  EXPECT_EQ(pixel(show(row(IntermediateId::color), style, {{0.0f, 0.25f, 1.0f, 1.0f}}), 0),
            (Bytes{137, 137, 137, 255}));
  style.map = ColorMap::Inferno;
  EXPECT_EQ(pixel(show(row(IntermediateId::color), style, {{0.0f, 0.25f, 1.0f, 1.0f}}), 0),
            bytesOf(taa::mapColor(ColorMap::Inferno, 0.25f)));
}

TEST_F(VisualizerTest, ShowsTheBoxWithItsNegativeChroma) {
  ViewStyle style;
  style.low = -0.5f;
  style.high = 0.5f;
  EXPECT_EQ(pixel(show(row(IntermediateId::boxMin), style, {{0.5f, 0.0f, -0.5f, 0.0f}}), 0),
            (Bytes{255, 188, 0, 255}));
}

TEST_F(VisualizerTest, DrawsEveryMapAsMapColorSays) {
  for (ColorMap map : {ColorMap::Gray, ColorMap::Viridis, ColorMap::Inferno, ColorMap::Diverging,
                       ColorMap::Cyclic, ColorMap::Categorical}) {
    ViewStyle style;
    style.map = map;
    std::vector<glm::vec4> texels;
    texels.reserve(101);
    for (int step = 0; step <= 100; ++step) texels.emplace_back(static_cast<float>(step) / 100.0f);
    const Picture picture = show(row(IntermediateId::alpha), style, texels);
    for (int step = 0; step <= 100; ++step) {
      const Bytes expected = bytesOf(taa::mapColor(map, static_cast<float>(step) / 100.0f));
      // 1: the driver's pow() where the encoded value lies half way between two bytes.
      for (std::size_t channel = 0; channel < 4; ++channel)
        EXPECT_NEAR(pixel(picture, step)[channel], expected[channel], 1)
            << taa::colorMapName(map) << " at " << step << "/100";
    }
  }
}

TEST_F(VisualizerTest, SpreadsDepthByItsLogarithm) {
  ViewStyle style = taa::defaultStyle(row(IntermediateId::depthView));
  style.low = 1.0f;
  style.high = 16.0f;
  style.map = ColorMap::Gray;
  const Picture picture =
      show(row(IntermediateId::depthView), style,
           {glm::vec4(1.0f), glm::vec4(2.0f), glm::vec4(4.0f), glm::vec4(16.0f), glm::vec4(100.0f)});
  const std::array<int, 5> expected = {0, 64, 128, 255, 255}; // 255/4, 255/2 rounded
  for (int x = 0; x < 5; ++x)
    // 1: the driver's log2() and pow().
    EXPECT_NEAR(pixel(picture, x)[0], expected[static_cast<std::size_t>(x)], 1) << x;
}

TEST_F(VisualizerTest, TellsTheSkyFromEveryDepth) {
  const ViewStyle style = taa::defaultStyle(row(IntermediateId::depth));
  std::vector<glm::vec4> texels(42, glm::vec4(0.0f));
  for (std::size_t step = 1; step < texels.size(); ++step)
    texels[step] = glm::vec4(std::exp2(0.25f - static_cast<float>(step) / 4.0f));
  const Picture picture = show(row(IntermediateId::depth), style, texels);
  const Bytes sky = pixel(picture, 0);
  EXPECT_GT(sky[2], sky[0]);
  for (int x = 1; x < picture.width; ++x) EXPECT_NE(pixel(picture, x), sky) << x;
}

TEST_F(VisualizerTest, KeepsZeroNeutralInSignedValues) {
  const taa::Intermediate signedRow = rowShownAs(Visual::Signed, 1);
  ViewStyle style = taa::defaultStyle(signedRow);
  style.low = -1.0f;
  style.high = 4.0f; // a range that is not symmetric moves nothing
  const Picture picture =
      show(signedRow, style, {glm::vec4(0.0f), glm::vec4(-4.0f), glm::vec4(4.0f), glm::vec4(2.0f)});
  EXPECT_EQ(pixel(picture, 0), bytesOf(taa::mapColor(ColorMap::Diverging, 0.5f)));
  EXPECT_EQ(pixel(picture, 0)[0], pixel(picture, 0)[2]);
  EXPECT_EQ(pixel(picture, 1), bytesOf(taa::mapColor(ColorMap::Diverging, 0.0f)));
  EXPECT_EQ(pixel(picture, 2), bytesOf(taa::mapColor(ColorMap::Diverging, 1.0f)));
  EXPECT_EQ(pixel(picture, 3), bytesOf(taa::mapColor(ColorMap::Diverging, 0.75f)));
}

TEST_F(VisualizerTest, ShowsDirectionAsHueAndLengthAsSaturation) {
  const taa::Intermediate& motion = row(IntermediateId::motion);
  const ViewStyle style = taa::defaultStyle(motion);
  const Picture picture =
      show(motion, style,
           {{0, 0, 0, 0}, {16, 0, 0, 0}, {0, 16, 0, 0}, {0, -32, 0, 0}, {8, 0, 0, 0}, {65504, 65504, 0, 0}});
  const float neutral = taa::kCyclicLightness * taa::kCyclicLightness * taa::kCyclicLightness;
  const auto cyclic = [](float turn) { return taa::mapColor(ColorMap::Cyclic, turn); };
  std::array<float, 3> half = cyclic(0.0f);
  for (float& channel : half) channel = neutral + 0.5f * (channel - neutral);
  const std::vector<Bytes> expected = {bytesOf({neutral, neutral, neutral}),
                                       bytesOf(cyclic(0.0f)),
                                       bytesOf(cyclic(0.25f)), // y is down
                                       bytesOf(cyclic(0.75f)), // longer than the range: saturated
                                       bytesOf(half),
                                       {0, 0, 0, 255}};
  for (int x = 0; x < 6; ++x)
    for (std::size_t channel = 0; channel < 4; ++channel)
      // 1: the driver's atan() and pow().
      EXPECT_NEAR(pixel(picture, x)[channel], expected[static_cast<std::size_t>(x)][channel], 1) << x;
}

TEST_F(VisualizerTest, ShowsOneComponentOfAVectorThroughTheDivergingMap) {
  ViewStyle style = taa::defaultStyle(row(IntermediateId::motion));
  style.red = false;
  const Picture picture = show(row(IntermediateId::motion), style, {{16, 0, 0, 0}, {0, -16, 0, 0}});
  EXPECT_EQ(pixel(picture, 0), bytesOf(taa::mapColor(ColorMap::Diverging, 0.5f)));
  EXPECT_EQ(pixel(picture, 1), bytesOf(taa::mapColor(ColorMap::Diverging, 0.0f)));
}

TEST_F(VisualizerTest, ShowsPositionsAsSharesOfThePicture) {
  const taa::Intermediate& position = row(IntermediateId::historyPosition);
  const Picture picture = show(position, taa::defaultStyle(position),
                               {{0, 0, 0, 0}, {1, 0.5f, 0, 0}, {2, 1, 0, 0}, {-5, 9, 0, 0}, {4, 1, 0, 0}});
  EXPECT_EQ(pixel(picture, 0), (Bytes{0, 0, 0, 255}));
  EXPECT_EQ(pixel(picture, 1), (Bytes{51, 128, 0, 255})); // 1/5 of 255, half of 255 rounded
  EXPECT_EQ(pixel(picture, 2), (Bytes{102, 255, 0, 255}));
  EXPECT_EQ(pixel(picture, 3), (Bytes{0, 255, 0, 255}));
  EXPECT_EQ(pixel(picture, 4), (Bytes{204, 255, 0, 255}));
}

TEST_F(VisualizerTest, ShowsNormalsAsTheUsualBytes) {
  const taa::Intermediate& normal = row(IntermediateId::normal);
  const Picture picture = show(normal, taa::defaultStyle(normal), {{0, 0, 1, 0}, {-1, 1, 0.2f, 0}});
  EXPECT_EQ(pixel(picture, 0), (Bytes{128, 128, 255, 255}));
  EXPECT_EQ(pixel(picture, 1), (Bytes{0, 255, 153, 255}));
}

TEST_F(VisualizerTest, ShowsMasksInBlackAndWhite) {
  const taa::Intermediate& mask = row(IntermediateId::onScreen);
  const Picture picture = show(mask, taa::defaultStyle(mask), {glm::vec4(0.0f), glm::vec4(1.0f)});
  EXPECT_EQ(pixel(picture, 0), (Bytes{0, 0, 0, 255}));
  EXPECT_EQ(pixel(picture, 1), (Bytes{255, 255, 255, 255}));
}

TEST_F(VisualizerTest, GivesNumbersTheColorsOfTheirCategories) {
  const taa::Intermediate& ids = row(IntermediateId::objectId);
  std::vector<glm::vec4> texels;
  texels.reserve(20);
  for (int number = 0; number < 20; ++number) texels.emplace_back(static_cast<float>(number));
  const Picture picture = show(ids, taa::defaultStyle(ids), texels);
  for (int number = 0; number < 20; ++number)
    EXPECT_EQ(pixel(picture, number), bytesOf(taa::categoryColor(number))) << number;
}

TEST_F(VisualizerTest, MarksWhatIsNoColorWhateverRangeAndChannels) {
  ViewStyle style;
  style.low = 1000.0f;
  style.high = 2000.0f;
  style.red = style.green = style.blue = false;
  const std::vector<glm::vec4> texels = {
      {0, kNaN, 0, 1}, {kInfinity, 0, 0, 1}, {0, 0, -1e-6f, 1}, {0, 0, 0, kNaN}, {-kInfinity, kNaN, 0, 1}};
  const Picture marked = show(row(IntermediateId::color), style, texels);
  EXPECT_EQ(pixel(marked, 0), (Bytes{255, 0, 0, 255}));
  EXPECT_EQ(pixel(marked, 1), (Bytes{0, 255, 0, 255}));
  EXPECT_EQ(pixel(marked, 2), (Bytes{0, 0, 255, 255}));
  EXPECT_EQ(pixel(marked, 3), (Bytes{0, 0, 0, 255})) << "the fourth channel is none of the row's";
  EXPECT_EQ(pixel(marked, 4), (Bytes{255, 0, 0, 255})) << "NaN before infinite";
  style.markInvalid = false;
  const Picture plain = show(row(IntermediateId::color), style, texels);
  for (int x = 0; x < 5; ++x) EXPECT_EQ(pixel(plain, x), (Bytes{0, 0, 0, 255})) << x;
}

TEST_F(VisualizerTest, MarksNaNInDataButNoNegativeValues) {
  const taa::Intermediate& motion = row(IntermediateId::motion);
  const Picture picture = show(motion, taa::defaultStyle(motion), {{-4, -4, 0, 0}, {0, kNaN, 0, 0}});
  EXPECT_NE(pixel(picture, 0), (Bytes{0, 0, 255, 255}));
  EXPECT_EQ(pixel(picture, 1), (Bytes{255, 0, 0, 255}));
}

TEST_F(VisualizerTest, RepeatsTexelsAboveOneToOne) {
  Image image(2, 2, 1);
  image.pixels = {0.0f, 1.0f, 1.0f, 0.0f};
  // Three screen pixels a texel, the viewport's corner half a texel inside the picture.
  const Picture picture = show(row(IntermediateId::onScreen), taa::ViewStyle{}, image,
                               {.origin = {0.5f, -0.5f}, .zoom = 4.0f}, 8, 8);
  const std::array<std::string_view, 8> expected = {"........", "........", "00####..", "00####..",
                                                    "00####..", "00####..", "##0000..", "##0000.."};
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const char wanted = expected[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      const int value = wanted == '#' ? 255 : 0;
      EXPECT_EQ(pixel(picture, x, y), (Bytes{value, value, value, wanted == '.' ? 0 : 255}))
          << x << ", " << y;
    }
}

TEST_F(VisualizerTest, AveragesLightOverTheAreaBelowOneToOne) {
  Image image(4, 2, 4);
  const std::array<float, 8> red = {0.0f, 1.0f, 0.5f, 0.5f, 1.0f, 1.0f, 0.0f, 0.25f};
  for (int index = 0; index < 8; ++index)
    image.at(index % 4, index / 4)[0] = red[static_cast<std::size_t>(index)];
  const Picture halved = show(row(IntermediateId::color), ViewStyle{}, image, {.zoom = 0.5f}, 3, 1);
  EXPECT_EQ(pixel(halved, 0), (Bytes{byteOf(0.75f), 0, 0, 255}));
  EXPECT_EQ(pixel(halved, 1), (Bytes{byteOf(0.3125f), 0, 0, 255}));
  EXPECT_EQ(pixel(halved, 2), (Bytes{0, 0, 0, 0}));
  // 4/3 texels a screen pixel: a whole one and a third of the next in x and in y.
  const Picture shrunk = show(row(IntermediateId::color), ViewStyle{}, image, {.zoom = 0.75f}, 3, 2);
  const float third = 1.0f / 3.0f;
  const float first = (0.0f + third * 1.0f + third * (1.0f + third * 1.0f)) / (16.0f / 9.0f);
  EXPECT_EQ(pixel(shrunk, 0, 0), (Bytes{byteOf(first), 0, 0, 255}));
  // The second row reaches half beyond the picture: the mean of what is there, half covered.
  const float below = (1.0f + third * 1.0f) / (4.0f / 3.0f);
  EXPECT_EQ(pixel(shrunk, 0, 1)[0], byteOf(below));
  EXPECT_NEAR(pixel(shrunk, 0, 1)[3], 127.5, 0.5) << "half way between two bytes";
}

TEST_F(VisualizerTest, TexelsAreEquallyLargeAtFractionalZoom) {
  Image image(2, 1, 4);
  image.at(1, 0)[0] = 1.0f;
  // Three screen pixels over two texels: the one in the middle lies half in either.
  const Picture enlarged = show(row(IntermediateId::color), ViewStyle{}, image, {.zoom = 1.5f}, 3, 1);
  const std::array<float, 3> expected = {0.0f, 0.5f, 1.0f};
  for (int x = 0; x < 3; ++x)
    EXPECT_EQ(pixel(enlarged, x)[0], byteOf(expected[static_cast<std::size_t>(x)])) << x;
  const Picture large = show(row(IntermediateId::color), ViewStyle{}, image, {.zoom = 8.5f}, 17, 1);
  for (int x = 0; x < 17; ++x) EXPECT_EQ(pixel(large, x)[0], x < 8 ? 0 : 255) << "sharp from 8 on, " << x;
}

TEST_F(VisualizerTest, ShowsTheSameFromAnotherTextureAndASecondTime) {
  const std::vector<glm::vec4> texels = {glm::vec4(0.2f), glm::vec4(0.9f)};
  const Picture first =
      show(row(IntermediateId::alpha), taa::defaultStyle(row(IntermediateId::alpha)), texels);
  for (int width = 1; width < 9; ++width) // more sizes than it keeps targets for
    show(row(IntermediateId::alpha), {},
         std::vector<glm::vec4>(static_cast<std::size_t>(width), glm::vec4(0.5f)));
  visualizer() = visualizer().reloaded();
  EXPECT_EQ(show(row(IntermediateId::alpha), taa::defaultStyle(row(IntermediateId::alpha)), texels).rgba,
            first.rgba);
}

TEST_F(VisualizerTest, OpensEveryRowWithinItsOwnRange) {
  for (const taa::Intermediate& each : taa::kIntermediates) {
    const ViewStyle style = taa::defaultStyle(each);
    EXPECT_EQ(style.low, each.low) << each.name;
    EXPECT_EQ(style.high, each.high) << each.name;
    EXPECT_TRUE(style.markInvalid && style.red && style.green && style.blue) << each.name;
    const Picture picture = show(each, style, {glm::vec4(0.5f)});
    EXPECT_EQ(pixel(picture, 0)[3], 255) << each.name;
  }
}
