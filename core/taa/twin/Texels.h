// A picture as the CPU twin reads it: all there, or fetched tile by tile where it is read.
#pragma once

#include "core/base/Image.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace taa::twin {

/// Coordinates and size are always those of the whole picture, so that what is computed from them is the
/// same however much of it is there.
class Texels : public Image {
 public:
  /// Side of tiles that hold what most pixels read of a picture.
  static constexpr int kTile = 16;
  /// The part whose upper left corner is (x, y).
  using Fetch = std::function<Image(int x, int y, int width, int height)>;

  Texels() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a picture is one that is all there
  Texels(Image image) : Image(std::move(image)) {}
  /// Read by `fetch`, which must be able to as long as somebody reads, in tiles that begin at multiples of
  /// their side.
  Texels(int width_, int height_, int channels_, Fetch fetch, int tile = kTile);

  glm::vec4 texel(int x, int y) const { return lazy_ ? fetched(x, y) : Image::texel(x, y); }
  /// Of a place beyond the border the nearest at it.
  glm::vec4 nearestTexel(int x, int y) const {
    return texel(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
  }
  bool empty() const { return !lazy_ && Image::empty(); }

 private:
  struct Lazy {
    Fetch fetch;
    int tile = kTile;
    std::map<std::pair<int, int>, Image> tiles;
  };
  glm::vec4 fetched(int x, int y) const;

  std::shared_ptr<Lazy> lazy_; // tiles are shared by copies
};

} // namespace taa::twin
