// What the render thread does with files: shaders read anew, frames exported.
#include "core/jobs/RenderWorker.h"

#include <exception>
#include <string>
#include <string_view>

namespace taa {

void RenderWorker::reloadShaders() {
  std::string error;
  try {
    inspector_.shot().reloadShaders();
    noteChange(RequestKind::Shaders);
    refinementStopped_ = false;
    // First: who hears that they are in use must know that the picture on show is not theirs yet.
    if (isOpen() && !inspector_.shot().isExact()) sendStatus();
  } catch (const std::exception& failed) {
    error = failed.what();
  }
  if (listener_.onShaders)
    listener_.onShaders(error);
  else if (!error.empty() && listener_.onError)
    listener_.onError({error, RequestKind::Shaders, latest_.of(RequestKind::Shaders)});
}

void RenderWorker::exportSequence(const SequenceRequest& request) {
  if (!isOpen()) return;
  ExportResult result{sequenceFile(request, request.first).string(), 0};
  attempt(RequestKind::Export, [&] {
    taa::exportSequence(inspector_, request, [this](std::string_view what, int done, int total) {
      if (listener_.onWork) listener_.onWork({std::string(what), done, total});
      return !ends_ && !pending_([](const Wishes& wishes) { return wishes.cancel; });
    });
    result.frames = request.last - request.first + 1;
  });
  ++version_; // a failed way back leaves another frame
  statusChanged_ = true;
  if (listener_.onWork) listener_.onWork({});
  if (listener_.onExported) listener_.onExported(result);
}

} // namespace taa
