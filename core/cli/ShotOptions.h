// Options that commands share: what to look at, and what becomes of files that are there.
#pragma once

#include "core/cli/Arguments.h"

#include <string>

namespace CLI {
class App;
}

namespace taa::cli {

/// SOURCE, or --session instead of it, with camera, size, settings and what the scene is made of.
void addShotOptions(CLI::App& command, ShotArguments& shot);
/// What a scene may ask for (SceneBudget).
void addSceneBudget(CLI::App& command, int& millions, int& mib);
void addForce(CLI::App& command, bool& force);
/// `what`: of what, with the range, as it follows "Samples in a pixel ".
void addReferenceSamples(CLI::App& command, int& samples, const std::string& what);

} // namespace taa::cli
