#include "core/doctor/source/OtherConventions.h"

#include "core/base/Say.h"
#include "core/capture/decode/ScreenUnits.h"
#include "core/doctor/depth/DepthCheck.h"
#include "core/doctor/jitter/JitterCheck.h"
#include "core/doctor/motion/MotionWords.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace taa::doctor {

namespace {

using capture::Conventions;
using capture::JitterInMotion;
using capture::ScreenUnit;
using capture::VerticalAxis;

Finding motionFinding(const MotionTrial& trial) {
  Finding out;
  nameBy(motionFault(&trial, Region(), RegionEvidence()), out);
  return out;
}

Finding matricesFinding(std::string id, std::string name) {
  Finding out;
  out.id = std::move(id);
  out.name = std::move(name);
  out.isWholePicture = true;
  out.symptom = say<"Whatever is made of depth and matrices, as motion of the sky, goes the wrong way.">();
  return out;
}

template <typename Value>
Value otherOf(Value now, Value one, Value two) {
  return now == one ? two : one;
}

void turnY(VerticalAxis& axis) {
  axis = otherOf(axis, VerticalAxis::Up, VerticalAxis::Down);
}

void addUnits(const Conventions& stated, const glm::ivec2& sizePx, std::vector<Otherwise>& out) {
  for (const ScreenUnit unit : {ScreenUnit::Pixels, ScreenUnit::Uv, ScreenUnit::Ndc}) {
    if (unit == stated.motion.unit) continue;
    const auto perUnit = [&](ScreenUnit of) { return capture::pxPerUnit(of, VerticalAxis::Down, sizePx); };
    MotionTrial trial{MotionKind::OtherUnit, glm::vec2(perUnit(unit) / perUnit(stated.motion.unit))};
    trial.isDevice = unit == ScreenUnit::Ndc || stated.motion.unit == ScreenUnit::Ndc;
    if (unit != ScreenUnit::Pixels && stated.motion.unit != ScreenUnit::Pixels)
      trial.kind = MotionKind::Scaled;
    out.push_back(
        {StatedGroup::MotionUnit, [unit](Conventions& c) { c.motion.unit = unit; }, motionFinding(trial)});
  }
}

void addAxes(std::vector<Otherwise>& out) {
  out.push_back({StatedGroup::MotionAxes,
                 [](Conventions& c) {
                   using capture::MotionDirection;
                   c.motion.direction = otherOf(c.motion.direction, MotionDirection::CurrentMinusPrevious,
                                                MotionDirection::PreviousMinusCurrent);
                 },
                 motionFinding({MotionKind::Opposite})});
  out.push_back({StatedGroup::MotionAxes, [](Conventions& c) { turnY(c.motion.yAxis); },
                 motionFinding({MotionKind::MirroredY})});
  out.push_back({StatedGroup::MotionAxes, [](Conventions& c) { c.motion.scale.x = -c.motion.scale.x; },
                 motionFinding({MotionKind::MirroredX})});
}

void addCamera(const Conventions& stated, std::vector<Otherwise>& out) {
  const bool has = stated.motion.includesCamera;
  out.push_back({StatedGroup::MotionCamera, [has](Conventions& c) { c.motion.includesCamera = !has; },
                 motionFinding({has ? MotionKind::LacksCamera : MotionKind::CameraTwice}), !has, has});
}

/// Whose jitter motion holds: of this frame and the one before.
glm::ivec2 heldJitter(JitterInMotion kind) {
  switch (kind) {
  case JitterInMotion::Removed:
    break;
  case JitterInMotion::Both:
    return {1, -1};
  case JitterInMotion::Current:
    return {1, 0};
  case JitterInMotion::Previous:
    return {0, -1};
  }
  return {0, 0};
}

/// What is wrong with motion that holds more or less of it than is taken off.
std::optional<MotionKind> jitterKind(const glm::ivec2& held) {
  const std::pair<glm::ivec2, MotionKind> kinds[] = {
      {{1, -1}, MotionKind::JitterOfBoth},         {{1, 0}, MotionKind::JitterOfThis},
      {{0, -1}, MotionKind::JitterOfPrevious},     {{-1, 1}, MotionKind::JitterTakenOff},
      {{-1, 0}, MotionKind::JitterOfThisTakenOff}, {{0, 1}, MotionKind::JitterOfPreviousTakenOff}};
  for (const auto& [of, kind] : kinds)
    if (of == held) return kind;
  return {};
}

void addJitter(const Conventions& stated, std::vector<Otherwise>& out) {
  for (const JitterInMotion jitter :
       {JitterInMotion::Removed, JitterInMotion::Both, JitterInMotion::Current, JitterInMotion::Previous}) {
    const auto kind = jitterKind(heldJitter(jitter) - heldJitter(stated.motion.jitter));
    if (kind)
      out.push_back({StatedGroup::MotionJitter, [jitter](Conventions& c) { c.motion.jitter = jitter; },
                     motionFinding({*kind}), stated.motion.jitter != JitterInMotion::Removed});
  }
  using capture::JitterMeaning;
  const auto turn = [](Conventions& c) {
    c.jitter.meaning = otherOf(c.jitter.meaning, JitterMeaning::Content, JitterMeaning::Sample);
  };
  const auto turnJitterY = [](Conventions& c) { turnY(c.jitter.yAxis); };
  out.push_back({StatedGroup::JitterSign, turn, jitterFinding({JitterKind::Opposite}), true});
  out.push_back({StatedGroup::JitterSign, turnJitterY, jitterFinding({JitterKind::MirroredY}), true});
  out.push_back({StatedGroup::JitterSign,
                 [turn, turnJitterY](Conventions& c) {
                   turn(c);
                   turnJitterY(c);
                 },
                 jitterFinding({JitterKind::MirroredX}), true});
  if (stated.jitter.delay > -1)
    out.push_back({StatedGroup::JitterFrame, [](Conventions& c) { --c.jitter.delay; },
                   jitterFinding({JitterKind::FrameLate}), true});
  if (stated.jitter.delay < 1)
    out.push_back({StatedGroup::JitterFrame, [](Conventions& c) { ++c.jitter.delay; },
                   jitterFinding({JitterKind::FrameEarly}), true});
}

/// `lowest`: of what is stored. Depth of another range makes the same motion as matrices of another one do:
/// of the two that can be wrong which what is stored lies in.
bool isOtherRange(const Conventions& stated, float lowest) {
  return stated.depth.kind == capture::DepthKind::Window &&
         (stated.depth.range == capture::ClipRange::ZeroToOne) == (lowest < 0.0f);
}

/// Of a depth buffer, either way around; and distances along the axis, on either side of the camera.
void addDepthKinds(const Conventions& stated, float lowest, std::vector<Otherwise>& out) {
  using capture::DepthConventions;
  const DepthConventions& depth = stated.depth;
  if (depth.kind == capture::DepthKind::Window) {
    out.push_back({StatedGroup::DepthKind,
                   [lowest](Conventions& c) {
                     DepthConventions distance;
                     distance.kind = capture::DepthKind::Planar;
                     distance.scale = lowest < 0.0f ? -1.0 : 1.0;
                     distance.nothing = c.depth.nothing;
                     distance.jittered = c.depth.jittered;
                     c.depth = distance;
                   },
                   depthFinding(RelationKind::Linear)});
    return;
  }
  for (const bool isReversed : {true, false})
    out.push_back({StatedGroup::DepthKind,
                   [isReversed, lowest](Conventions& c) {
                     DepthConventions window;
                     window.reversed = isReversed;
                     window.range =
                         lowest < 0.0f ? capture::ClipRange::MinusOneToOne : capture::ClipRange::ZeroToOne;
                     window.jittered = c.depth.jittered;
                     c.depth = window;
                   },
                   depthKindFinding(), true});
}

void addDepth(const Conventions& stated, float lowest, std::vector<Otherwise>& out) {
  addDepthKinds(stated, lowest, out);
  if (stated.depth.kind != capture::DepthKind::Window) return;
  using capture::ClipRange;
  out.push_back({StatedGroup::DepthOrder, [](Conventions& c) { c.depth.reversed = !c.depth.reversed; },
                 depthFinding(RelationKind::Reversed)});
  if (!isOtherRange(stated, lowest)) return;
  Finding range = depthFinding(RelationKind::HalfRange);
  if (stated.depth.range == ClipRange::ZeroToOne)
    range.change = say<"State that depth is stored from −1 to 1: it is not from 0 to 1.">();
  out.push_back({StatedGroup::DepthRange,
                 [](Conventions& c) {
                   c.depth.range = otherOf(c.depth.range, ClipRange::ZeroToOne, ClipRange::MinusOneToOne);
                 },
                 std::move(range), true});
}

void addMatrices(const Conventions& stated, float lowest, std::vector<Otherwise>& out) {
  using capture::ClipRange;
  out.push_back(
      {StatedGroup::ClipAxis, [](Conventions& c) { turnY(c.matrices.clipY); }, matricesFlipped({})});
  if (isOtherRange(stated, lowest)) return;
  const bool isFrom0 = stated.matrices.clipZ == ClipRange::ZeroToOne;
  Finding range = matricesFinding("matricesRange", say<"Matrices of another range of depth">());
  range.change = isFrom0 ? say<"State that z of clip space goes from −1 to 1, as OpenGL's does.">()
                         : say<"State that z of clip space goes from 0 to 1, as that of Direct3D, Vulkan and "
                               "Metal does.">();
  out.push_back({StatedGroup::ClipRange,
                 [](Conventions& c) {
                   c.matrices.clipZ =
                       otherOf(c.matrices.clipZ, ClipRange::ZeroToOne, ClipRange::MinusOneToOne);
                 },
                 std::move(range), true});
}

bool statesJitter(const capture::Manifest& manifest) {
  return std::ranges::any_of(manifest.frames,
                             [](const auto& frame) { return frame.jitter != glm::dvec2(0.0); });
}

/// All that has a y.
void turnAxes(Conventions& conventions) {
  turnY(conventions.motion.yAxis);
  turnY(conventions.jitter.yAxis);
  turnY(conventions.matrices.clipY);
}

/// Planes are read once: what is stored from the other end has another y in all that has one.
void addRows(const Conventions& stated, std::vector<Otherwise>& out) {
  out.push_back({StatedGroup::Rows, turnAxes, rowsTurned(stated.rows)});
  out.back().isOfSeveral = true;
}

} // namespace

std::vector<Otherwise> othersThan(const capture::Manifest& manifest, float lowestDepth) {
  const Conventions& stated = manifest.conventions;
  std::vector<Otherwise> out;
  addUnits(stated, manifest.sizePx, out);
  addAxes(out);
  addCamera(stated, out);
  if (statesJitter(manifest)) addJitter(stated, out);
  addDepth(stated, lowestDepth, out);
  addMatrices(stated, lowestDepth, out);
  addRows(stated, out);
  return out;
}

void turnRows(capture::Conventions& conventions) {
  using capture::RowOrder;
  turnAxes(conventions);
  conventions.rows = otherOf(conventions.rows, RowOrder::TopFirst, RowOrder::BottomFirst);
}

Finding rowsTurned(capture::RowOrder stated) {
  Finding out;
  out.id = "rowsTurned";
  out.name = say<"Rows from the other end">();
  out.isWholePicture = true;
  out.symptom = say<"The picture is upside down; moved by its motion it breaks up.">();
  out.change = stated == capture::RowOrder::TopFirst ? say<"State that rows are stored from the bottom on.">()
                                                     : say<"State that rows are stored from the top on.">();
  return out;
}

Finding matricesFlipped(std::string reason) {
  Finding out = matricesFinding("matricesFlipped", say<"Matrices upside down">());
  out.reason = std::move(reason);
  out.change = say<"State that y of clip space goes the other way, or negate the second row of the "
                   "projection.">();
  return out;
}

} // namespace taa::doctor
