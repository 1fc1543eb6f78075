#include "core/inspect/Inspector.h"

#include "core/base/Say.h"
#include "core/inspect/InspectorParts.h"
#include "core/probe/Probe.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

namespace taa {

void Inspector::watch(const std::vector<IntermediateId>& ids) {
  std::vector<IntermediateId> ofResolve, ofReference;
  for (const IntermediateId id : ids) {
    std::vector<IntermediateId>& once = isOfReference(id) ? ofReference : ofResolve;
    if (std::ranges::find(once, id) == once.end()) once.push_back(id);
  }
  parts_->maker.watched = std::move(ofResolve);
  parts_->watchedOfReference = std::move(ofReference);
}

Image Inspector::image(IntermediateId id, int lane, std::optional<gl::Rect> region) {
  const gl::Rect part = region.value_or(gl::Rect{0, 0, width(), height()});
  const gl::PassGroup group(pass_group::kExposure);
  assert(part.x >= 0 && part.y >= 0 && part.x + part.width <= width() && part.y + part.height <= height());
  if (isOfReference(id)) return parts_->referenceImage(id, part, lane);
  return parts_->maker.exposed(parts_->subject, parts_->shown, id, lane).image(id, part);
}

std::vector<Image> Inspector::images(const std::vector<IntermediateId>& ids, int lane) {
  const ShownLane& shown = parts_->lane(lane);
  std::vector<IntermediateId> missing;
  for (IntermediateId id : ids)
    if (!isOfReference(id) && !(shown.isExposed && shown.watched.holds(id)) &&
        std::ranges::find(missing, id) == missing.end())
      missing.push_back(id);
  Exposure exposure;
  if (!missing.empty()) exposure = parts_->maker.expose(parts_->subject, parts_->shown, missing, lane);
  std::vector<Image> images;
  images.reserve(ids.size());
  for (IntermediateId id : ids)
    images.push_back(isOfReference(id) ? image(id, lane)
                                       : (exposure.holds(id) ? exposure : shown.watched).image(id));
  return images;
}

PixelRecord Inspector::probe(int x, int y, int lane) {
  return probeAround(x, y, 0, lane).front();
}

std::vector<PixelRecord> Inspector::probeAround(int x, int y, int radius, int lane) {
  if (x < 0 || y < 0 || x >= width() || y >= height())
    throw Error(say<"pixel (%1, %2) lies outside the picture of %3 × %4 pixels">(x, y, width(), height()));
  const int left = std::max(0, x - radius), top = std::max(0, y - radius);
  const int right = std::min(width() - 1, x + radius), bottom = std::min(height() - 1, y + radius);
  const gl::Rect region{left, top, right - left + 1, bottom - top + 1};
  const ShownLane& shown = parts_->lane(lane);
  const gl::PassGroup group(pass_group::kProbe);
  std::vector<PixelRecord> inside = probeRegion(parts_->maker.pass, inputs(lane), shown.previous.get(),
                                                *shown.current, settings(lane), region);
  parts_->addReference(inside, region, lane);
  std::vector<PixelRecord> around;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx) {
      const int column = std::clamp(x + dx, left, right) - left, row = std::clamp(y + dy, top, bottom) - top;
      around.push_back(inside[static_cast<std::size_t>(row) * region.width + column]);
    }
  return around;
}

Picture Inspector::picture(IntermediateId id, const ViewStyle& style, const ViewTransform& transform,
                           int width, int height, int lane) {
  const gl::PassGroup exposing(pass_group::kExposure);
  if (isOfReference(id)) return parts_->referencePicture(id, style, transform, {width, height}, lane);
  const Exposure& exposure = parts_->maker.exposed(parts_->subject, parts_->shown, id, lane);
  const gl::PassGroup drawing(pass_group::kViews);
  return parts_->visualizer.draw(exposure.texture(id), exposure.layer(id), exposure.firstChannel(id),
                                 intermediate(id), style, transform, width, height);
}

const FrameInputs& Inspector::inputs(int lane) const {
  return parts_->inputs(lane);
}

} // namespace taa
