// How much single frames count in an accumulated pixel, and how many samples' worth of averaging that is. No
// GL.
#pragma once

#include "core/render/JitterWay.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace taa {

/// Weight of each frame in the picture that the last one left: α·Π(1 − α of those after it). `alphas`: the
/// current frame's weight in each frame, oldest first. They sum up to 1 when the oldest is 1 (manual §15).
std::vector<double> frameWeights(std::span<const double> alphas);

/// Samples of equal weight that average noise as much: (Σw)²/Σw². 0 without weights.
double effectiveSamples(std::span<const double> weights);
/// That after each of the frames.
std::vector<double> effectiveSamplesOver(std::span<const double> alphas);

/// α of the frames 0 … frames − 1 after history starts, of a gray pixel in which nothing moves or changes:
/// what the settings come to where nothing disturbs.
std::vector<double> alphasAtRest(const Settings& settings, int frames);

/// One place of the jitter pattern.
struct JitterSample {
  glm::dvec2 position{0.5}; ///< in the pixel, 0 to 1 each, y down: where that frame's sample lies
  double weight = 0.0;      ///< of all frames that have it, in the picture
};

/// The pattern over one period, with what the frames that used each place weigh.
struct JitterPattern {
  std::vector<JitterSample> samples; ///< by index in the pattern
  glm::dvec2 mean{0.0};              ///< of the positions, against the pixel's center, px
  glm::dvec2 weightedMean{0.0};      ///< with the weights: where the picture's content lies
  int cells = 1;                     ///< a side of the grid that coverage is measured on, ⌊√period⌋
  double coverage = 0.0;             ///< share of the cells×cells parts of the pixel that hold a sample
  double effective = 0.0;            ///< samples, places counted once
};

/// `weights`: of the frames up to `frame`, which is the last; as frameWeights() gives them. `way`: the
/// camera's in that frame (jitterWay()), which points across it are turned by; those of frames before, which
/// lay a little otherwise, are shown there too.
JitterPattern jitterPattern(const JitterSettings& settings, int frame, std::span<const double> weights,
                            const glm::dvec2& way = kFirstWay);
/// As above, of a pattern whose points are known: displacements of content, px, one for each index.
JitterPattern jitterPattern(std::span<const glm::vec2> pointsPx, int frame, std::span<const double> weights);

} // namespace taa
