#include "core/doctor/motion/MotionReturns.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/doctor/motion/MotionFindings.h"
#include "core/doctor/motion/MotionWords.h"
#include "core/settings/Faults.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

constexpr std::size_t kEnoughReturned = 60;
/// A jump is so many times what motion changes by in the frame after, and so many px more.
constexpr double kReturnFactor = 3.0, kReturnPx = 2.0;

bool isReturnJump(const glm::dvec2& first, const glm::dvec2& next, const glm::dvec2& later) {
  return glm::distance(first, next) >= kReturnFactor * glm::distance(next, later) + kReturnPx;
}

} // namespace

std::string returnChange() {
  return say<"Where it was not drawn in the frame before, take the transform of then, not that of the frame "
             "it was last drawn in; or mark it as having no previous position.">();
}

void ReturnEvidence::add(const DoctorFrame& frame, const std::vector<RegionIndex>& labels) {
  if (frame.motionPx.empty()) return;
  if (!first_) first_ = frame.frame;
  if (frame.startsHistory) starts_.push_back(frame.frame);
  const auto width = static_cast<std::size_t>(frame.motionPx.width);
  const auto highest = std::ranges::max_element(labels);
  std::vector<Mean> means(highest == labels.end() ? 0 : static_cast<std::size_t>(*highest + 1));
  std::vector<bool> isSeen(means.size(), false);
  for (int y = 0; y < frame.motionPx.height; ++y)
    for (int x = 0; x < frame.motionPx.width; ++x) {
      const RegionIndex region = labels[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
      if (region == kNoRegion) continue;
      isSeen[static_cast<std::size_t>(region)] = true;
      const glm::vec2 motion = frame.motionAt(x, y);
      if (!isMotion(motion)) continue;
      Mean& mean = means[static_cast<std::size_t>(region)];
      ++mean.pixels;
      mean.sum += glm::dvec2(motion);
    }
  for (std::size_t i = 0; i < means.size(); ++i) {
    const auto region = static_cast<RegionIndex>(i);
    if (isSeen[i]) seen_[region].push_back(frame.frame);
    if (means[i].pixels > 0) means_[region][frame.frame] = means[i];
  }
}

std::vector<Return> ReturnEvidence::found() const {
  std::vector<Return> out;
  for (const auto& [region, means] : means_) {
    const std::vector<int>& seen = seen_.at(region);
    for (const int frame : seen) {
      const bool isNew = frame > *first_ && !std::ranges::binary_search(seen, frame - 1);
      if (!isNew || std::ranges::count(starts_, frame) > 0 || std::ranges::count(starts_, frame + 1) > 0)
        continue;
      const auto now = means.find(frame), next = means.find(frame + 1), later = means.find(frame + 2);
      if (now == means.end() || next == means.end() || later == means.end()) continue;
      if (std::min({now->second.pixels, next->second.pixels, later->second.pixels}) < kEnoughReturned)
        continue;
      if (isReturnJump(now->second.px(), next->second.px(), later->second.px()))
        out.push_back({region, frame, now->second.px(), next->second.px()});
    }
  }
  return out;
}

void tellReturns(std::vector<Return> returns, const std::vector<Region>& regions,
                 const CaptureInfo& captureInfo, Diagnosis& out) {
  // Parts that no number says come and go as motion and depth join and part them.
  std::erase_if(returns, [&](const Return& one) {
    return regions[static_cast<std::size_t>(one.region)].objectId == 0;
  });
  if (returns.empty()) return;
  Finding finding = faultFinding(Fault::OldTransformOnReturn);
  std::erase_if(out.findings, [&](const Finding& other) { return other.id == finding.id; });
  finding.confidence = Confidence::Likely;
  for (const Return& one : returns) {
    const RegionPlace place =
        placeOf(regions[static_cast<std::size_t>(one.region)], captureInfo, allPixels(captureInfo, out));
    finding.reason +=
        (finding.reason.empty() ? "" : " ") +
        say<"In frame %1 %2 is drawn and in the frame before it is not; you write %3 for it there, and "
            "%4 in the frame after.">(captureInfo.frameNames.of(one.frame), place.name,
                                      shortVector(storedMotion(captureInfo, one.px)),
                                      shortVector(storedMotion(captureInfo, one.next)));
    if (std::ranges::count(finding.regions, place.name, &RegionPlace::name) == 0)
      finding.regions.push_back(place);
  }
  std::ranges::stable_sort(finding.regions, std::greater(), &RegionPlace::share);
  finding.change = returnChange();
  out.findings.push_back(std::move(finding));
}

} // namespace taa::doctor
