// How long work reports where it is and learns that it should stop.
#pragma once

#include "core/base/Error.h"

#include <functional>
#include <string_view>

namespace taa {

/// Called with what is being done, steps done and steps in all; returns false to cancel. May be empty.
using Progress = std::function<bool(std::string_view what, int done, int total)>;

/// Reports to `progress` when there is one; throws Cancelled when it says so.
inline void report(const Progress& progress, std::string_view what, int done, int total) {
  if (progress && !progress(what, done, total)) throw Cancelled();
}

} // namespace taa
