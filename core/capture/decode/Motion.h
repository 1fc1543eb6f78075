// A plane of motion in a capture's conventions, in this program's and back.
#pragma once

#include "core/base/Image.h"
#include "core/capture/decode/CameraMotion.h"
#include "core/capture/decode/StoredValue.h"
#include "core/capture/format/Manifest.h"

#include <glm/vec2.hpp>

#include <optional>

namespace taa::capture {

/// Unreal: sign(v) · √(2|v|) · kUnrealSlope + kUnrealRest, v in NDC, in 16 bits; 0 is kept for what is not
/// written.
inline constexpr double kUnrealSlope = 0.2495, kUnrealRest = 32767.0 / 65535.0;

/// What motion is made of besides its own plane.
struct MotionInputs {
  glm::dvec2 jitterPx{0.0}, previousJitterPx{0.0};
  const Image* depth = nullptr;         ///< this program's, as large as motion; null: not known
  const CameraMotion* camera = nullptr; ///< null: not known
};

class MotionDecoder {
 public:
  /// Throws Error where conventions cannot be. `inputs` are used as long as this.
  MotionDecoder(const Manifest& manifest, const MotionInputs& inputs);

  /// In place: two channels.
  void decode(Image& motion) const;
  void encode(Image& motion) const;

 private:
  template <MotionEncoding kEncoding>
  void decodeRow(float* row, int width, int y) const;
  void encodeRow(float* row, int width, int y) const;
  glm::vec2 encoded(const glm::vec2& motionPx, int x, int y) const;
  glm::vec2 fallback(MotionFallback kind, int x, int y) const;
  glm::vec2 cameraMotion(int x, int y) const;

  MotionConventions conventions_;
  MotionInputs inputs_;
  glm::dvec2 pxPerValue_; ///< of what is decoded
  glm::dvec2 jitterLeft_; ///< px that stored motion holds besides motion
  StoredValue notWritten_;
  bool isIdentity_ = false;
};

} // namespace taa::capture
