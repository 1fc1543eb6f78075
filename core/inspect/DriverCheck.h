// Whether this machine's driver computes presets within what GLSL allows.
#pragma once

#include "core/base/Progress.h"
#include "core/probe/Verification.h"

#include <string>

namespace taa {

class Inspector;

/// Things that move, come and go before a sky: presets do all they can there.
inline constexpr const char* kDriverCheckSource = "builtin:disocclusion";
inline constexpr int kDriverCheckWidth = 160, kDriverCheckHeight = 90;
inline constexpr int kDriverCheckFirst = 1, kDriverCheckLast = 2; ///< frames

/// Adds these frames of what is open, of all its lanes. Throws Error, Cancelled.
void verifyFrames(Inspector& inspector, int first, int last, FrameVerifier& verifier,
                  const Progress& progress = {});
/// The same by every whole preset in place of the settings.
void verifyPresets(Inspector& inspector, int first, int last, FrameVerifier& verifier,
                   const Progress& progress = {});

struct DriverCheck {
  std::string driver;
  Verification verification;
};
/// Of all whole presets on kDriverCheckSource, with an Inspector of its own: not on a thread that has one.
/// Throws Error, Cancelled.
DriverCheck checkDriver(const Progress& progress = {});

} // namespace taa
