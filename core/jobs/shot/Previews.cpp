#include "core/jobs/shot/Previews.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace taa {

bool Previews::isSlow() {
  if (!fromMs_ || !jobContext_.isOpen()) return false;
  if (const double last = jobContext_.inspector.shot().times().resolve; last > 0.0) resolveMs_ = last;
  return resolveMs_ >= *fromMs_;
}

bool Previews::tell(const Settings& settings) {
  if (!isSlow()) return false;
  bool isTold = false;
  for (std::size_t index = 0; index < subscriptions_.views.size(); ++index) {
    const ViewRequest& view = subscriptions_.views[index];
    if (!isShown(view) || view.lane != 0 || view.other) continue;
    jobContext_.attempt(RequestKind::Views, [&] {
      std::optional<Picture> picture = jobContext_.inspector.views().preview(settings, view);
      if (!picture) return;
      ViewResult result{
          .view = static_cast<int>(index), .request = view, .picture = {}, .values = {}, .region = {}};
      result.picture = std::move(*picture);
      result.frame = jobContext_.inspector.shot().frame();
      result.exact = false;
      result.isPreview = true;
      result.shotVersion = jobContext_.shotVersion();
      jobContext_.tell(RequestKind::Views, std::move(result));
      isTold = true;
    });
  }
  areShown_ = areShown_ || isTold;
  return isTold && jobContext_.waiting().settings();
}

void Previews::withdraw() {
  if (std::exchange(areShown_, false)) ++jobContext_.previewVersion;
}

} // namespace taa
