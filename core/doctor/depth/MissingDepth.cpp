#include "core/doctor/depth/MissingDepth.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/doctor/motion/MotionFindings.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace taa::doctor {

namespace {

/// Four depths in a row, m, of which the outer two are one of each side: whether there is a step between the
/// inner ones that neither side goes on with.
bool isStep(float own2, float own, float other, float other2) {
  constexpr float kSlopes = 3.0f, kLeastShare = 0.003f;
  if ((own == 0.0f) != (other == 0.0f)) return true;
  const float slope = std::max(std::abs(own - own2), std::abs(other - other2));
  return std::abs(own - other) > kSlopes * slope + kLeastShare * own;
}

/// Of a region's squares: how many move as given where depth and matrices make something else, and how many
/// say.
struct Apart {
  std::size_t asGiven = 0, asked = 0;
  double px = 0.0; ///< sum, from what depth and matrices make
};

std::map<RegionIndex, Apart> apartOf(const FlowSeen& seen) {
  constexpr double kApartPx = 0.5;
  std::map<RegionIndex, Apart> out;
  for (const FlowPair& pair : seen.pairs)
    for (const FlowSquare& square : pair.squares) {
      if (!square.camera) continue;
      Apart& apart = out[square.region];
      ++apart.asked;
      const double px = glm::distance(square.px, *square.camera);
      if (px > std::max(kApartPx, kChanceErrors * square.errorPx) && square.offPx() < 0.5 * px) {
        ++apart.asGiven;
        apart.px += px;
      }
    }
  return out;
}

bool isApart(const Apart& apart) {
  constexpr std::size_t kEnough = 16;
  constexpr double kMost = 0.7;
  return apart.asGiven >= kEnough &&
         static_cast<double>(apart.asGiven) >= kMost * static_cast<double>(apart.asked);
}

} // namespace

void MissingDepth::add(const DoctorFrame& frame, const std::vector<RegionIndex>& labels) {
  if (frame.depthView.empty()) return;
  const auto highest = std::ranges::max_element(labels);
  const std::size_t count = highest == labels.end() ? 0 : static_cast<std::size_t>(*highest + 1);
  if (silhouettes_.size() < count) silhouettes_.resize(count);
  const glm::ivec2 size = frame.sizePx();
  const auto at = [&](const glm::ivec2& pixel) {
    return labels[static_cast<std::size_t>(pixel.y) * size.x + pixel.x];
  };
  const auto compare = [&](const glm::ivec2& first, const glm::ivec2& step) {
    const glm::ivec2 one = first + step, other = one + step, last = other + step;
    if (at(one) == at(other) || at(first) != at(one) || at(other) != at(last)) return;
    const auto depth = [&](const glm::ivec2& pixel) { return *frame.depthView.at(pixel.x, pixel.y); };
    const bool hasStep = isStep(depth(first), depth(one), depth(other), depth(last));
    for (const RegionIndex region : {at(one), at(other)}) {
      if (region == kNoRegion) continue;
      ++silhouettes_[static_cast<std::size_t>(region)].pairs;
      if (hasStep) ++silhouettes_[static_cast<std::size_t>(region)].steps;
    }
  };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      if (x + 3 < size.x) compare({x, y}, {1, 0});
      if (y + 3 < size.y) compare({x, y}, {0, 1});
    }
}

bool MissingDepth::isFlat(std::size_t region) const {
  constexpr std::size_t kEnough = 100;
  constexpr double kNoneShare = 0.05;
  return region < silhouettes_.size() && silhouettes_[region].pairs >= kEnough &&
         static_cast<double>(silhouettes_[region].steps) <=
             kNoneShare * static_cast<double>(silhouettes_[region].pairs);
}

void MissingDepth::tell(const FlowSeen& seen, const CaptureInfo& captureInfo, Diagnosis& out) const {
  Finding finding;
  double px = 0.0;
  std::size_t squares = 0;
  for (const auto& [region, apart] : apartOf(seen)) {
    const Region& of = seen.regions[static_cast<std::size_t>(region)];
    if (of.isSky || !isFlat(static_cast<std::size_t>(region)) || !isApart(apart)) continue;
    finding.regions.push_back(placeOf(of, captureInfo, allPixels(captureInfo, out)));
    px += apart.px;
    squares += apart.asGiven;
  }
  if (finding.regions.empty()) return;
  std::ranges::stable_sort(finding.regions, std::greater(), &RegionPlace::share);
  finding.id = "depthOfObjectMissing";
  finding.name = say<"An object missing in depth">();
  finding.confidence = Confidence::Likely;
  finding.symptom = say<"Motion and history that are made of depth are those of what is behind it.">();
  finding.reason = say<
      "Depth has no step at its outline, and %1 squares of it move as they are said to: %2 px from what that "
      "depth makes of them.">(squares, shortNumber(px / static_cast<double>(squares)));
  finding.change =
      say<"Draw it into depth as well. If it lies flat on what is behind it, and moves over it, this "
          "is as it should be.">();
  out.findings.push_back(std::move(finding));
  out.parts.takeBack(say<"Depth and matrices">());
}

} // namespace taa::doctor
