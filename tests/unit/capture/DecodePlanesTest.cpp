// Color, ids and the rest of a frame's planes, and planes that are not what the capture says.
#include "core/base/Error.h"
#include "core/capture/decode/DecodedFrame.h"
#include "tests/unit/capture/CaptureFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace taa::capture {
namespace {

constexpr glm::ivec2 kSize(2, 1);

DecodedFrame decodedColor(const Manifest& manifest, int channels, const std::vector<float>& stored) {
  FramePlanes planes;
  planes[PlaneKind::Color] = planeFrom(manifest.sizePx.x, manifest.sizePx.y, channels, stored);
  return decode(manifest, 1, std::move(planes));
}

bool says(const std::vector<std::string>& sentences, const std::string& words) {
  return std::ranges::any_of(
      sentences, [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

} // namespace

TEST(DecodePlanes, ColorWithoutAlphaIsOpaque) {
  const DecodedFrame frame = decodedColor(manifestOf({}, kSize), 3, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(frame.color.pixels, (std::vector<float>{1, 2, 3, 1, 4, 5, 6, 1}));
}

TEST(DecodePlanes, OwnColorKeepsItsBits) {
  const float inf = std::numeric_limits<float>::infinity();
  const DecodedFrame frame =
      decodedColor(manifestOf({}, kSize), 4, {-1, -0.0f, inf, 0.5f, std::nanf(""), 1e-40f, 3, 2});
  EXPECT_TRUE(std::signbit(frame.color.pixels[1]));
  EXPECT_EQ(frame.color.pixels[2], inf);
  EXPECT_TRUE(std::isnan(frame.color.pixels[4]));
  EXPECT_EQ(frame.color.pixels[5], 1e-40f);
}

TEST(DecodePlanes, SrgbBecomesLinear) {
  Conventions conventions;
  conventions.color.encoding = ColorEncoding::Srgb;
  // IEC 61966-2-1: 0.5 → 0.214041140, 0.04 → 0.04 / 12.92, 2 → (2.055 / 1.055)^2.4.
  const DecodedFrame frame =
      decodedColor(manifestOf(conventions, kSize), 4, {0.5f, 0.04f, 2.0f, 0.5f, 0, 1, -1, 1});
  EXPECT_NEAR(frame.color.pixels[0], 0.214041140f, 2e-8f);
  EXPECT_NEAR(frame.color.pixels[1], 0.04f / 12.92f, 1e-9f);
  EXPECT_NEAR(frame.color.pixels[2], 4.95385f, 2e-5f);
  EXPECT_EQ(frame.color.pixels[3], 0.5f) << "alpha is no color";
  EXPECT_EQ(frame.color.pixels[4], 0.0f);
  EXPECT_EQ(frame.color.pixels[5], 1.0f);
  EXPECT_NEAR(frame.color.pixels[6], -1.0f / 12.92f, 1e-8f);
}

TEST(DecodePlanes, AFormatThatIsSrgbIsDecodedByWhoReadsIt) {
  Conventions conventions;
  conventions.color.encoding = ColorEncoding::Srgb;
  Manifest manifest = manifestOf(conventions, kSize);
  manifest.planes[PlaneKind::Color].raw = RawFormat::RGBA8_SRGB;
  EXPECT_EQ(decodedColor(manifest, 3, {0.5f}).color.pixels[0], 0.5f);
}

TEST(DecodePlanes, PreExposureIsDividedOut) {
  Conventions conventions;
  conventions.color.preExposed = true;
  Manifest manifest = manifestOf(conventions, kSize);
  manifest.frames[1].preExposure = 4.0;
  EXPECT_EQ(decodedColor(manifest, 3, {1, 2, 4}).color.pixels,
            (std::vector<float>{0.25f, 0.5f, 1, 1, 0.25f, 0.5f, 1, 1}));
  for (const double exposure : {0.0, -1.0, std::nan("")}) {
    manifest.frames[1].preExposure = exposure;
    EXPECT_THROW(decodedColor(manifest, 3, {1}), Error);
  }
}

TEST(DecodePlanes, IdsAndNormalsTakeTheNearestTexel) {
  const Manifest manifest = manifestOf({}, {4, 2});
  FramePlanes planes = planesOf(manifest);
  PlaneData& ids = planes[PlaneKind::ObjectId];
  ids.width = 2;
  ids.height = 1;
  ids.integers = {7, 4000000000u};
  planes[PlaneKind::Normal] = planeFrom(4, 2, 3, {0, 1, 0});
  const DecodedFrame frame = decode(manifest, 1, planes);
  EXPECT_EQ(frame.objectId,
            (std::vector<std::uint32_t>{7, 7, 4000000000u, 4000000000u, 7, 7, 4000000000u, 4000000000u}));
  EXPECT_EQ(frame.normal.channels, 4);
  EXPECT_EQ(frame.normal.at(3, 1)[1], 1.0f);
  EXPECT_EQ(frame.normal.at(3, 1)[3], 0.0f);
}

TEST(DecodePlanes, TheOutputKeepsItsOwnSize) {
  Manifest manifest = manifestOf({}, kSize);
  manifest.outputPx = {4, 2};
  FramePlanes planes = planesOf(manifest);
  planes[PlaneKind::Output] = planeFrom(4, 2, 3, {0.5f});
  planes[PlaneKind::Reference] = planeFrom(8, 4, 3, {0.5f});
  const DecodedFrame frame = decode(manifest, 1, planes);
  EXPECT_EQ(frame.output.width, 4);
  EXPECT_EQ(frame.reference.width, 8);
}

TEST(DecodePlanes, PlanesThatContradictTheCaptureAreErrors) {
  const Manifest manifest = manifestOf({}, kSize);
  const auto fails = [&](auto&& change) {
    FramePlanes planes = planesOf(manifest);
    change(planes);
    EXPECT_THROW(decode(manifest, 1, planes), Error);
  };
  fails([](FramePlanes& planes) { planes.erase(PlaneKind::Color); });
  fails([](FramePlanes& planes) { planes[PlaneKind::Color] = planeFrom(3, 1, 3, {1}); });
  fails([](FramePlanes& planes) { planes[PlaneKind::Color] = planeFrom(2, 1, 1, {1}); });
  fails([](FramePlanes& planes) { planes[PlaneKind::Color].height = -1; });
  fails([](FramePlanes& planes) { planes[PlaneKind::Color].image.pixels.pop_back(); });
  fails([](FramePlanes& planes) { planes[PlaneKind::Motion] = planeFrom(2, 1, 1, {1}); });
  fails([](FramePlanes& planes) { planes[PlaneKind::Depth] = {}; });
  fails([](FramePlanes& planes) { planes[PlaneKind::ObjectId] = planeFrom(2, 1, 1, {1}); });
  EXPECT_THROW(decode(manifest, 2, planesOf(manifest)), Error) << "there are two frames";
}

TEST(MissingInputs, SaysWhatIsDoneInstead) {
  Manifest manifest = manifestOf({}, kSize);
  std::vector<std::string> sentences = missingInputs(manifest);
  EXPECT_TRUE(says(sentences, "no motion"));
  EXPECT_TRUE(says(sentences, "no depth"));
  EXPECT_TRUE(says(sentences, "without matrices"));
  EXPECT_TRUE(says(sentences, "no object ids"));
  EXPECT_TRUE(says(sentences, "no jitter") || says(sentences, "has a jitter"));
  for (const PlaneKind kind : {PlaneKind::Motion, PlaneKind::Depth, PlaneKind::ObjectId, PlaneKind::Normal,
                               PlaneKind::PreviousDepth})
    manifest.planes[kind].file = "a";
  for (CapturedFrame& frame : manifest.frames) {
    frame.view = moveBy(0, 0, 0);
    frame.projection = projections::reversed(1, 1, 0.1);
    frame.jitter = {0.25, 0.25};
  }
  EXPECT_EQ(missingInputs(manifest), std::vector<std::string>{});
  manifest.planes[PlaneKind::Motion].sizePx = {1, 1};
  EXPECT_TRUE(says(missingInputs(manifest), "nearest"));
  manifest.planes.erase(PlaneKind::Motion);
  EXPECT_TRUE(says(missingInputs(manifest), "made of depth and matrices"));
  manifest.frames[1].view = {};
  EXPECT_TRUE(says(missingInputs(manifest), "1 of 2 frames"));
}

// Engines often have no motion in their first frame, which is not to say that there is none.
TEST(MissingInputs, SaysWhichPlanesAreThereInSomeFramesOnly) {
  Manifest manifest = manifestOf({}, kSize, 3);
  manifest.frames[1].planes[PlaneKind::Motion].file = "a";
  manifest.frames[2].planes[PlaneKind::Motion].file = "b";
  const std::vector<std::string> sentences = missingInputs(manifest);
  EXPECT_TRUE(says(sentences, "motion is part of 2 of 3 frames"));
  EXPECT_FALSE(says(sentences, "there is no motion"));
}

// taa_capture.h states every plane with its frame.
TEST(MissingInputs, SaysTheSizesOfPlanesOfFrames) {
  Manifest manifest = manifestOf({}, {4, 2});
  for (CapturedFrame& frame : manifest.frames) {
    frame.planes[PlaneKind::Motion].file = "a";
    frame.planes[PlaneKind::Motion].raw = RawFormat::RG16F;
    frame.planes[PlaneKind::Motion].sizePx = {2, 1};
  }
  EXPECT_TRUE(says(missingInputs(manifest), "motion is 2×1 and the frame 4×2"));
}

TEST(MissingInputs, SaysThatNoFrameIsPreExposed) {
  Manifest manifest = manifestLike("unreal", kSize);
  EXPECT_TRUE(says(missingInputs(manifest), "color is pre-exposed"));
  manifest.frames[1].preExposure = 2.0;
  EXPECT_FALSE(says(missingInputs(manifest), "color is pre-exposed"));
}

} // namespace taa::capture
