// Which samples a pixel is made of: its weight taken back along history, frame by frame. No GL.
#pragma once

#include "core/base/Progress.h"
#include "core/verdict/lineage/PixelStep.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace taa {

inline constexpr int kLineageFrames = 32, kMaxLineageFrames = 256;

/// Where the steps come from.
class LineageSource {
 public:
  LineageSource() = default;
  LineageSource(const LineageSource&) = delete;
  LineageSource& operator=(const LineageSource&) = delete;
  virtual ~LineageSource() = default;
  /// Of a pixel of the picture. Frames come in falling order. Throws Error, Cancelled.
  virtual PixelStep step(int frame, const glm::ivec2& pixel) = 0;
};

struct LineageOptions {
  int frames = kLineageFrames; ///< how far back, with the frame itself; 1 to kMaxLineageFrames
  double minWeight = 1e-5;     ///< pixels of frames before that count less are not followed
  double minSample = 1e-4;     ///< samples that count less are not listed
};

/// A frame's part in the pixel.
struct LineageFrame {
  int frame = 0;
  double weight = 0.0;      ///< of its samples: Rec. 709 luma of the channels'
  glm::dvec3 channels{0.0}; ///< the same of red, green and blue
  double rectified = 0.0;   ///< what its rectification took the place of
  glm::dvec3 color{0.0};    ///< Σ weight · sample
  glm::dvec3 own{0.0};      ///< color that the resolve added: rectification, tone space, clamps, rounding
  glm::dvec2 place{0.0};    ///< px, where today's pixel center was: its path
  double spreadPx = 0.0;    ///< root of the mean square distance from there: how far resampling blurs
  int pixels = 0;           ///< that were followed
  int object = 0;           ///< whose motion the heaviest of them follows
};

/// An old sample. A texel of a frame that several pixels read is one.
struct FootprintSample {
  int frame = 0;
  glm::ivec2 texel{0};    ///< of what was drawn
  glm::dvec2 offset{0.0}; ///< from today's pixel center, in today's px: where its place is now
  double weight = 0.0;
};

/// Σ frames' weights + rectified + older + pruned + blank = 1, and the colors of the same sum up to
/// `resolved`.
struct Lineage {
  int frame = 0;
  glm::ivec2 pixel{0};
  std::vector<LineageFrame> frames;     ///< latest first; ends where history starts
  std::vector<FootprintSample> samples; ///< latest first
  double weight = 0.0;                  ///< of all samples
  double rectified = 0.0;               ///< what rectification replaced
  double older = 0.0;                   ///< history that the first of the frames was resolved on
  double pruned = 0.0;                  ///< in pixels that count too little to be followed
  double blank = 0.0;                   ///< black borders, and what printed filters miss of 1
  glm::dvec3 rest{0.0};                 ///< color of what is older or pruned
  glm::dvec3 resolved{0.0};             ///< what the pixel became
  double historyLength = 1.0;           ///< N, what the resolve believes `effectiveFrames` to be
  double effectiveFrames = 0.0;         ///< (Σw)²/Σw² of the frames' weights
  double effectiveSamples = 0.0;        ///< the same of single samples, which resampling mixes more of
  double variance = 0.0;                ///< Σw² of single samples: what is left of their noise's
  double radiusPx = 0.0;                ///< root of the mean square of the samples' offsets
};

/// Of pixel `pixel` of frame `frame`. With W = 1 there, each pixel leaves α·W to its samples; of the rest c
/// is what rectification replaced, and (1 − α)(1 − c)·W goes to the texels that were read, by the weights of
/// the history filter (pixelStep() has the rules). Weights are thus shares of what was mixed, and the
/// response to a change of a sample where α, c and the taps do not change with it.
Lineage lineageOf(LineageSource& source, int frame, const glm::ivec2& pixel,
                  const LineageOptions& options = {}, const Progress& progress = {});

} // namespace taa
