// Explanations of what motion vectors are instead of what they are said to be, each with the motion that
// pixels would have if it were right.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/motion/OtherCameras.h"
#include "core/settings/Faults.h"

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa::doctor {

/// What is stored as motion m of a pixel, beside what it truly moves by; in the order in which they are
/// tried: those that say most before those that say little.
enum class MotionKind : std::uint8_t {
  AsGiven,
  Resting,   ///< the pixels do not move over the screen
  MirroredX, ///< x has the other sign; likewise y, both
  MirroredY,
  Opposite,
  SwappedAxes,
  TurnedLeft, ///< what pixels move by is (−y, x) of m; (y, −x)
  TurnedRight,
  JitterOfThis, ///< m holds the jitter of this frame; of the frame before; the difference of both
  JitterOfPrevious,
  JitterOfBoth,
  JitterTakenOff, ///< the difference was taken off though m had none; likewise that of this frame alone, of
                  ///< the frame before
  JitterOfThisTakenOff,
  JitterOfPreviousTakenOff,
  FrameLate,    ///< m is that of the frame before
  FrameEarly,   ///< m is that of the frame after
  Forward,      ///< m is what the surface moves by until the frame after
  Scaled,       ///< m is too long or too short by one factor for both axes
  LacksCamera,  ///< m is without the camera's motion
  CameraTwice,  ///< m holds the camera's motion twice
  Encoded,      ///< m is ½ + ½ of what it should be, in shares of the picture
  Root,         ///< m is the root of what it should be, in shares of the picture
  OtherUnit,    ///< by a factor that the picture's size explains
  TwoFramesOld, ///< m goes back two frames
  CameraTurned, ///< m was made with a previous camera that is turned; moved; mirrored; never set
  CameraBeside,
  CameraMirrored,
  CameraIdentity,
  CameraUnzoomed, ///< m was made with this frame's projection for the previous position, too
  CameraUnmoved,  ///< m was made as if the previous camera had stood where this one stands; likewise as if it
  CameraUnturned, ///< had looked the same way
  OfCamera, ///< the pixels move as what rests in the world does: whatever is wrong with that, this fits it
};

struct MotionTrial {
  MotionKind kind = MotionKind::AsGiven;
  glm::vec2 factor{1.0f}; ///< of Scaled, OtherUnit: the true motion is m times it
  bool isDevice = false;  ///< of OtherUnit: device coordinates, not those of a texture
};

/// What the true motion is made of, if an explanation is right.
enum class MotionMadeOf : std::uint8_t {
  Given,
  Screen,  ///< nothing: it is 0
  Factors, ///< factors times m
  Curve,   ///< m, not in proportion to it
  Jitter,  ///< m and shares of the jitters of both frames
  OtherFrame,
  Camera,     ///< depth and the matrices of both frames, or these and m
  OtherCamera ///< m less what depth and matrices make with another camera than theirs
};

struct FrameNeighbors;

/// A fault that the table of faults does not have, as nothing injects it.
struct OwnFault {
  std::string_view id, name, symptom;
};

/// All that is known of each kind: a row is an explanation.
struct MotionRow {
  MotionKind kind;
  std::string_view id, text; ///< for files, for people; of one with a factor of its own the text is empty
  MotionMadeOf madeOf = MotionMadeOf::Given;
  /// What a pixel moves by if it is so, px; null: by factors or shares.
  std::optional<glm::vec2> (*motion)(const FrameNeighbors& frames, const glm::ivec2& pixel) = nullptr;
  /// Of Factors, unless the trial has them: what true x has of x and of y, and true y of x and of y. Of
  /// Jitter: how many times the jitter of this frame, and of the one before, are added.
  std::array<float, 4> shares{};
  /// What makes such frames right, as --set takes it; empty: see motionCorrection().
  std::array<std::string_view, 2> correction{};
  /// What it is called and what one sees: of the table of faults, or its own; none where that depends on the
  /// region, see motionFault().
  std::optional<Fault> fault{};
  OwnFault own{};
  std::string_view change{}; ///< a sentence: what to do
};
const MotionRow& motionRow(MotionKind kind);
MotionMadeOf madeOf(MotionKind kind);

/// What m is multiplied with; nothing where it is no product.
std::optional<glm::dmat2> factorsOf(const MotionTrial& trial);

/// Of all kinds in their order, for pictures of a size.
std::vector<MotionTrial> motionTrials(const glm::ivec2& sizePx);

/// "jitterOfThis", for files; of Scaled with its factor, "scaled:0.5".
std::string trialId(const MotionTrial& trial);
/// For people: "y negated".
std::string trialText(const MotionTrial& trial);

/// A frame, the one before it, and the one after it where there is one.
struct FrameNeighbors {
  const DoctorFrame& now;
  const DoctorFrame& before;
  const DoctorFrame* after = nullptr;
  OtherCameras others{}; ///< of `now`

  /// What is added to a place of now to find the same place before, besides −motion, px.
  glm::vec2 jitterStep() const { return before.jitterPx - now.jitterPx; }
};

/// Of the distance: what is so much nearer hides a surface, whatever depth is rounded to; or, where it is
/// known to be another one, whatever lies before it at all.
inline constexpr float kHiddenShare = 0.9f, kHiddenByOtherShare = 0.995f;
/// Whether something nearer lay at `before`, a pixel of the frame before, than what a pixel shows; or the sky
/// is now where it was not. False where no depth tells.
bool wasHidden(const FrameNeighbors& frames, const glm::ivec2& pixel, const glm::ivec2& before,
               float share = kHiddenShare);

/// What a pixel moves by if the trial is right, px; nothing where it says nothing.
std::optional<glm::vec2> trueMotion(const MotionTrial& trial, const FrameNeighbors& frames,
                                    const glm::ivec2& pixel);

} // namespace taa::doctor
