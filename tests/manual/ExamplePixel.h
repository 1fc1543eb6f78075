// A pixel by hand, for pages that show how its values are made.
#pragma once

#include "core/explanation/RowExplanation.h"
#include "core/taa/Intermediates.h"

#include <vector>

namespace taa {

struct ExampleRow {
  IntermediateId id;
  RowExplanation explanation;
};

/// By `balanced`, of rows that have a formula: the silhouette of something bright that moves by a pixel and a
/// quarter.
std::vector<ExampleRow> exampleRows();

} // namespace taa
