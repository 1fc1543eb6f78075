#include "core/inspect/ReferenceOfShot.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/gl/PassTimer.h"
#include "core/inspect/MemoryNeed.h"
#include "core/inspect/OverTimeOfShot.h"
#include "core/measure/Profiler.h"
#include "core/measure/References.h"
#include "core/render/CaptureFacts.h"
#include "core/replay/ShotPlayer.h"

#include <algorithm>
#include <memory>
#include <string>

namespace taa {

ReferenceOfShot::ReferenceOfShot(ShotPlayer& player, References& references, OverTimeOfShot& overTime,
                                 const gl::Driver& driver)
    : player_(player), references_(references), overTime_(overTime), driver_(driver) {}

void ReferenceOfShot::makeRows(const std::vector<IntermediateId>& ids, int samples, const Progress& progress,
                               int lane) {
  if (std::ranges::any_of(ids, isOfEngine) && !engineRows(lane)) throw Error(whyNoEngineOutput());
  const bool isCompared =
      std::ranges::any_of(ids, [](IntermediateId id) { return needsReference(id) && !isOverTime(id); });
  if (isCompared) refine(samples, progress, lane);
  const bool needsThem =
      std::ranges::any_of(ids, [](IntermediateId id) { return needsReference(id) && isOverTime(id); });
  overTime_.refine(kindsOverTime(ids), needsThem ? samples : 0, progress, lane);
}

void ReferenceOfShot::refine(int samples, const Progress& progress, int lane) {
  const gl::PassGroup group(pass_group::kReference);
  const glm::ivec2 size = player_.picturePx();
  requireReference(driver_, referenceBytes(player_.settings(lane), size, player_.scene()), size);
  references_.refine(*player_.state().frames, keyOf(lane), samples, progress);
}

int ReferenceOfShot::samples(int lane) const {
  const ReferencePicture* picture = references_.find(keyOf(lane));
  return picture ? picture->samples : 0;
}

void ReferenceOfShot::setBudget(std::size_t bytes) {
  references_.setBudget(bytes);
}

PictureError ReferenceOfShot::error(int lane) {
  return requiredRows(IntermediateId::reference, lane).compared().error();
}

PictureError ReferenceOfShot::errorOfFirst(int samples, int lane, const Progress& progress) {
  const Image reference = requiredRows(IntermediateId::reference, lane).reference();
  if (samples >= this->samples(lane)) return pictureError(reference, reference);
  return pictureError(references_.meanOfFirst(*player_.state().frames, keyOf(lane), samples, progress),
                      reference);
}

ReferenceKey ReferenceOfShot::keyOf(int lane) const {
  return {referenceRequest(player_.state().request(static_cast<std::size_t>(lane))), player_.shown().frame};
}

ReferenceRows* ReferenceOfShot::rows(int lane) {
  const ReferenceKey wanted = keyOf(lane);
  const ReferencePicture* picture = references_.find(wanted);
  if (!picture) return nullptr;
  ReferenceRows& rows = rows_.at(static_cast<std::size_t>(lane));
  const ReferenceRows::Origin origin{player_.lane(lane).current, player_.settings(lane), wanted,
                                     picture->samples};
  if (!rows.isOf(origin))
    rows.set(origin, picture->mean(),
             player_.exposed(IntermediateId::output, lane).image(IntermediateId::output));
  return &rows;
}

ReferenceRows* ReferenceOfShot::engineRows(int lane) {
  ReferenceRows& rows = engineRows_.at(static_cast<std::size_t>(lane));
  const ReferenceRows::Origin origin{player_.lane(lane).current, player_.settings(lane), keyOf(lane), 1};
  if (rows.isOf(origin)) return &rows;
  const std::shared_ptr<const Image> output = player_.state().frames->engineOutput(player_.shown().frame);
  if (!output) return nullptr;
  rows.set(origin, *output, player_.exposed(IntermediateId::resolved, lane).image(IntermediateId::resolved));
  return &rows;
}

ReferenceRows& ReferenceOfShot::requiredRows(IntermediateId id, int lane) {
  if (ReferenceRows* made = rowsOf(id, lane)) return *made;
  if (isOfEngine(id)) throw Error(whyNoEngineOutput());
  throw Error(say<"there is no reference of frame %1 yet: it has to be drawn first">(player_.shown().frame));
}

bool ReferenceOfShot::has(IntermediateId id, int lane) {
  if (isOfEngine(id)) return engineRows(lane) != nullptr;
  return isOverTime(id) ? overTime_.rows(id, lane) != nullptr : samples(lane) > 0;
}

Image ReferenceOfShot::image(IntermediateId id, const gl::Rect& region, int lane) {
  if (!isOverTime(id)) return requiredRows(id, lane).image(id, region);
  if (const RowsOverTime* made = overTime_.rows(id, lane)) return made->image(id, region);
  throw Error(say<"%1 of frame %2 is not there yet: it has to be measured first">(intermediate(id).label,
                                                                                  player_.shown().frame));
}

const gl::Texture* ReferenceOfShot::texture(IntermediateId id, int lane) {
  if (isOverTime(id)) {
    RowsOverTime* made = overTime_.rows(id, lane);
    return made ? &made->texture(id) : nullptr;
  }
  ReferenceRows* made = rowsOf(id, lane);
  return made ? &made->texture(id) : nullptr;
}

void ReferenceOfShot::addTo(std::vector<twin::PixelRecord>& records, const gl::Rect& region, int lane) {
  const ReferenceRows* made = rows(lane);
  const std::shared_ptr<const Image> ofEngine = player_.state().frames->engineOutput(player_.shown().frame);
  for (const Intermediate& row : kIntermediates) {
    if (!isOfReference(row.id)) continue;
    const bool isMap = isOverTime(row.id) || needsPixelsAround(row.id);
    const Image map = isMap && has(row.id, lane) ? image(row.id, region, lane) : Image();
    const Image* other = isOfEngine(row.id) ? ofEngine.get() : made ? &made->reference() : nullptr;
    if (isMap ? map.empty() : !other) continue;
    const IntermediateId ours = isOfEngine(row.id) ? IntermediateId::resolved : IntermediateId::output;
    for (int y = 0; y < region.height; ++y)
      for (int x = 0; x < region.width; ++x) {
        twin::PixelRecord& record = records[static_cast<std::size_t>(y) * region.width + x];
        twin::at(record, row.id) =
            isMap ? map.texel(x, y)
                  : referenceValue(row.id, twin::at(record, ours), other->texel(region.x + x, region.y + y));
      }
  }
}

void ReferenceOfShot::forget() {
  references_.clear();
  for (ReferenceRows& rows : rows_) rows.forget();
  for (ReferenceRows& rows : engineRows_) rows.forget();
  overTime_.forget();
}

} // namespace taa
