#include "core/capture/import/DrawnRectangle.h"

#include "core/base/Say.h"
#include "core/capture/planes/Planes.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace taa::capture {

namespace {

/// Pixels that have another color than one, of all frames that were added.
class Bounds {
 public:
  explicit Bounds(std::vector<float> around) : around_(std::move(around)) {}

  void add(const Image& color) {
    for (int y = 0; y < color.height; ++y)
      for (int x = 0; x < color.width; ++x) {
        if (std::equal(around_.begin(), around_.end(), color.at(x, y))) continue;
        low_ = glm::min(low_, glm::ivec2(x, y));
        high_ = glm::max(high_, glm::ivec2(x, y));
      }
  }
  /// Empty: all pixels have that color.
  DrawnRectangle rectangle() const {
    return high_.x < low_.x ? DrawnRectangle() : DrawnRectangle{low_, high_ - low_ + 1};
  }

 private:
  std::vector<float> around_;
  glm::ivec2 low_{kMaxCaptureSide}, high_{-1};
};

} // namespace

std::optional<DrawnRectangle> drawnRectangle(const std::filesystem::path& folder, const Manifest& manifest,
                                             const Progress& progress) {
  constexpr std::size_t kFrames = 4;
  constexpr double kLeast = 0.1, kMost = 0.95; // of the picture's area
  const std::size_t count = std::min(kFrames, manifest.frames.size());
  std::vector<Bounds> byCorner;
  for (std::size_t i = 0; i < count; ++i) {
    report(progress, say<"Looking where pictures lie">(), static_cast<int>(i), static_cast<int>(count));
    const std::size_t frame = count < 2 ? 0 : i * (manifest.frames.size() - 1) / (count - 1);
    const Image color = readPlane(folder, manifest, manifest.frames[frame], PlaneKind::Color).image;
    if (byCorner.empty())
      for (const int y : {0, color.height - 1})
        for (const int x : {0, color.width - 1})
          byCorner.emplace_back(std::vector<float>(color.at(x, y), color.at(x, y) + color.channels));
    for (Bounds& bounds : byCorner) bounds.add(color);
  }
  std::optional<DrawnRectangle> smallest;
  for (const Bounds& bounds : byCorner) {
    const DrawnRectangle rectangle = bounds.rectangle();
    const double share = rectangle.shareOf(manifest.sizePx);
    if (share < kLeast || share > kMost) continue;
    if (!smallest || rectangle.shareOf(smallest->sizePx) < 1.0) smallest = rectangle;
  }
  return smallest;
}

Manifest croppedTo(const DrawnRectangle& rectangle, Manifest manifest) {
  const auto crop = [&](std::map<PlaneKind, PlaneSource>& planes) {
    for (auto& [kind, source] : planes) {
      if (source.raw && source.sizePx.x == 0) source.sizePx = manifest.sizeOf(kind);
      source.atPx = source.atPx.value_or(glm::ivec2(0)) + rectangle.atPx;
    }
  };
  crop(manifest.planes);
  for (CapturedFrame& frame : manifest.frames) crop(frame.planes);
  manifest.sizePx = rectangle.sizePx;
  manifest.outputPx = {0, 0};
  return manifest;
}

} // namespace taa::capture
