// Whether pixels of a plane share texels: it was made in a lower resolution than the picture, and each value
// stands in a square of pixels.
#pragma once

#include "core/base/Image.h"

#include <array>
#include <cstddef>
#include <optional>

namespace taa::doctor {

/// Pairs of neighbors in a row or a column where the plane changes, by the side of the squares that they
/// would be in or between; squares start at the first row and column.
class SharedTexels {
 public:
  void add(const Image& plane);
  /// px, 2 to 4: the largest of which nearly all pairs within a square are equal, and those between squares
  /// are not; nothing where there is none, or too little changes.
  std::optional<int> side() const;

 private:
  struct Pairs {
    std::size_t within = 0, withinEqual = 0, between = 0, betweenEqual = 0;
  };
  static constexpr int kLeastSide = 2;
  std::array<Pairs, 3> bySide_; ///< from kLeastSide on
};

} // namespace taa::doctor
