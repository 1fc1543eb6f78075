// What the window is called by.
#pragma once

#include <QString>

namespace taa::app {

class Session;

/// "balanced*": the star says that settings were changed since.
QString settingsName(const Session& session);
/// Source, settings, size.
QString titleText(const Session& session);

} // namespace taa::app
