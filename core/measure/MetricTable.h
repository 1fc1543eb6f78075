// The one table of metrics: what each is, what it needs, and where more of it is better. Curves, menus,
// command lines and files derive from it.
#pragma once

#include "core/taa/Intermediates.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace taa {

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
  HistoryRemoved,
  HistoryLetThrough,
  HistoryThrownAway,
  RelativeMse,
  Ssim,
  Flip,
  HdrFlip,
  Sharpness,
  GhostEnergy,
  GeometryKept,
  GeometryRemoved,
  GeometryLetThrough,
  GeometryThrownAway,
  Supersampling,
};

struct MetricInfo {
  Metric metric;
  std::string_view id;    ///< in files and command lines
  std::string_view label; ///< as a heading
  std::string_view unit{};
  double low = 0.0, high = 1.0; ///< range a plot opens with
  std::string_view description{};
  /// The intermediate it is made of, or the map of what it is a number of; empty: of output and reference.
  std::string_view row{};
  bool needsReference = false; ///< not known of a frame without a reference
  bool isOverTime = false;     ///< of the frames before, too: not known before those were made
  bool isHigherBetter = false; ///< of two settings the one with more of it is the better one
  int category = -1;           ///< of a row of categories: the share of pixels that have it; −1: a mean
  bool isCostly = false;       ///< takes seconds: made only where it is named
};

inline constexpr std::array<MetricInfo, 31> kMetrics{{
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
    {Metric::HistoryRemoved, "historyRemoved", "Wrong history removed", "%", 0, 100,
     "Share of pixels whose history was off, and was rejected or pulled.", "verdictMap", true, true, false,
     1},
    {Metric::HistoryLetThrough, "historyLetThrough", "Wrong history let through", "%", 0, 100,
     "Share of pixels whose history was off, and was left so.", "verdictMap", true, true, false, 2},
    {Metric::HistoryThrownAway, "historyThrownAway", "Good history thrown away", "%", 0, 100,
     "Share of pixels whose history was as it should be, and was rejected or pulled.", "verdictMap", true,
     true, false, 3},
    {.metric = Metric::RelativeMse,
     .id = "relativeMse",
     .label = "Relative MSE",
     .high = 0.1,
     .description = "Mean squared difference of output and reference over the reference's own square + 0.01, "
                    "scene-linear: dark places count as bright ones do.",
     .row = "relativeError",
     .needsReference = true},
    {.metric = Metric::Ssim,
     .id = "ssim",
     .label = "SSIM",
     .low = 0.8,
     .high = 1,
     .description = "How alike the structure of output and reference is, by luma as it is shown: 1 the same, "
                    "0 nothing in common.",
     .row = "ssimMap",
     .needsReference = true,
     .isHigherBetter = true},
    {.metric = Metric::Flip,
     .id = "flip",
     .label = "FLIP",
     .high = 0.2,
     .description = "How much a person who flips between output and reference sees of their difference: the "
                    "mean over all pixels, 0 nothing, 1 all there can be.",
     .row = "flip",
     .needsReference = true},
    {.metric = Metric::HdrFlip,
     .id = "hdrFlip",
     .label = "HDR-FLIP",
     .high = 0.2,
     .description = "As FLIP, but each pixel at the exposure that shows most of its difference, from the "
                    "brightest pixel's to the median's. It takes seconds a frame.",
     .needsReference = true,
     .isCostly = true},
    {.metric = Metric::Sharpness,
     .id = "sharpness",
     .label = "Sharpness",
     .high = 1.5,
     .description = "How steep edges are, compared with the reference's: 1 as steep, less blurred, more "
                    "aliased or sharpened.",
     .needsReference = true,
     .isHigherBetter = true},
    {.metric = Metric::GhostEnergy,
     .id = "ghostEnergy",
     .label = "Ghost energy",
     .high = 0.05,
     .description = "Root of the mean square of the part of the error that lies towards what was shown a "
                    "frame ago: at most RMSE.",
     .row = "ghost",
     .needsReference = true,
     .isOverTime = true},
    {.metric = Metric::GeometryKept,
     .id = "geometryKept",
     .label = "Same surface kept",
     .unit = "%",
     .high = 100,
     .description = "Share of pixels whose history was of what they show, by the scene's geometry, and was "
                    "not rejected.",
     .row = "geometryVerdict",
     .needsReference = true,
     .isOverTime = true,
     .isHigherBetter = true,
     .category = 0},
    {.metric = Metric::GeometryRemoved,
     .id = "geometryRemoved",
     .label = "Other surface rejected",
     .unit = "%",
     .high = 100,
     .description = "Share of pixels whose history was of something else, and was rejected.",
     .row = "geometryVerdict",
     .needsReference = true,
     .isOverTime = true,
     .category = 1},
    {.metric = Metric::GeometryLetThrough,
     .id = "geometryLetThrough",
     .label = "Other surface let through",
     .unit = "%",
     .high = 100,
     .description = "Share of pixels whose history was of something else, and was not rejected.",
     .row = "geometryVerdict",
     .needsReference = true,
     .isOverTime = true,
     .category = 2},
    {.metric = Metric::GeometryThrownAway,
     .id = "geometryThrownAway",
     .label = "Same surface rejected",
     .unit = "%",
     .high = 100,
     .description = "Share of pixels whose history was of what they show, and was rejected.",
     .row = "geometryVerdict",
     .needsReference = true,
     .isOverTime = true,
     .category = 3},
    {.metric = Metric::Supersampling,
     .id = "supersampling",
     .label = "RMSE of supersampling",
     .high = 0.1,
     .description = "RMSE of the mean of as many samples a pixel of this instant as there were frames since "
                    "history started: what the output of a picture at rest converges beside. Nothing of the "
                    "resolve is in it, and it is 0 from as many as the reference has; it draws them anew.",
     .needsReference = true,
     .isCostly = true},
}};

constexpr const MetricInfo& metricInfo(Metric metric) {
  return kMetrics[static_cast<std::size_t>(metric)];
}
std::optional<Metric> findMetric(std::string_view id);
/// As above; throws Error naming those there are.
Metric metricNamed(std::string_view id);
/// What measures a metric over time; None: it is of the frame alone.
OverTime overTimeOf(Metric metric);
/// The number of a map: of a row of the reference that one is made of, or nothing.
std::optional<Metric> metricOfMap(IntermediateId id);

} // namespace taa
