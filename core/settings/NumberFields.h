// Numbers of the settings by where they lie: what the twin reads is the field itself, no copy.
#pragma once

#include "core/settings/Parameters.h"

namespace taa {

/// The field of a Number.
const float* fieldOf(const Parameter& number, const Settings& settings);
/// The Number whose field that is; null: it is no field of these settings.
const Parameter* numberAt(const float* field, const Settings& settings);

} // namespace taa
