// The ladders of the sources: what the listings of one add, one after another.
#pragma once

#include "core/settings/Presets.h"

#include <string_view>
#include <vector>

namespace taa {

/// The ladder that a built-in preset is a rung of, in its source's order, with the whole pipelines among its
/// steps; empty: it is of none.
std::vector<const Preset*> ladderOf(std::string_view id);

} // namespace taa
