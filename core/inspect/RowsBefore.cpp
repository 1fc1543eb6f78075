#include "core/inspect/RowsBefore.h"

#include "core/render/FrameClock.h"
#include "core/replay/ShotPlayer.h"
#include "core/settings/Parameters.h"
#include "core/taa/twin/Known.h"

#include <cassert>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace taa {

namespace {

HistoryHandle currentHistory(const ShownFrame* frame, int lane) {
  return frame ? frame->lanes[static_cast<std::size_t>(lane)].current : nullptr;
}

gl::Texture partialTexture(const PartialImage& row) {
  const bool isWhole = row.absence.empty();
  Image texels(row.values.width, row.values.height, 4);
  for (int y = 0; y < texels.height; ++y)
    for (int x = 0; x < texels.width; ++x) {
      const float absence = isWhole ? 0.0f : *row.absence.at(x, y);
      float* texel = texels.at(x, y);
      for (int channel = 0; channel < row.values.channels && absence == 0.0f; ++channel)
        texel[channel] = row.values.at(x, y)[channel];
      texel[3] = absence;
    }
  gl::Texture texture({texels.width, texels.height, 1}, gl::Format::RGBA32F, "row of the frame before");
  texture.upload(texels);
  return texture;
}

} // namespace

Absence absenceBefore(const ShotState& state, int frame, IntermediateId id) {
  if (frame == 0) return Absence::FirstFrame;
  if (isCut(*state.scene, frame)) return Absence::Cut;
  const bool hasHistory = !startsHistory(state, frame) && !startsHistory(state, frame - 1);
  return isOfHistory(id) && !hasHistory ? Absence::NoHistory : Absence::None;
}

bool RowsBefore::isOf(const Origin& origin, const PictureSource& source) const {
  const ShownFrame* before = source.frame ? player_.find(source.frame) : nullptr;
  return origin.frame == player_.shown().frame && origin.settings == player_.settings(source.lane) &&
         origin.now.lock() == currentHistory(&player_.shown(), source.lane) &&
         origin.before.lock() == currentHistory(before, source.lane);
}

PartialImage RowsBefore::made(const PictureSource& source) {
  const Intermediate& row = intermediate(source.id);
  const Absence absence = absenceBefore(player_.state(), player_.shown().frame, source.id);
  if (absence != Absence::None) return absentImage(row, player_.picturePx(), absence);
  FrameMaker& maker = player_.maker();
  const std::vector<IntermediateId> places(std::begin(kPlacesBefore), std::end(kPlacesBefore));
  const ExposedRows& now = maker.exposedAll(player_.state(), player_.shown(), places, source.lane);
  const Image positions = now.image(kPlacesBefore[0]), motions = now.image(kPlacesBefore[1]);
  ShownFrame* before = player_.find(source.frame);
  assert(before && before->frame == player_.shown().frame - 1);
  const Image values = maker.exposed(player_.state(), *before, source.id, source.lane).image(source.id);
  return rowBefore(row, values, positions, motions);
}

// Those of frames that are gone are of no use any more.
RowsBefore::Kept& RowsBefore::kept(const PictureSource& source) {
  assert(source.alongMotion);
  const std::pair key(source.lane, source.id);
  if (const auto found = kept_.find(key); found != kept_.end() && isOf(found->second.origin, source))
    return found->second;
  std::erase_if(kept_, [this](const auto& entry) { return entry.second.origin.now.expired(); });
  const ShownFrame* before = source.frame ? player_.find(source.frame) : nullptr;
  Kept fresh{{currentHistory(&player_.shown(), source.lane), currentHistory(before, source.lane),
              player_.settings(source.lane), player_.shown().frame},
             made(source),
             {}};
  return kept_.insert_or_assign(key, std::move(fresh)).first->second;
}

const PartialImage& RowsBefore::values(const PictureSource& source) {
  return kept(source).values;
}

const gl::Texture& RowsBefore::texture(const PictureSource& source) {
  Kept& row = kept(source);
  if (row.texture.id() == 0) row.texture = partialTexture(row.values);
  return row.texture;
}

} // namespace taa
