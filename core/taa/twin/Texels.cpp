#include "core/taa/twin/Texels.h"

#include <algorithm>

namespace taa::twin {

Texels::Texels(int width_, int height_, int channels_, Fetch fetch)
    : lazy_(std::make_shared<Lazy>(Lazy{std::move(fetch), {}})) {
  width = width_;
  height = height_;
  channels = channels_;
}

glm::vec4 Texels::fetched(int x, int y) const {
  assert(x >= 0 && x < width && y >= 0 && y < height);
  const std::pair corner(x / kTile * kTile, y / kTile * kTile);
  auto tile = lazy_->tiles.find(corner);
  if (tile == lazy_->tiles.end())
    tile =
        lazy_->tiles
            .emplace(corner, lazy_->fetch(corner.first, corner.second, std::min(kTile, width - corner.first),
                                          std::min(kTile, height - corner.second)))
            .first;
  return tile->second.texel(x - corner.first, y - corner.second);
}

} // namespace taa::twin
