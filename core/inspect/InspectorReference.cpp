// The supersampled picture of the frame on show, and the rows that compare with it.
#include "core/base/Say.h"
#include "core/inspect/InspectorParts.h"
#include "core/inspect/MemoryNeed.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa {

ReferenceSubject InspectedShot::Parts::referenceSubject(int index) const {
  return {referenceRequest(subject.request(static_cast<std::size_t>(index))), shown.frame};
}

void InspectedShot::Parts::checkReference(int index, std::size_t more) const {
  const std::optional<std::size_t> available = gl::availableMemory(context.driver());
  if (!available) return;
  const glm::ivec2 size(subject.width, subject.height);
  const std::string refusal =
      referenceRefusal(referenceBytes(settings(index), size, hasFog()) + more, size, *available);
  if (!refusal.empty()) throw Error(refusal);
}

const ReferencePicture& InspectedShot::Parts::referenceOf(const Subject& of, int frame, int samples,
                                                          References& drawn, const Progress& progress) {
  const gl::PassGroup group(pass_group::kReference);
  const ReferenceSubject wanted{referenceRequest(of.request(0)), frame};
  for (const References* at : {&std::as_const(references), &std::as_const(drawn)})
    if (const ReferencePicture* picture = at->find(wanted); picture && picture->samples == samples)
      return *picture;
  drawn.refine(*of.renderer, wanted, samples, progress);
  return *drawn.find(wanted);
}

ReferenceRows* InspectedShot::Parts::referenceRows(int index) {
  const ReferenceSubject wanted = referenceSubject(index);
  const ReferencePicture* picture = references.find(wanted);
  if (!picture) return nullptr;
  ReferenceRows& rows = comparisons.at(static_cast<std::size_t>(index));
  const ReferenceRows::Origin origin{lane(index).current, settings(index), wanted, picture->samples};
  if (!rows.isOf(origin))
    rows.set(origin, picture->mean(),
             maker.exposed(subject, shown, IntermediateId::output, index).image(IntermediateId::output));
  return &rows;
}

ReferenceRows& InspectedShot::Parts::requiredReferenceRows(int index) {
  if (ReferenceRows* rows = referenceRows(index)) return *rows;
  throw Error(say<"there is no reference of frame %1 yet: it has to be drawn first">(shown.frame));
}

void InspectedShot::Parts::forgetReferences() {
  references.clear();
  for (ReferenceRows& rows : comparisons) rows.forget();
  for (FlickerRows& rows : flickers) rows.forget();
}

Image InspectedShot::Parts::referenceImage(IntermediateId id, const gl::Rect& region, int index) {
  if (!isOverTime(id)) return requiredReferenceRows(index).image(id, region);
  if (const FlickerRows* rows = flickerRows(id, index)) return rows->image(id, region);
  throw Error(say<"there is no flicker of frame %1 yet: it has to be measured first">(shown.frame));
}

const gl::Texture* InspectedShot::Parts::referenceTexture(IntermediateId id, int index) {
  if (isOverTime(id)) {
    FlickerRows* rows = flickerRows(id, index);
    return rows ? &rows->texture(id) : nullptr;
  }
  ReferenceRows* rows = referenceRows(index);
  return rows ? &rows->texture(id) : nullptr;
}

// One without a reference is empty: nothing is covered.
Picture InspectedShot::Parts::referencePicture(IntermediateId id, const ViewStyle& style,
                                               const ViewTransform& transform, const glm::ivec2& size,
                                               int index) {
  if (const gl::Texture* texture = referenceTexture(id, index))
    return visualizer.draw(*texture, 0, 0, intermediate(id), style, transform, size.x, size.y);
  return {size.x, size.y, std::vector<std::uint8_t>(std::size_t(4) * size.x * size.y)};
}

void InspectedShot::Parts::addReference(std::vector<PixelRecord>& around, const gl::Rect& region, int index) {
  const ReferenceRows* rows = referenceRows(index);
  for (int y = 0; y < region.height; ++y)
    for (int x = 0; x < region.width; ++x) {
      PixelRecord& record = around[static_cast<std::size_t>(y) * region.width + x];
      const glm::ivec2 pixel(region.x + x, region.y + y);
      for (const Intermediate& row : kIntermediates) {
        if (!isOfReference(row.id)) continue;
        glm::vec4& value = twin::at(record, row.id);
        if (const FlickerRows* over = isOverTime(row.id) ? flickerRows(row.id, index) : nullptr)
          value = over->map(row.id).texel(pixel.x, pixel.y);
        else if (rows && !isOverTime(row.id))
          value = referenceValue(row.id, twin::at(record, IntermediateId::output),
                                 rows->reference().texel(pixel.x, pixel.y));
      }
    }
}

void Inspector::makeRows(const std::vector<IntermediateId>& ids, int samples, const Progress& progress,
                         int lane) {
  const bool isCompared =
      std::ranges::any_of(ids, [](IntermediateId id) { return needsReference(id) && !isOverTime(id); });
  if (isCompared) refineReference(samples, progress, lane);
  const bool hasFlicker = std::ranges::count(ids, IntermediateId::flicker) > 0;
  if (std::ranges::any_of(ids, isOverTime)) refineFlicker(hasFlicker ? samples : 0, progress, lane);
}

void Inspector::refineReference(int samples, const Progress& progress, int lane) {
  const gl::PassGroup group(pass_group::kReference);
  parts_->checkReference(lane);
  parts_->references.refine(*parts_->subject.renderer, parts_->referenceSubject(lane), samples, progress);
}

int Inspector::referenceSamples(int lane) const {
  const ReferencePicture* picture = parts_->references.find(parts_->referenceSubject(lane));
  return picture ? picture->samples : 0;
}

void Inspector::setReferenceBudget(std::size_t bytes) {
  parts_->references.setBudget(bytes);
}

PictureError Inspector::referenceError(int lane) {
  return parts_->requiredReferenceRows(lane).error();
}

} // namespace taa
