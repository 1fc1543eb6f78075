// Regions whose motion is wrong, by what is wrong with it: one fault and all that it shows in.
#pragma once

#include "core/doctor/motion/MotionJudgement.h"
#include "core/doctor/motion/MotionWords.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace taa::doctor {

/// One fault and the regions that it shows in, which live as long as what was judged.
struct FaultGroup {
  FaultWords fault;
  std::optional<std::size_t> trial;
  std::vector<const JudgedRegion*> regions;
  double pixels = 0.0;
};

/// Whether the motion of surfaces is that of the cameras at so many pixels that these are right.
bool areCamerasRight(const std::vector<JudgedRegion>& judged);

/// Those that show in the most pixels first.
std::vector<FaultGroup> groupsOf(const std::vector<JudgedRegion>& judged,
                                 const std::vector<MotionTrial>& trials, const FrameNames& names);

/// Whether depth and matrices tell it.
bool isChecked(const FaultGroup& group);
/// Whether no pixels speak for it, but outlines.
bool isOutlined(const FaultGroup& group);
/// Whether nothing speaks for it but the centroids of small objects.
bool isOfCentroids(const FaultGroup& group);
/// Whether one region leaves no other explanation: it decides for all that the fault shows in.
bool isTold(const FaultGroup& group);
bool isSure(const FaultGroup& group);

/// Explanations that fit all regions as well and lead to the same places: x negated, where nothing moves
/// along y, is both negated.
std::vector<std::size_t> alikesOf(const FaultGroup& group);
/// Of the faults that a group's other explanations would be.
std::vector<std::string> alikeIds(const FaultGroup& group, const std::vector<MotionTrial>& trials);

} // namespace taa::doctor
