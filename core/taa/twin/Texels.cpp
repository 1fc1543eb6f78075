#include "core/taa/twin/Texels.h"

#include <algorithm>

namespace taa::twin {

Texels::Texels(int width_, int height_, int channels_, Fetch fetch, int tile)
    : lazy_(std::make_shared<Lazy>(Lazy{std::move(fetch), tile, {}})) {
  assert(tile > 0);
  width = width_;
  height = height_;
  channels = channels_;
}

glm::vec4 Texels::fetched(int x, int y) const {
  assert(x >= 0 && x < width && y >= 0 && y < height);
  const int side = lazy_->tile;
  const std::pair corner(x / side * side, y / side * side);
  auto tile = lazy_->tiles.find(corner);
  if (tile == lazy_->tiles.end())
    tile =
        lazy_->tiles
            .emplace(corner, lazy_->fetch(corner.first, corner.second, std::min(side, width - corner.first),
                                          std::min(side, height - corner.second)))
            .first;
  return tile->second.texel(x - corner.first, y - corner.second);
}

} // namespace taa::twin
