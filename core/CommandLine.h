// The taa-batch line that makes the picture of a session's view again.
#pragma once

#include "core/inspect/Visualizer.h"
#include "core/io/SessionFile.h"

#include <string>

namespace taa {

/// A word as a POSIX shell reads it back: quoted where it has to be.
std::string shellQuoted(const std::string& word);

/// "taa-batch render … --format png --out .": the session's shot, frame and settings, and one intermediate in
/// this style, all of the picture at 1:1.
std::string renderCommand(const SessionFile& session, IntermediateId id, const ViewStyle& style);

} // namespace taa
