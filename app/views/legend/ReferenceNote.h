// What a view of the reference says about it besides its legend.
#pragma once

#include "core/requests/Results.h"

#include <QString>

namespace taa::app {

/// Samples so far and how far the output is from them; empty where the result is of another row.
QString referenceNote(const ViewResult& result);

} // namespace taa::app
