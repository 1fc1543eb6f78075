// A pixel by hand, for pages that show how its values are made.
#pragma once

#include "core/story/ProbeStory.h"
#include "core/taa/Intermediates.h"

#include <vector>

namespace taa {

struct ExampleRow {
  IntermediateId id;
  RowStory story;
};

/// By `balanced`, of rows that have a formula: the rim of something bright that moves by a pixel and a
/// quarter.
std::vector<ExampleRow> exampleRows();

} // namespace taa
