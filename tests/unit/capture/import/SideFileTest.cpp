// What matrices and JSON beside pictures show of their conventions, on matrices written from the definitions.
#include "core/capture/import/SideFile.h"

#include "core/base/Files.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace taa::capture {

namespace fs = std::filesystem;

namespace {

/// Rows of column vectors.
constexpr StatedMatrix kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
constexpr StatedMatrix kAside = {1, 0, 0, -3, 0, 1, 0, -2, 0, 0, 1, -7, 0, 0, 0, 1};

/// Looks along −z; z/w is `atInfinity` far away and `atInfinity` + `slope`/distance at a distance.
StatedMatrix perspective(double atInfinity, double slope) {
  return {1.2, 0, 0, 0, 0, 2.1, 0, 0, 0, 0, -atInfinity, slope, 0, 0, -1, 0};
}

StatedMatrix transposed(const StatedMatrix& matrix) {
  StatedMatrix out{};
  for (std::size_t i = 0; i < 16; ++i) out[i] = matrix[4 * (i % 4) + i / 4];
  return out;
}

SideFrames framesWith(const StatedMatrix& view, const StatedMatrix& projection) {
  SideFrames frames;
  frames.frames[0].view = view;
  frames.frames[0].projection = projection;
  return frames;
}

/// OpenGL's, with near 0.1 and far 100: z/w = (f + n)/(f − n) − 2fn/(f − n)/distance.
const StatedMatrix kOpenGl = perspective(100.1 / 99.9, -20.0 / 99.9);

} // namespace

TEST(SideFile, SeesTheOrderByThePlaceOfTheCamera) {
  const SeenMatrices rows = matricesOf(framesWith(kAside, kOpenGl), 0.1, {});
  EXPECT_TRUE(rows.isOrderSeen);
  EXPECT_EQ(rows.conventions.order, MatrixOrder::RowMajor);
  const SeenMatrices columns = matricesOf(framesWith(transposed(kAside), transposed(kOpenGl)), 0.1, {});
  EXPECT_TRUE(columns.isOrderSeen);
  EXPECT_EQ(columns.conventions.order, MatrixOrder::ColumnMajor);
}

TEST(SideFile, SeesTheOrderByTheProjectionOfACameraAtTheOrigin) {
  const SeenMatrices rows = matricesOf(framesWith(kIdentity, kOpenGl), 0.1, {});
  EXPECT_TRUE(rows.isOrderSeen);
  EXPECT_EQ(rows.conventions.order, MatrixOrder::RowMajor);
  const SeenMatrices columns = matricesOf(framesWith(kIdentity, transposed(kOpenGl)), 0.1, {});
  EXPECT_TRUE(columns.isOrderSeen);
  EXPECT_EQ(columns.conventions.order, MatrixOrder::ColumnMajor);
  EXPECT_EQ(columns.conventions.clipZ, ClipRange::MinusOneToOne);
}

TEST(SideFile, SeesTheOrderByAnyFrame) {
  SideFrames frames = framesWith(kIdentity, transposed(perspective(0.0, 1.0)));
  frames.frames[1].view = transposed(kAside);
  frames.frames[1].projection = frames.frames[0].projection;
  const SeenMatrices seen = matricesOf(frames, 0.0, {});
  EXPECT_TRUE(seen.isOrderSeen);
  EXPECT_EQ(seen.conventions.order, MatrixOrder::ColumnMajor);
}

// With the near plane at 1, z and w of a reversed, infinite projection have the same numbers in either order.
TEST(SideFile, LeavesTheOrderThatCannotBeSeen) {
  MatrixConventions start;
  start.order = MatrixOrder::ColumnMajor;
  const SeenMatrices seen = matricesOf(framesWith(kIdentity, transposed(perspective(0.0, 1.0))), 1.0, start);
  EXPECT_FALSE(seen.isOrderSeen);
  EXPECT_EQ(seen.conventions.order, MatrixOrder::ColumnMajor);
}

// Rows of row vectors lie as columns of column vectors do: an engine's own way to say it stays.
TEST(SideFile, KeepsTheSideOfVectorsThatLieTheSame) {
  MatrixConventions start;
  start.vectors = VectorSide::Row;
  const SeenMatrices seen = matricesOf(framesWith(transposed(kAside), transposed(kOpenGl)), 0.1, start);
  EXPECT_EQ(seen.conventions.order, MatrixOrder::RowMajor);
  EXPECT_EQ(seen.conventions.vectors, VectorSide::Row);
  EXPECT_EQ(matricesOf(framesWith(kAside, kOpenGl), 0.1, start).conventions.vectors, VectorSide::Column);
}

TEST(SideFile, SeesWhereClipSpaceBeginsByTheNearPlane) {
  const auto seen = [](const StatedMatrix& projection, double nearPlane) {
    return matricesOf(framesWith(kAside, projection), nearPlane, {});
  };
  EXPECT_EQ(seen(kOpenGl, 0.1).conventions.clipZ, ClipRange::MinusOneToOne);
  // f/(f − n) − fn/(f − n)/distance
  EXPECT_EQ(seen(perspective(100.0 / 99.9, -10.0 / 99.9), 0.1).conventions.clipZ, ClipRange::ZeroToOne);
  // Reversed and infinite: n/distance, and −1 + 2n/distance.
  EXPECT_EQ(seen(perspective(0.0, 0.1), 0.1).conventions.clipZ, ClipRange::ZeroToOne);
  EXPECT_EQ(seen(perspective(-1.0, 0.2), 0.1).conventions.clipZ, ClipRange::MinusOneToOne);
  EXPECT_TRUE(seen(kOpenGl, 0.1).isClipZSeen);
  EXPECT_FALSE(seen(kOpenGl, 0.0).isClipZSeen);
  EXPECT_FALSE(seen(kOpenGl, 10.0).isClipZSeen) << "no range puts the near plane there";
}

TEST(SideFile, LeavesWhatAProjectionWithoutPerspectiveDoesNotShow) {
  MatrixConventions start;
  start.forward = ForwardAxis::PositiveZ;
  start.clipZ = ClipRange::MinusOneToOne;
  const StatedMatrix orthographic = {0.1, 0, 0, 0, 0, 0.2, 0, 0, 0, 0, -0.01, 0.5, 0, 0, 0, 1};
  const SeenMatrices seen = matricesOf(framesWith(kIdentity, transposed(orthographic)), 0.1, start);
  EXPECT_TRUE(seen.isOrderSeen);
  EXPECT_EQ(seen.conventions.order, MatrixOrder::ColumnMajor);
  EXPECT_FALSE(seen.isForwardSeen);
  EXPECT_EQ(seen.conventions.forward, ForwardAxis::PositiveZ);
  EXPECT_EQ(seen.conventions.clipZ, ClipRange::MinusOneToOne);
}

TEST(SideFile, KnowsKeysHoweverTheyAreWritten) {
  const fs::path folder = test::temporaryFolder() / "side";
  fs::create_directories(folder);
  writeFile(folder / "a.json", R"({"Clip start": 0.5, "Frames": [{"Frame Number": 7, "jitterUv": {"x": 0.25,
"Y": -0.5}, "cameraCut": true, "elements": 3}, {"frame_number": 8, "jitter_uv": [0, 0.125],
"pre-exposure": 0}], "Object IDs": ["nothing", "door"]})");
  const std::optional<SideFile> side = readSideFile(folder, "a.json");
  fs::remove_all(folder);
  ASSERT_TRUE(side && side->lists.size() == 1);
  EXPECT_EQ(side->nearPlane, 0.5);
  const SideFrames& frames = side->lists[0];
  EXPECT_TRUE(frames.isNumbered && frames.hasJitter);
  EXPECT_EQ(frames.jitterUnit, ScreenUnit::Uv);
  EXPECT_EQ(frames.frames.at(7).jitter, glm::dvec2(0.25, -0.5));
  EXPECT_TRUE(frames.frames.at(7).cut);
  EXPECT_EQ(frames.frames.at(8).jitter, glm::dvec2(0.0, 0.125));
  EXPECT_EQ(frames.frames.at(8).preExposure, 1.0) << "0 is none";
  EXPECT_EQ(side->objects, (std::map<std::uint32_t, std::string>{{1, "door"}})) << "0 is no object";
}

} // namespace taa::capture
