// A picture and its reference: maps and numbers of how far they are apart, each made when it is first asked
// for. No GL.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"
#include "core/measure/Metrics.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>

#include <map>
#include <optional>

namespace taa {

/// The metrics that are of such two pictures alone.
constexpr bool isOfPictures(Metric metric) {
  return metricInfo(metric).needsReference && !metricInfo(metric).isOverTime &&
         metric != Metric::Supersampling;
}

class PictureComparison {
 public:
  PictureComparison() = default;
  /// Both scene-linear, of the same size, with three channels at least.
  PictureComparison(Image picture, Image reference);

  const Image& picture() const { return picture_; }
  const Image& reference() const { return reference_; }

  const PictureError& error();
  /// Expects isOfPictures(metric). Nothing where it is not defined: sharpness without edges. Costly ones
  /// report; throws Cancelled.
  std::optional<double> metric(Metric metric, const Progress& progress = {});
  /// Of a row that needsPixelsAround().
  const Image& map(IntermediateId id);
  /// A part of that map, bit for bit; made of what it takes alone while the whole is not there.
  Image mapPart(IntermediateId id, const glm::ivec2& firstPx, const glm::ivec2& sizePx) const;

 private:
  std::optional<double> computed(Metric metric, const Progress& progress);
  const Image& shown();
  const Image& shownReference();

  Image picture_, reference_;
  Image shown_, shownReference_; // empty: not made
  std::optional<PictureError> error_;
  std::map<IntermediateId, Image> maps_;
  std::map<Metric, std::optional<double>> metrics_;
};

} // namespace taa
