// Where the metrics of frames that are not on show have come to.
#pragma once

#include "core/inspect/FrameWindow.h"
#include "core/measure/References.h"
#include "core/replay/TraceCursor.h"

namespace taa {

/// Worth nothing once what frames are a function of has changed. The reference is of one frame: those of
/// frames on show stay where they are.
struct MetricCursor {
  TraceCursor trace;
  References references;
  FrameWindow window;
};

} // namespace taa
