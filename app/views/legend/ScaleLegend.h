// The short legend of a low picture.
#pragma once

#include "app/views/legend/Legend.h"

namespace taa::app {

/// Name, range and colors, and a sign for what is left out. Of categories the name alone: they take
/// lines of their own in a narrow strip.
void addScaleLegend(LegendFlow& flow, const LegendSide& side, const ThemeColors& colors);

} // namespace taa::app
