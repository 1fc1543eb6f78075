// Opens the dialog that tunes settings, with the ways out of it.
#pragma once

class QWidget;

namespace taa::app {

class Exports;
class OwnPresets;
class Session;

/// That of `window`, which `presets` and `exports` belong to.
void openTune(Session& session, OwnPresets& presets, Exports& exports, QWidget* window);

} // namespace taa::app
