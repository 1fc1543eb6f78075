#include "core/capture/decode/Depth.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/decode/Rows.h"

#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace taa::capture {

namespace {

void checkDepth(const DepthConventions& depth) {
  if (!std::isfinite(depth.scale) || depth.scale == 0.0)
    throw Error(say<"depth.scale is no number that distances can be scaled by; it is not 0">());
  const bool hasNear = std::isfinite(depth.nearPlane) && depth.nearPlane >= 0.0;
  if (!hasNear || !(depth.farPlane >= 0.0))
    throw Error(say<"depth.nearPlane and depth.farPlane are distances; neither is below 0">());
  if (depth.nearPlane > 0.0 && depth.farPlane > 0.0 && depth.farPlane <= depth.nearPlane)
    throw Error(say<"depth.farPlane is nearer than depth.nearPlane; set depth.reversed where depth is">());
}

/// What stands in a window's depth at the far plane.
double farthestOf(const DepthConventions& depth) {
  if (!depth.reversed) return 1.0;
  return depth.range == ClipRange::MinusOneToOne ? -1.0 : 0.0;
}

/// Applies `value` to all pixels: value(stored, x, y).
template <typename Value>
void forPixels(Image& image, const Value& value) {
  forRows(image.height, image.pixels.size(), [&](int first, int end) {
    for (int y = first; y < end; ++y) {
      float* row = image.at(0, y);
      for (int x = 0; x < image.width; ++x) row[x] = value(row[x], x, y);
    }
  });
}

} // namespace

DepthDecoder::DepthDecoder(const Manifest& manifest, const StatedCamera* camera, const glm::dvec2& jitterPx)
    : kind_(manifest.conventions.depth.kind), nothing_(manifest.conventions.depth.nothing) {
  const DepthConventions& depth = manifest.conventions.depth;
  checkDepth(depth);
  if (depth.jittered) jitterPx_ = jitterPx;
  if (camera) {
    hasCamera_ = true;
    isOrthographic_ = camera->camera.orthographic;
    clipFromView_ = camera->camera.clipFromView;
    nearPlane_ = camera->nearPlane;
    rayFromNdc_ = glm::inverse(glm::dmat2(clipFromView_));
    ndcShift_ = isOrthographic_ ? -glm::dvec2(clipFromView_[3]) : glm::dvec2(clipFromView_[2]);
  } else if (depth.nearPlane > 0.0) {
    nearPlane_ = depth.nearPlane * manifest.conventions.matrices.metersPerUnit;
  }
  if (kind_ == DepthKind::Window)
    stateWindow(manifest, camera);
  else
    slope_ = depth.scale * manifest.conventions.matrices.metersPerUnit;
}

void DepthDecoder::stateWindow(const Manifest& manifest, const StatedCamera* camera) {
  const DepthConventions& depth = manifest.conventions.depth;
  const double metersPerUnit = manifest.conventions.matrices.metersPerUnit;
  const bool isStated = depth.nearPlane > 0.0;
  double nearPlane = nearPlane_, farPlane = kInfinite;
  if (isStated) {
    nearPlane = depth.nearPlane * metersPerUnit;
    if (depth.farPlane > 0.0) farPlane = depth.farPlane * metersPerUnit;
  } else if (camera) {
    farPlane = camera->farPlane;
  }
  // Of 0…1 reversed: near is 1, far is 0.
  if (!isOrthographic_) {
    slope_ = (1.0 - nearPlane / farPlane) * (nearPlane_ / nearPlane);
    base_ = (nearPlane / farPlane) * (nearPlane_ / nearPlane);
  } else if (isStated) {
    if (std::isinf(farPlane))
      throw Error(say<"the camera is orthographic; state depth.farPlane beside depth.nearPlane">());
    slope_ = clipFromView_[2][2] * (farPlane - nearPlane);
    base_ = clipFromView_[3][2] - clipFromView_[2][2] * farPlane;
  }
  if (!depth.reversed) {
    base_ += slope_;
    slope_ = -slope_;
  }
  if (depth.range == ClipRange::MinusOneToOne) {
    base_ += 0.5 * slope_;
    slope_ *= 0.5;
  }
  farthest_ = StoredValue(farthestOf(depth));
  isIdentity_ = slope_ == 1.0 && base_ == 0.0 && !depth.nothing;
}

float DepthDecoder::decodedWindow(float stored) const {
  if (nothing_ == stored || farthest_ == stored) return 0.0f;
  const auto depth = static_cast<float>(slope_ * static_cast<double>(stored) + base_);
  return depth <= 0.0f ? 0.0f : depth; // NaN stays
}

double DepthDecoder::depthOf(double planar) const {
  return isOrthographic_ ? clipFromView_[3][2] - clipFromView_[2][2] * planar : nearPlane_ / planar;
}

double DepthDecoder::planarOf(double depth) const {
  return isOrthographic_ ? (clipFromView_[3][2] - depth) / clipFromView_[2][2] : nearPlane_ / depth;
}

double DepthDecoder::raySquare(const Image& depth, int x, int y) const {
  const glm::dvec2 place = (glm::dvec2(x, y) + 0.5 - jitterPx_) / glm::dvec2(depth.width, depth.height);
  const glm::dvec2 ray = rayFromNdc_ * (glm::dvec2(2.0 * place.x - 1.0, 1.0 - 2.0 * place.y) + ndcShift_);
  return ray.x * ray.x + ray.y * ray.y;
}

float DepthDecoder::decodedDistance(const Image& depth, float stored, int x, int y) const {
  if (nothing_ == stored) return 0.0f;
  double distance = slope_ * static_cast<double>(stored);
  if (kind_ == DepthKind::Radial && hasCamera_) {
    const double square = raySquare(depth, x, y);
    distance = isOrthographic_ ? std::sqrt(std::max(0.0, distance * distance - square))
                               : distance / std::sqrt(1.0 + square);
  }
  if (distance <= 0.0) return 0.0f;
  const auto result = static_cast<float>(depthOf(distance));
  return result <= 0.0f ? 0.0f : result; // NaN stays
}

float DepthDecoder::encodedDistance(const Image& depth, float value, int x, int y) const {
  const bool isNothing = value == 0.0f;
  if (isNothing && nothing_.isStated()) return nothing_.value();
  double distance = isNothing ? kInfinite : planarOf(value);
  if (kind_ == DepthKind::Radial && hasCamera_) {
    const double square = raySquare(depth, x, y);
    distance = isOrthographic_ ? std::sqrt(distance * distance + square) : distance * std::sqrt(1.0 + square);
  }
  return static_cast<float>(distance / slope_);
}

float DepthDecoder::encodedWindow(float value) const {
  if (value == 0.0f) return nothing_.isStated() ? nothing_.value() : farthest_.value();
  return static_cast<float>((static_cast<double>(value) - base_) / slope_);
}

void DepthDecoder::decode(Image& depth) const {
  if (isIdentity_) return;
  if (kind_ == DepthKind::Window)
    forPixels(depth, [this](float stored, int, int) { return decodedWindow(stored); });
  else
    forPixels(depth, [&](float stored, int x, int y) { return decodedDistance(depth, stored, x, y); });
}

void DepthDecoder::encode(Image& depth) const {
  if (isIdentity_) return;
  if (kind_ == DepthKind::Window)
    forPixels(depth, [this](float value, int, int) { return encodedWindow(value); });
  else
    forPixels(depth, [&](float value, int x, int y) { return encodedDistance(depth, value, x, y); });
}

} // namespace taa::capture
