// What of a side file's frames a capture can state: the rest is left out in a sentence, as nobody wrote it
// for capture.json.
#pragma once

#include "core/capture/format/Manifest.h"

#include <string>
#include <vector>

namespace taa::capture {

/// Leaves out matrices without their other half or beyond any camera, jitter beyond any picture, and times
/// that do not rise from frame to frame. `file`: as sentences name it.
void keepWithinLimits(std::vector<CapturedFrame>& frames, const std::string& file,
                      std::vector<std::string>& unsure);

} // namespace taa::capture
