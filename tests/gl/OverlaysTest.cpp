// What is laid over pictures, pixel by pixel: differences, hatches, tints, outlines, arrows.
#include "core/base/Light.h"
#include "core/picture/ColorMap.h"
#include "core/picture/Visualizer.h"
#include "tests/support/GlTest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

using taa::ColorMap;
using taa::DrawnLayers;
using taa::Image;
using taa::IntermediateId;
using taa::Picture;
using taa::ViewStyle;
using taa::ViewTransform;
using Bytes = std::array<int, 3>;

constexpr Bytes kWhite{255, 255, 255}, kBlack{0, 0, 0};

Bytes bytesOf(const std::array<float, 3>& linear) {
  Bytes bytes{};
  for (std::size_t channel = 0; channel < 3; ++channel)
    bytes[channel] = static_cast<int>(std::lround(255.0f * taa::srgbEncoded(linear[channel])));
  return bytes;
}

Bytes pixel(const Picture& picture, int x, int y = 0) {
  const std::uint8_t* rgba = picture.rgba.data() + (static_cast<std::size_t>(y) * picture.width + x) * 4;
  return {rgba[0], rgba[1], rgba[2]};
}

taa::gl::Texture textureOf(const Image& image) {
  const taa::gl::Format format = image.channels == 1   ? taa::gl::Format::R32F
                                 : image.channels == 2 ? taa::gl::Format::RG32F
                                                       : taa::gl::Format::RGBA32F;
  taa::gl::Texture texture({.width = image.width, .height = image.height, .layers = 1}, format, "layer");
  texture.upload(image, 0);
  return texture;
}

/// A picture of one value a texel.
Image oneChannel(int width, const std::vector<float>& values) {
  Image image(width, static_cast<int>(values.size()) / width, 1);
  image.pixels = values;
  return image;
}

Image filled(int width, int height, const std::vector<float>& value) {
  Image image(width, height, static_cast<int>(value.size()));
  for (std::size_t index = 0; index < image.pixels.size(); ++index)
    image.pixels[index] = value[index % value.size()];
  return image;
}

const taa::Intermediate& row(IntermediateId id) {
  return taa::intermediate(id);
}

class OverlaysTest : public taa::test::GlTest {
 protected:
  static Picture draw(const DrawnLayers& layers, IntermediateId id, const ViewStyle& style,
                      const ViewTransform& transform, int width, int height) {
    static taa::Visualizer visualizer;
    return visualizer.draw(layers, row(id), style, transform, width, height);
  }
};

} // namespace

TEST_F(OverlaysTest, ADifferenceIsDrawnWithItsSignAroundTheMiddleOfItsMap) {
  const taa::gl::Texture first = textureOf(oneChannel(4, {0.5f, 0.25f, 0.75f, 0.5f}));
  const taa::gl::Texture second = textureOf(oneChannel(4, {0.5f, 0.5f, 0.25f, 0.375f}));
  ViewStyle style;
  style.map = ColorMap::Diverging;
  style.low = -0.5f;
  style.high = 0.5f;
  const Picture picture = draw({.row = {&first}, .minus = {&second}}, IntermediateId::alpha, style, {}, 4, 1);
  const std::array<float, 4> places = {0.5f, 0.25f, 1.0f, 0.625f};
  for (int x = 0; x < 4; ++x)
    EXPECT_EQ(pixel(picture, x),
              bytesOf(taa::mapColor(ColorMap::Diverging, places[static_cast<std::size_t>(x)])))
        << x;
}

TEST_F(OverlaysTest, OfColorsTheShownChannelThatDiffersMostIsDrawn) {
  const taa::gl::Texture first = textureOf(filled(1, 1, {0.5f, 0.25f, 1.0f, 1.0f}));
  const taa::gl::Texture second = textureOf(filled(1, 1, {0.25f, 0.5f, 0.25f, 0.0f}));
  ViewStyle style;
  style.map = ColorMap::Diverging;
  style.low = -1.0f;
  const auto shown = [&] {
    return pixel(draw({.row = {&first}, .minus = {&second}}, IntermediateId::resolved, style, {}, 1, 1), 0);
  };
  EXPECT_EQ(shown(), bytesOf(taa::mapColor(ColorMap::Diverging, 0.875f))) << "blue: 0.75 more";
  style.blue = style.red = false;
  EXPECT_EQ(shown(), bytesOf(taa::mapColor(ColorMap::Diverging, 0.375f))) << "green alone: 0.25 less";
}

TEST_F(OverlaysTest, HatchesEitherEndInItsOwnColorAndDirection) {
  const taa::gl::Texture values = textureOf(oneChannel(3, {2.0f, 0.5f, -1.0f}));
  ViewStyle style;
  style.markClipped = true;
  const int zoom = 12;
  const Picture picture = draw({.row = {&values}}, IntermediateId::alpha, style,
                               {.zoom = static_cast<float>(zoom)}, 3 * zoom, zoom);
  const Bytes above = bytesOf(taa::kAboveColor), below = bytesOf(taa::kBelowColor);
  const Bytes middle = bytesOf(taa::mapColor(taa::ColorMap::Gray, 0.5f));
  EXPECT_EQ(above, (Bytes{213, 94, 0}));
  EXPECT_EQ(below, (Bytes{86, 180, 233}));
  for (int y = 0; y < zoom; ++y)
    for (int x = 0; x < 3 * zoom; ++x) {
      const bool rises = (x + y) % 6 < 2, falls = (x - y + 600) % 6 < 2;
      const Bytes expected = x < zoom       ? (rises ? above : kWhite)
                             : x < 2 * zoom ? middle
                                            : (falls ? below : kBlack);
      ASSERT_EQ(pixel(picture, x, y), expected) << x << ", " << y;
    }
}

TEST_F(OverlaysTest, HatchesGrowWithTheScaleAndShowWhereAnyTexelIsClipped) {
  const taa::gl::Texture values = textureOf(oneChannel(4, {0.0f, 0.0f, 0.0f, 9.0f}));
  ViewStyle style;
  style.markClipped = true;
  const Picture halved =
      draw({.row = {&values}}, IntermediateId::alpha, style, {.zoom = 0.5f, .scale = 2.0f}, 2, 1);
  EXPECT_EQ(pixel(halved, 0), kBlack);
  EXPECT_EQ(pixel(halved, 1), bytesOf(taa::kAboveColor)) << "(1 / 2) % 6 < 2";
}

TEST_F(OverlaysTest, ExposureMovesWhatIsClipped) {
  const taa::gl::Texture values = textureOf(filled(1, 1, {0.6f, 0.0f, 0.0f, 1.0f}));
  ViewStyle style;
  style.markClipped = true;
  EXPECT_EQ(pixel(draw({.row = {&values}}, IntermediateId::color, style, {}, 1, 1), 0)[1], 0);
  style.exposure = 1.0f;
  EXPECT_EQ(pixel(draw({.row = {&values}}, IntermediateId::color, style, {}, 1, 1), 0),
            bytesOf(taa::kAboveColor));
}

TEST_F(OverlaysTest, TintsByTheReasonAndLeavesWhatIsKept) {
  const taa::gl::Texture values = textureOf(oneChannel(3, {0.25f, 0.25f, 0.25f}));
  const taa::gl::Texture reasons = textureOf(oneChannel(3, {0.0f, 3.0f, 7.0f}));
  ViewStyle style;
  style.markRejected = true;
  const Picture picture =
      draw({.row = {&values}, .rejectReason = {&reasons}}, IntermediateId::alpha, style, {}, 3, 1);
  const float quarter = taa::mapColor(taa::ColorMap::Gray, 0.25f)[0];
  EXPECT_EQ(pixel(picture, 0), bytesOf({quarter, quarter, quarter}));
  for (const int reason : {3, 7}) {
    std::array<float, 3> tinted = taa::categoryColor(reason);
    for (float& channel : tinted) channel = quarter + taa::kTintShare * (channel - quarter);
    EXPECT_EQ(pixel(picture, reason == 3 ? 1 : 2), bytesOf(tinted)) << reason;
  }
}

TEST_F(OverlaysTest, LargeTexelsHoldTheNumberOfTheirReason) {
  const taa::gl::Texture values = textureOf(oneChannel(2, {0.25f, 0.25f}));
  const taa::gl::Texture reasons = textureOf(oneChannel(2, {0.0f, 7.0f}));
  ViewStyle style;
  style.markRejected = true;
  const auto drawn = [&](float zoom) {
    return draw({.row = {&values}, .rejectReason = {&reasons}}, IntermediateId::alpha, style, {.zoom = zoom},
                static_cast<int>(2 * zoom), static_cast<int>(zoom));
  };
  const Picture large = drawn(16.0f);
  // A 7 two pixels inside the corner of the second texel: a bar above, a leg at its right.
  const char* const seven[] = {"###", "..#", "..#", "..#", "..#"};
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 3; ++x)
      EXPECT_EQ(pixel(large, 16 + 2 + x, 2 + y), seven[y][x] == '#' ? kWhite : kBlack) << x << ", " << y;
  const Bytes tint = pixel(large, 30, 14);
  EXPECT_NE(tint, kBlack);
  EXPECT_EQ(pixel(large, 2, 2), pixel(large, 14, 14)) << "none where nothing is rejected";
  const Picture small = drawn(8.0f);
  for (int y = 0; y < 8; ++y)
    for (int x = 8; x < 16; ++x) EXPECT_EQ(pixel(small, x, y), tint) << x << ", " << y;
}

TEST_F(OverlaysTest, TheScaleOfArrowsIsWhatIsDrawn) {
  const taa::gl::Texture values = textureOf(filled(8, 8, {100.0f, 0.0f}));
  ViewStyle style = taa::defaultStyle(row(IntermediateId::motion));
  style.arrows = true;
  const ViewTransform transform{.zoom = 32.0f};
  const Picture picture = draw({.row = {&values}}, IntermediateId::motion, style, transform, 256, 256);
  int length = 0;
  for (int x = 32; x < 64; ++x) length += pixel(picture, x, 48) == kWhite ? 1 : 0;
  EXPECT_NEAR(length, taa::arrowScale(transform).longest, 2.0) << "its tip is narrower than a pixel";
  const float most = std::max(std::abs(style.low), std::abs(style.high));
  const float least = taa::arrowScale(transform).minShare * most;
  const auto whiteIn = [&](float x) {
    const taa::gl::Texture still = textureOf(filled(8, 8, {x, 0.0f}));
    const Picture drawn = draw({.row = {&still}}, IntermediateId::motion, style, transform, 256, 256);
    int count = 0;
    for (int at = 32; at < 64; ++at) count += pixel(drawn, at, 48) == kWhite ? 1 : 0;
    return count;
  };
  EXPECT_LE(whiteIn(0.98f * least), 2) << "a dot";
  EXPECT_GE(whiteIn(1.1f * least), 3) << "an arrow";
}

TEST_F(OverlaysTest, OutlinesRunBetweenObjectsAndNotAroundThePicture) {
  const taa::gl::Texture values = textureOf(filled(2, 2, {0.25f}));
  const taa::gl::Texture objects = textureOf(oneChannel(2, {4.0f, 4.0f, 4.0f, 9.0f}));
  ViewStyle style;
  style.outlineObjects = true;
  const Picture picture =
      draw({.row = {&values}, .objectId = {&objects}}, IntermediateId::alpha, style, {.zoom = 8.0f}, 16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const bool isEdge = (x == 8 && y >= 8) || (y == 8 && x >= 8);
      const Bytes dash = (x + y) / 4 % 2 == 0 ? kWhite : kBlack;
      ASSERT_EQ(pixel(picture, x, y), isEdge ? dash : bytesOf(taa::mapColor(taa::ColorMap::Gray, 0.25f)))
          << x << ", " << y;
    }
}

TEST_F(OverlaysTest, AnArrowPointsAlongItsVectorAndIsAsLongAsItsShareOfTheRange) {
  const taa::gl::Texture right = textureOf(filled(1, 1, {16.0f, 0.0f}));
  ViewStyle style = taa::defaultStyle(row(IntermediateId::motion)); // to 16 px
  const ViewTransform transform{.zoom = 40.0f};
  const Picture bare = draw({.row = {&right}}, IntermediateId::motion, style, transform, 40, 40);
  style.arrows = true;
  const Picture picture = draw({.row = {&right}}, IntermediateId::motion, style, transform, 40, 40);
  // The middle lies between pixels 19 and 20; the arrow reaches 0.45 · 40 = 18 to either side, and its edge
  // one more. Along the row of pixel 20, half a pixel below the middle, the shaft is white.
  for (int x = 0; x < 40; ++x) {
    const double along = x + 0.5 - 20.0;
    const bool isShaft = along >= -18.0 && along <= 17.0; // the tip's sides close in at half a pixel aside
    const Bytes expected = isShaft ? kWhite : std::abs(along) <= 19.0 ? kBlack : pixel(bare, x, 20);
    EXPECT_EQ(pixel(picture, x, 20), expected) << x;
  }
  // The head is 6 long and as wide; at its back end, 12 from the middle, pixels to 2.5 aside are white.
  for (int y = 14; y < 26; ++y) {
    const double aside = std::abs(y + 0.5 - 20.0), forward = 32 + 0.5 - 20.0;
    const double outside = aside - 0.5 * (18.0 - forward);
    EXPECT_EQ(pixel(picture, 32, y), outside <= 0.0   ? kWhite
                                     : outside <= 1.0 ? kBlack
                                                      : pixel(bare, 32, y))
        << y;
  }
  EXPECT_EQ(pixel(picture, 8, 25), pixel(bare, 8, 25)) << "the tail has no head";
}

TEST_F(OverlaysTest, ArrowsPointDownForPositiveYAndStillTexelsHaveADot) {
  ViewStyle style = taa::defaultStyle(row(IntermediateId::motion));
  style.arrows = true;
  const ViewTransform transform{.zoom = 40.0f};
  const auto drawn = [&](float x, float y) {
    const taa::gl::Texture vector = textureOf(filled(1, 1, {x, y}));
    return draw({.row = {&vector}}, IntermediateId::motion, style, transform, 40, 40);
  };
  const Picture down = drawn(0.0f, 16.0f);
  EXPECT_EQ(pixel(down, 22, 32), kWhite) << "the head is below the middle";
  EXPECT_NE(pixel(down, 22, 7), kWhite);
  const Picture none = drawn(0.0f, 0.0f);
  EXPECT_EQ(pixel(none, 20, 20), kWhite);
  EXPECT_EQ(pixel(none, 21, 20), kBlack);
  EXPECT_EQ(pixel(none, 23, 20), pixel(none, 0, 0));
  const Picture unknown = drawn(65504.0f, 65504.0f);
  EXPECT_EQ(pixel(unknown, 20, 20), kBlack) << "no previous position: no arrow";
}

TEST_F(OverlaysTest, BelowTheirSpacingArrowsStandForTheTexelInTheMiddleOfACell) {
  // 12 screen px a texel: an arrow for every two by two of them, of the last of those.
  Image vectors = filled(4, 2, {-16.0f, 0.0f});
  vectors.at(1, 1)[0] = 16.0f;
  const taa::gl::Texture texture = textureOf(vectors);
  ViewStyle style = taa::defaultStyle(row(IntermediateId::motion));
  style.arrows = true;
  const Picture picture = draw({.row = {&texture}}, IntermediateId::motion, style, {.zoom = 12.0f}, 48, 24);
  // Half length 0.45 · 24 = 10.8 around x 12 and 36; heads begin 4.8 from the middle.
  EXPECT_EQ(pixel(picture, 17, 13), kWhite) << "first cell points right";
  EXPECT_NE(pixel(picture, 6, 14), kWhite);
  EXPECT_EQ(pixel(picture, 30, 13), kWhite) << "second cell points left";
  EXPECT_NE(pixel(picture, 41, 14), kWhite);
}
