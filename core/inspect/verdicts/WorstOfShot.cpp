#include "core/inspect/verdicts/WorstOfShot.h"

#include "core/inspect/ReferenceOfShot.h"
#include "core/inspect/Views.h"

namespace taa {

WorstOfShot::WorstOfShot(Views& views, ReferenceOfShot& reference) : views_(views), reference_(reference) {}

std::vector<WorstPixel> WorstOfShot::of(const WorstQuestion& question) {
  const Image row = views_.image(question.row, question.lane);
  if (!question.category) return worstPixels(amounts(row), question.count, question.apartPx);
  constexpr IntermediateId kError = IntermediateId::referenceErrorAbs;
  const Image error = reference_.has(kError, question.lane) ? views_.image(kError, question.lane)
                                                            : Image(row.width, row.height, 1);
  return worstPixels(ofCategory(row, *question.category, error), question.count, question.apartPx);
}

} // namespace taa
