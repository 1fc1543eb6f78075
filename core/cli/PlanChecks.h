// Whether what is asked of a shot is there once it is open, and whose mistake it is where it is not.
#pragma once

#include "core/cli/Shot.h"

#include <functional>
#include <string>

namespace taa::cli {

/// What is open, and how many frames it has.
struct OpenedShot {
  const Scene* scene; ///< null: a capture, which has nothing to choose
  int frames;
};

/// Throws UsageError that names the flag where the call asks for a camera, an object or a frame that is not
/// there, and Error that names the session where that does.
void checkWishes(const ShotPlan& plan, const OpenedShot& opened);

/// Calls `open`; whose mistake it is that there is no such animation or length is told as above.
void openChosen(const ShotPlan& plan, const std::function<void()>& open);

/// Throws UsageError that names the frames there are, Error where `frame` is that of the session.
void requireFrame(const ShotPlan& plan, const std::string& source, int frames, int frame);

} // namespace taa::cli
