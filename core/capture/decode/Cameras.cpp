#include "core/capture/decode/Cameras.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace taa::capture {

namespace {

/// What matrices that went through 32-bit floats leave where there should be 0, relative to their elements.
constexpr double kRounding = 1e-5;

/// What is said of a matrix that cannot be one.
struct Where {
  int frame;
  std::string view, projection;
};

bool isFinite(const glm::dmat4& m) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(m[column][row])) return false;
  return true;
}

/// Of column vectors, from the order and side that are stated; and back, as it is its own inverse.
glm::dmat4 columnVectors(const glm::dmat4& stated, const MatrixConventions& conventions) {
  const bool isRowMajor = conventions.order == MatrixOrder::RowMajor;
  const bool isColumn = conventions.vectors == VectorSide::Column;
  return isRowMajor == isColumn ? glm::transpose(stated) : stated;
}

glm::dmat4 readMatrix(const StatedMatrix& stated, const MatrixConventions& conventions) {
  glm::dmat4 m;
  for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = stated[static_cast<std::size_t>(i)];
  return columnVectors(m, conventions);
}

StatedMatrix written(const glm::dmat4& matrix, const MatrixConventions& conventions) {
  const glm::dmat4 m = columnVectors(matrix, conventions);
  StatedMatrix stated{};
  for (int i = 0; i < 16; ++i) stated[static_cast<std::size_t>(i)] = m[i / 4][i % 4];
  return stated;
}

void negateRow(glm::dmat4& m, int row) {
  for (int column = 0; column < 4; ++column) m[column][row] = -m[column][row];
}

/// Moves the picture by `jitterPx`, x right, y down: T(2jx/W, −2jy/H) · clip.
void jitter(glm::dmat4& clip, const glm::dvec2& jitterPx, const glm::ivec2& sizePx) {
  const glm::dvec2 ndc = glm::dvec2(2.0, -2.0) * (jitterPx / glm::dvec2(sizePx));
  for (int column = 0; column < 4; ++column) {
    clip[column][0] += ndc.x * clip[column][3];
    clip[column][1] += ndc.y * clip[column][3];
  }
}

/// Whether rows of these directions span a space, however long they are.
bool isRegular(double determinant, double lengths) {
  return std::isfinite(lengths) && std::abs(determinant) > 1e-9 * lengths;
}

glm::dmat4 viewFrom(const StatedMatrix& stated, const MatrixConventions& conventions, const Where& where) {
  glm::dmat4 view = readMatrix(stated, conventions);
  if (!isFinite(view))
    throw Error(say<"frame %1: the %2 holds a number that is not finite">(where.frame, where.view));
  const double unit = view[3][3];
  const double largest = std::max({std::abs(view[0][3]), std::abs(view[1][3]), std::abs(view[2][3])});
  if (unit == 0.0 || largest > kRounding * std::abs(unit))
    throw Error(
        say<"frame %1: the last row of the %2 is not 0 0 0 1; set matrices.order or matrices.vectors">(
            where.frame, where.view));
  view /= unit;
  for (int column = 0; column < 4; ++column) view[column][3] = column == 3 ? 1.0 : 0.0;
  const glm::dmat3 turn(view);
  const double lengths = glm::length(turn[0]) * glm::length(turn[1]) * glm::length(turn[2]);
  if (!isRegular(glm::determinant(turn), lengths))
    throw Error(say<"frame %1: the %2 is singular: no camera sees so">(where.frame, where.view));
  if (conventions.forward == ForwardAxis::PositiveZ) negateRow(view, 2);
  const glm::dvec3 place = glm::dvec3(view[3]) * conventions.metersPerUnit;
  view[3] = glm::dvec4(place, 1.0);
  return view;
}

/// Scales a projection so that w is −z or 1, exactly, and brings its lengths to meters.
void normalizeProjection(glm::dmat4& clip, double metersPerUnit, const Where& where) {
  const glm::dvec4 w(clip[0][3], clip[1][3], clip[2][3], clip[3][3]);
  const double largest = std::max({std::abs(w.x), std::abs(w.y), std::abs(w.z), std::abs(w.w)});
  const bool isPerspective = std::abs(w.z) > kRounding * largest;
  const double other = std::max({std::abs(w.x), std::abs(w.y), std::abs(isPerspective ? w.w : w.z)});
  if (largest == 0.0 || other > kRounding * largest)
    throw Error(say<"frame %1: the %2 is neither perspective nor orthographic; set matrices.order or "
                    "matrices.vectors">(where.frame, where.projection));
  if (isPerspective && w.z > 0.0)
    throw Error(say<"frame %1: the %2 looks along the other axis than matrices.forward says">(
        where.frame, where.projection));
  clip /= isPerspective ? -w.z : w.w;
  if (isPerspective)
    clip[3] *= metersPerUnit;
  else
    for (int column = 0; column < 3; ++column) clip[column] /= metersPerUnit;
  for (int column = 0; column < 4; ++column) clip[column][3] = 0.0;
  if (isPerspective)
    clip[2][3] = -1.0;
  else
    clip[3][3] = 1.0;
}

/// Depth is b / distance − a with perspective: where it is at the ends of its range.
void takePerspectiveDepth(StatedCamera& out, ClipRange range, const Where& where) {
  glm::dmat4& clip = out.camera.clipFromView;
  const double a = clip[2][2], b = clip[3][2];
  const double first = a + (range == ClipRange::ZeroToOne ? 0.0 : -1.0), last = a + 1.0;
  const bool isLastNear = last / b > first / b;
  const double nearTerm = isLastNear ? last : first, farTerm = isLastNear ? first : last;
  out.nearPlane = b / nearTerm;
  const bool hasFar = farTerm / nearTerm > 0.0;
  out.farPlane = hasFar ? b / farTerm : kInfinite;
  // Written so that NaN fails it.
  if (!(out.nearPlane > 0.0 && std::isfinite(out.nearPlane) && farTerm / nearTerm > -kRounding))
    throw Error(say<"frame %1: the %2 has no near plane before the camera; set matrices.clipZ">(
        where.frame, where.projection));
  clip[2][2] = 0.0;
  clip[3][2] = out.nearPlane;
}

/// Depth is a · z + b without perspective.
void takeOrthographicDepth(StatedCamera& out, ClipRange range, const Where& where) {
  glm::dmat4& clip = out.camera.clipFromView;
  double a = clip[2][2], b = clip[3][2];
  if (range == ClipRange::MinusOneToOne) {
    a = 0.5 * a;
    b = 0.5 * b + 0.5;
  }
  if (a < 0.0) {
    a = -a;
    b = 1.0 - b;
  }
  out.nearPlane = (b - 1.0) / a;
  out.farPlane = b / a;
  if (!(a > 0.0 && std::isfinite(out.farPlane) && out.farPlane > out.nearPlane))
    throw Error(say<"frame %1: the %2 has no near and far plane">(where.frame, where.projection));
  clip[2][2] = a;
  clip[3][2] = b;
}

void checkProjection(const glm::dmat4& clip, const Where& where) {
  const double across = std::hypot(clip[0][0], clip[1][0]), down = std::hypot(clip[0][1], clip[1][1]);
  if (!isFinite(clip) || !isRegular(clip[0][0] * clip[1][1] - clip[1][0] * clip[0][1], across * down))
    throw Error(say<"frame %1: the %2 is singular: no camera sees so">(where.frame, where.projection));
  const double slant = std::max(std::abs(clip[0][2]), std::abs(clip[1][2]));
  if (slant > kRounding * std::max({std::abs(clip[2][2]), std::abs(clip[3][2]), slant}))
    throw Error(say<"frame %1: the %2 has a slanted near plane; state it with a straight one">(
        where.frame, where.projection));
}

void takeProjection(StatedCamera& out, const StatedMatrix& stated, const Manifest& manifest,
                    const glm::dvec2& jitterPx, const Where& where) {
  const MatrixConventions& conventions = manifest.conventions.matrices;
  glm::dmat4& clip = out.camera.clipFromView;
  clip = readMatrix(stated, conventions);
  if (!isFinite(clip))
    throw Error(say<"frame %1: the %2 holds a number that is not finite">(where.frame, where.projection));
  if (conventions.clipY == VerticalAxis::Down) negateRow(clip, 1);
  if (conventions.forward == ForwardAxis::PositiveZ) clip[2] = -clip[2];
  normalizeProjection(clip, conventions.metersPerUnit, where);
  if (conventions.jittered) jitter(clip, -jitterPx, manifest.sizePx);
  checkProjection(clip, where);
  clip[0][2] = clip[1][2] = 0.0;
  out.camera.orthographic = clip[2][3] == 0.0;
  if (out.camera.orthographic)
    takeOrthographicDepth(out, conventions.clipZ, where);
  else
    takePerspectiveDepth(out, conventions.clipZ, where);
}

/// Expects both matrices.
StatedCamera cameraFrom(const Manifest& manifest, const StatedMatrix& view, const StatedMatrix& projection,
                        const glm::dvec2& jitterPx, const Where& where) {
  const MatrixConventions& conventions = manifest.conventions.matrices;
  if (!(conventions.metersPerUnit > 0.0 && std::isfinite(conventions.metersPerUnit)))
    throw Error(say<"matrices.metersPerUnit is not a length; it is above 0">());
  if (manifest.sizePx.x <= 0 || manifest.sizePx.y <= 0)
    throw Error(say<"the capture's frames have no size">());
  StatedCamera out;
  out.camera.viewFromWorld = viewFrom(view, conventions, where);
  takeProjection(out, projection, manifest, jitterPx, where);
  if (!isFinite(glm::inverse(out.camera.clipFromView * out.camera.viewFromWorld)))
    throw Error(say<"frame %1: the matrices are singular: no camera sees so">(where.frame));
  return out;
}

std::optional<StatedCamera> ownCamera(const Manifest& manifest, const CapturedFrame& frame,
                                      const glm::dvec2& jitterPx) {
  if (!frame.view || !frame.projection) return {};
  const Where where{frame.number, say<"view matrix">(), say<"projection matrix">()};
  return cameraFrom(manifest, *frame.view, *frame.projection, jitterPx, where);
}

/// Jitter that a frame's projections hold; what is not asked for is not read.
glm::dvec2 jitterIn(const Manifest& manifest, std::size_t index) {
  return manifest.conventions.matrices.jittered ? decodeJitter(manifest, index) : glm::dvec2(0.0);
}

/// Expects a frame before `index`.
std::optional<StatedCamera> previousCamera(const Manifest& manifest, std::size_t index) {
  const CapturedFrame& frame = manifest.frames[index];
  const CapturedFrame& before = manifest.frames[index - 1];
  const glm::dvec2 jitterPx = jitterIn(manifest, index - 1);
  if (!frame.previousView && !frame.previousProjection) return ownCamera(manifest, before, jitterPx);
  const std::optional<StatedMatrix>& view = frame.previousView ? frame.previousView : before.view;
  const std::optional<StatedMatrix>& projection =
      frame.previousProjection ? frame.previousProjection : before.projection;
  if (!view || !projection) return {};
  const Where where{frame.number, say<"previous view matrix">(), say<"previous projection matrix">()};
  return cameraFrom(manifest, *view, *projection, jitterPx, where);
}

/// The place of a frame of the manifest, or one with its number; the number of frames: none.
std::size_t indexOf(const Manifest& manifest, const CapturedFrame& frame) {
  const CapturedFrame* first = manifest.frames.data();
  const std::less<const CapturedFrame*> isBefore;
  if (!isBefore(&frame, first) && isBefore(&frame, first + manifest.frames.size()))
    return static_cast<std::size_t>(&frame - first);
  const auto found = std::ranges::find(manifest.frames, frame.number, &CapturedFrame::number);
  return static_cast<std::size_t>(found - manifest.frames.begin());
}

/// Depth terms a and b of a stated projection: see takePerspectiveDepth() and takeOrthographicDepth().
glm::dvec2 encodedDepth(const DecodedCamera& camera, const Conventions& conventions) {
  double a = camera.clipFromView[2][2], b = camera.clipFromView[3][2];
  const double sign = camera.orthographic ? 1.0 : -1.0; // of a, as depth 1 stands for it
  const double farPlane = conventions.depth.farPlane * conventions.matrices.metersPerUnit;
  if (!camera.orthographic && farPlane > 0.0) {
    const double ratio = b / farPlane;
    a = ratio / (1.0 - ratio);
    b = b / (1.0 - ratio);
  }
  // Of depth = ±a + b/d or a·z + b: what stands alone is turned over and moved.
  double& alone = camera.orthographic ? b : a;
  if (!conventions.depth.reversed) {
    a = -a;
    b = -b;
    alone += sign;
  }
  if (conventions.matrices.clipZ == ClipRange::MinusOneToOne) {
    a *= 2.0;
    b *= 2.0;
    alone -= sign;
  }
  return {a, b};
}

} // namespace

std::optional<DecodedCamera> decodeCamera(const Manifest& manifest, const CapturedFrame& frame) {
  const std::size_t index = indexOf(manifest, frame);
  const bool isKnown = index < manifest.frames.size();
  const std::optional<StatedCamera> camera =
      ownCamera(manifest, frame, isKnown ? jitterIn(manifest, index) : glm::dvec2(0.0));
  if (!camera) return {};
  return camera->camera;
}

StatedCameras statedCameras(const Manifest& manifest, std::size_t index) {
  const CapturedFrame& frame = manifest.frames.at(index);
  StatedCameras cameras;
  cameras.now = ownCamera(manifest, frame, jitterIn(manifest, index));
  if (!cameras.now) return cameras;
  const bool startsHistory = index == 0 || frame.cut;
  cameras.previous = startsHistory ? cameras.now : previousCamera(manifest, index);
  return cameras;
}

StatedMatrix withoutJitter(const Manifest& manifest, const StatedMatrix& projection,
                           const glm::dvec2& jitterPx) {
  const MatrixConventions& conventions = manifest.conventions.matrices;
  glm::dmat4 clip = readMatrix(projection, conventions);
  const bool isDown = conventions.clipY == VerticalAxis::Down;
  if (isDown) negateRow(clip, 1);
  jitter(clip, -jitterPx, manifest.sizePx);
  if (isDown) negateRow(clip, 1);
  return written(clip, conventions);
}

CameraMatrices encodedCamera(const Manifest& manifest, const DecodedCamera& camera,
                             const glm::dvec2& jitterPx) {
  const MatrixConventions& conventions = manifest.conventions.matrices;
  glm::dmat4 view = camera.viewFromWorld, clip = camera.clipFromView;
  const glm::dvec2 depth = encodedDepth(camera, manifest.conventions);
  clip[2][2] = depth.x;
  clip[3][2] = depth.y;
  if (conventions.jittered) jitter(clip, jitterPx, manifest.sizePx);
  view[3] = glm::dvec4(glm::dvec3(view[3]) / conventions.metersPerUnit, 1.0);
  if (camera.orthographic)
    for (int column = 0; column < 3; ++column) clip[column] *= conventions.metersPerUnit;
  else
    clip[3] /= conventions.metersPerUnit;
  if (conventions.forward == ForwardAxis::PositiveZ) {
    negateRow(view, 2);
    clip[2] = -clip[2];
  }
  if (conventions.clipY == VerticalAxis::Down) negateRow(clip, 1);
  return {written(view, conventions), written(clip, conventions)};
}

} // namespace taa::capture
