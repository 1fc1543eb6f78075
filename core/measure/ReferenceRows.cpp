#include "core/measure/ReferenceRows.h"

#include "core/measure/compare/RelativeError.h"
#include "core/settings/Parameters.h"
#include "core/taa/twin/Color.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cassert>
#include <utility>

namespace taa {

glm::vec4 referenceValue(IntermediateId id, const glm::vec4& output, const glm::vec4& reference) {
  assert(isOfReference(id) && !isOverTime(id) && !needsPixelsAround(id));
  if (id == IntermediateId::reference || id == IntermediateId::engineOutput)
    return {glm::vec3(reference), 0.0f};
  const glm::vec3 is(output), should(reference);
  if (id == IntermediateId::referenceError || id == IntermediateId::engineDifference)
    return {twin::luma(is) - twin::luma(should), 0.0f, 0.0f, 0.0f};
  if (id == IntermediateId::relativeError)
    return {static_cast<float>(relativeError(is, should)), 0.0f, 0.0f, 0.0f};
  const glm::vec3 difference = glm::abs(is - should);
  return {std::max({difference.x, difference.y, difference.z}), 0.0f, 0.0f, 0.0f};
}

gl::Texture rowTexture(const Image& row, const std::string& label) {
  const bool isColor = row.channels == 3; // GL has no three channels that it must draw into
  Image texels(row.width, row.height, isColor ? 4 : 1);
  for (int y = 0; y < row.height; ++y)
    for (int x = 0; x < row.width; ++x) std::copy_n(row.at(x, y), row.channels, texels.at(x, y));
  gl::Texture texture({row.width, row.height, 1}, isColor ? gl::Format::RGBA32F : gl::Format::R32F, label);
  texture.upload(texels);
  return texture;
}

bool ReferenceRows::isOf(const Origin& origin) const {
  return samples_ == origin.samples && key_ == origin.key && settings_ == origin.settings &&
         current_.lock() == origin.current;
}

void ReferenceRows::set(const Origin& origin, Image reference, Image output) {
  forget(); // the old pictures first: there may not be room for both
  current_ = origin.current;
  settings_ = origin.settings;
  key_ = origin.key;
  samples_ = origin.samples;
  compared_ = PictureComparison(std::move(output), std::move(reference));
}

Image ReferenceRows::image(IntermediateId id, const gl::Rect& region) {
  const bool isWhole = region.width == reference().width && region.height == reference().height;
  if (needsPixelsAround(id) && isWhole) return compared_.map(id);
  if (needsPixelsAround(id))
    return compared_.mapPart(id, {region.x, region.y}, {region.width, region.height});
  Image row(region.width, region.height, intermediate(id).channels);
  for (int y = 0; y < region.height; ++y)
    for (int x = 0; x < region.width; ++x) {
      const int px = region.x + x, py = region.y + y;
      const glm::vec4 value =
          referenceValue(id, compared_.picture().texel(px, py), reference().texel(px, py));
      for (int channel = 0; channel < row.channels; ++channel) row.at(x, y)[channel] = value[channel];
    }
  return row;
}

const gl::Texture& ReferenceRows::texture(IntermediateId id) {
  gl::Texture& texture = textures_[id];
  if (texture) return texture;
  const gl::Rect whole{0, 0, reference().width, reference().height};
  texture = rowTexture(needsPixelsAround(id) ? compared_.map(id) : image(id, whole), "reference row");
  return texture;
}

} // namespace taa
