// What the status line says of the pixel under the mouse.
#pragma once

#include <QString>

namespace taa::app {

class ViewPanel;

/// "A (12, 34)  0.5" with the values of both sides; empty: the mouse is on no pixel. `startsHistory`: the
/// frame on show has no history.
QString hoverText(const ViewPanel& view, bool startsHistory);

} // namespace taa::app
