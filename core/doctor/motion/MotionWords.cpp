#include "core/doctor/motion/MotionWords.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/decode/ScreenUnits.h"
#include "core/settings/Faults.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

/// One that the table of faults has.
FaultWords ofTable(Fault fault, std::string change) {
  const FaultInfo& row = faultInfo(fault);
  return {std::string(row.id), std::string(row.label), std::string(row.symptom), std::move(change)};
}

FaultWords ofOwn(const OwnFault& fault, std::string change) {
  return {std::string(fault.id), std::string(fault.name), std::string(fault.symptom), std::move(change)};
}

FaultWords unwrittenFault(const Region& region) {
  if (region.isSky)
    return ofTable(Fault::SkyWithoutMotion,
                   say<"Write motion where nothing is drawn, too: that of the camera for points infinitely "
                       "far away. Or let the resolve rebuild it from depth and matrices there.">());
  return ofTable(Fault::MotionZero,
                 say<"Write motion for it: draw it in the pass that writes motion, with the transforms of "
                     "this frame and of the one before.">());
}

FaultWords scaledFault(const MotionTrial& trial) {
  const bool isOfUnits = trial.factor.x == 0.5f || trial.factor.x == 2.0f;
  const std::string factor = shortNumber(static_cast<double>(trial.factor.x));
  const std::string change =
      isOfUnits
          ? say<"Multiply the motion that you write by %1, or state the unit that it has: the picture is 2 "
                "device coordinates wide, and 1 texture coordinate.">(factor)
          : say<"Multiply the motion that you write by %1.">(factor);
  if (trial.factor.x == 0.5f)
    return ofTable(Fault::MotionDoubled,
                   change + " " +
                       say<"Where it is so for one object alone, its previous transform may be two frames "
                           "old: keep that of the frame before.">());
  if (trial.factor.x == 2.0f) return ofTable(Fault::MotionHalved, change);
  return lengthWords(change);
}

FaultWords unitFault(const MotionTrial& trial) {
  const std::string change = say<"Multiply the motion that you write by %1, or state the unit that it has.">(
      shortVector(glm::dvec2(trial.factor)));
  if (std::abs(trial.factor.x) <= 1.0f)
    return {"motionUnit", say<"Motion of another unit">(),
            say<"History comes from outside of the picture: nothing accumulates while anything moves.">(),
            change};
  return ofTable(trial.isDevice ? Fault::MotionInNdc : Fault::MotionInUv, change);
}

/// Motion that is not the camera's, and by what other camera it is made.
FaultWords wrongCameraFault(Fault fault) {
  if (fault == Fault::CameraTurned)
    return ofTable(fault,
                   say<"It rests in the world, and its motion is the camera's and the same amount more: make "
                       "it with the view of the frame before, unchanged.">());
  return ofTable(fault, say<"It rests in the world, and its motion is that of a camera beside this one: make "
                            "it with the matrices of the frame before of the same view.">());
}

FaultWords cameraFault(const Region& region, const RegionEvidence& evidence, bool areCamerasRight) {
  if (isUnwritten(evidence)) return unwrittenFault(region);
  // A matrix that is wrong is so for all that a pass draws.
  if (const auto fault = areCamerasRight ? std::nullopt : wrongCamera(evidence))
    return wrongCameraFault(*fault);
  return {
      "motionNotCameras", say<"Motion of what rests is not the camera's">(),
      say<"A double image of what rests.">(),
      areCamerasRight
          ? say<"It rests in the world, and its motion is not that of the camera, which is right elsewhere: "
                "make it with the same matrices, and let nothing transparent before it write its own.">()
          : say<"It rests in the world, and its motion is not that of the camera: make it with the matrices "
                "of the frame before, of the same camera and pass.">()};
}

FaultWords lacksCameraFault(const Region& region, const RegionEvidence& evidence) {
  if (isUnwritten(evidence)) return unwrittenFault(region);
  return ofTable(Fault::MotionWithoutCamera,
                 say<"Add the camera's motion: the previous matrix has to be that of the frame before, not "
                     "this frame's.">());
}

/// Whether what is given is the camera's motion, or 0, at most of its pixels.
bool isOfCameraAlone(const RegionEvidence& evidence) {
  constexpr double kMost = 0.6;
  const std::size_t ofCamera = std::max(evidence.ofCamera, evidence.zero);
  return evidence.pixels == 0 ||
         static_cast<double>(ofCamera) >= kMost * static_cast<double>(evidence.pixels);
}

/// Whether its motion is 0 in some frames and not in others.
bool isAtTimesZero(const RegionEvidence& evidence) {
  const auto rests = [](const PairTrace& trace) { return trace.pixels > 0 && trace.lengthPx == 0.0; };
  const auto resting = std::ranges::count_if(evidence.traces, rests);
  return resting >= 2 && std::ssize(evidence.traces) - resting >= 2;
}

/// "1, 3, 5 …": frames in which it is.
std::string zeroFrames(const RegionEvidence& evidence, const FrameNames& names) {
  std::vector<int> zero, asked;
  for (const PairTrace& trace : evidence.traces) {
    if (trace.pixels == 0) continue;
    asked.push_back(trace.frame);
    if (trace.lengthPx == 0.0) zero.push_back(trace.frame);
  }
  return names.of(zero, asked);
}

FaultWords atTimesZeroFault(const RegionEvidence& evidence, const FrameNames& names) {
  return {
      "motionAtTimesZero", say<"Motion 0 in some frames of what moves in all">(),
      say<"It trembles, and ghosts in every other frame.">(),
      say<"In %1 its motion is 0: its transform, or what is made of it, is brought up to date less often than it is "
          "drawn. Make motion of the two transforms that it is drawn with.">(zeroFrames(evidence, names))};
}

FaultWords searchedFault(const Region& region, const RegionEvidence& evidence, const FrameNames& names) {
  if (isAtTimesZero(evidence)) return atTimesZeroFault(evidence, names);
  if (isUnwritten(evidence)) return unwrittenFault(region);
  if (!isOfCameraAlone(evidence)) return unknownMotion();
  return ofTable(Fault::MotionCameraOnly,
                 say<"Its motion is the camera's alone, and it moves by itself: write motion with its own "
                     "previous transform, skin or vertex animation.">());
}

} // namespace

FaultWords motionFault(const MotionTrial* trial, const Region& region, const RegionEvidence& evidence,
                       const FrameNames& names, bool areCamerasRight) {
  if (!trial) return searchedFault(region, evidence, names);
  if (trial->kind == MotionKind::OfCamera) return cameraFault(region, evidence, areCamerasRight);
  if (trial->kind == MotionKind::LacksCamera) return lacksCameraFault(region, evidence);
  if (trial->kind == MotionKind::Scaled) return scaledFault(*trial);
  if (trial->kind == MotionKind::OtherUnit) return unitFault(*trial);
  const MotionRow& row = motionRow(trial->kind);
  return row.fault ? ofTable(*row.fault, std::string(row.change)) : ofOwn(row.own, std::string(row.change));
}

FaultWords lengthWords(std::string change) {
  return {"motionScaled", say<"Motion of another length">(), say<"Ghosts grow with speed.">(),
          std::move(change)};
}

FaultWords turnedWords(std::string change) {
  return ofOwn(motionRow(MotionKind::TurnedLeft).own, std::move(change));
}

FaultWords unknownMotion() {
  return {
      std::string(kUnknownMotionId), say<"Motion that none of the known mistakes explains">(),
      say<"Ghosts or smears where and when it is wrong.">(),
      say<"Look at how motion is made of these objects in these frames: what is drawn, with which transforms, into "
          "which target.">()};
}

void nameBy(const FaultWords& fault, Finding& out) {
  out.id = fault.id;
  out.name = fault.name;
  out.symptom = fault.symptom;
  out.change = fault.change;
}

std::optional<MotionTrial> axesBesideUnit(const MotionTrial& trial, const CaptureInfo& captureInfo) {
  if (trial.kind != MotionKind::OtherUnit) return {};
  // Device coordinates point up, where nothing is stated of their axes.
  const bool isUp = trial.isDevice && std::abs(trial.factor.x) > 1.0f && !captureInfo.conventions;
  const bool isLeft = trial.factor.x < 0.0f, isOtherY = (trial.factor.y < 0.0f) != isUp;
  if (isLeft && isOtherY) return MotionTrial{MotionKind::Opposite};
  if (isLeft) return MotionTrial{MotionKind::MirroredX};
  if (isOtherY) return MotionTrial{MotionKind::MirroredY};
  return {};
}

MotionTrial unitAlone(const MotionTrial& trial, const MotionTrial& axes) {
  MotionTrial out = trial;
  if (axes.kind != MotionKind::MirroredY) out.factor.x = -out.factor.x;
  if (axes.kind != MotionKind::MirroredX) out.factor.y = -out.factor.y;
  return out;
}

glm::dvec2 storedMotion(const CaptureInfo& captureInfo, const glm::dvec2& motionPx) {
  if (!captureInfo.conventions) return motionPx;
  const capture::MotionConventions& motion = captureInfo.conventions->motion;
  glm::dvec2 perValue = motion.scale * capture::pxPerUnit(motion.unit, motion.yAxis, captureInfo.sizePx);
  if (motion.unit == capture::ScreenUnit::Pixels && motion.pixelOf == capture::PixelOf::Output)
    perValue *= glm::dvec2(captureInfo.sizePx) / glm::dvec2(captureInfo.outputPx);
  if (motion.direction == capture::MotionDirection::PreviousMinusCurrent) perValue = -perValue;
  const bool hasOffset = motion.encoding == capture::MotionEncoding::Offset;
  return motionPx / perValue + (hasOffset ? motion.offset : glm::dvec2(0.0));
}

std::string motionExample(const CaptureInfo& captureInfo, const RegionEvidence& evidence, std::size_t trial) {
  const MotionExample& example = evidence.example;
  if (trial >= example.byTrial.size() || !example.byTrial[trial]) return {};
  const glm::dvec2 given = storedMotion(captureInfo, glm::dvec2(example.given));
  const glm::dvec2 should = storedMotion(captureInfo, glm::dvec2(*example.byTrial[trial]));
  const bool isEncoded =
      captureInfo.conventions && captureInfo.conventions->motion.encoding == capture::MotionEncoding::Unreal;
  const std::string place = say<"at pixel %1, %2 of frame %3">(example.pixel.x, example.pixel.y,
                                                               captureInfo.frameNames.of(example.frame));
  if (isEncoded)
    return say<"For example %1 you write what decodes to %2; the pictures show %3.">(
        place, shortVector(given), shortVector(should));
  return say<"For example %1 you write %2; the pictures show %3.">(place, shortVector(given),
                                                                   shortVector(should));
}

Undecided contradictedMatrices(const MotionTrial& trial, const std::string& names, bool isMisfit) {
  return {
      say<"Depth and matrices">(),
      say<"the motion of %1 is not what they make, and would be if it were taken like this: %2; but the "
          "pictures fit it as it is, as they do where something moves by itself">(names, trialText(trial)),
      say<"State matrices and depth as they are used, or let these rest.">(),
      {},
      isMisfit};
}

Undecided undecidedMotion(MotionVerdict verdict, const RegionPlace& place, const RegionEvidence& evidence) {
  Undecided out{say<"Motion of %1">(place.name), {}, {}};
  const double movedPx = evidence.pixels == 0 ? 0.0 : evidence.givenPx / static_cast<double>(evidence.pixels);
  switch (verdict) {
  case MotionVerdict::Right:
  case MotionVerdict::Wrong:
    break;
  case MotionVerdict::TooSmall:
    out.reason =
        say<"only %1 of its pixels can be followed, in %2 pairs of frames">(evidence.pixels, evidence.pairs);
    out.capture = say<"Bring the camera nearer to it, or capture more and larger frames.">();
    break;
  case MotionVerdict::Still:
    out.reason =
        say<"it moves by %1 px a frame in the mean: all explanations say the same">(shortNumber(movedPx));
    out.capture = say<"Let it, or the camera, move by some pixels a frame.">();
    break;
  case MotionVerdict::NoTexture:
    out.reason = say<"it has too little detail to tell one place from another">();
    out.capture = say<"Put a texture with fine detail on it.">();
    break;
  case MotionVerdict::Doubtful:
    out.reason = say<"another explanation fits a little better than the motion given, and none clearly">();
    out.capture = say<"Let it move by some pixels a frame, before the camera and in even light.">();
    out.isMisfit = true;
    break;
  case MotionVerdict::Contradicted:
    out.reason = say<"neither the motion given nor another explanation fits: its light, its material or what "
                     "lies over it changes more than motion can tell">();
    out.capture = say<"Keep lights and materials as they are, and nothing transparent before it.">();
    out.isMisfit = true;
    break;
  }
  return out;
}

} // namespace taa::doctor
