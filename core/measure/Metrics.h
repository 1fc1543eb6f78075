// Metrics of a whole picture: how far it is from the reference, and what the resolve did to it.
#pragma once

#include "core/base/Image.h"
#include "core/taa/rows/Intermediates.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

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

/// One number for a frame.
enum class Metric : std::uint8_t {
  MeanAlpha,
  Rejected,
  Clipped,
  ClipAmount,
  HistoryLength,
  Rmse,
  Psnr,
  RmseLinear,
  Deviation,
  Flicker,
  ErrorGhost,
  ErrorLag,
  ErrorBlur,
  ErrorAliasing,
  ErrorRectification,
  ErrorOlder,
  RightlyKept,
  GhostRemoved,
  GhostLetThrough,
  HistoryThrownAway,
};

struct MetricInfo {
  Metric metric;
  std::string_view id;    ///< in files and command lines
  std::string_view label; ///< as a heading
  std::string_view unit;
  double low, high; ///< range a plot opens with
  std::string_view description;
  std::string_view row;        ///< the intermediate it is made of; empty: of output and reference
  bool needsReference = false; ///< not known of a frame without a reference
  bool isOverTime = false;     ///< of the frames before, too: not known before those were made
  bool isHigherBetter = false; ///< of two settings the one with more of it is the better one
  int category = -1;           ///< of a row of categories: the share of pixels that have it; −1: a mean
};

inline constexpr std::array<MetricInfo, 20> kMetrics{{
    {Metric::MeanAlpha, "meanAlpha", "Mean α", "", 0, 1, "Mean weight of the current frame.", "alpha"},
    {Metric::Rejected, "rejected", "Rejected", "%", 0, 100,
     "Share of pixels whose history was rejected; all of them where history starts.", "rejectReason"},
    {Metric::Clipped, "clipped", "Clipped", "%", 0, 100, "Share of pixels whose history was pulled.",
     "clipAmount"},
    {Metric::ClipAmount, "clipAmount", "Mean clip amount", "", 0, 1,
     "How far history was pulled towards its target, the mean over all pixels.", "clipAmount"},
    {Metric::HistoryLength, "historyLength", "Mean history length", "frames", 0, 20,
     "Mean number of samples that a pixel holds after the frame.", "historyLength"},
    {Metric::Rmse, "rmse", "RMSE", "", 0, 0.1,
     "Root of the mean squared difference of output and reference as they are shown: clamped to 0…1, sRGB, "
     "over red, green and blue.",
     "", true},
    {Metric::Psnr, "psnr", "PSNR", "dB", 10, 60,
     "Peak signal to noise of output against reference as they are shown, −20 log₁₀ RMSE: the peak is 1.", "",
     true, false, true},
    {Metric::RmseLinear, "rmseLinear", "RMSE, scene-linear", "", 0, 1,
     "As RMSE, but scene-linear and not clamped: bright highlights count for what they are.", "", true},
    {Metric::Deviation, "deviationOverTime", "Deviation over time", "", 0, 0.02,
     "Standard deviation of what is shown over the last frames, followed along the motion: the mean over all "
     "pixels that were seen before. It has in it what really changes.",
     "deviationOverTime", false, true},
    {Metric::Flicker, "flicker", "Flicker", "", 0, 0.02,
     "Standard deviation of what is shown over the last frames, followed along the motion, without what the "
     "reference has of it: the mean over all pixels that were seen before.",
     "flicker", true, true},
    {Metric::ErrorGhost, "errorGhost", "Ghost part", "", 0, 0.02,
     "Mean over all pixels of |luma| of the error that comes of history of something else.", "errorGhost",
     true, true},
    {Metric::ErrorLag, "errorLag", "Lag part", "", 0, 0.02,
     "Mean |luma| of the error that comes of changes on the surface since history was made.", "errorLag",
     true, true},
    {Metric::ErrorBlur, "errorBlur", "Blur part", "", 0, 0.02,
     "Mean |luma| of the error that comes of reading history between its pixels.", "errorBlur", true, true},
    {Metric::ErrorAliasing, "errorAliasing", "Aliasing part", "", 0, 0.02,
     "Mean |luma| of the error that single frames' samples have, with their noise.", "errorAliasing", true,
     true},
    {Metric::ErrorRectification, "errorRectification", "Rectification part", "", 0, 0.02,
     "Mean |luma| of the error that no other part has: the pipeline's own.", "errorRectification", true,
     true},
    {Metric::ErrorOlder, "errorOlder", "Older part", "", 0, 0.02,
     "Mean |luma| of the error from before the frames that the others are followed over.", "errorOlder", true,
     true},
    {Metric::RightlyKept, "rightlyKept", "Rightly kept", "%", 0, 100,
     "Share of pixels whose history was as it should be, and was left so.", "verdictMap", true, true, true,
     0},
    {Metric::GhostRemoved, "ghostRemoved", "Ghost removed", "%", 0, 100,
     "Share of pixels whose history was off, and was rejected or pulled.", "verdictMap", true, true, false,
     1},
    {Metric::GhostLetThrough, "ghostLetThrough", "Ghost let through", "%", 0, 100,
     "Share of pixels whose history was off, and was left so.", "verdictMap", true, true, false, 2},
    {Metric::HistoryThrownAway, "historyThrownAway", "Good history thrown away", "%", 0, 100,
     "Share of pixels whose history was as it should be, and was rejected or pulled.", "verdictMap", true,
     true, false, 3},
}};

constexpr const MetricInfo& metricInfo(Metric metric) {
  return kMetrics[static_cast<std::size_t>(metric)];
}
std::optional<Metric> findMetric(std::string_view id);
/// What measures a metric over time; None: it is of the frame alone.
OverTime overTimeOf(Metric metric);
/// The metric that is the mean of a row over time, or nothing.
std::optional<Metric> meanOfRow(IntermediateId id);

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
