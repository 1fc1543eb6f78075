#include "core/measure/PictureComparison.h"

#include "core/measure/compare/Flip.h"
#include "core/measure/compare/HdrFlip.h"
#include "core/measure/compare/RelativeError.h"
#include "core/measure/compare/Sharpness.h"
#include "core/measure/compare/Ssim.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace taa {

namespace {

double meanOfMap(const Image& map) {
  return std::accumulate(map.pixels.begin(), map.pixels.end(), 0.0) / static_cast<double>(map.pixels.size());
}

Image partOfImage(const Image& image, const glm::ivec2& firstPx, const glm::ivec2& sizePx) {
  Image part(sizePx.x, sizePx.y, image.channels);
  for (int y = 0; y < sizePx.y; ++y)
    std::copy_n(image.at(firstPx.x, firstPx.y + y), sizePx.x * image.channels, part.at(0, y));
  return part;
}

Image unlikeness(const Image& shown, const Image& reference) {
  Image map = ssimMap(shown, reference);
  for (float& value : map.pixels) value = 1.0f - value;
  return map;
}

} // namespace

PictureComparison::PictureComparison(Image picture, Image reference)
    : picture_(std::move(picture)), reference_(std::move(reference)) {
  assert(picture_.width == reference_.width && picture_.height == reference_.height);
  assert(picture_.channels >= 3 && reference_.channels >= 3);
}

const Image& PictureComparison::shown() {
  if (shown_.empty()) shown_ = shownColors(picture_);
  return shown_;
}

const Image& PictureComparison::shownReference() {
  if (shownReference_.empty()) shownReference_ = shownColors(reference_);
  return shownReference_;
}

const PictureError& PictureComparison::error() {
  if (!error_) error_ = pictureError(picture_, reference_);
  return *error_;
}

const Image& PictureComparison::map(IntermediateId id) {
  assert(needsPixelsAround(id));
  const auto found = maps_.find(id);
  if (found != maps_.end()) return found->second;
  Image map =
      id == IntermediateId::flip ? flipMap(picture_, reference_) : unlikeness(shown(), shownReference());
  return maps_.emplace(id, std::move(map)).first->second;
}

Image PictureComparison::mapPart(IntermediateId id, const glm::ivec2& firstPx,
                                 const glm::ivec2& sizePx) const {
  assert(needsPixelsAround(id));
  const auto found = maps_.find(id);
  if (found != maps_.end()) return partOfImage(found->second, firstPx, sizePx);
  const int reach = id == IntermediateId::flip ? flipReach() : kSsimReach;
  const glm::ivec2 from = glm::max(firstPx - reach, glm::ivec2(0));
  const glm::ivec2 to = glm::min(firstPx + sizePx + reach, glm::ivec2(picture_.width, picture_.height));
  const Image picture = partOfImage(picture_, from, to - from);
  const Image reference = partOfImage(reference_, from, to - from);
  const Image map = id == IntermediateId::flip ? flipMap(picture, reference)
                                               : unlikeness(shownColors(picture), shownColors(reference));
  return partOfImage(map, firstPx - from, sizePx);
}

std::optional<double> PictureComparison::metric(Metric metric, const Progress& progress) {
  assert(isOfPictures(metric));
  const auto found = metrics_.find(metric);
  if (found != metrics_.end()) return found->second;
  return metrics_.emplace(metric, computed(metric, progress)).first->second;
}

std::optional<double> PictureComparison::computed(Metric metric, const Progress& progress) {
  switch (metric) {
  case Metric::Rmse:
    return error().rmse;
  case Metric::Psnr:
    return error().psnr;
  case Metric::RmseLinear:
    return error().rmseLinear;
  case Metric::RelativeMse:
    return relativeMse(picture_, reference_);
  case Metric::Ssim:
    return 1.0 - meanSsim(map(IntermediateId::ssimMap));
  case Metric::Flip:
    return meanOfMap(map(IntermediateId::flip));
  case Metric::HdrFlip:
    return meanOfMap(hdrFlipMap(picture_, reference_, progress));
  case Metric::Sharpness:
    return sharpness(shown(), shownReference());
  default:
    assert(false); // not of two pictures
    return {};
  }
}

} // namespace taa
