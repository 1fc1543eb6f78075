// The error of a frame split by what made it, along the history that carried it there. No GL.
//
// Of each part P but the last two: what its frame adds (core/verdict/parts/FrameErrors.h), and of what was
// there before the history's share, read where history was read:
//   Pₙ = added + (1 − α)·Σ wᵢ·Pₙ₋₁(xᵢ)
// It begins with the first of the frames that are given: with nothing where history starts there, else with
// that frame's error as `older`, to which nothing is added. `rectification` is what the parts leave of
// out − R: what clamping and clipping, locks, deringing, mixing of compressed colors, rounding and dithering
// did, in all of the frames. So the parts sum up to the error by definition.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"
#include "core/settings/Settings.h"
#include "core/verdict/parts/FrameErrors.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace taa {

/// Frames that they are followed over unless told otherwise, as flicker is.
inline constexpr int kPartsFrames = 16;

enum class ErrorPart : std::uint8_t {
  Ghost,         ///< history was of something else
  Lag,           ///< what is seen has changed since
  Blur,          ///< history was read between its pixels
  Aliasing,      ///< of single frames' samples, noise too
  Older,         ///< from before the frames that are followed
  Rectification, ///< the pipeline's own
};
inline constexpr std::size_t kErrorParts = 6;

/// Three channels each, scene-linear: above 0 the picture is too bright by it.
struct ErrorParts {
  std::array<Image, kErrorParts> images;
  const Image& at(ErrorPart part) const { return images[static_cast<std::size_t>(part)]; }
  Image& at(ErrorPart part) { return images[static_cast<std::size_t>(part)]; }
};

/// Frames in a row, one at least.
struct PartsWindow {
  std::span<const FrameErrors* const> oldestFirst; ///< all but the first with their history
  bool startsHistory = false;                      ///< the first one does
};

/// Of the last frame. Asks `progress` frame by frame whether to stop.
ErrorParts errorParts(const PartsWindow& window, const HistorySettings& settings,
                      const Progress& progress = {});

} // namespace taa
