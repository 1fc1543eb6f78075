// What depth, matrices and motion say of each other, on frames whose motion follows from the camera.
#include "core/capture/import/DepthValues.h"

#include "core/base/Files.h"
#include "core/capture/import/Guess.h"
#include "tests/unit/capture/import/ImportFixtures.h"

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {

namespace fs = std::filesystem;

namespace {

/// A camera that goes to the right or turns, seen things at rest, in this program's conventions.
struct MovingCamera {
  static constexpr int kFrames = 4, kSkyRows = 12;
  static constexpr double kFocalX = 1.5, kFocalY = 2.0, kNear = 0.1; ///< of square pixels, 128 × 96
  double step = 0.0;                                                 ///< m a frame, along x
  double turn = 0.0;                                                 ///< radians a frame, about y

  static double distance(int x, int y) { return 2.0 + 0.05 * y + 0.4 * std::sin(0.11 * x); }

  /// Rows; the place of a point of the world in view space.
  std::string view(int frame) const {
    const double c = std::cos(frame * turn), s = std::sin(frame * turn);
    const auto text = [](double value) { return std::to_string(value); };
    return "[" + text(c) + ",0," + text(s) + "," + text(-frame * step) + ",0,1,0,0," + text(-s) + ",0," +
           text(c) + ",0,0,0,0,1]";
  }

  /// px, x right, y down, of what is at the pixel.
  glm::dvec2 motion(int x, int y) const {
    if (y < kSkyRows) return {0.0, 0.0}; // not written
    const double z = distance(x, y);
    const glm::dvec2 ndc((2 * x + 1.0) / MovingSquare::kWidth - 1.0,
                         1.0 - (2 * y + 1.0) / MovingSquare::kHeight);
    const glm::dvec3 now(ndc.x / kFocalX * z, ndc.y / kFocalY * z, -z);
    // The view of the frame before is this one turned back, and a step to the left.
    const double c = std::cos(turn), s = std::sin(turn);
    const glm::dvec3 before(c * now.x - s * now.z + step, now.y, s * now.x + c * now.z);
    const glm::dvec2 was(-kFocalX * before.x / before.z, -kFocalY * before.y / before.z);
    return {0.5 * MovingSquare::kWidth * (ndc.x - was.x), -0.5 * MovingSquare::kHeight * (ndc.y - was.y)};
  }

  void write(const fs::path& folder) const {
    fs::remove_all(folder);
    fs::create_directories(folder);
    std::string frames;
    for (int frame = 0; frame < kFrames; ++frame) {
      std::vector<float> values;
      for (int y = 0; y < MovingSquare::kHeight; ++y)
        for (int x = 0; x < MovingSquare::kWidth; ++x) {
          const glm::dvec2 px = motion(x, y);
          const double depth = y < kSkyRows ? 0.0 : kNear / distance(x, y);
          for (const double value : {0.5, 0.5, 0.5, px.x, px.y, depth})
            values.push_back(static_cast<float>(value));
        }
      writeExr(folder / (std::to_string(frame) + ".exr"),
               {"R", "G", "B", "velocity.X", "velocity.Y", "depth.Z"}, values);
      frames += std::string(frame == 0 ? "" : ",") + R"({"frame":)" + std::to_string(frame) + R"(,"view":)" +
                view(frame) + R"(,"projection":[1.5,0,0,0,0,2,0,0,0,0,0,0.1,0,0,-1,0]})";
    }
    writeFile(folder / "frames.json", R"({"near":0.1,"frames":[)" + frames + "]}");
  }
};

class DepthValuesTest : public testing::Test {
 protected:
  ~DepthValuesTest() override { fs::remove_all(folder_); }

  fs::path folder_ = test::temporaryFolder() / "depth";
  MovingCamera camera_;
  /// Pictures of one gray say nothing of motion.
  const std::vector<std::string> motion_ = {"motion.direction=currentMinusPrevious", "motion.unit=pixels",
                                            "motion.yAxis=down"};

  Guess guessed(const std::vector<std::string>& more = {}) {
    camera_.write(folder_);
    std::vector<std::string> assignments = motion_;
    assignments.insert(assignments.end(), more.begin(), more.end());
    return guessCapture(folder_, "", assignments);
  }
};

Finding kindOf(const Guess& guess) {
  const auto found = std::ranges::find(guess.findings, "depth.kind", &Finding::path);
  if (found != guess.findings.end()) return *found;
  ADD_FAILURE() << "depth was not asked about";
  return {};
}

} // namespace

TEST_F(DepthValuesTest, ACameraThatMovesTellsTheKindOfDepth) {
  camera_.step = 0.1;
  const Guess guess = guessed();
  EXPECT_TRUE(kindOf(guess).isSure) << kindOf(guess).reason;
  EXPECT_EQ(guess.manifest.conventions.depth.kind, DepthKind::Window);
  EXPECT_TRUE(guess.manifest.conventions.depth.reversed);
  EXPECT_LT(kindOf(guess).hypotheses.front().residual, 0.005);
}

// What Babylon.js has where nothing is would be the near plane of a depth buffer: import ended with an error.
TEST_F(DepthValuesTest, AnotherKindThanThatOfTheEngineKeepsNoValueForNothing) {
  camera_.step = 0.1;
  camera_.write(folder_);
  const Guess guess = guessCapture(folder_, "babylon", motion_);
  EXPECT_TRUE(kindOf(guess).isSure) << kindOf(guess).reason;
  EXPECT_EQ(guess.manifest.conventions.depth.kind, DepthKind::Window);
  EXPECT_TRUE(guess.manifest.conventions.depth.reversed);
  EXPECT_FALSE(guess.manifest.conventions.depth.nothing.has_value());
}

TEST_F(DepthValuesTest, WhatTheCallerStatesOfDepthStays) {
  camera_.step = 0.1;
  const Guess guess = guessed({"depth.reversed=off"});
  EXPECT_FALSE(guess.manifest.conventions.depth.reversed);
  EXPECT_TRUE(kindOf(guess).contradicts()) << kindOf(guess).reason;
}

// Turning moves what is near as what is far: every kind of depth fits to the last bit, and none is shown.
TEST_F(DepthValuesTest, ACameraThatTurnsTellsNothingOfDepth) {
  camera_.turn = 0.02;
  const Finding kind = kindOf(guessed());
  ASSERT_GT(kind.hypotheses.size(), 1u);
  EXPECT_LT(kind.hypotheses[1].residual, 0.005);
  EXPECT_FALSE(kind.isSure) << kind.reason;
  EXPECT_EQ(kind.reason, "another one fits as well");
}

// What is left of pictures of one gray is rounding, whichever of it is less.
TEST_F(DepthValuesTest, PicturesWithoutDetailTellNothingOfMotion) {
  camera_.step = 0.1;
  for (const Finding& finding : guessed().findings) {
    const bool isOfColor = finding.path != "depth.kind" && finding.path != "motion.whereNothing";
    EXPECT_FALSE(isOfColor && finding.isSure) << finding.question << ": " << finding.reason;
  }
}

TEST_F(DepthValuesTest, ASkyThatStandsStillUnderATurningCameraWasNotWritten) {
  camera_.turn = 0.02;
  const Guess guess = guessed();
  EXPECT_EQ(guess.manifest.conventions.motion.whereNothing, MotionFallback::Camera);
}

TEST_F(DepthValuesTest, FramesWithoutMotionAreLeftOut) {
  camera_.step = 0.1;
  Manifest manifest = guessed().manifest;
  const PlaneSource motion = manifest.planes.at(PlaneKind::Motion);
  manifest.planes.erase(PlaneKind::Motion);
  for (const std::size_t last : {0u, 1u}) {
    for (std::size_t i = 0; i <= last; ++i) manifest.frames[i].planes[PlaneKind::Motion] = motion;
    const std::vector<Finding> findings = measureConventions(folder_, manifest);
    const auto kind = std::ranges::find(findings, "depth.kind", &Finding::path);
    ASSERT_NE(kind, findings.end());
    // Only frame 1 has both motion and a frame before it.
    EXPECT_EQ(kind->hypotheses.empty(), last == 0);
  }
}

} // namespace taa::capture
