// Small pictures and figures: what the Inspector does besides frames.
#include "core/inspect/InspectorParts.h"

#include <cstddef>
#include <optional>

namespace taa {

Picture Inspector::thumbnail(IntermediateId id, const glm::ivec2& texels, int lane) {
  const gl::PassGroup group(pass_group::kThumbnails);
  if (isOfReference(id)) {
    const ViewTransform whole{.zoom = static_cast<float>(texels.x) / static_cast<float>(width())};
    return parts_->referencePicture(id, defaultStyle(intermediate(id)), whole, texels, lane);
  }
  return parts_->thumbnails.draw(parts_->maker.pass, parts_->visualizer, parts_->resolved(lane), id, texels);
}

void Inspector::setProfiling(bool on) {
  if (on == parts_->timer.has_value()) return;
  parts_->timer.reset();
  parts_->profiled = 0;
  if (on) parts_->timer.emplace(gl::timingMethodFor(driver()));
}

std::optional<FrameProfile> Inspector::takeProfile() {
  if (!parts_->timer || parts_->timer->framesStarted() == parts_->profiled) return {};
  parts_->profiled = parts_->timer->framesStarted();
  std::size_t checkpointBytes = 0;
  for (const Checkpoints& kept : parts_->checkpoints) checkpointBytes += kept.bytes();
  return profileOf(*parts_->timer, frame(), parts_->shown.sceneMs + parts_->shown.resolveMs, checkpointBytes);
}

StageCosts Inspector::measureStages(const Progress& progress, int lane) {
  return parts_->stageMeter.measure(parts_->maker.pass, parts_->resolved(lane), progress);
}

} // namespace taa
