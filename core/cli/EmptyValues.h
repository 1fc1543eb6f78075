// Options that are given without a value: --baseline "".
#pragma once

namespace CLI {
class App;
}

namespace taa::cli {

/// Refuses an empty value of any option of the command and of those below it: what is ignored is believed to
/// have had its effect. To be called when all options are there.
void refuseEmptyValues(CLI::App& app);

} // namespace taa::cli
