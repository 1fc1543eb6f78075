// A pixel's lineage in a few sentences: made from its numbers, so that nothing is said that they do not say.
#pragma once

#include "core/verdict/lineage/Lineage.h"

#include <string>
#include <vector>

namespace taa {

/// How many samples' worth it is and what that leaves of noise; what the parts of it are; where its samples
/// lie.
std::vector<std::string> lineageSentences(const Lineage& lineage);

} // namespace taa
