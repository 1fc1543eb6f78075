// The worst pixels of the frame on show.
#pragma once

#include "core/taa/Intermediates.h"
#include "core/verdict/parts/WorstPixels.h"

#include <glm/vec2.hpp>

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

/// Where the next one is looked for.
enum class WorstStep {
  Pixel,    ///< of the same row, or category of it
  Category, ///< of the next category of the row that something is wrong with
  // Whatever the error is
  Rejected, ///< pixels whose history was rejected, those of the largest error first where that is known
  Clipped,  ///< pixels whose history was moved by rectification, the farthest first
  NoNumber  ///< pixels of the row that are NaN or infinite in a channel
};

/// One of those that a key goes through.
struct FoundWorst {
  WorstQuestion question; ///< row and category that it is of
  WorstPixel worst;
  WorstStep step = WorstStep::Pixel; ///< how it was looked for
  int number = 1, count = 1;         ///< the worst is 1
};

class WorstOfShot {
 public:
  /// The row by which the worst pixels of a view that shows `shown` are found.
  static IntermediateId rowOf(IntermediateId shown, WorstStep step = WorstStep::Pixel);

  /// Of rows that views show.
  WorstOfShot(Views& views, ReferenceOfShot& reference);

  /// Of a category the pixels with the largest absolute error come first, where there is a reference of the
  /// frame. Throws Error where the row is not made.
  std::vector<WorstPixel> of(const WorstQuestion& question);
  /// The one after the pixel `after`, the worst where that is none of them or the last. Of errors and what is
  /// made of them; of a row of categories that of `after`, unless nothing is wrong with it: then of the first
  /// in which something is, ghosts let through before others. Of any other row that of the absolute error.
  /// Throws Error where the row is not made, or nothing is wrong anywhere, or it has no categories to go to;
  /// of Rejected, Clipped and NoNumber where there is no such pixel.
  FoundWorst next(IntermediateId shown, int lane, const std::optional<glm::ivec2>& after,
                  WorstStep step = WorstStep::Pixel);

 private:
  std::vector<WorstPixel> searched(IntermediateId shown, int lane, WorstStep step);
  /// Absolute, 0 without a reference; one channel, of the size of `like`.
  Image errorOf(const Image& like, int lane);
  WorstQuestion questionOf(IntermediateId shown, int lane, const std::optional<glm::ivec2>& after,
                           WorstStep step);

  Views& views_;
  ReferenceOfShot& reference_;
};

} // namespace taa
