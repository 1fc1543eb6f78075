// Options of the command that tries the doctor.
#pragma once

#include "core/base/Progress.h"
#include "core/cli/Arguments.h"

namespace CLI {
class App;
}

namespace taa::cli {

/// What is given must outlive the parsing.
void addConfusions(CLI::App& app, ConfusionsArguments& confusions, const Progress& progress);

} // namespace taa::cli
