#include "core/inspect/Views.h"

#include "core/gl/PassTimer.h"
#include "core/inspect/ReferenceOfShot.h"
#include "core/measure/Profiler.h"
#include "core/render/CaptureFacts.h"
#include "core/replay/ShotPlayer.h"
#include "core/settings/Parameters.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace taa {

namespace {

Layer layerOf(const ExposedRows& exposedRows, IntermediateId id) {
  return {&exposedRows.texture(id), exposedRows.layer(id), exposedRows.firstChannel(id)};
}

/// As many pixels of a region as one run of the resolve exposes all rows of.
glm::ivec2 previewTexels(const gl::Rect& region) {
  const double pixels = static_cast<double>(region.width) * region.height;
  const double scale = std::min(1.0, std::sqrt(kFewTexels / pixels));
  return glm::max(glm::ivec2(scale * glm::dvec2(region.width, region.height)), glm::ivec2(1));
}

} // namespace

Views::Views(ShotPlayer& player, Visualizer& visualizer, ReferenceOfShot& reference)
    : player_(player), visualizer_(visualizer), reference_(reference), rowsBefore_(player) {}

void Views::watch(const std::vector<IntermediateId>& ids) {
  player_.watch(ids);
}

Image Views::image(IntermediateId id, int lane, std::optional<gl::Rect> region) {
  const glm::ivec2 size = player_.picturePx();
  const gl::Rect part = region.value_or(gl::Rect{0, 0, size.x, size.y});
  const gl::PassGroup group(pass_group::kExposure);
  assert(part.x >= 0 && part.y >= 0 && part.x + part.width <= size.x && part.y + part.height <= size.y);
  if (isOfReference(id)) return reference_.image(id, part, lane);
  return player_.exposed(id, lane).image(id, part);
}

std::vector<Image> Views::images(const std::vector<IntermediateId>& ids, int lane) {
  const ShownLane& shown = player_.lane(lane);
  std::vector<IntermediateId> missing;
  for (IntermediateId id : ids)
    if (!isOfReference(id) && !(shown.isExposed && shown.watched.holds(id)) &&
        std::ranges::find(missing, id) == missing.end())
      missing.push_back(id);
  ExposedRows exposedRows;
  if (!missing.empty()) exposedRows = player_.maker().expose(player_.state(), player_.shown(), missing, lane);
  std::vector<Image> images;
  images.reserve(ids.size());
  for (IntermediateId id : ids)
    images.push_back(isOfReference(id) ? image(id, lane)
                                       : (exposedRows.holds(id) ? exposedRows : shown.watched).image(id));
  return images;
}

Picture Views::picture(IntermediateId id, const ViewStyle& style, const ViewTransform& transform, int width,
                       int height, int lane) {
  const gl::PassGroup exposing(pass_group::kExposure);
  if (isOfReference(id)) return pictureOfReference(id, style, transform, {width, height}, lane);
  const ExposedRows& exposedRows = player_.exposed(id, lane);
  const gl::PassGroup drawing(pass_group::kViews);
  return visualizer_.draw(exposedRows.texture(id), exposedRows.layer(id), exposedRows.firstChannel(id),
                          intermediate(id), style, transform, width, height);
}

// One without a reference is empty: nothing is covered.
Picture Views::pictureOfReference(IntermediateId id, const ViewStyle& style, const ViewTransform& transform,
                                  const glm::ivec2& size, int lane) {
  if (const gl::Texture* texture = reference_.texture(id, lane))
    return visualizer_.draw(*texture, 0, 0, intermediate(id), style, transform, size.x, size.y);
  return {size.x, size.y, std::vector<std::uint8_t>(std::size_t(4) * size.x * size.y)};
}

Picture Views::thumbnail(IntermediateId id, const glm::ivec2& texels, int lane) {
  const gl::PassGroup group(pass_group::kThumbnails);
  if (isOfReference(id)) {
    const float width = static_cast<float>(player_.picturePx().x);
    const ViewTransform whole{.zoom = static_cast<float>(texels.x) / width};
    return pictureOfReference(id, defaultStyle(intermediate(id)), whole, texels, lane);
  }
  return thumbnails_.draw(player_.maker().pass, visualizer_, player_.resolved(lane), id, texels);
}

std::optional<Picture> Views::preview(const Settings& settings, const ViewRequest& view) {
  const gl::PassGroup group(pass_group::kThumbnails);
  const auto capture = player_.state().frames->capture();
  const Settings used = capture ? settingsOn(*capture, settings) : settings;
  const ShownLane& shown = player_.lane(view.lane);
  const bool isOfResolve = !isOfReference(view.id) && intermediate(view.id).stage != Stage::Output;
  if (!isOfResolve || !sameInputs(used, player_.settings(view.lane)) || !shown.inputs->areDrawn) return {};
  const gl::Rect region = visiblePixels(view, player_.picturePx());
  if (region.width <= 0 || region.height <= 0) return {};
  const glm::ivec2 texels = previewTexels(region);
  if (previewRows_.region() != region || previewRows_.texels() != texels)
    previewRows_ = ExposedRows(allRows(), region, texels);
  TaaPass& pass = player_.maker().pass;
  if (!pass.isPrepared(used, previewRows_)) return {};
  pass.expose(shown.inputs->textures, shown.previous.get(), *shown.current, used, previewRows_);
  const Layer layer = layerOf(previewRows_, view.id);
  const float texelsPerPixel = static_cast<float>(texels.x) / static_cast<float>(region.width);
  ViewTransform transform = view.transform;
  transform.origin = (transform.origin - glm::vec2(region.x, region.y)) * texelsPerPixel;
  transform.zoom /= texelsPerPixel;
  return visualizer_.draw(*layer.texture, layer.layer, layer.firstChannel, intermediate(view.id), view.style,
                          transform, view.width, view.height);
}

const FrameInputs& Views::inputs(int lane) const {
  return player_.inputs(lane);
}

void Views::keepComparisonFrames(const std::vector<int>& frames, const Progress& progress) {
  player_.keepComparisonFrames(frames, progress);
}

bool Views::isCached(const PictureSource& source) const {
  if (!player_.isOpen() || static_cast<std::size_t>(source.lane) >= player_.state().lanes.size())
    return false;
  const ShownFrame* frame = player_.find(source.frame);
  if (!isOfReference(source.id) || !frame) return frame != nullptr;
  return frame == &player_.shown() && reference_.has(source.id, source.lane);
}

bool Views::isExact(const PictureSource& source) const {
  return player_.find(source.frame)->lanes[static_cast<std::size_t>(source.lane)].exact;
}

// Of what lies in a texture of its own: exposed first, where that exposes something.
Layer Views::separateLayer(const PictureSource& source) {
  if (source.alongMotion) return {&rowsBefore_.texture(source), 0, 0, true};
  return isOfReference(source.id) ? Layer{reference_.texture(source.id, source.lane)} : Layer{};
}

// Rows of one lane's frame are exposed together. What lies over a picture along the motion is of the
// frame on show, whose pixels it has.
DrawnLayers Views::layersOf(const PictureSource& source, const std::optional<PictureSource>& minus,
                            const ViewStyle& style) {
  const gl::PassGroup group(pass_group::kExposure);
  const ShotState& state = player_.state();
  FrameMaker& maker = player_.maker();
  DrawnLayers layers{.row = separateLayer(source), .minus = minus ? separateLayer(*minus) : Layer{}};
  ShownFrame& frame = source.alongMotion ? player_.shown() : *player_.find(source.frame);
  const bool isSameFrame = minus && minus->lane == source.lane && player_.find(minus->frame) == &frame;
  std::vector<IntermediateId> ids;
  if (!layers.row.texture) ids.push_back(source.id);
  if (isSameFrame && !layers.minus.texture) ids.push_back(minus->id);
  if (style.markRejected) ids.push_back(IntermediateId::rejectReason);
  if (style.outlineObjects) ids.push_back(IntermediateId::objectId);
  if (!ids.empty()) {
    const ExposedRows& exposedRows = maker.exposedAll(state, frame, inTableOrder(ids), source.lane);
    if (!layers.row.texture) layers.row = layerOf(exposedRows, source.id);
    if (isSameFrame && !layers.minus.texture) layers.minus = layerOf(exposedRows, minus->id);
    if (style.markRejected) layers.rejectReason = layerOf(exposedRows, IntermediateId::rejectReason);
    if (style.outlineObjects) layers.objectId = layerOf(exposedRows, IntermediateId::objectId);
  }
  if (minus && !layers.minus.texture)
    layers.minus =
        layerOf(maker.exposed(state, *player_.find(minus->frame), minus->id, minus->lane), minus->id);
  return layers;
}

Picture Views::picture(const PictureSource& source, const std::optional<PictureSource>& minus,
                       const ViewStyle& style, const ViewTransform& transform, int width, int height) {
  if (isOfReference(source.id) && !isCached(source))
    return pictureOfReference(source.id, style, transform, {width, height}, source.lane);
  assert(isCached(source) && (!minus || isCached(*minus)));
  const DrawnLayers layers = layersOf(source, minus, style);
  const gl::PassGroup group(pass_group::kViews);
  return visualizer_.draw(layers, intermediate(source.id), style, transform, width, height);
}

Absence Views::absenceOf(const PictureSource& source) const {
  return source.alongMotion ? absenceBefore(player_.state(), player_.shown().frame, source.id)
                            : Absence::None;
}

PartialImage Views::values(const PictureSource& source, const std::optional<PictureSource>& minus,
                           const gl::Rect& region) {
  assert(isCached(source) && (!minus || isCached(*minus)));
  const gl::PassGroup group(pass_group::kExposure);
  const auto valuesOf = [&](const PictureSource& of) -> PartialImage {
    if (of.alongMotion)
      return partOf(rowsBefore_.values(of), {region.x, region.y}, {region.width, region.height});
    if (isOfReference(of.id)) return {reference_.image(of.id, region, of.lane), {}};
    const ExposedRows& exposedRows =
        player_.maker().exposed(player_.state(), *player_.find(of.frame), of.id, of.lane);
    return {exposedRows.image(of.id, region), {}};
  };
  PartialImage own = valuesOf(source);
  return minus ? differenceOf(intermediate(source.id), own, valuesOf(*minus)) : own;
}

} // namespace taa
