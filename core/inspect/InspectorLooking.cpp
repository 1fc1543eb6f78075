// Comparing: frames beside the one on show, differences, overlays.
#include "core/inspect/InspectorParts.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

namespace taa {

namespace {

Layer layerOf(const Exposure& exposure, IntermediateId id) {
  return {&exposure.texture(id), exposure.layer(id), exposure.firstChannel(id)};
}

} // namespace

ShownFrame* InspectedShot::Parts::find(const std::optional<int>& frame) {
  if (!frame || *frame == shown.frame) return &shown;
  const auto found = std::ranges::find(aside, *frame, &ShownFrame::frame);
  return found == aside.end() ? nullptr : &*found;
}

void Inspector::keepAside(const std::vector<int>& frames, const Progress& progress) {
  std::erase_if(parts_->aside, [&](const ShownFrame& kept) {
    return std::ranges::find(frames, kept.frame) == frames.end();
  });
  for (const int frame : frames) {
    assert(frame >= 0 && frame < frameCount());
    if (parts_->find(frame)) continue;
    try {
      parts_->aside.push_back(
          parts_->maker.replay(parts_->subject, parts_->checkpoints, frame, parts_->budget, progress));
    } catch (...) {
      parts_->keepShown();
      throw;
    }
    parts_->keepShown();
  }
}

bool Inspector::isAtHand(const Look& look) const {
  if (!parts_->isOpen() || look.lane >= laneCount()) return false;
  const ShownFrame* frame = parts_->find(look.frame);
  if (!isOfReference(look.id) || !frame) return frame != nullptr;
  if (frame != &parts_->shown) return false;
  return isOverTime(look.id) ? parts_->flickerRows(look.id, look.lane) != nullptr
                             : referenceSamples(look.lane) > 0;
}

bool Inspector::isExact(const Look& look) const {
  return parts_->find(look.frame)->lanes[static_cast<std::size_t>(look.lane)].exact;
}

// Rows of one lane's frame come out of one exposure.
DrawnLayers InspectedShot::Parts::layersOf(const Look& look, const std::optional<Look>& minus,
                                           const ViewStyle& style) {
  const gl::PassGroup group(pass_group::kExposure);
  ShownFrame& frame = *find(look.frame);
  const bool isSameFrame = minus && minus->lane == look.lane && find(minus->frame) == &frame;
  std::vector<IntermediateId> ids{look.id};
  if (isSameFrame) ids.push_back(minus->id);
  if (style.markRejected) ids.push_back(IntermediateId::rejectReason);
  if (style.outlineObjects) ids.push_back(IntermediateId::objectId);
  // First: comparing with the reference exposes the output.
  const auto referenceOf = [this](const Look& of) {
    return isOfReference(of.id) ? Layer{referenceTexture(of.id, of.lane)} : Layer{};
  };
  DrawnLayers layers{.row = referenceOf(look), .minus = minus ? referenceOf(*minus) : Layer{}};
  std::erase_if(ids, isOfReference);
  if (!ids.empty()) {
    const Exposure& exposure = maker.exposedAll(subject, frame, inTableOrder(ids), look.lane);
    if (!layers.row.texture) layers.row = layerOf(exposure, look.id);
    if (isSameFrame && !layers.minus.texture) layers.minus = layerOf(exposure, minus->id);
    if (style.markRejected) layers.rejectReason = layerOf(exposure, IntermediateId::rejectReason);
    if (style.outlineObjects) layers.objectId = layerOf(exposure, IntermediateId::objectId);
  }
  if (minus && !layers.minus.texture)
    layers.minus = layerOf(maker.exposed(subject, *find(minus->frame), minus->id, minus->lane), minus->id);
  return layers;
}

Picture Inspector::picture(const Look& look, const std::optional<Look>& minus, const ViewStyle& style,
                           const ViewTransform& transform, int width, int height) {
  if (isOfReference(look.id) && !isAtHand(look))
    return parts_->referencePicture(look.id, style, transform, {width, height}, look.lane);
  assert(isAtHand(look) && (!minus || isAtHand(*minus)));
  const DrawnLayers layers = parts_->layersOf(look, minus, style);
  const gl::PassGroup group(pass_group::kViews);
  return parts_->visualizer.draw(layers, intermediate(look.id), style, transform, width, height);
}

Image Inspector::image(const Look& look, const std::optional<Look>& minus, const gl::Rect& region) {
  assert(isAtHand(look) && (!minus || isAtHand(*minus)));
  const gl::PassGroup group(pass_group::kExposure);
  const auto values = [&](const Look& of) {
    if (isOfReference(of.id)) return parts_->referenceImage(of.id, region, of.lane);
    return parts_->maker.exposed(parts_->subject, *parts_->find(of.frame), of.id, of.lane)
        .image(of.id, region);
  };
  Image image = values(look);
  if (!minus) return image;
  const Image other = values(*minus);
  assert(other.channels == image.channels);
  for (std::size_t index = 0; index < image.pixels.size(); ++index)
    image.pixels[index] -= other.pixels[index];
  return image;
}

} // namespace taa
