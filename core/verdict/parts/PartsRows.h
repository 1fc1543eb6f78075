// The rows of the table that parts of the error and verdicts over history are, and the rows of the resolve
// that they are made of.
#pragma once

#include "core/measure/RowsOverTime.h"
#include "core/settings/Settings.h"
#include "core/verdict/parts/ErrorParts.h"

#include <vector>

namespace taa {

/// The row that a part is.
IntermediateId rowOfPart(ErrorPart part);

/// What frameErrors() takes of a frame's resolve.
std::vector<IntermediateId> rowsOfErrors(const Settings& settings);
/// What verdicts over a frame's history take besides.
std::vector<IntermediateId> rowsOfVerdicts();

/// Of rowsOfErrors(); without reference and steps.
PartsInputs partsInputs(const RowImages& resolve, const Settings& settings);

/// Luma of each part, and both maps, of the last frame. `resolve`: its rows of both kinds; `reference`:
/// scene-linear; `steps`: surfaceSteps() from the frame before, empty where history starts.
RowImages partsRows(const ErrorParts& parts, const RowImages& resolve, const Image& reference,
                    const Image& steps);

} // namespace taa
