// Whether two images agree within limits, and where they differ most; a failed comparison leaves pictures.
#pragma once

#include "core/base/Image.h"

#include <cstddef>
#include <limits>
#include <string>

namespace taa::test {

/// How far an image may be from the expected one. As it stands: the same bits, any NaN being equal to any
/// other.
struct Limits {
  /// Of each value, relative to max(1, |expected|); 0: the same bits.
  float tolerance = 0.0f;
  /// Part of all values that may be outliers: values that differ by more than the tolerance.
  double outliers = 0.0;
  /// The largest difference of an outlier, as a part of the expected picture's reach: its highest minus its
  /// lowest finite value, at least 1.
  float worst = 0.0f;
  /// Of all differences, each relative to max(1, |expected|).
  double mean = std::numeric_limits<double>::infinity();
  /// Whether an outlier may be NaN or infinite where a finite value is expected, or the other way round.
  bool mayLoseFinite = false;
};

/// The limits of what a GPU computes as its CPU twin does. A driver that is exact has the twin's bits. Any
/// other rounds within `tolerance`, but a comparison within rounding of its threshold may fall the other way:
/// in one value of a hundred, which then is another one of the picture's range and none beyond it.
Limits limitsOf(bool isExact, float tolerance);

/// What a comparison found.
struct Comparison {
  bool agrees = true;
  std::size_t differing = 0; ///< values beyond the tolerance
  double worst = 0.0;        ///< difference at (x, y), infinite where only one of the two is finite
  int x = 0, y = 0, channel = 0;
  double mean = 0.0; ///< of the finite differences, each relative to max(1, |expected|)
  std::string text;  ///< empty when they agree
};

Comparison compare(const Image& actual, const Image& expected, const Limits& limits = {});

/// What compare() says. A failure also leaves pictures, which the text names (FailedImages.h): only for
/// images that are expected to agree.
std::string difference(const Image& actual, const Image& expected, const Limits& limits);
std::string difference(const Image& actual, const Image& expected, float tolerance = 0.0f);

/// The same as a question, for images that are expected to differ.
bool agree(const Image& actual, const Image& expected, float tolerance = 0.0f);

/// The part of `image` at (x, y).
Image crop(const Image& image, int x, int y, int width, int height);

} // namespace taa::test
