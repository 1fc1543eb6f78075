// Small captures made by hand: planes of given values, and matrices as the documents of engines print them.
#pragma once

#include "core/capture/decode/DecodedFrame.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace taa::capture {

inline PlaneData planeFrom(int width, int height, int channels, const std::vector<float>& values) {
  PlaneData plane;
  plane.image = Image(width, height, channels);
  for (std::size_t i = 0; i < plane.image.pixels.size(); ++i)
    plane.image.pixels[i] = values[i % values.size()];
  plane.width = width;
  plane.height = height;
  return plane;
}

/// A capture with color in all of its frames, which are numbered from 0.
inline Manifest manifestOf(const Conventions& conventions, const glm::ivec2& sizePx, std::size_t frames = 2) {
  Manifest manifest;
  manifest.conventions = conventions;
  manifest.sizePx = sizePx;
  manifest.planes[PlaneKind::Color].file = "color.{frame}.raw";
  manifest.frames.resize(frames);
  for (std::size_t i = 0; i < frames; ++i) manifest.frames[i].number = static_cast<int>(i);
  return manifest;
}

inline FramePlanes planesOf(const Manifest& manifest) {
  FramePlanes planes;
  planes[PlaneKind::Color] = planeFrom(manifest.sizePx.x, manifest.sizePx.y, 3, {0.25f, 0.5f, 2.0f});
  return planes;
}

/// Frames of an engine's starting point.
inline Manifest manifestLike(std::string_view id, const glm::ivec2& sizePx, std::size_t frames = 2) {
  return manifestOf(startingPoint(id).conventions, sizePx, frames);
}

/// A projection as it lies in memory; a and b are its slopes, in units of the world.
namespace projections {

/// glFrustum's reference page, in rows for column vectors.
inline StatedMatrix gl(double a, double b, double n, double f) {
  return {a, 0, 0, 0, 0, b, 0, 0, 0, 0, -(f + n) / (f - n), -2.0 * f * n / (f - n), 0, 0, -1, 0};
}
/// D3DXMatrixPerspectiveLH, in rows for row vectors.
inline StatedMatrix d3d(double a, double b, double n, double f) {
  return {a, 0, 0, 0, 0, b, 0, 0, 0, 0, f / (f - n), 1, 0, 0, -n * f / (f - n), 0};
}
/// Direct3D's with reversed depth and without a far plane, as Unreal has it.
inline StatedMatrix d3dReversed(double a, double b, double n) {
  return {a, 0, 0, 0, 0, b, 0, 0, 0, 0, 0, 1, 0, 0, n, 0};
}
/// Depth 0…1 looking along −z, in rows for column vectors.
inline StatedMatrix zeroToOne(double a, double b, double n, double f) {
  return {a, 0, 0, 0, 0, b, 0, 0, 0, 0, -f / (f - n), -n * f / (f - n), 0, 0, -1, 0};
}
/// Reversed without a far plane, in rows for column vectors: this program's.
inline StatedMatrix reversed(double a, double b, double n) {
  return {a, 0, 0, 0, 0, b, 0, 0, 0, 0, 0, n, 0, 0, -1, 0};
}

} // namespace projections

inline StatedMatrix transposed(const StatedMatrix& m) {
  StatedMatrix result{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column) result[4 * row + column] = m[4 * column + row];
  return result;
}

/// A view that only moves, in rows for column vectors.
inline StatedMatrix moveBy(double x, double y, double z) {
  return {1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1};
}

/// Near 0.1 m, far 100 m, slopes 1 and 2, as each engine states it.
struct EngineCamera {
  StatedMatrix view, projection;
};

/// Of a camera at (1, 2, 3) m that looks along its forward axis of the world.
inline EngineCamera engineCamera(std::string_view id) {
  const StatedMatrix view = moveBy(-1, -2, -3);
  if (id == "taa-inspector") return {view, projections::reversed(1, 2, 0.1)};
  if (id == "bevy") return {transposed(view), transposed(projections::reversed(1, 2, 0.1))};
  if (id == "unreal") return {transposed(moveBy(-100, -200, -300)), projections::d3dReversed(1, 2, 10)};
  if (id == "xess" || id == "streamline") return {transposed(view), projections::d3d(1, 2, 0.1, 100)};
  if (id == "fsr") return {view, projections::zeroToOne(1, 2, 0.1, 100)};
  if (id == "metalfx") return {transposed(view), transposed(projections::zeroToOne(1, 2, 0.1, 100))};
  if (id == "three" || id == "blender") return {view, projections::gl(1, 2, 0.1, 100)};
  // Unity, Godot: columns in memory; Babylon: rows for row vectors, which are the same numbers.
  return {transposed(view), transposed(projections::gl(1, 2, 0.1, 100))};
}

} // namespace taa::capture
