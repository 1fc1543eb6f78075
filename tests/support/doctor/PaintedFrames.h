// Frames of a shot whose every pixel has a known place and motion: a textured ground that the camera passes,
// a board that moves before it, and a plain sky.
#pragma once

#include "core/doctor/examination/Doctor.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace taa::test {

inline constexpr glm::ivec2 kPaintedPx{160, 96};
inline constexpr std::uint32_t kGroundId = 1, kBoardId = 2;

/// What moves in the shot, px a frame, x right and y down; the camera's motion is that of ground and sky.
struct PaintedShot {
  glm::dvec2 cameraPx{2.25, -1.5}, boardPx{1.5, 3.0}; ///< the board's besides the camera's
  bool isJittered = true;                             ///< Halton 2, 3
  bool isBoardTextured = true;
  double change = 0.0;                    ///< of both speeds from frame to frame, px
  std::optional<double> boardChange = {}; ///< of the board's alone; nothing: it slows by as much
};

/// As a healthy engine gives it.
doctor::DoctorFrame paintedFrame(const PaintedShot& shot, int frame);

/// What an engine does wrong to a frame.
using FrameFault = std::function<void(doctor::DoctorFrame&)>;

/// Of `frames` frames of the shot, with a fault or none.
doctor::Examination paintedExamination(const PaintedShot& shot, int frames, const FrameFault& fault = {});

/// Changes the motion of the pixels of an object; 0: of the sky.
void changeMotion(doctor::DoctorFrame& frame, std::uint32_t objectId,
                  const std::function<glm::vec2(const glm::vec2&)>& change);

/// Ids of findings, in their order: "motionZero, jitterLate".
std::string idsOf(const doctor::Diagnosis& diagnosis);

} // namespace taa::test
