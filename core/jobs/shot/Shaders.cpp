#include "core/jobs/shot/Shaders.h"

#include "core/base/ShownText.h"

#include <exception>
#include <utility>

namespace taa {

void Shaders::take(const request::ReloadShaders&) {
  read_.emplace();
  try {
    jobContext_.inspector.shot().reloadShaders();
    jobContext_.noteChange(RequestKind::Shaders);
    jobContext_.isReplayStopped = false;
  } catch (const std::exception& failed) {
    read_->error = shownReason(failed);
  }
}

void Shaders::deliver() {
  if (read_) jobContext_.tell(RequestKind::Shaders, *std::exchange(read_, {}));
}

} // namespace taa
