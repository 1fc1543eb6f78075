#include "core/doctor/color/ScreenTiles.h"

#include "core/capture/import/FrameSamples.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace taa::doctor {

namespace {

constexpr float kEdgeOfLuma = 0.02f;   ///< between the pixels on both sides
constexpr std::size_t kLeastEdges = 4; ///< pixels, along each axis
// Of luma in the mean: pictures hold no less where nothing moves, and clearly more.
constexpr double kFixedLuma = 0.002, kChangingLuma = 0.004;
constexpr float kJitteredPx = 0.05f;

/// The edges of a square in a pair of frames.
class TilePair {
 public:
  TilePair(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels, const glm::ivec2& first,
           const glm::ivec2& end)
      : frames_(frames), labels_(labels), jitterStep_(frames.jitterStep()) {
    for (int y = first.y; y < end.y; ++y)
      for (int x = first.x; x < end.x; ++x) addPixel({x, y});
  }

  void addTo(ScreenTile& tile) const {
    if (alongX_ < kLeastEdges || alongY_ < kLeastEdges) return;
    const auto pixels = static_cast<double>(sums_.pixels);
    ++tile.pairs;
    if (sums_.inPlace <= kFixedLuma * pixels) ++tile.fixed;
    if (sums_.inPlace > kChangingLuma * pixels) ++tile.changing;
    if (sums_.jittered < std::min(sums_.inPlace, sums_.asGiven)) ++tile.jittered;
    if (sums_.jittered < std::min(sums_.inPlace, sums_.moving())) ++tile.jitteredOfAll;
    tile.sums.add(sums_);
  }

 private:
  void addPixel(const glm::ivec2& pixel) {
    const Image& luma = frames_.now.luma;
    const bool isAlongX =
        std::abs(*luma.at(pixel.x + 1, pixel.y) - *luma.at(pixel.x - 1, pixel.y)) >= kEdgeOfLuma;
    const bool isAlongY =
        std::abs(*luma.at(pixel.x, pixel.y + 1) - *luma.at(pixel.x, pixel.y - 1)) >= kEdgeOfLuma;
    if (!isAlongX && !isAlongY) return;
    if (isAlongX) ++alongX_;
    if (isAlongY) ++alongY_;
    const glm::vec2 given = givenAt(pixel);
    const glm::vec2 world = cameraMotionPx(frames_.now, pixel).value_or(given);
    ++sums_.pixels;
    if (!isInside(labels_, frames_.now.sizePx(), pixel.x, pixel.y)) ++sums_.atSilhouette;
    sums_.inPlace += leftBy(pixel, -jitterStep_);
    sums_.jittered += leftBy(pixel, glm::vec2(0.0f));
    sums_.asGiven += leftBy(pixel, -given);
    sums_.unjittered += leftBy(pixel, -given - jitterStep_);
    sums_.ofWorld += leftBy(pixel, -world);
    sums_.ofWorldUnjittered += leftBy(pixel, -world - jitterStep_);
    sums_.worldPx += static_cast<double>(glm::length(world));
    sums_.givenPx += static_cast<double>(glm::length(given));
  }

  glm::vec2 givenAt(const glm::ivec2& pixel) const {
    if (frames_.now.motionPx.empty()) return glm::vec2(0.0f);
    const glm::vec2 given = frames_.now.motionAt(pixel.x, pixel.y);
    return isMotion(given) ? given : glm::vec2(0.0f);
  }

  /// `stepPx`: from the pixel to its place in the frame before, besides jitter.
  double leftBy(const glm::ivec2& pixel, const glm::vec2& stepPx) const {
    const glm::vec2 place = glm::vec2(pixel) + 0.5f + jitterStep_ + stepPx;
    return static_cast<double>(std::abs(*frames_.now.luma.at(pixel.x, pixel.y) -
                                        capture::betweenPixels(frames_.before.luma, place)));
  }

  const FrameNeighbors& frames_;
  const std::vector<RegionIndex>& labels_;
  glm::vec2 jitterStep_;
  std::size_t alongX_ = 0, alongY_ = 0;
  TileSums sums_;
};

} // namespace

void TileSums::add(const TileSums& other) {
  pixels += other.pixels;
  atSilhouette += other.atSilhouette;
  inPlace += other.inPlace;
  jittered += other.jittered;
  asGiven += other.asGiven;
  unjittered += other.unjittered;
  ofWorld += other.ofWorld;
  ofWorldUnjittered += other.ofWorldUnjittered;
  worldPx += other.worldPx;
  givenPx += other.givenPx;
}

void ScreenTiles::add(const FrameNeighbors& frames, const std::vector<RegionIndex>& regions) {
  sizePx = frames.now.sizePx();
  counts = (sizePx + kTilePx - 1) / kTilePx;
  tiles.resize(static_cast<std::size_t>(counts.x) * counts.y);
  for (int row = 0; row < counts.y; ++row)
    for (int column = 0; column < counts.x; ++column) {
      const glm::ivec2 first = kTilePx * glm::ivec2(column, row);
      const TilePair pair(frames, regions, glm::max(first, glm::ivec2(1)),
                          glm::min(first + kTilePx, sizePx - 1));
      pair.addTo(tiles[static_cast<std::size_t>(row) * counts.x + column]);
    }
  labels = regions;
  const auto firstSky = std::ranges::find(frames.now.depth.pixels, 0.0f);
  if (firstSky != frames.now.depth.pixels.end())
    sky = labels[static_cast<std::size_t>(firstSky - frames.now.depth.pixels.begin())];
  frame = frames.now.frame;
  ++pairs;
  if (glm::length(frames.jitterStep()) >= kJitteredPx) ++jitteredPairs;
}

} // namespace taa::doctor
