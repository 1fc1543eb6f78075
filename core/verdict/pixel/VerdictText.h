// A verdict in a sentence. No GL.
#pragma once

#include "core/verdict/pixel/PixelVerdict.h"

#include <string>

namespace taa {

/// "Ghost of the red bar, 6 frames ago: no test of geometry runs, and history is kept as it is." `object`:
/// name of what causeObject is, empty where it has none; `settings` made the frames.
std::string verdictSentence(const PixelVerdict& verdict, int frame, const std::string& object,
                            const Settings& settings);

/// What of a verdict is measured: how far it is off and how much it changes, in steps of 255.
std::string verdictMeasures(const PixelVerdict& verdict);

} // namespace taa
