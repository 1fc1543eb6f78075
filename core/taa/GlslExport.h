// The resolve of some settings, and what is shown of it, as one GLSL file that needs nothing else, for
// somebody's own engine.
#pragma once

#include "core/gl/Program.h"
#include "core/settings/Settings.h"

#include <string>

namespace taa {

/// The resolve's program of these settings as it runs here when nothing of it is watched. Throws Error when a
/// file is missing.
gl::ShaderSource resolveSource(const Settings& settings);

/// The macro that makes of an exported file the pass after the resolve.
inline constexpr const char* kOutputMacro = "TAA_OUTPUT";

/// A whole fragment shader: the same computation with every setting put in as a constant and what they rule
/// out left out, the comments of what is left, and before it what goes in and out, by which conventions, and
/// the license. Where stage Output changes what is shown there are two: the other one, which draws the row
/// `output`, where kOutputMacro is defined. `title`: what these settings are called, on one line. Throws
/// Error.
std::string exportedGlsl(const Settings& settings, const std::string& title);

/// What to call settings that were changed from a preset: "balanced, weight.minimum=0.05".
std::string settingsTitle(const std::string& presetId, const Settings& settings, const Settings& preset);

} // namespace taa
