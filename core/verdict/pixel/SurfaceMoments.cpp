#include "core/verdict/pixel/SurfaceMoments.h"

#include "core/verdict/pixel/PixelVerdict.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taa {

namespace {

/// How far a moment's color, as shown, is from the mean of those beside it.
glm::dvec3 bendOf(const std::vector<SurfaceMoment>& moments, std::size_t at,
                  glm::dvec3 SurfaceMoment::*color) {
  return glm::abs(shownValue(moments[at].*color) -
                  0.5 * (shownValue(moments[at - 1].*color) + shownValue(moments[at + 1].*color)));
}

double largestOfRow(const twin::PixelRecord& record, IntermediateId id) {
  return largestMagnitude(glm::dvec3(glm::vec3(twin::at(record, id))));
}

} // namespace

double largestMagnitude(const glm::dvec3& value) {
  return std::max({std::fabs(value.x), std::fabs(value.y), std::fabs(value.z)});
}

double recordValue(const twin::PixelRecord& record, IntermediateId id) {
  return static_cast<double>(twin::at(record, id).x);
}

double flickerOf(const std::vector<SurfaceMoment>& moments) {
  std::vector<double> bends;
  for (std::size_t at = 1; at + 1 < moments.size(); ++at) {
    const glm::dvec3 beyond =
        bendOf(moments, at, &SurfaceMoment::resolved) - bendOf(moments, at, &SurfaceMoment::reference);
    bends.push_back(std::max({0.0, beyond.x, beyond.y, beyond.z}));
  }
  // A single moment that stands out bends its neighbors, too: of few moments they are no quarter of all.
  constexpr std::size_t kBendsOfOne = 3;
  if (bends.size() <= kBendsOfOne) return 0.0;
  std::ranges::sort(bends);
  return bends[std::min((3 * bends.size()) / 4, bends.size() - 1 - kBendsOfOne)];
}

bool isHighlight(const std::vector<SurfaceMoment>& moments) {
  return std::ranges::any_of(moments, [](const SurfaceMoment& moment) {
    return largestMagnitude(moment.reference) > 1.0 ||
           largestOfRow(moment.record, IntermediateId::color) > 1.0 ||
           largestOfRow(moment.record, IntermediateId::currentFiltered) > 1.0;
  });
}

bool wasBehind(const twin::PixelRecord& record) {
  const double found = recordValue(record, IntermediateId::historyDepth);
  return recordValue(record, IntermediateId::rejectReason) == 4.0 && // RejectReason::Depth
         found > 0.0 && found < recordValue(record, IntermediateId::depthExpected);
}

} // namespace taa
