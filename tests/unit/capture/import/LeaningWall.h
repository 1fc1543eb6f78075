// Frames of a wall that leans away from a camera that goes sideways, with depth and matrices.
#pragma once

#include "tests/unit/capture/import/ImportFixtures.h"

#include "core/base/Files.h"
#include "core/capture/format/Conventions.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace taa::capture {

/// The wall is where kNear · d + lean.x · x + lean.y · y = 1, d before the camera of frame 0, m.
struct LeaningWall {
  static constexpr double kNear = 0.3;                ///< 1/m
  static constexpr double kSlopeX = 1.5, kSlopeY = 2; ///< of the projection
  glm::dvec2 lean{0.1, 0.25};                         ///< 1/m
  double stepM = 0.06;                                ///< that the camera goes to the right in a frame
  double statedStepM = 0.06;                          ///< the same as matrices state it
  bool isDepthJittered = true;

  /// x and y over distance of a place of the picture without jitter.
  static glm::dvec2 rayAt(const glm::dvec2& place) {
    const glm::dvec2 size(MovingSquare::kWidth, MovingSquare::kHeight);
    return {(2.0 * place.x / size.x - 1.0) / kSlopeX, (1.0 - 2.0 * place.y / size.y) / kSlopeY};
  }
  double distanceAt(const glm::dvec2& place, int frame) const {
    const glm::dvec2 ray = rayAt(place);
    return (1.0 - lean.x * stepM * frame) / (kNear + lean.x * ray.x + lean.y * ray.y);
  }
  /// px, current − previous.
  double motionAt(const glm::dvec2& place, int frame) const {
    return -stepM * kSlopeX / distanceAt(place, frame) * 0.5 * MovingSquare::kWidth;
  }
  double colorAt(const glm::dvec2& place, int frame) const {
    constexpr double kPerM = 30.0;
    const glm::dvec2 at = rayAt(place) * distanceAt(place, frame);
    return MovingSquare::texture(kPerM * glm::dvec2(at.x + stepM * frame, at.y), 0.0);
  }
};

/// Values of one frame: red, green, blue, motion in pixels, and distance along the axis.
inline std::vector<float> wallFrame(const LeaningWall& wall, int frame) {
  std::vector<float> values;
  for (int y = 0; y < MovingSquare::kHeight; ++y)
    for (int x = 0; x < MovingSquare::kWidth; ++x) {
      const glm::dvec2 pixel = glm::dvec2(x, y) + 0.5, seen = pixel - MovingSquare::jitterPx(frame);
      const auto color = static_cast<float>(wall.colorAt(seen, frame));
      const double distance = wall.distanceAt(wall.isDepthJittered ? seen : pixel, frame);
      for (int c = 0; c < 3; ++c) values.push_back(color);
      values.push_back(static_cast<float>(wall.motionAt(seen, frame)));
      values.push_back(0.0f);
      values.push_back(static_cast<float>(distance));
    }
  return values;
}

/// frame.0000.exr … and frames.json with this program's jitter and OpenGL's matrices in rows.
inline void writeWall(const std::filesystem::path& folder, const LeaningWall& wall) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const std::string projection = "[" + std::to_string(LeaningWall::kSlopeX) + ", 0, 0, 0, 0, " +
                                 std::to_string(LeaningWall::kSlopeY) +
                                 ", 0, 0, 0, 0, -1.002002002, -0.2002002002, 0, 0, -1, 0]";
  std::string frames;
  for (int frame = 0; frame < MovingSquare::kFrames; ++frame) {
    writeExr(folder / ("frame.000" + std::to_string(frame) + ".exr"),
             {"R", "G", "B", "velocity.X", "velocity.Y", "depth.Z"}, wallFrame(wall, frame));
    const glm::dvec2 jitter = MovingSquare::jitterPx(frame);
    frames += std::string(frame == 0 ? "" : ", ") + R"({"frame": )" + std::to_string(frame) +
              R"(, "jitter": [)" + std::to_string(jitter.x) + ", " + std::to_string(jitter.y) +
              R"(], "view": [1, 0, 0, )" + std::to_string(-wall.statedStepM * frame) +
              R"(, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], "projection": )" + projection + "}";
  }
  writeFile(folder / "frames.json", R"({"near": 0.1, "far": 100, "frames": [)" + frames + "]}");
}

} // namespace taa::capture
