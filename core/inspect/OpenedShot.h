// What somebody looks at, opened once more for work in the background.
#pragma once

#include "core/base/Progress.h"
#include "core/io/SessionFile.h"

namespace taa {

class Inspector;

/// Opens what `shot` says, but for its settings and lanes. Throws Error, Cancelled.
void openShotOf(Inspector& inspector, const SessionFile& shot, const Progress& progress);

} // namespace taa
