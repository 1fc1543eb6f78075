// Compiles programs of the resolve on a thread of its own, so that frames go on meanwhile.
#pragma once

#include "core/base/EmbeddedFiles.h"
#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>

#include <chrono>
#include <memory>
#include <vector>

namespace taa {

/// Something that may be resolved soon.
struct CompileRequest {
  Settings settings;
  glm::ivec2 picturePx{0};
  std::vector<IntermediateId> exposed; ///< in the run that is shown; none in those that are only replayed
};

/// Its thread has a GL context that shares nothing with others: what it compiles, drivers keep on disk,
/// where the context that draws finds it. Measured on llvmpipe (Mesa 22.3): what was compiled so is had in 13
/// ms of CPU instead of 310, and frames come no slower than one busy core makes them. Where the driver keeps
/// nothing on disk it is of no use and does no harm. Errors are left to whoever compiles it again.
class BackgroundCompiler {
 public:
  BackgroundCompiler();
  /// Waits for what is being compiled.
  ~BackgroundCompiler();
  BackgroundCompiler(const BackgroundCompiler&) = delete;
  BackgroundCompiler& operator=(const BackgroundCompiler&) = delete;

  /// With the shaders in use on the calling thread. One that has not begun gives way to the next.
  void want(CompileRequest request);
  /// Whether all is done by then.
  bool waitFor(std::chrono::milliseconds duration);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace taa
