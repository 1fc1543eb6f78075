#include "app/commands/Tune.h"

#include "app/commands/Exports.h"
#include "app/commands/OwnPresets.h"
#include "app/dialogs/TuneDialog.h"

namespace taa::app {

void openTune(Session& session, OwnPresets& presets, Exports& exports, QWidget* window) {
  TuneDialog::openAt(session,
                     {[&presets](const Settings& found) { presets.askForNameOf(found); },
                      [&exports](const Settings& found) { exports.askForGlslOf(found); }},
                     window);
}

} // namespace taa::app
