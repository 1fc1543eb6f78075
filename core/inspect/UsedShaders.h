// The shaders as they were when they were read last: files that are being edited change nothing until they
// compile.
#pragma once

#include "core/base/EmbeddedFiles.h"

namespace taa {

/// In use on this thread while it lives.
class UsedShaders {
 public:
  UsedShaders() { useShaders(readShaders()); }
  ~UsedShaders() { useShaders(nullptr); }
  UsedShaders(const UsedShaders&) = delete;
  UsedShaders& operator=(const UsedShaders&) = delete;
};

} // namespace taa
