// How many pixels of a frame something was done to.
#pragma once

#include "core/base/Image.h"

#include <span>

namespace taa {

/// A row, and the value that says that a pixel was left as it was.
struct ChangedRow {
  const Image& row;
  float untouched = 0.0f;
};

/// Share of pixels, 0 to 1, where any channel of any of the rows says otherwise. Expects rows of one size.
double shareOfChanged(std::span<const ChangedRow> rows);

} // namespace taa
