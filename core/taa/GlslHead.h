// What stands before exported shaders: what it is, what goes in and out, by which conventions, the license.
#pragma once

#include "core/settings/Settings.h"

#include <string>

namespace taa {

/// Whether the weights of the current filter are the same whatever the jitter is.
bool hasConstantWeights(const CurrentSettings& settings);

/// Comment lines. `resolve`, `output`: the shaders, of whose inputs and outputs only those that are there are
/// told; `output` is empty where what is shown is what the resolve gave.
std::string glslHead(const Settings& settings, const std::string& title, const std::string& resolve,
                     const std::string& output);

} // namespace taa
