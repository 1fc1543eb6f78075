// How many settings are resolved beside one another.
#pragma once

namespace taa {

/// The settings in force, and for each of four views others to compare them with.
inline constexpr int kMaxLanes = 5;

} // namespace taa
