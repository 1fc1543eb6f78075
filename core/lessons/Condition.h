// What a lesson claims of a state, or asks for: comparisons of metrics, of values at pixels and of shares of
// the picture with numbers and with each other.
#pragma once

#include "core/measure/MetricTable.h"
#include "core/settings/Faults.h"
#include "core/taa/Intermediates.h"
#include "core/verdict/pixel/PixelVerdict.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

enum class QuantityKind : std::uint8_t {
  Number,
  Metric,     ///< "metric psnr"
  Value,      ///< "probe 120,60 clipAmount": a row at a pixel
  Difference, ///< "difference 120,60 resolved of clamp": of two lanes at a pixel, of the channel that has
              ///< most
  Share,      ///< "share rejectReason above 0": of the picture's pixels, %
  Verdict,    ///< "verdict 120,60 ghost": 1 where that is wrong with the pixel, else 0
  Doctor,     ///< "doctor motionNegatedY": 1 where the doctor finds that fault, else 0
  Lineage,    ///< "lineage 120,60 radius": of the samples that a pixel is made of
  Volume,     ///< "volume 120,60": of the pixel's box, in RGB of the box's tone curve
  Levels,     ///< "levels fogOpacity": values of the row that 8 bits tell apart, in the whole picture
  Pushed,     ///< "pushed none", "pushed several": % of pixels that get so many when this frame's are pushed
              ///< back along their motion instead of gathered
  Fetches,    ///< "fetches": texture reads of a pixel's resolve, see TextureFetches.h
  Changed,    ///< "changed of clip": % of pixels that resolve to another color than with the state's own
              ///< settings
  Time,       ///< "time of clip": of the resolve, times that of the state's own settings
};

/// What is asked of a lineage.
enum class LineageFigure : std::uint8_t {
  Samples, ///< single samples of equal weight that average noise as much
  Frames,  ///< the same of frames
  Radius,  ///< root of the mean square of the samples' offsets, px
  Spread,  ///< how far resampling blurs the oldest frame that is followed, px
  Older    ///< weight of what is older than the frames that are followed
};

/// Whether it is of one pixel.
constexpr bool isOfPixel(QuantityKind kind) {
  return kind == QuantityKind::Value || kind == QuantityKind::Difference || kind == QuantityKind::Verdict ||
         kind == QuantityKind::Lineage || kind == QuantityKind::Volume;
}

/// One number, of the state's own settings and frame unless it says otherwise.
struct Quantity {
  QuantityKind kind = QuantityKind::Number;
  double number = 0.0; ///< Number; Share: the limit
  Metric metric{};
  IntermediateId row{};
  int channel = -1;                  ///< −1: luma of three channels, length of two
  std::optional<glm::ivec2> pixel{}; ///< nothing: the one that is probed
  bool isBelow = false;              ///< Share
  VerdictKind verdict{};
  Fault fault{};
  LineageFigure figure{};
  bool isSeveral = false;     ///< Pushed
  std::string lane{};         ///< its name; empty: the state's own settings
  std::optional<int> frame{}; ///< nothing: the state's own
  double factor = 1.0, offset = 0.0;
};

enum class Relation : std::uint8_t { Less, LessOrEqual, Greater, GreaterOrEqual, Equal };

/// "metric psnr > metric psnr of off + 2"
struct Condition {
  std::string text; ///< as it is written
  int line = 0;     ///< of the file
  Quantity left, right;
  Relation relation{};
  double tolerance = 0.0; ///< Equal: "within 0.001"
};

/// Throws Error that says what is not understood. Whether its lanes are there is not asked.
Condition conditionFrom(std::string_view text);

bool holds(const Condition& condition, double left, double right);

/// Both sides of each, without numbers.
std::vector<const Quantity*> quantitiesOf(const std::vector<Condition>& conditions);

} // namespace taa
