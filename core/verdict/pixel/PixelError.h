// The error of a pixel, split by part and by the frame it came in. No GL.
//
// With W the share that a pixel of an older frame has in today's, α, current color c, history h read from
// texels i with weights w, rectified history h′, and the reference R, that pixel's error out − R is
//   α·(c − R)                              aliasing: samples that are not the mean over the pixel
// + (out − α·c − (1 − α)·h)                rectification's own: h′ − h, and what tone space and rounding add
// + (1 − α)·(Σ w·R_before(i) − R)          what truth itself changed on the way, see below
// + (1 − α)·Σ w·(error of texel i then)    followed on
// The third term is a ghost where history was of something else, else lag and blur (rules and tolerance of
// core/verdict/parts/FrameErrors.h). The terms of all pixels of a frame are added up; where the way ends, the
// error that is left is `Older`. All parts of all frames sum up to the error.
#pragma once

#include "core/base/Progress.h"
#include "core/verdict/parts/ErrorParts.h"
#include "core/verdict/pixel/Evidence.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace taa {

/// By part, scene-linear red, green, blue.
using ErrorSplit = std::array<glm::dvec3, kErrorParts>;

inline glm::dvec3& of(ErrorSplit& split, ErrorPart part) {
  return split[static_cast<std::size_t>(part)];
}
inline const glm::dvec3& of(const ErrorSplit& split, ErrorPart part) {
  return split[static_cast<std::size_t>(part)];
}

/// What came in with one frame.
struct ErrorOfFrame {
  int frame = 0;
  ErrorSplit split{};
  glm::ivec2 pixel{0}; ///< the one that counts most in today's
  // Of the pixel through which most of the ghost came in with this frame; the above where none did.
  glm::ivec2 ghostPixel{0};
  int ghostObject = -1; ///< what history was read of there, in the frame before; −1: no ghost came in
  bool isGhostOfMotion = false; ///< at the surface's own place there was less than half of that ghost
  double weight = 0.0;          ///< share of all its pixels in today's, luma
  bool isBlendedOver = false;   ///< something is blended over what `pixel` shows
  bool isChanging = false;      ///< its material changes without motion
};

struct PixelError {
  int frame = 0;
  glm::ivec2 pixel{0};
  glm::dvec3 resolved{0.0}, reference{0.0};
  std::vector<ErrorOfFrame> frames; ///< latest first; ends where history starts or counts no more
  ErrorSplit sum{};                 ///< of all frames
  glm::dvec3 error() const { return resolved - reference; }
};

PixelError pixelError(EvidenceSource& source, int frame, const glm::ivec2& pixel,
                      const LineageOptions& options = {}, const Progress& progress = {});

} // namespace taa
