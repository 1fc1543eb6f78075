// The settings that a built-in scene is opened with, so that it shows what it is about.
#pragma once

#include "core/settings/Settings.h"

#include <string>

namespace taa {

/// `settings` of `from` as `to`, another source, is opened with: what is still as the scene `from` wants it
/// goes back to the default, and what is the default then is set as the scene `to` wants it. What somebody
/// chose otherwise stays.
Settings settingsForScene(const Settings& settings, const std::string& from, const std::string& to);

} // namespace taa
