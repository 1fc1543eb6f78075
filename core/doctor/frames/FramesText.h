// Frames in words.
#pragma once

#include <string>
#include <vector>

namespace taa::doctor {

/// "all frames", "frame 7", "frames 9 to 16", "frames 3, 5, 8 (3 of 24)": of those that were asked.
/// Both rise. Expects one frame at least, and that all were asked.
std::string framesText(const std::vector<int>& frames, const std::vector<int>& asked);

} // namespace taa::doctor
