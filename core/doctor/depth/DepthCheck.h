// Whether depth is what it is said to be: with the matrices it makes the motion of what rests, or it does
// not; what hides something else is nearer by it, or it is not; and its values have the form of a projection,
// or another one.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/depth/DepthEnds.h"
#include "core/doctor/depth/DepthForm.h"
#include "core/doctor/depth/DepthOrder.h"
#include "core/doctor/frames/DoctorFrame.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace taa::doctor {

/// How the depth that is stored follows from the true one, which is reversed with its far plane at infinity.
enum class RelationKind : std::uint8_t {
  AsStated,
  NearPlane, ///< by a factor: the near plane is another one
  Reversed,  ///< 1 − depth
  Linear,    ///< it grows with the distance
  HalfRange, ///< ½ + ½ of it: what is stored from 0 to 1 is said to be from −1 to 1
  AlongRay,  ///< of distances from the eye that are said to be those along the axis; the other way around
  AlongAxis,
};

/// A pixel's depth as stored, and the one with which the cameras make the motion given.
struct DepthSample {
  double stored = 0.0, byMotion = 0.0;
  double ray = 1.0; ///< the way from the eye to it, over that along the viewing axis
};

struct DepthRelation {
  RelationKind kind = RelationKind::AsStated;
  double factor = 1.0;   ///< byMotion = factor · f(stored)
  double residual = 0.0; ///< median of |log| of what both sides differ by
};

/// Over all frames.
struct DepthEvidence {
  /// Pixels that the camera's way past them moves, of a motion that some depth makes.
  std::vector<DepthSample> samples;
  std::vector<double> factors; ///< DoctorFrame::distanceFactor, where it is known
  DepthOrder order;            ///< added to by whoever knows regions, as is the form
  DepthForm form;
  DepthEnds ends; ///< likewise, as no camera is asked

  void add(const DoctorFrame& frame);
};

/// All relations, AsStated first. Expects samples.
std::vector<DepthRelation> depthRelations(const std::vector<DepthSample>& samples);

/// How, where depth is clearly the other way around or linear: no mistake of motion looks like that. Where
/// nothing tells the unit of a distance, what is nearest is taken to be at ten near planes.
std::optional<DepthRelation> otherDepth(const DepthEvidence& evidence);
/// By which factor it is that of another near plane, where that is clear.
std::optional<DepthRelation> otherNear(const DepthEvidence& evidence);
/// Makes a frame's depth the one that follows from the stored one. What the same surface had a frame ago is
/// held to be what it has now.
void correctDepth(const DepthRelation& relation, DoctorFrame& frame);

struct DepthCaptureInfo {
  bool isMotionRight = true;      ///< as far as is known; else what hides it is no evidence, as motion tells
  bool isDistance = false;        ///< depth is stated to be a distance, and no device depth
  bool isOfCameraOrDepth = false; ///< see MotionTold
  bool isDepthDrawn = false;      ///< this program's own depth, which follows from its matrices
};
/// What a relation says is wrong, and what to change; without what it rests on.
Finding depthFinding(RelationKind kind);
/// The same of depth that is stated to be a distance and is none.
Finding depthKindFinding();
/// Adds what is wrong where all that is drawn lies at one end of depth, and returns whether it does: then
/// depth says nothing else, and all else is looked at without it. `isDistance`: see DepthCaptureInfo.
bool tellEnds(const DepthEnds& ends, bool isDistance, Diagnosis& out);
/// Adds that the planes that are stated are not those of the matrices, and returns whether they are not.
bool tellNear(const DepthEvidence& evidence, Diagnosis& out);
/// Adds what is wrong, right or not decided about depth; see tellNear() for what is stated of its planes.
void tellDepth(const DepthEvidence& evidence, Diagnosis& out, const DepthCaptureInfo& captureInfo = {});

} // namespace taa::doctor
