// Why OpenGL cannot be had here, as a sentence that names the cause and what to change: a function of what
// EGL and the driver offered and of the environment.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace taa::gl {

/// Where the start of OpenGL ended.
enum class StartStep {
  Library,     ///< EGL knows no driver
  Display,     ///< no driver opens a display
  DesktopGl,   ///< EGL offers OpenGL ES only
  Context,     ///< there is no OpenGL 4.5 core context
  Surfaceless, ///< the driver draws only into windows
  Crash,       ///< drawing with this driver ends the process, see isKnownToCrash()
};

struct StartFailure {
  StartStep step = StartStep::Display;
  std::string renderer{}, version{}; ///< GL_RENDERER, GL_VERSION of the newest context there is; empty: none
};

/// The value of a variable; nothing: it is not set.
using Environment = std::function<std::optional<std::string>(const char* name)>;

/// That of this process.
Environment processEnvironment();

/// Whether this driver ends the process when it draws the program's passes, by its GL_RENDERER and
/// GL_VERSION.
bool isKnownToCrash(const std::string& renderer, const std::string& version);

/// Names the variables that are the cause, where some are set so that they can be, and says to unset them;
/// else what to install, update or set. Never advises what is set already.
std::string refusal(const StartFailure& failure, const Environment& environment);

} // namespace taa::gl
