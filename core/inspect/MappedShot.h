// Where a number of the settings matters, on a shot that somebody looks at, beside it.
#pragma once

#include "core/base/Progress.h"
#include "core/io/SessionFile.h"
#include "core/picture/Visualizer.h"
#include "core/probe/Sensitivity.h"

#include <string>

namespace taa {

struct MapRequest {
  SessionFile shot; ///< with the frame; of its lanes the first
  std::string path; ///< of a number
};

/// With a GL context of its own: expects a thread that has none. Frames are drawn in turn with other threads.
/// Throws Error, Cancelled.
SensitivityMap mapShot(const MapRequest& request, const Progress& progress = {});

/// The change of luma that is drawn as the end of the colors: 99 of 100 pixels that move move less. 0: none
/// moves.
float mappedRange(const SensitivityMap& map);
/// Its change of luma, from darker (blue) over gray to brighter (orange), which ends at `range`.
Picture mapPicture(const SensitivityMap& map, float range);

} // namespace taa
