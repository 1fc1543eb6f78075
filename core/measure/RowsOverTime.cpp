#include "core/measure/RowsOverTime.h"

#include "core/measure/Flicker.h"
#include "core/measure/ReferenceRows.h"
#include "core/measure/compare/GhostEnergy.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace taa {

std::optional<double> metricOverTime(Metric metric, const RowImages& rows) {
  const MetricInfo& info = metricInfo(metric);
  const Image& row = rows.at(intermediateNamed(info.row));
  if (overTimeOf(metric) == OverTime::Flicker) {
    const std::optional<double> mean = meanOverTime(row, rows.at(IntermediateId::framesFollowed));
    return mean && metric == Metric::GhostEnergy ? ghostEnergy(row) : mean;
  }
  double sum = 0.0;
  for (const float value : row.pixels)
    sum +=
        info.category < 0 ? std::fabs(static_cast<double>(value)) : static_cast<int>(value) == info.category;
  return (info.category < 0 ? 1.0 : 100.0) * sum / static_cast<double>(row.pixels.size());
}

void RowsOverTime::set(const Origin& origin, int samples, RowImages maps) {
  textures_.clear(); // the old pictures first: there may not be room for both
  origin_ = origin;
  samples_ = samples;
  maps_ = std::move(maps);
}

std::optional<int> RowsOverTime::samples(const Origin& origin) const {
  if (maps_.empty() || !(origin_ == origin)) return {};
  return samples_;
}

const Image& RowsOverTime::map(IntermediateId id) const {
  assert(isOverTime(id) && maps_.contains(id));
  return maps_.at(id);
}

Image RowsOverTime::image(IntermediateId id, const gl::Rect& region) const {
  const Image& whole = map(id);
  Image part(region.width, region.height, whole.channels);
  for (int y = 0; y < region.height; ++y)
    std::copy_n(whole.at(region.x, region.y + y), region.width * whole.channels, part.at(0, y));
  return part;
}

const gl::Texture& RowsOverTime::texture(IntermediateId id) {
  gl::Texture& texture = textures_[id];
  if (!texture) texture = rowTexture(map(id), "row over time");
  return texture;
}

} // namespace taa
