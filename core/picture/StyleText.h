// How a view shows its row, in words that flags and files hold: "exposure=1.5", "map=viridis".
#pragma once

#include "core/picture/Visualizer.h"

#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// The assignments that turn `base` into `style`.
std::vector<std::string> styleDifferences(const ViewStyle& style, const ViewStyle& base);

/// Applies one. Keys: low, high, exposure (numbers), channels (letters of rgb, or none), map (a color map),
/// marks, clipped, rejected, outlines, arrows (on, off). Throws Error that says what is expected.
void applyStyle(ViewStyle& style, std::string_view assignment);

} // namespace taa
