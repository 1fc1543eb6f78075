// Frames that real engines wrote: the motion they stored is that of the camera wherever nothing moves by
// itself.
#include "core/base/Files.h"
#include "core/capture/decode/DecodedFrame.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace taa::capture {
namespace {

namespace fs = std::filesystem;

StatedMatrix matrixFrom(const nlohmann::json& rows) {
  StatedMatrix matrix{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column) matrix[4 * row + column] = rows[row][column];
  return matrix;
}

Manifest manifestFrom(const nlohmann::json& frames, const std::string& like) {
  Manifest manifest;
  manifest.conventions = startingPoint(like).conventions;
  manifest.sizePx = {480, 270};
  for (const nlohmann::json& stated : frames) {
    CapturedFrame frame;
    frame.number = stated["frame"];
    frame.jitter = {stated["jitter_px"][0].get<double>(), stated["jitter_px"][1].get<double>()};
    frame.view = matrixFrom(stated["view"]);
    frame.projection = matrixFrom(stated["projection_unjittered"]);
    manifest.frames.push_back(frame);
  }
  return manifest;
}

/// Of the pixels that are not sky, how far stored motion is from that of the camera, px; sorted.
std::vector<float> residuals(const fs::path& folder, Manifest manifest, std::size_t index) {
  FramePlanes planes = readPlanes(folder, manifest, manifest.frames[index]);
  const DecodedFrame stored = decode(manifest, index, planes);
  planes.erase(PlaneKind::Motion);
  const DecodedFrame rebuilt = decode(manifest, index, planes);
  std::vector<float> differences;
  for (std::size_t i = 0; i < stored.depth.pixels.size(); ++i)
    if (stored.depth.pixels[i] > 0.0f)
      differences.push_back(std::hypot(stored.motion.pixels[2 * i] - rebuilt.motion.pixels[2 * i],
                                       stored.motion.pixels[2 * i + 1] - rebuilt.motion.pixels[2 * i + 1]));
  std::ranges::sort(differences);
  return differences;
}

} // namespace

TEST(RealFrames, MotionOfBlenderIsThatOfItsCamera) {
  const fs::path folder = fs::path(TAA_SHARED_DATA) / "capture-blender";
  if (!fs::exists(folder)) GTEST_SKIP() << "no shared data at " << TAA_SHARED_DATA;
  const nlohmann::json json = nlohmann::json::parse(readFile(folder / "frames.json"));
  Manifest manifest = manifestFrom(json["taa"]["frames"], "blender");
  const std::string file = "taa/workshop.{frame:4}.exr";
  manifest.planes[PlaneKind::Color] = {
      file, "", {"ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B"}, {}, {}, 0, {}};
  manifest.planes[PlaneKind::Motion] = {file, "", {"ViewLayer.Vector.X", "ViewLayer.Vector.Y"}, {}, {},
                                        0,    {}};
  manifest.planes[PlaneKind::Depth] = {file, "", {"ViewLayer.Depth.Z"}, {}, {}, 0, {}};
  const std::vector<float> px = residuals(folder, manifest, 5);
  ASSERT_GT(px.size(), 80000u);
  // The data's own README: at most 2e-4 px where nothing moves by itself, which is most of the picture.
  EXPECT_LT(px[px.size() / 2], 2e-4f);
}

TEST(RealFrames, MotionOfThreeIsThatOfItsCamera) {
  const fs::path folder = fs::path(TAA_SHARED_DATA) / "capture-three";
  if (!fs::exists(folder)) GTEST_SKIP() << "no shared data at " << TAA_SHARED_DATA;
  const nlohmann::json json = nlohmann::json::parse(readFile(folder / "frames.json"));
  Manifest manifest = manifestFrom(json["frames"], "three");
  const std::string file = "frame.{frame:4}.exr";
  manifest.planes[PlaneKind::Color] = {file, "", {"R", "G", "B"}, {}, {}, 0, {}};
  manifest.planes[PlaneKind::Motion] = {file, "", {"velocity.X", "velocity.Y"}, {}, {}, 0, {}};
  manifest.planes[PlaneKind::Depth] = {file, "", {"depth.Z"}, {}, {}, 0, {}};
  const std::vector<float> px = residuals(folder, manifest, 5);
  // The camera rests.
  EXPECT_LT(px[px.size() / 2], 0.003f);
}

} // namespace taa::capture
