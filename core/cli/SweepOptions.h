// Options of the commands that try many settings.
#pragma once

#include "core/base/Progress.h"
#include "core/cli/Arguments.h"

namespace CLI {
class App;
}

namespace taa::cli {

/// What is given must outlive the parsing; see runSweep() of `hasFailed`.
void addSweep(CLI::App& app, SweepArguments& sweep, const Progress& progress, bool& hasFailed);
void addTune(CLI::App& app, TuneArguments& tune, const Progress& progress);

} // namespace taa::cli
