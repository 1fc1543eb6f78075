// What a driver made of a frame, against the ranges that GLSL allows it: no tolerances.
#pragma once

#include "core/base/Image.h"
#include "core/taa/Intermediates.h"
#include "core/taa/twin/Interval.h"

#include <glm/vec2.hpp>

#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace taa {

using twin::PixelRecord;

/// A value that lies outside its range.
struct OutsideValue {
  glm::ivec2 pixel{0};
  int channel = 0;
  float found = 0.0f;
  twin::Interval allowed{};
};

/// A row over all pixels. Each value's range starts from what the driver made of the rows before it.
struct RowVerification {
  IntermediateId id{};
  std::size_t values = 0;
  std::size_t equal = 0;    ///< that have the twin's bits
  std::size_t outside = 0;  ///< that are what no driver may make
  std::size_t anything = 0; ///< of which GLSL promises nothing: division by 0
  std::size_t open = 0;     ///< of pixels with too many comparisons that could go both ways to try them all
  double medianUlp = 0.0;   ///< width of the range, in units of the last place of the row's scale: the
  double widestUlp = 0.0;   ///< root of its mean square
  glm::ivec2 widestAt{0};
  std::optional<OutsideValue> example{}; ///< the first one outside

  void addCounts(const RowVerification& other);
};

/// The rows that there were values of, in the order of the table.
struct Verification {
  std::vector<RowVerification> rows;

  RowVerification all() const; ///< sums, and the widest; no row's id
  bool isRight() const { return all().outside == 0; }
};

/// The rows and values of a pixel, in the order they are made; of the paths that comparisons could take
/// the one with the fewest outside. `isOpen`: not all were tried, and some are outside.
struct VerifiedPixel {
  std::vector<twin::Observation::Compared> values;
  bool isOpen = false;
};
VerifiedPixel verifyPixel(const twin::Inputs& inputs, const Settings& settings, const glm::ivec2& pixel,
                          const PixelRecord& found, const std::bitset<kIntermediateCount>& rows);

/// The values of a row, of any number of pixels.
struct VerifiedValues {
  RowVerification sums;
  std::size_t points = 0;    ///< ranges of one float
  std::vector<float> widths; ///< of the others that end somewhere
  double squares = 0.0;      ///< of the twin's values in both
  float widest = -1.0f;
};
using VerifiedTable = std::array<VerifiedValues, kIntermediateCount>;

/// Whole frames, a part of each after the other: all rows of many pixels are large.
class FrameVerifier {
 public:
  /// Lines of a part, of `ids` pictures as wide as the frame. `inputs` are read from several threads: they
  /// must be there (TwinReading::Whole).
  void add(const twin::Inputs& inputs, const Settings& settings, int firstLine,
           std::span<const IntermediateId> ids, std::span<const Image> rows);
  Verification verification() const;

 private:
  VerifiedTable all_;
};

} // namespace taa
