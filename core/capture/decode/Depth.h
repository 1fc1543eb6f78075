// A plane of depth in a capture's conventions, in this program's and back.
#pragma once

#include "core/base/Image.h"
#include "core/capture/decode/Cameras.h"
#include "core/capture/decode/StoredValue.h"
#include "core/capture/format/Manifest.h"

#include <glm/mat2x2.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace taa::capture {

/// What depth is made of where a capture has no matrices and states no planes, m; see
/// DecodedFrame::nearPlane.
inline constexpr double kUnknownNearPlane = 0.1;

class DepthDecoder {
 public:
  /// `camera`: null where matrices are not stated. Throws Error where conventions cannot be.
  DepthDecoder(const Manifest& manifest, const StatedCamera* camera, const glm::dvec2& jitterPx);

  double nearPlane() const { return nearPlane_; }
  /// In place: one channel.
  void decode(Image& depth) const;
  void encode(Image& depth) const;

 private:
  void stateWindow(const Manifest& manifest, const StatedCamera* camera);
  float decodedWindow(float stored) const;
  float encodedWindow(float value) const;
  float decodedDistance(const Image& depth, float stored, int x, int y) const;
  float encodedDistance(const Image& depth, float value, int x, int y) const;
  /// Square of what a pixel's ray goes sideways for 1 along the axis; orthographic: how far from the axis it
  /// is.
  double raySquare(const Image& depth, int x, int y) const;
  double depthOf(double planar) const;
  double planarOf(double depth) const;

  DepthKind kind_;
  bool isOrthographic_ = false, hasCamera_ = false, isIdentity_ = false;
  double nearPlane_ = kUnknownNearPlane; ///< m
  double slope_ = 1.0, base_ = 0.0; ///< Window: depth = slope · stored + base; else distance = slope · stored
  StoredValue nothing_, farthest_;
  glm::dmat4 clipFromView_{1.0}; ///< with hasCamera_
  glm::dmat2 rayFromNdc_{1.0};   ///< likewise
  glm::dvec2 ndcShift_{0.0};
  glm::dvec2 jitterPx_{0.0}; ///< of what depth shows
};

} // namespace taa::capture
