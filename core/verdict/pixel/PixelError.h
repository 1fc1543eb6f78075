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
//
// Which frame truth changed in says when a ghost came in, not what is seen in it: on the way a surface may be
// crossed that is darker than what lies behind and before it. That is told by the samples: with w the share
// that a sample s has in today's color, less what rectification replaced (core/verdict/lineage), and today's
// reference R, those beyond a ghost pull today's color by Σ w·(s − R) from it, each for its object.
#pragma once

#include "core/base/Progress.h"
#include "core/verdict/parts/ErrorParts.h"
#include "core/verdict/pixel/Evidence.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <optional>
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

/// Frames that verdicts follow an error over.
inline constexpr int kFollowedFrames = 16;

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
  int passedBy = -1; ///< object in one of the eight around `pixel` that moves otherwise; −1: none does
};

/// Samples of one frame and one object that history was read of instead of today's surface.
struct OutlierSamples {
  int frame = 0;
  int object = 0;       ///< 0: the sky
  glm::dvec3 pull{0.0}; ///< Σ w·(s − R), scene-linear
  double weight = 0.0;  ///< Σ w of all samples of the frame, mean of the channels
};

/// Where most of an error lies that is older than the frames that were followed.
struct OlderPlace {
  int frame = 0;
  glm::ivec2 pixel{0};
};

struct PixelError {
  int frame = 0;
  glm::ivec2 pixel{0};
  glm::dvec3 resolved{0.0}, reference{0.0};
  std::vector<ErrorOfFrame> frames; ///< latest first; ends where history starts or counts no more
  ErrorSplit sum{};                 ///< of all frames
  /// Latest first, of a frame by object. What is left before the last frame counts as a sample of what it
  /// showed then.
  std::vector<OutlierSamples> outliers;
  std::optional<OlderPlace> older; ///< nothing: history starts within the frames that were followed
  glm::dvec3 error() const { return resolved - reference; }
};

PixelError pixelError(EvidenceSource& source, int frame, const glm::ivec2& pixel,
                      const LineageOptions& options = {}, const Progress& progress = {});

} // namespace taa
