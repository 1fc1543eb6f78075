#include "core/verdict/pixel/OlderError.h"

#include <glm/geometric.hpp>

#include <cstddef>
#include <optional>

namespace taa {

namespace {

/// Pixels that count less in the one that is followed on are left out: it takes as long as one that is not.
constexpr double kOlderWeight = 0.02;

ErrorPart partOfOlder(const PixelError& error) {
  const double followed = error.frames.empty() ? 0.0 : 1.0 - error.frames.back().weight;
  ErrorPart made = ErrorPart::Older;
  if (followed <= 0.0) return made;
  double most = 0.5 * followed * glm::dot(error.error(), error.error());
  for (std::size_t part = 0; part < kErrorParts; ++part) {
    const double share = glm::dot(error.sum[part], error.error());
    if (static_cast<ErrorPart>(part) == ErrorPart::Older || share < most) continue;
    most = share;
    made = static_cast<ErrorPart>(part);
  }
  return made;
}

std::optional<OlderPlace> placeOfOlder(const PixelError& error) {
  return mainPart(error).part == ErrorPart::Older ? error.older : std::nullopt;
}

} // namespace

// A part's share is what of the error points its way: the shares sum up to 1.
MainPart mainPart(const PixelError& error) {
  MainPart main;
  const double square = glm::dot(error.error(), error.error());
  if (square == 0.0) return main;
  for (std::size_t part = 0; part < kErrorParts; ++part) {
    const double share = glm::dot(error.sum[part], error.error()) / square;
    if (share <= main.share) continue;
    main.share = share;
    main.part = static_cast<ErrorPart>(part);
  }
  if (main.part == ErrorPart::Older) main.part = partOfOlder(error);
  return main;
}

std::optional<PixelError> olderError(EvidenceSource& source, const PixelError& error,
                                     const Progress& progress) {
  LineageOptions options;
  options.frames = kFollowedFrames;
  options.minWeight = kOlderWeight;
  std::optional<PixelError> found;
  std::optional<OlderPlace> place = placeOfOlder(error);
  for (int step = 0; step < kOlderSteps && place; ++step) {
    found = pixelError(source, place->frame, place->pixel, options, progress);
    place = placeOfOlder(*found);
  }
  return found;
}

} // namespace taa
