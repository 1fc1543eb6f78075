// A GL 4.5 core context of our own: surfaceless EGL, no window system (manual, architecture).
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace taa::gl {

/// What the driver says of itself.
struct Driver {
  std::string vendor, renderer, version;
  bool isSoftware =
      false; ///< rasterizes on the CPU, zink over lavapipe included: timer queries around compute lie
  bool isExact = false; ///< llvmpipe or softpipe itself: has the bits of the CPU twins
  int maxTextureSize = 0;
};

/// Why this driver cannot draw the program's passes, where that is known from its name (GL_RENDERER) and
/// version (GL_VERSION): a sentence to refuse it with, since trying it would end the process.
std::optional<std::string> knownFault(const std::string& renderer, const std::string& version);

/// Makes the context current on the constructing thread and sets the conventions of the manual
/// (upper-left origin, depth 0…1). Use and destroy it on that thread. Throws Error when there is no GL 4.5 to
/// be had.
class Context {
 public:
  Context();
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  const Driver& driver() const { return driver_; }

  /// Again, on the thread that made it, after another context was made or destroyed there.
  void makeCurrent();

  /// Errors the driver reported since the last call. Tests and debug builds treat any of them as a failure.
  std::vector<std::string> takeMessages();

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
  Driver driver_;
};

/// Blocks until the GPU has done all that was asked of it; for timing where timer queries lie.
void finish();

/// Bytes that textures may still take: of the machine's memory for a software driver, else as the driver
/// says. Nothing where it does not say.
std::optional<std::size_t> availableMemory(const Driver& driver);

/// Throws Error naming `what` when GL has run out of memory or reported another error since the last check.
void checkErrors(const std::string& what);

/// The same of what was made under `label`; `what` is said only of memory that has run out.
void checkAllocated(const std::string& label, const std::string& what);

/// The Error of both for memory that has run out.
[[noreturn]] void throwOutOfMemory(const std::string& what);

} // namespace taa::gl
