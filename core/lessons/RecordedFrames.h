// Frames that a lesson has recorded: drawn by this program, written as an engine would hand them out, and
// opened like any capture.
#pragma once

#include "core/base/Progress.h"
#include "core/lessons/LessonState.h"

namespace taa {

class Inspector;

/// The state on the frames that it records: a capture in place of the scene. They are drawn and written where
/// this program has not done so since it started, into a folder of its own that goes when it ends;
/// `inspector` then has another shot open. A state that records none comes back as it is. Any thread. Throws
/// Error, Cancelled.
LessonState onItsFrames(Inspector& inspector, const LessonState& state, const Progress& progress);

} // namespace taa
