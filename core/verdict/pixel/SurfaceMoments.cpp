#include "core/verdict/pixel/SurfaceMoments.h"

#include "core/base/Median.h"
#include "core/verdict/pixel/PixelVerdict.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

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
    if (moments[at - 1].isJump || moments[at].isJump) break; // what was before it is another view
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

bool isBrighterThanWhite(const SurfaceMoment& moment) {
  return largestOfRow(moment.record, IntermediateId::color) > 1.0 ||
         largestOfRow(moment.record, IntermediateId::currentFiltered) > 1.0;
}

bool isHighlight(const std::vector<SurfaceMoment>& moments) {
  return std::ranges::any_of(moments, [](const SurfaceMoment& moment) {
    return largestMagnitude(moment.reference) > 1.0 || isBrighterThanWhite(moment);
  });
}

BrightFrames brightFrames(const std::vector<SurfaceMoment>& moments) {
  BrightFrames bright;
  for (const SurfaceMoment& moment : moments) {
    if (!isBrighterThanWhite(moment)) continue;
    ++bright.all;
    if (largestOfRow(moment.record, IntermediateId::color) <= 1.0) ++bright.filtered;
  }
  return bright;
}

std::size_t availableSamples(const std::vector<SurfaceMoment>& moments) {
  for (std::size_t at = 0; at < moments.size(); ++at) {
    const bool hadNone = rejectReasonOf(moments[at].record) == twin::RejectReason::NoHistory;
    if (hadNone || (moments[at].isUncovered && isRestart(moments[at].record))) return at + 1;
  }
  return moments.size();
}

twin::RejectReason rejectReasonOf(const twin::PixelRecord& record) {
  return static_cast<twin::RejectReason>(static_cast<int>(recordValue(record, IntermediateId::rejectReason)));
}

glm::dvec3 shownSample(const SurfaceMoment& moment) {
  return shownValue(glm::dvec3(glm::vec3(twin::at(moment.record, IntermediateId::color))));
}

double usualWeight(const std::vector<SurfaceMoment>& moments) {
  std::vector<double> weights;
  for (const SurfaceMoment& moment : moments)
    if (rejectReasonOf(moment.record) == twin::RejectReason::Kept)
      weights.push_back(recordValue(moment.record, IntermediateId::alpha));
  if (2 * weights.size() <= moments.size()) return 0.0;
  return upperMedian(std::move(weights));
}

bool areWeighedUnevenly(const std::vector<SurfaceMoment>& moments) {
  constexpr double kEvenlyWeighed = 0.75;
  const std::size_t available = availableSamples(moments);
  double left = 1.0, squares = 0.0; // Σw is 1
  for (std::size_t at = 0; at < available; ++at) {
    const bool isFirst = at + 1 == available;
    const double alpha = isFirst ? 1.0 : recordValue(moments[at].record, IntermediateId::alpha);
    squares += left * alpha * left * alpha;
    left *= 1.0 - alpha;
  }
  return 1.0 < kEvenlyWeighed * static_cast<double>(available) * squares;
}

bool isRestart(const twin::PixelRecord& record) {
  return recordValue(record, IntermediateId::alpha) >= 1.0;
}

double errorOfMean(const std::vector<SurfaceMoment>& moments, std::size_t count, IntermediateId row) {
  glm::dvec3 off(0.0);
  for (std::size_t at = 0; at < count; ++at)
    off += glm::dvec3(glm::vec3(twin::at(moments[at].record, row))) - moments[at].reference;
  const glm::dvec3& truth = moments.front().reference;
  return largestMagnitude(shownValue(truth + off / static_cast<double>(count)) - shownValue(truth));
}

} // namespace taa
