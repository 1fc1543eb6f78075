// Sequences of frames drawn by formulas, as an engine of stated conventions would write them.
#pragma once

#include "core/base/Files.h"
#include "core/capture/format/Conventions.h"
#include "core/capture/import/Guess.h"
#include "tests/support/Paths.h"

#include <OpenImageIO/imageio.h>
#include <glm/vec2.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {

/// The first finding about a convention; fails where there is none.
inline Finding findingOf(const std::vector<Finding>& findings, std::string_view path) {
  const auto found = std::ranges::find(findings, path, &Finding::path);
  if (found != findings.end()) return *found;
  ADD_FAILURE() << "nothing was found about " << path;
  return {};
}

/// A textured wall that the camera passes, and a square that moves before it, sampled at points.
struct MovingSquare {
  static constexpr int kWidth = 128, kHeight = 96, kFrames = 5;
  static constexpr double kSquare = 40.0;            ///< px
  glm::dvec2 wallPx{2.3, -1.1}, squarePx{-3.2, 2.4}; ///< a frame, x right, y down

  /// Displacement of content; Halton(2, 3) of the first frames.
  static glm::dvec2 jitterPx(int frame) {
    static constexpr double kX[] = {0.0, -0.25, 0.25, -0.375, 0.125};
    static constexpr double kY[] = {-0.1667, 0.1667, -0.3889, -0.0556, 0.2778};
    return {kX[frame % 5], kY[frame % 5]};
  }
  static double texture(const glm::dvec2& at, double seed) {
    return 0.5 + 0.12 * std::sin(0.71 * at.x + 0.23 * at.y + seed) +
           0.12 * std::sin(0.9 * at.y - 0.31 * at.x) +
           0.1 * std::sin(0.37 * at.x - 0.55 * at.y + 2.0 * seed) + 0.1 * std::sin(0.19 * at.x + 0.13 * at.y);
  }
  bool isSquare(const glm::dvec2& at, int frame) const {
    const glm::dvec2 corner = glm::dvec2(70.0, 20.0) + static_cast<double>(frame) * squarePx;
    const glm::dvec2 in = at - corner;
    return in.x >= 0.0 && in.y >= 0.0 && in.x < kSquare && in.y < kSquare;
  }
  double color(const glm::dvec2& at, int frame) const {
    const bool is = isSquare(at, frame);
    return texture(at - static_cast<double>(frame) * (is ? squarePx : wallPx), is ? 1.3 : 0.0);
  }
};

/// What a stored motion or jitter times is px, x right, y down, content, current − previous.
inline glm::dvec2 unitPx(ScreenUnit unit, VerticalAxis yAxis) {
  glm::dvec2 px(1.0);
  if (unit != ScreenUnit::Pixels) px = {MovingSquare::kWidth, MovingSquare::kHeight};
  if (unit == ScreenUnit::Ndc) px *= 0.5;
  if (yAxis == VerticalAxis::Up) px.y = -px.y;
  return px;
}

inline void writeExr(const std::filesystem::path& file, const std::vector<std::string>& channels,
                     const std::vector<float>& values,
                     const glm::ivec2& sizePx = {MovingSquare::kWidth, MovingSquare::kHeight}) {
  OIIO::ImageSpec spec(sizePx.x, sizePx.y, static_cast<int>(channels.size()), OIIO::TypeFloat);
  spec.channelnames = channels;
  const std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create(file.string());
  ASSERT_TRUE(out && out->open(file.string(), spec));
  ASSERT_TRUE(out->write_image(OIIO::TypeFloat, values.data()));
  ASSERT_TRUE(out->close());
}

/// Values of one frame: red, green, blue, and motion as the conventions have it.
inline std::vector<float> squareFrame(const MovingSquare& scene, const Conventions& stated, int frame) {
  glm::dvec2 px = unitPx(stated.motion.unit, stated.motion.yAxis);
  if (stated.motion.direction == MotionDirection::PreviousMinusCurrent) px = -px;
  std::vector<float> values;
  for (int y = 0; y < MovingSquare::kHeight; ++y)
    for (int x = 0; x < MovingSquare::kWidth; ++x) {
      const glm::dvec2 at = glm::dvec2(x, y) + 0.5 - MovingSquare::jitterPx(frame);
      const auto color = static_cast<float>(scene.color(at, frame));
      const glm::dvec2 motion = (scene.isSquare(at, frame) ? scene.squarePx : scene.wallPx) / px;
      for (int c = 0; c < 3; ++c) values.push_back(color);
      values.push_back(static_cast<float>(motion.x));
      values.push_back(static_cast<float>(motion.y));
    }
  return values;
}

/// frame.0001.exr … and frames.json, whose jitter is as the conventions have it.
inline void writeSquare(const std::filesystem::path& folder, const MovingSquare& scene,
                        const Conventions& stated) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  glm::dvec2 px = unitPx(stated.jitter.unit, stated.jitter.yAxis);
  if (stated.jitter.meaning == JitterMeaning::Sample) px = -px;
  std::string frames;
  for (int frame = 0; frame < MovingSquare::kFrames; ++frame) {
    writeExr(folder / ("frame.000" + std::to_string(frame + 1) + ".exr"),
             {"R", "G", "B", "velocity.X", "velocity.Y"}, squareFrame(scene, stated, frame));
    const glm::dvec2 jitter = MovingSquare::jitterPx(frame) / px;
    frames += std::string(frame == 0 ? "" : ", ") + R"({"frame": )" + std::to_string(frame + 1) +
              R"(, "jitter": [)" + std::to_string(jitter.x) + ", " + std::to_string(jitter.y) + "]}";
  }
  writeFile(folder / "frames.json", R"({"fps": 24, "frames": [)" + frames + "]}");
}

} // namespace taa::capture
