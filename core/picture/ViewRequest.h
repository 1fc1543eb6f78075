// What a view asks of the render thread, and what comes back.
#pragma once

#include "core/base/Image.h"
#include "core/gl/Texture.h"
#include "core/measure/Metrics.h"
#include "core/measure/compare/FrameBefore.h"
#include "core/picture/RegionSpread.h"
#include "core/picture/Visualizer.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <numeric>
#include <optional>

namespace taa {

/// What a view is compared with: another row, lane or frame.
struct OtherSide {
  IntermediateId id = IntermediateId::resolved;
  ViewStyle style{};
  int lane = 0;
  std::optional<int> frame{}; ///< clamped to the shot; nothing: the frame on show
  int framesBefore = 0;       ///< without `frame`: that long before the one on show
  bool alongMotion = false;   ///< the frame before the one on show, read where its pixels came from
  bool operator==(const OtherSide&) const = default;
  bool isOfAnotherFrame() const { return frame || framesBefore != 0 || alongMotion; }
};

/// One view on the screen. A picture is delivered again whenever what it shows or how has changed.
struct ViewRequest {
  IntermediateId id = IntermediateId::resolved;
  ViewStyle style;
  ViewTransform transform;
  int width = 0, height = 0; ///< screen pixels; 0: not shown
  int lane = 0;
  bool withValues = false; ///< also deliver the values of the visible texels (for printing them when large)
  std::optional<OtherSide> other{};
  bool asDifference =
      false; ///< the picture is what it is more than the other side, which has as many channels
  std::optional<gl::Rect> measured{}; ///< also say how the values of these pixels are spread
  bool operator==(const ViewRequest&) const = default;
};

/// The pixels of a picture that a view shows, whole ones.
gl::Rect visiblePixels(const ViewRequest& view, const glm::ivec2& picturePx);

/// Pixels of the whole picture that were rejected for each reason; [0]: kept. All 0: not counted.
inline constexpr int kReasonCount = 10;
using ReasonCounts = std::array<int, kReasonCount>;
inline int totalOf(const ReasonCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0);
}
ReasonCounts countReasons(const Image& reasons);

/// The other side of a view, of the same pixels.
struct ViewSide {
  Picture picture;
  Image values, absence{}; ///< as of ViewResult
  int frame = 0;
  bool exact = true;
  ReasonCounts reasons{};            ///< where they are shown
  Absence allAbsent = Absence::None; ///< why it has no values at all
};

/// A finished picture of a view, with what it was made from.
struct ViewResult {
  int view = 0; ///< index into the views
  ViewRequest request;
  Picture picture;
  Image values;    ///< of `region` when asked for; else empty
  Image absence{}; ///< why values of `region` are none (Absence as a number); empty: there are all
  gl::Rect region; ///< pixels of the picture that `values` holds
  /// Of a row of the reference: how many samples that has, 0: none yet, the picture is empty; and how far the
  /// output is from it.
  int referenceSamples = 0;
  bool isReferenceGiven =
      false; ///< it came with the capture: it is one picture, and the samples mean nothing
  std::optional<PictureError> error{};
  /// Of a row over time: samples of the references that went into it, 0: none; nothing: it is not measured
  /// yet, the picture is empty.
  std::optional<int> overTimeSamples{};
  /// Of a row of the reference that a metric is the number of (metricOfMap()): that, where it is known.
  std::optional<double> number{};
  /// Of what was to be measured, as far as it lies in the picture; nothing where it does not, or the row is
  /// not made.
  std::optional<RegionSpread> spread{};
  int frame = 0;
  bool exact = true;
  bool isPreview = false;          ///< by settings that are not in force yet, of few of its pixels
  ReasonCounts reasons{};          ///< where they are shown
  std::optional<ViewSide> other{}; ///< delivered together; nothing while it is on its way
  std::uint64_t shotVersion = 0;   ///< see Status
};

} // namespace taa
