// What the weight of the current frame takes from the frame as a whole: its jitter and its length.
#include "core/taa/TaaPass.h"

#include <algorithm>
#include <cmath>

namespace taa {

float sampleDistanceFactor(SampleDistance form, glm::vec2 jitterPx) {
  const glm::dvec2 jitter(jitterPx);
  const double squared = jitter.x * jitter.x + jitter.y * jitter.y; // px²
  constexpr double kVariance = 0.22;                                // of the Gaussian of manual 7.4, px²
  switch (form) {
  case SampleDistance::None:
    return 1.0f;
  case SampleDistance::Gaussian:
  case SampleDistance::GaussianMoving:
    return static_cast<float>(std::exp(-squared / (2.0 * kVariance)));
  case SampleDistance::Parabola:
    return static_cast<float>(std::max(1.0 - squared, 0.0));
  }
  return 1.0f;
}

int frameEighths(double stepSeconds, float referenceRate) {
  const double frames = stepSeconds * static_cast<double>(referenceRate);
  return static_cast<int>(std::clamp(std::round(8.0 * frames), 1.0, 64.0));
}

} // namespace taa
