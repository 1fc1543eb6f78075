// What is known of engines and libraries, each with the derivation of its signs. Where a library leaves a
// choice to a flag, its starting point is what holds without the flag, and its notes name the flag.
#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/capture/format/Conventions.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace taa::capture {

namespace {

/// Motion and what is the same of it in all but a few: without jitter, with the camera's, nothing left out.
void setMotion(Conventions& c, MotionDirection direction, ScreenUnit unit, VerticalAxis yAxis) {
  c.motion.direction = direction;
  c.motion.unit = unit;
  c.motion.yAxis = yAxis;
}

void setJitter(Conventions& c, ScreenUnit unit, JitterMeaning meaning, VerticalAxis yAxis) {
  c.jitter.unit = unit;
  c.jitter.meaning = meaning;
  c.jitter.yAxis = yAxis;
}

/// Of engines whose cameras have OpenGL's projection whatever draws with it.
void setGlMatrices(Conventions& c, MatrixOrder order) {
  c.matrices.order = order;
  c.matrices.clipZ = ClipRange::MinusOneToOne;
}

/// Of engines with Direct3D's: rows, and a camera that looks along +z.
void setD3dMatrices(Conventions& c) {
  c.matrices.vectors = VectorSide::Row;
  c.matrices.forward = ForwardAxis::PositiveZ;
}

// Conventions{} is this program; its value of "no previous position" has to be said.
Conventions ownConventions() {
  Conventions c;
  c.motion.notWritten = 65504.0;
  c.motion.fallback = MotionFallback::None;
  return c;
}

// Motion is encoded and 0 where nothing was written, which is all that does not move by itself. The jitter of
// s pixels is added to the third row of a projection for row vectors as (2s.x/W, −2s.y/H); w is +z there, so
// that content moves by s with y down. A unit is a centimeter.
Conventions unrealConventions() {
  Conventions c;
  setMotion(c, MotionDirection::CurrentMinusPrevious, ScreenUnit::Ndc, VerticalAxis::Up);
  c.motion.encoding = MotionEncoding::Unreal;
  c.motion.notWritten = 0.0;
  c.motion.fallback = MotionFallback::Camera;
  setD3dMatrices(c);
  c.matrices.metersPerUnit = 0.01;
  c.color.preExposed = true;
  return c;
}

// URP multiplies T(2j.x/W, 2j.y/H) from the left to a projection whose y is up: content moves by j pixels, y
// up. Camera.projectionMatrix is OpenGL's on every platform; Matrix4x4 lies in columns.
Conventions unityConventions() {
  Conventions c;
  setMotion(c, MotionDirection::CurrentMinusPrevious, ScreenUnit::Uv, VerticalAxis::Down);
  setJitter(c, ScreenUnit::Pixels, JitterMeaning::Content, VerticalAxis::Up);
  setGlMatrices(c, MatrixOrder::ColumnMajor);
  return c;
}

// The jitter, in device coordinates, is added to the fourth column of the matrix that turns OpenGL's clip
// space into Vulkan's and stands left of the projection: content moves by it, y down. Camera projections are
// OpenGL's before that matrix.
Conventions godotConventions() {
  Conventions c;
  setMotion(c, MotionDirection::PreviousMinusCurrent, ScreenUnit::Uv, VerticalAxis::Down);
  setJitter(c, ScreenUnit::Ndc, JitterMeaning::Content, VerticalAxis::Down);
  setGlMatrices(c, MatrixOrder::ColumnMajor);
  return c;
}

// offset · (2, −2)/size is added to the third column where w = −z. Divided by w that is −2·offset.x/W and
// +2·offset.y/H with y up: content moves by minus the offset, y down, so that the sample is what moves.
Conventions bevyConventions() {
  Conventions c;
  setMotion(c, MotionDirection::CurrentMinusPrevious, ScreenUnit::Uv, VerticalAxis::Down);
  setJitter(c, ScreenUnit::Pixels, JitterMeaning::Sample, VerticalAxis::Down);
  c.matrices.order = MatrixOrder::ColumnMajor;
  return c;
}

// Measured: pixel (c, r) shows the picture without jitter at (c + ½ + j.x, r + ½ + j.y), r down.
Conventions threeConventions() {
  Conventions c;
  setMotion(c, MotionDirection::CurrentMinusPrevious, ScreenUnit::Ndc, VerticalAxis::Up);
  setJitter(c, ScreenUnit::Pixels, JitterMeaning::Sample, VerticalAxis::Down);
  c.depth.reversed = false;
  c.depth.nothing = 1.0;
  setGlMatrices(c, MatrixOrder::RowMajor);
  return c;
}

// Measured: content moves by the jitter in clip units, so y is up; what is read after the draw of frame n is
// the jitter of frame n + 1. Depth is z of a view space that looks along −z, drawn without jitter. Matrices
// are rows for row vectors.
Conventions babylonConventions() {
  Conventions c;
  setMotion(c, MotionDirection::PreviousMinusCurrent, ScreenUnit::Uv, VerticalAxis::Up);
  setJitter(c, ScreenUnit::Ndc, JitterMeaning::Content, VerticalAxis::Up);
  c.jitter.delay = 1;
  c.depth.kind = DepthKind::Planar;
  c.depth.scale = -1.0;
  c.depth.nothing = 0.0;
  c.depth.jittered = false;
  setGlMatrices(c, MatrixOrder::RowMajor);
  c.matrices.vectors = VectorSide::Row;
  return normalized(c);
}

// T(2j.x/W, −2j.y/H)·P with y of device coordinates up: content moves by j pixels, y down, as here.
Conventions fsrConventions() {
  Conventions c;
  setMotion(c, MotionDirection::PreviousMinusCurrent, ScreenUnit::Pixels, VerticalAxis::Down);
  c.depth.reversed = false;
  c.color.preExposed = true;
  return c;
}

// P[2][0] += 2j.x/W and P[2][1] −= 2j.y/H in a projection for row vectors, where w = +z: content moves by j
// pixels, y down; the guide says the same as "sample at −j", since a pixel p then shows what lies at p − j.
Conventions xessConventions() {
  Conventions c;
  setMotion(c, MotionDirection::PreviousMinusCurrent, ScreenUnit::Pixels, VerticalAxis::Down);
  c.depth.reversed = false;
  setD3dMatrices(c);
  return c;
}

// mvecScale brings motion to −1…1, and is 1/size for motion in pixels: a motion through the whole picture is
// 1 then, which is texture coordinates.
Conventions streamlineConventions() {
  Conventions c;
  setMotion(c, MotionDirection::PreviousMinusCurrent, ScreenUnit::Uv, VerticalAxis::Down);
  c.depth.reversed = false;
  setD3dMatrices(c);
  return c;
}

// The jitter leads from the jittered picture back to the reference frame: what pixel p shows lies at p + j of
// the picture without jitter, so that the sample is what moves. The origin is top left, y is down.
Conventions metalfxConventions() {
  Conventions c;
  setMotion(c, MotionDirection::PreviousMinusCurrent, ScreenUnit::Pixels, VerticalAxis::Down);
  setJitter(c, ScreenUnit::Pixels, JitterMeaning::Sample, VerticalAxis::Down);
  c.depth.reversed = false;
  c.matrices.order = MatrixOrder::ColumnMajor;
  return c;
}

// Measured: shift_x = j.x/W and shift_y = −j.y/H move content by −j pixels, y down. The sky has motion 0 even
// where the camera turns.
Conventions blenderConventions() {
  Conventions c;
  setMotion(c, MotionDirection::PreviousMinusCurrent, ScreenUnit::Pixels, VerticalAxis::Up);
  c.motion.whereNothing = MotionFallback::Camera;
  setJitter(c, ScreenUnit::Pixels, JitterMeaning::Sample, VerticalAxis::Down);
  c.depth.kind = DepthKind::Planar;
  c.depth.nothing = 1e10;
  setGlMatrices(c, MatrixOrder::RowMajor);
  return normalized(c);
}

} // namespace

std::span<const StartingPoint> startingPoints() {
  static const StartingPoint kPoints[] = {
      {"taa-inspector", "This program",
       "What this program writes. 65504 stands where there is no previous position.", "manual, conventions",
       ownConventions()},
      {"unreal", "Unreal Engine 5",
       "Motion is that of the velocity buffer, in 16 bits without sign; what does not move by itself is 0 "
       "and "
       "is made from depth. Matrices without jitter are those whose names end in NoAA. Projects can draw "
       "motion at other resolutions and encode it without the square root.",
       "Unreal's Common.ush as plugins quote it; second hand", unrealConventions()},
      {"unity", "Unity (URP, HDRP)",
       "HDRP shifts the planes of the frustum, which moves content by minus the jitter: state "
       "jitter.meaning=sample for it. Depth is not reversed with OpenGL. Matrices are those of the camera: "
       "worldToCameraMatrix and nonJitteredProjectionMatrix.",
       "MotionVectorsCommon.hlsl of Unity's Graphics repository", unityConventions()},
      {"godot", "Godot 4",
       "Before 4.2 motion was current − previous, before 4.3 depth was not reversed. Matrices are those of "
       "the "
       "camera, without the correction for Vulkan.",
       "taa_resolve.glsl and projection.cpp of Godot", godotConventions()},
      {"bevy", "Bevy",
       "The jitter is TemporalJitter's offset. Perspective cameras sample at plus the offset; orthographic "
       "ones are to be measured.",
       "taa.wesl and TemporalJitter of Bevy", bevyConventions()},
      {"three", "three.js",
       "For TRAANode on WebGL2. The first frame is drawn without jitter, while the node sets itself up. "
       "Matrix4.elements lies in columns: state matrices.order=columnMajor where they are written as they "
       "are.",
       "measured with r187", threeConventions()},
      {"babylon", "Babylon.js",
       "The jitter that is read after a draw is the next frame's; state jitter.delay=0 where it is read "
       "before. In a left-handed scene depth is positive and the camera looks along +z: state depth.scale=1 "
       "and matrices.forward=positiveZ.",
       "measured with 9.34", babylonConventions()},
      {"fsr", "AMD FSR 2 and 3",
       "Motion is what the texture times motionVectorScale says: state the scale. It is of the output size, "
       "holds jitter, or depth is reversed where the context's flags say so. State the engine's matrices.",
       "docs/techniques/super-resolution-upscaler.md of the FidelityFX SDK", fsrConventions()},
      {"xess", "Intel XeSS 2",
       "Motion is in device coordinates, of the output size or with jitter, and depth is reversed, where the "
       "flags of initialization say so. State the engine's matrices.",
       "doc/xess_sr_developer_guide_english.md of intel/xess", xessConventions()},
      {"streamline", "NVIDIA Streamline (DLSS)",
       "State mvecScale as motion.scaleX and motion.scaleY, and the value of invalid motion as "
       "motion.notWritten. Flags say whether motion holds the camera's and jitter and whether depth is "
       "reversed. The sign of the jitter differs between integrations: measure it.",
       "include/sl_consts.h and docs/ProgrammingGuideDLSS.md of Streamline", streamlineConventions()},
      {"metalfx", "Apple MetalFX",
       "Motion is what the texture times motionVectorScale says: state the scale. Depth is reversed where "
       "isDepthReversed says so. State the engine's matrices.",
       "MTLFXTemporalScalerBase of MetalFX", metalfxConventions()},
      {"blender", "Blender Cycles",
       "Motion is the first two channels of the Vector pass, which is 0 everywhere with motion blur on. The "
       "jitter is what the camera is shifted by, in pixels, y down. The Vector pass of several samples is "
       "their mean, which is mixed at silhouettes.",
       "measured with 3.4", blenderConventions()},
  };
  return kPoints;
}

const StartingPoint& startingPoint(std::string_view id) {
  const std::span<const StartingPoint> points = startingPoints();
  const auto found = std::ranges::find(points, id, &StartingPoint::id);
  if (found != points.end()) return *found;
  std::string ids;
  for (const StartingPoint& point : points) ids += (ids.empty() ? "" : ", ") + std::string(point.id);
  throw Error(say<"there is no starting point \"%1\": give one of %2">(shownText(id), ids));
}

} // namespace taa::capture
