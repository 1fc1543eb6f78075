// The worst pixels of the frame on show.
#pragma once

#include "core/taa/rows/Intermediates.h"
#include "core/verdict/parts/WorstPixels.h"

#include <optional>
#include <vector>

namespace taa {

class ReferenceOfShot;
class Views;

/// What is looked for.
struct WorstQuestion {
  IntermediateId row = IntermediateId::referenceErrorAbs;
  std::optional<int> category{}; ///< of a row of categories; nothing: the amounts of the row
  int count = 5;
  int apartPx = 8;
  int lane = 0;
};

class WorstOfShot {
 public:
  /// Of rows that views show.
  WorstOfShot(Views& views, ReferenceOfShot& reference);

  /// Of a category the pixels with the largest absolute error come first, where there is a reference of the
  /// frame. Throws Error where the row is not made.
  std::vector<WorstPixel> of(const WorstQuestion& question);

 private:
  Views& views_;
  ReferenceOfShot& reference_;
};

} // namespace taa
