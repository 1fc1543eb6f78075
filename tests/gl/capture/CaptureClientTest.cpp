// A program that is not this renderer writes a capture with taa_capture.h: it is read back as what it drew.
#include "core/base/Files.h"
#include "core/capture/format/Manifest.h"
#include "core/capture/planes/Planes.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace fs = std::filesystem;

namespace taa::capture {

namespace {

constexpr int kWidth = 64, kHeight = 48, kSquare = 16;

class CaptureClient : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    fs::remove_all(folder);
    const test::ProcessResult result = run();
    ASSERT_EQ(result.exitCode, 0) << result.err;
  }

  test::ProcessResult run() const {
    return test::runProcess({test::binary("taa_capture_client").string(), folder.string()});
  }

  fs::path folder = test::temporaryFolder() / "client";
};

struct Square {
  glm::ivec2 corner; ///< top left
  glm::vec4 color;
  glm::vec2 motion;
  float depth;
  std::uint32_t id;
};

/// All pixels of a square and those around it that are not the sky's, of a frame.
void expectSquare(const FramePlanes& planes, const Square& square) {
  for (int y = square.corner.y; y < square.corner.y + kSquare; ++y)
    for (int x = square.corner.x; x < square.corner.x + kSquare; ++x) {
      ASSERT_EQ(planes.at(PlaneKind::Color).image.texel(x, y), square.color) << x << ", " << y;
      ASSERT_EQ(glm::vec2(planes.at(PlaneKind::Motion).image.texel(x, y)), square.motion) << x << ", " << y;
      ASSERT_EQ(planes.at(PlaneKind::Depth).image.at(x, y)[0], square.depth) << x << ", " << y;
      ASSERT_EQ(planes.at(PlaneKind::ObjectId).integers[static_cast<std::size_t>(y * kWidth + x)], square.id);
    }
}

std::size_t countIds(const FramePlanes& planes) {
  std::size_t count = 0;
  for (const std::uint32_t id : planes.at(PlaneKind::ObjectId).integers) count += id == 0 ? 0 : 1;
  return count;
}

} // namespace

TEST_F(CaptureClient, WritesWhatReadManifestUnderstands) {
  const Manifest manifest = readManifest(folder);
  EXPECT_EQ(manifest.name, "Two \"squares\"");
  EXPECT_EQ(manifest.engine, "tests/capture_client");
  EXPECT_EQ(manifest.like, "taa-inspector");
  EXPECT_EQ(manifest.sizePx, glm::ivec2(kWidth, kHeight));
  EXPECT_EQ(manifest.framesPerSecond, 30.0);
  EXPECT_EQ(manifest.objects.at(7), "green square");
  EXPECT_EQ(manifest.objects.at(300), "red square");
  EXPECT_EQ(manifest.conventions.motion.unit, ScreenUnit::Ndc);
  EXPECT_FALSE(manifest.conventions.motion.notWritten);
  EXPECT_FALSE(manifest.conventions.depth.reversed);
  EXPECT_EQ(manifest.conventions.matrices.clipZ, ClipRange::MinusOneToOne);
  ASSERT_EQ(manifest.frames.size(), 4u);
  EXPECT_TRUE(manifest.frames[0].cut && !manifest.frames[1].cut);
  EXPECT_EQ(manifest.frames[3].number, 3);
  EXPECT_EQ(manifest.frames[3].jitter, glm::dvec2(0.375, 0.25));
  ASSERT_TRUE(manifest.frames[2].projection);
  EXPECT_EQ((*manifest.frames[2].projection)[10], -1.0);
}

// The squares stand still, or go by four pixels, in GL's pixels from the lower left: (40, 24) and (8 + 4n,
// 8). Jitter is less than half a pixel, so that it moves no pixel's center over an edge.
TEST_F(CaptureClient, WritesPlanesThatHoldWhatItDrew) {
  const Manifest manifest = readManifest(folder);
  for (const CapturedFrame& frame : manifest.frames) {
    const FramePlanes planes = readPlanes(folder, manifest, frame);
    ASSERT_EQ(planes.size(), 4u);
    const float moved =
        frame.number > 0 ? 2.0f * 4.0f / kWidth : 0.0f; // in device coordinates: exact in halves
    expectSquare(planes, {{40, kHeight - 24 - kSquare}, {2.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f}, 0.5f, 300});
    expectSquare(
        planes,
        {{8 + 4 * frame.number, kHeight - 8 - kSquare}, {0.0f, 0.5f, 0.0f, 1.0f}, {moved, 0.0f}, 0.25f, 7});
    EXPECT_EQ(countIds(planes), 2u * kSquare * kSquare);
    EXPECT_EQ(planes.at(PlaneKind::Color).image.texel(0, 0), glm::vec4(0.25f, 0.5f, 1.0f, 1.0f));
    EXPECT_EQ(planes.at(PlaneKind::Depth).image.at(0, 0)[0], 1.0f);
  }
}

TEST_F(CaptureClient, ReplacesNoCaptureUnasked) {
  const std::string before = readFile(folder / kManifestName);
  const test::ProcessResult again = run();
  EXPECT_NE(again.exitCode, 0);
  EXPECT_NE(again.err.find("there is a capture in the folder already"), std::string::npos) << again.err;
  EXPECT_EQ(readFile(folder / kManifestName), before);
}

TEST_F(CaptureClient, LeavesTheFramesBeforeACrash) {
  fs::remove_all(folder);
  const test::ProcessResult crash =
      test::runProcess({test::binary("taa_capture_client").string(), folder.string(), "2"});
  ASSERT_EQ(crash.exitCode, 3) << crash.err;
  const Manifest manifest = readManifest(folder);
  ASSERT_EQ(manifest.frames.size(), 2u);
  for (const CapturedFrame& frame : manifest.frames)
    EXPECT_EQ(countIds(readPlanes(folder, manifest, frame)), 2u * kSquare * kSquare);
}

TEST_F(CaptureClient, LeavesNothingHalfWritten) {
  std::size_t files = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
    ++files;
  }
  EXPECT_EQ(files, 4u * 4u + 1u);
}

} // namespace taa::capture
