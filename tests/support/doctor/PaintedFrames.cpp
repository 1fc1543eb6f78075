#include "tests/support/doctor/PaintedFrames.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace taa::test {

namespace {

constexpr double kHorizon = 16.0; ///< row at frame 0; it moves with the camera
constexpr double kBoardLeft = 70.0, kBoardTop = 40.0, kBoardSide = 36.0;
constexpr float kGroundDepth = 0.01f, kBoardDepth = 0.02f; // near plane 0.1 m: at 10 and 5 m

/// Waves of a few pixels' length whose sum does not repeat in the picture, 0 to 1.
double paint(const glm::dvec2& place, double seed) {
  constexpr std::array<std::array<double, 3>, 5> kWaves = {
      {{0.9, 0.3, 0.0}, {-0.4, 0.8, 1.3}, {0.55, 0.71, 2.1}, {0.21, -0.37, 0.4}, {1.1, -0.95, 3.0}}};
  double sum = 0.0;
  for (const auto& wave : kWaves)
    sum += std::sin(wave[0] * place.x + wave[1] * place.y + wave[2] + seed * wave[0]);
  return 0.5 + 0.08 * sum;
}

/// How far something has moved at a frame of a speed that changes evenly.
glm::dvec2 movedPx(const glm::dvec2& stepPx, double change, int frame) {
  return stepPx * static_cast<double>(frame) + 0.5 * change * static_cast<double>(frame) * (frame + 1);
}
glm::dvec2 stepAt(const glm::dvec2& stepPx, double change, int frame) {
  return stepPx + change * static_cast<double>(frame);
}

glm::vec2 halton(int frame) {
  const auto radical = [](int index, int base) {
    float value = 0.0f, share = 1.0f;
    for (; index > 0; index /= base) {
      share /= static_cast<float>(base);
      value += share * static_cast<float>(index % base);
    }
    return value;
  };
  return {radical(frame % 8 + 1, 2) - 0.5f, radical(frame % 8 + 1, 3) - 0.5f};
}

} // namespace

doctor::DoctorFrame paintedFrame(const PaintedShot& shot, int frame) {
  const glm::ivec2 size = kPaintedPx;
  doctor::DoctorFrame out;
  out.frame = frame;
  out.startsHistory = frame == 0;
  if (shot.isJittered) out.jitterPx = halton(frame);
  out.depthJitterPx = out.jitterPx;
  out.luma = Image(size.x, size.y, 1);
  out.motionPx = Image(size.x, size.y, 2);
  out.depth = out.depthView = out.previousDepthView = Image(size.x, size.y, 1);
  out.objectId.assign(static_cast<std::size_t>(size.x) * size.y, 0);
  const glm::dvec2 camera = stepAt(shot.cameraPx, shot.change, frame);
  const glm::dvec2 cameraMoved = movedPx(shot.cameraPx, shot.change, frame);
  const double boardChange = shot.boardChange.value_or(-shot.change);
  const glm::dvec2 board = camera + stepAt(shot.boardPx, boardChange, frame);
  const glm::dvec2 boardMoved = cameraMoved + movedPx(shot.boardPx, boardChange, frame);
  // The previous picture's device coordinates are this one's less the camera's motion.
  out.previousClipFromClip =
      glm::translate(glm::mat4(1.0f), glm::vec3(-2.0 * camera.x / size.x, 2.0 * camera.y / size.y, 0.0));
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::dvec2 place = glm::dvec2(x, y) + 0.5 - glm::dvec2(out.jitterPx);
      const glm::dvec2 onBoard = place - boardMoved - glm::dvec2(kBoardLeft, kBoardTop);
      const bool isBoard =
          onBoard.x >= 0.0 && onBoard.y >= 0.0 && onBoard.x < kBoardSide && onBoard.y < kBoardSide;
      const bool isSky = !isBoard && place.y - cameraMoved.y < kHorizon;
      const std::size_t i = static_cast<std::size_t>(y) * size.x + x;
      const glm::vec2 motion(isBoard ? board : camera);
      out.motionPx.pixels[2 * i] = motion.x;
      out.motionPx.pixels[2 * i + 1] = motion.y;
      out.objectId[i] = isBoard ? kBoardId : isSky ? 0 : kGroundId;
      out.depth.pixels[i] = isBoard ? kBoardDepth : isSky ? 0.0f : kGroundDepth;
      out.depthView.pixels[i] = out.previousDepthView.pixels[i] = isBoard ? 5.0f : isSky ? 0.0f : 10.0f;
      const double plain = 0.3;
      out.luma.pixels[i] = static_cast<float>(isBoard ? (shot.isBoardTextured ? paint(onBoard, 40.0) : plain)
                                                      : (isSky ? plain : paint(place - cameraMoved, 0.0)));
    }
  return out;
}

doctor::Examination paintedExamination(const PaintedShot& shot, int frames, const FrameFault& fault) {
  doctor::Examination out;
  out.frames = frames;
  out.captureInfo.objectNames = {{kGroundId, "ground"}, {kBoardId, "board"}};
  out.read = [shot, fault](int frame) {
    doctor::DoctorFrame painted = paintedFrame(shot, frame);
    if (fault) fault(painted);
    return painted;
  };
  return out;
}

void changeMotion(doctor::DoctorFrame& frame, std::uint32_t objectId,
                  const std::function<glm::vec2(const glm::vec2&)>& change) {
  for (std::size_t i = 0; i < frame.objectId.size(); ++i) {
    if (frame.objectId[i] != objectId) continue;
    float* motion = frame.motionPx.pixels.data() + 2 * i;
    const glm::vec2 changed = change({motion[0], motion[1]});
    motion[0] = changed.x;
    motion[1] = changed.y;
  }
}

std::string idsOf(const doctor::Diagnosis& diagnosis) {
  std::string text;
  for (const doctor::Finding& finding : diagnosis.findings) text += (text.empty() ? "" : ", ") + finding.id;
  return text;
}

} // namespace taa::test
