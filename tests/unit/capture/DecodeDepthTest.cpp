// Depth of every engine, from values that were computed by hand for a surface at 4 m.
#include "core/base/Error.h"
#include "core/capture/decode/DecodedFrame.h"
#include "tests/unit/capture/CaptureFixtures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace taa::capture {
namespace {

constexpr glm::ivec2 kSize(4, 2);

DecodedFrame decodedDepth(const Manifest& manifest, const std::vector<float>& stored) {
  FramePlanes planes = planesOf(manifest);
  planes[PlaneKind::Depth] = planeFrom(manifest.sizePx.x, manifest.sizePx.y, 1, stored);
  return decode(manifest, 1, planes);
}

/// A capture whose camera is the engine's, with near 0.1 m and far 100 m or none.
Manifest withCamera(std::string_view id) {
  Manifest manifest = manifestLike(id, kSize);
  const EngineCamera camera = engineCamera(id);
  for (CapturedFrame& frame : manifest.frames) {
    frame.view = camera.view;
    frame.projection = camera.projection;
  }
  return manifest;
}

// With near 0.1 and far 100: (0.1 · 100/4 − 0.1) / 99.9 reversed.
constexpr float kReversed = 0.024024024f;

/// What stands at 4 m and in the sky.
struct Stored {
  const char* engine;
  float surface, sky;
};
const std::vector<Stored> kStored = {
    {"taa-inspector", 0.025f, 0.0f},
    {"unreal", 0.025f, 0.0f},
    {"unity", kReversed, 0.0f},
    {"godot", kReversed, 0.0f},
    {"bevy", 0.025f, 0.0f},
    {"three", 1.0f - kReversed, 1.0f},
    {"babylon", -4.0f, 0.0f},
    {"fsr", 1.0f - kReversed, 1.0f},
    {"xess", 1.0f - kReversed, 1.0f},
    {"streamline", 1.0f - kReversed, 1.0f},
    {"metalfx", 1.0f - kReversed, 1.0f},
    {"blender", 4.0f, 1e10f},
};

} // namespace

TEST(DecodeDepth, TakesWhatEachEngineStores) {
  for (const Stored& stored : kStored) {
    const DecodedFrame frame = decodedDepth(withCamera(stored.engine), {stored.surface, stored.sky});
    EXPECT_NEAR(frame.nearPlane, 0.1, 1e-12) << stored.engine;
    // Half a step of a float below 1 is 3e-8 of 0.025.
    EXPECT_NEAR(frame.depth.pixels[0], 0.025f, 4e-8f) << stored.engine;
    EXPECT_EQ(frame.depth.pixels[1], 0.0f) << stored.engine;
  }
  EXPECT_EQ(kStored.size(), startingPoints().size());
}

TEST(DecodeDepth, OwnValuesKeepTheirBits) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const std::vector<float> stored = {0.7f, 1e-30f, 0.0f, 1.5f, inf, -inf, -0.25f, nan};
  const DecodedFrame frame = decodedDepth(withCamera("taa-inspector"), stored);
  for (std::size_t i = 0; i + 1 < stored.size(); ++i) EXPECT_EQ(frame.depth.pixels[i], stored[i]);
  EXPECT_TRUE(std::isnan(frame.depth.pixels.back()));
}

TEST(DecodeDepth, StatedPlanesAreUsedInsteadOfTheMatrix) {
  // The matrix has near 0.1, depth 0.2 and 50: at 4 m (0.2 · 50/4 − 0.2) / 49.8 reversed.
  Manifest manifest = withCamera("taa-inspector");
  manifest.conventions.depth.nearPlane = 0.2;
  manifest.conventions.depth.farPlane = 50.0;
  const DecodedFrame frame = decodedDepth(manifest, {static_cast<float>(2.3 / 49.8)});
  EXPECT_NEAR(frame.depth.pixels[0], 0.1f / 4.0f, 1e-8f);
}

TEST(DecodeDepth, NeedsNoMatrixWhereItsPlanesAreStated) {
  Conventions conventions;
  conventions.depth.nearPlane = 20.0;
  conventions.depth.reversed = false;
  conventions.depth.range = ClipRange::MinusOneToOne;
  conventions.matrices.metersPerUnit = 0.01;
  // 1 − 2 · 0.2 / 4 of −1…1 without a far plane.
  const DecodedFrame frame = decodedDepth(manifestOf(conventions, kSize), {0.9f});
  EXPECT_DOUBLE_EQ(frame.nearPlane, 0.2);
  EXPECT_NEAR(frame.depth.pixels[0], 0.05f, 4e-8f);
}

TEST(DecodeDepth, RadialDistancesBecomePlanar) {
  // Slopes 1 and 2 of 4 × 2 px: the first pixel is seen at (−0.75, 0.5 / 2) for 1 along the axis.
  Manifest manifest = withCamera("taa-inspector");
  manifest.conventions.depth.kind = DepthKind::Radial;
  const float radial = static_cast<float>(4.0 * std::sqrt(1.0 + 0.75 * 0.75 + 0.25 * 0.25));
  EXPECT_NEAR(decodedDepth(manifest, {radial}).depth.pixels[0], 0.025f, 4e-9f);
  // Jitter of a whole pixel to the right: the second one shows what the first one showed.
  manifest.frames[1].jitter = {1.0, 0.0};
  EXPECT_NEAR(decodedDepth(manifest, {radial}).depth.pixels[1], 0.025f, 4e-9f);
}

TEST(DecodeDepth, DistancesThatCannotBeAreNothing) {
  Conventions conventions;
  conventions.depth.kind = DepthKind::Planar;
  const float inf = std::numeric_limits<float>::infinity();
  const DecodedFrame frame = decodedDepth(manifestOf(conventions, kSize), {-1.0f, 0.0f, inf, std::nanf("")});
  EXPECT_EQ(frame.depth.pixels[0], 0.0f);
  EXPECT_EQ(frame.depth.pixels[1], 0.0f);
  EXPECT_EQ(frame.depth.pixels[2], 0.0f);
  EXPECT_TRUE(std::isnan(frame.depth.pixels[3]));
}

TEST(DecodeDepth, AnOrthographicWindowStaysLinear) {
  Manifest manifest = manifestOf({}, kSize);
  manifest.conventions.depth.reversed = false;
  manifest.conventions.matrices.clipZ = ClipRange::MinusOneToOne;
  // glOrtho's reference page: near 1, far 11.
  const StatedMatrix ortho = {0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, -0.2, -1.2, 0, 0, 0, 1};
  for (CapturedFrame& frame : manifest.frames) {
    frame.view = moveBy(0, 0, 0);
    frame.projection = ortho;
  }
  // A window's depth of 0.25 is at 3.5 m.
  const DecodedFrame window = decodedDepth(manifest, {0.25f, 1.0f});
  EXPECT_NEAR(window.depth.pixels[0], 0.75f, 1e-7f);
  EXPECT_EQ(window.depth.pixels[1], 0.0f);
  EXPECT_TRUE(window.camera->orthographic);
  manifest.conventions.depth.kind = DepthKind::Planar;
  EXPECT_NEAR(decodedDepth(manifest, {3.5f}).depth.pixels[0], 0.75f, 1e-7f);
}

TEST(DecodeDepth, ConventionsThatCannotBeAreErrors) {
  const auto fails = [](auto&& change) {
    Conventions conventions;
    change(conventions.depth);
    EXPECT_THROW(decodedDepth(manifestOf(conventions, kSize), {0.5f}), Error);
  };
  fails([](DepthConventions& depth) { depth.scale = 0.0; });
  fails([](DepthConventions& depth) { depth.nearPlane = -1.0; });
  fails([](DepthConventions& depth) { depth.nearPlane = std::nan(""); });
  fails([](DepthConventions& depth) { depth.nearPlane = 2.0, depth.farPlane = 1.0; });
}

} // namespace taa::capture
