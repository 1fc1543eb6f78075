// Contexts of one process draw one after the other.
#pragma once

#include "core/base/Progress.h"

#include <functional>

namespace taa::gl {

/// While one lives no other thread has one. Mesa's llvmpipe asks of every texture that is read whether a
/// context of the process still draws into it, and up to 22.3 at least goes through the lists of the others
/// without a lock: two threads that draw at once end the process. Code that draws where another thread may
/// draw takes this one; nothing is lost, since llvmpipe draws on all processors anyway. The thread that has
/// waited longest is next.
class ContextLock {
 public:
  ContextLock();
  /// Waits until all that was asked of GL is done.
  ~ContextLock();
  ContextLock(const ContextLock&) = delete;
  ContextLock& operator=(const ContextLock&) = delete;

  /// Lets others draw while `wait` is called, which does not.
  void restDuring(const std::function<void()>& wait);
  /// Lets threads draw that wait for the lock; returns at once where none does.
  void pass();
  /// As `progress`, but that others draw between two steps.
  Progress passing(const Progress& progress);
};

} // namespace taa::gl
