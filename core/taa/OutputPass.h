// What is shown of a resolved picture: the rows of stage Output. Reads the history of the frame, never writes
// it.
#pragma once

#include "core/taa/PassInputs.h"
#include "core/taa/ProgramCache.h"
#include "core/taa/TaaPass.h"

#include <string>

namespace taa {

/// Whether what is shown may differ from the resolved picture (shaders/taa/output.glsl).
bool changesOutput(const Settings& settings);

/// What the program of this pass depends on, all else as by default, so that other choices share it.
Settings outputSettings(const Settings& settings);

/// GLSL that says whether something is laid over what is shown.
std::string overlayPrelude(bool hasOverlay);

/// Needs the current context for its whole life.
class OutputPass {
 public:
  OutputPass();

  /// Fills the rows of stage Output in `exposedRows`, whose region lies in the picture `resolved`, which may
  /// have another size than the inputs. Nothing to do when it holds none of them.
  void fill(const FrameInputs& inputs, const gl::Texture& resolved, const Settings& settings,
            const ExposedRows& exposedRows);

  /// Compiles the program for `settings` now; not when `layout` holds no row of stage Output.
  void prepare(const Settings& settings, const ExposedLayout& layout);

  ProgramCache programs;

 private:
  PassInputs passInputs_;
};

} // namespace taa
