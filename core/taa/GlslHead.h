// What stands before an exported shader: what it is, what goes in and out, by which conventions, the license.
#pragma once

#include "core/settings/Settings.h"

#include <string>

namespace taa {

/// Whether the weights of the current filter are the same whatever the jitter is.
bool hasConstantWeights(const CurrentSettings& settings);

/// Comment lines. `body`: the shader, of whose inputs and outputs only those that are there are told.
std::string glslHead(const Settings& settings, const std::string& title, const std::string& body);

} // namespace taa
