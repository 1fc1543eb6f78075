#include "core/doctor/motion/MotionGroups.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace taa::doctor {

namespace {

/// Whether nothing that rests has motion, though depth and matrices move it.
bool isNothingOfCamera(const std::vector<JudgedRegion>& judged) {
  return std::ranges::none_of(judged, [](const JudgedRegion& region) {
    return region.consistency.verdict == ConsistencyVerdict::OfCamera && region.evidence->givenPx > 0.0;
  });
}

/// The region that says what a fault is called: of those that one explanation fits, one that motion was
/// written for tells more than one that has none; where what rests has none, likewise one that moves by
/// itself.
const JudgedRegion& namedBy(const JudgedRegion& region, const std::vector<JudgedRegion>& judged) {
  if (!region.trial || !isUnwritten(*region.evidence)) return region;
  const bool isNothing = isNothingOfCamera(judged);
  const JudgedRegion* surface = &region;
  for (const JudgedRegion& other : judged) {
    const bool isApart = isNothing && other.consistency.verdict == ConsistencyVerdict::Apart;
    if ((other.trial == region.trial || isApart) && !isUnwritten(*other.evidence)) return other;
    if (other.trial == region.trial && !other.region->isSky) surface = &other;
  }
  return *surface;
}

/// Explanations that depth and matrices fit as well.
std::vector<std::size_t> consistencyAlikes(const FaultGroup& group) {
  std::vector<std::size_t> out;
  for (const std::size_t other : group.regions.front()->decision.explanations)
    if (other != *group.trial) out.push_back(other);
  std::erase_if(out, [&](std::size_t other) {
    return !std::ranges::all_of(group.regions, [other](const JudgedRegion* region) {
      return !region->isChecked || std::ranges::count(region->decision.explanations, other) > 0;
    });
  });
  return out;
}

bool isBy(const FaultGroup& group, DecidedBy by) {
  return std::ranges::all_of(group.regions,
                             [by](const JudgedRegion* region) { return region->decision.by == by; });
}

} // namespace

bool areCamerasRight(const std::vector<JudgedRegion>& judged) {
  constexpr double kTrustedShare = 0.3;
  std::size_t known = 0, ofCamera = 0;
  for (const JudgedRegion& region : judged) {
    if (region.region->isSky || region.evidence->cameraPx == 0.0) continue;
    known += region.evidence->cameraKnown;
    ofCamera += region.evidence->ofCamera;
  }
  return known > 0 && static_cast<double>(ofCamera) >= kTrustedShare * static_cast<double>(known);
}

std::vector<FaultGroup> groupsOf(const std::vector<JudgedRegion>& judged,
                                 const std::vector<MotionTrial>& trials, const FrameNames& names) {
  const bool areRight = areCamerasRight(judged);
  std::vector<FaultGroup> groups;
  for (const JudgedRegion& region : judged) {
    if (region.decision.verdict != MotionVerdict::Wrong) continue;
    const MotionTrial* trial = region.trial ? &trials[*region.trial] : nullptr;
    const JudgedRegion& named = namedBy(region, judged);
    FaultWords fault = motionFault(trial, *named.region, *named.evidence, names, areRight);
    auto found = std::ranges::find_if(groups, [&](const FaultGroup& group) {
      return group.fault.id == fault.id && group.trial == region.trial;
    });
    if (found == groups.end()) {
      groups.push_back({std::move(fault), region.trial, {}, 0.0});
      found = groups.end() - 1;
    }
    found->regions.push_back(&region);
    found->pixels += region.region->pixels;
  }
  std::ranges::stable_sort(groups, std::greater(), &FaultGroup::pixels);
  return groups;
}

bool isChecked(const FaultGroup& group) {
  return group.regions.front()->isChecked;
}

bool isOutlined(const FaultGroup& group) {
  return isBy(group, DecidedBy::Outline);
}

bool isOfCentroids(const FaultGroup& group) {
  return isBy(group, DecidedBy::Centroids);
}

bool isTold(const FaultGroup& group) {
  return std::ranges::any_of(group.regions,
                             [](const JudgedRegion* region) { return rivalsOf(*region).empty(); });
}

bool isSure(const FaultGroup& group) {
  if (!alikesOf(group).empty()) return false;
  return isChecked(group) ? group.regions.front()->pixelsSay == PixelsSay::Yes : isTold(group);
}

std::vector<std::size_t> alikesOf(const FaultGroup& group) {
  std::vector<std::size_t> out;
  if (!group.trial) return out;
  if (isChecked(group)) return consistencyAlikes(group);
  for (const std::size_t other : group.regions.front()->decision.explanations) {
    const auto isSame = [other](const JudgedRegion* region) {
      return std::ranges::count(region->decision.explanations, other) > 0 && isAlike(*region, other);
    };
    if (other != *group.trial && std::ranges::all_of(group.regions, isSame)) out.push_back(other);
  }
  return out;
}

std::vector<std::string> alikeIds(const FaultGroup& group, const std::vector<MotionTrial>& trials) {
  std::vector<std::string> out;
  std::vector<std::size_t> others = alikesOf(group);
  if (!isChecked(group) && !isTold(group))
    for (const JudgedRegion* region : group.regions)
      for (const std::size_t rival : rivalsOf(*region)) others.push_back(rival);
  for (const std::size_t other : others) {
    const JudgedRegion& region = *group.regions.front();
    std::string id = motionFault(&trials[other], *region.region, *region.evidence).id;
    if (id != group.fault.id && std::ranges::count(out, id) == 0) out.push_back(std::move(id));
  }
  return out;
}

} // namespace taa::doctor
