// Metrics of a whole picture: how far it is from the reference, and what the resolve did to it.
#pragma once

#include "core/base/Image.h"
#include "core/measure/MetricTable.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace taa {

/// How many samples a reference may have, and has unless told otherwise.
inline constexpr int kMinReferenceSamples = 4, kMaxReferenceSamples = 1024, kReferenceSamples = 64;

/// How far a picture is from another one, over red, green and blue of all pixels.
struct PictureError {
  /// Root of the mean squared difference of the pictures as they are shown: exposure 0, clamped to 0…1,
  /// encoded as sRGB. Scene-linear, a few highlights would be all of it.
  double rmse = 0.0;
  double psnr = 0.0;       ///< −20 log₁₀ of that, dB: the peak is 1; infinite where they are the same
  double rmseLinear = 0.0; ///< as the first, but scene-linear and of all there is
};

/// What a screen is sent of a scene-linear picture, in 0…1: exposure 0, clamped, encoded as sRGB (IEC
/// 61966-2-1). Three channels, of three at least.
Image shownColors(const Image& linear);

/// Both have the same size and three channels at least.
PictureError pictureError(const Image& picture, const Image& reference);

/// Metrics of one lane of a frame; those that were not asked for or are not known are empty.
struct FrameMetrics {
  int frame = 0, lane = 0;
  bool exact = true;        ///< of the frame
  int referenceSamples = 0; ///< of the reference that RMSE and PSNR were taken against; 0: there was none
  /// The same of flicker; 0: only the deviation is known; nothing: neither is.
  std::optional<int> flickerSamples{};
  std::optional<int> partsSamples{}; ///< the same of parts of the error; nothing: they are not known
  std::array<std::optional<double>, kMetrics.size()> values;
  std::uint64_t shotVersion = 0; ///< counts what frames were a function of (Status::shotVersion)

  const std::optional<double>& at(Metric metric) const { return values[static_cast<std::size_t>(metric)]; }
  std::optional<double>& at(Metric metric) { return values[static_cast<std::size_t>(metric)]; }
};

inline const std::optional<int>& samplesOf(const FrameMetrics& metrics, OverTime kind) {
  return kind == OverTime::Flicker ? metrics.flickerSamples : metrics.partsSamples;
}

/// The metric from the picture of its row; expects that it has one, which is not over time.
double metricOf(Metric metric, const Image& row);

} // namespace taa
