#include "core/doctor/motion/MotionReasons.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

constexpr std::size_t kShownResiduals = 12;

/// By what they leave; the first, and those that are always shown.
std::vector<Residual> sortedResiduals(std::vector<Residual> all) {
  std::ranges::stable_sort(all, {}, &Residual::value);
  std::size_t kept = 0;
  std::erase_if(all, [&](const Residual& residual) {
    return ++kept > kShownResiduals && !residual.isGiven && !residual.isBest;
  });
  return all;
}

/// What each explanation leaves of the pixels with detail of all regions of a group, × 1000. Where it says
/// the same as the motion given, it leaves the same.
std::vector<Residual> residualsOf(const FaultGroup& group, const std::vector<MotionTrial>& trials) {
  double given = 0.0, foundGain = 0.0;
  std::size_t pixels = 0;
  std::vector<double> gains(trials.size(), 0.0);
  for (const JudgedRegion* region : group.regions) {
    given += region->evidence->texturedError;
    pixels += region->evidence->textured;
    foundGain += region->evidence->found.gain();
    for (std::size_t t = 0; t < trials.size(); ++t) gains[t] += region->evidence->trials[t].gain();
  }
  const auto left = [&](double gain) {
    return 1000.0 * (given - gain) / static_cast<double>(std::max<std::size_t>(1, pixels));
  };
  std::vector<Residual> out;
  for (std::size_t t = 0; t < trials.size(); ++t)
    out.push_back({trialId(trials[t]), trialText(trials[t]), left(gains[t]), t == 0, t == group.trial});
  if (!group.trial) out.push_back({"found", say<"found by search">(), left(foundGain), false, true});
  return sortedResiduals(std::move(out));
}

/// Of an explanation, or of what the centroids of regions move by, over all regions of a group.
OutlineCounts outlineCounts(const FaultGroup& group, std::optional<std::size_t> trial) {
  OutlineCounts sum;
  for (const JudgedRegion* region : group.regions) {
    const OutlineEvidence& outline = region->evidence->outline;
    if (!trial)
      sum.add(outline.found);
    else if (*trial < outline.trials.size())
      sum.add(outline.trials[*trial]);
  }
  return sum;
}

/// Of the pixels near outlines, where the best one leads elsewhere than the motion given: the share that lay
/// outside, %. Where an explanation says the same as the motion given, it leaves the same.
std::vector<Residual> outlineResiduals(const FaultGroup& group, const std::vector<MotionTrial>& trials) {
  const OutlineCounts best = outlineCounts(group, group.trial);
  const auto left = [&](const OutlineCounts& counts) {
    const double gain = static_cast<double>(counts.given) - static_cast<double>(counts.tried);
    return std::max(0.0, 100.0 * (static_cast<double>(best.given) - gain) / static_cast<double>(best.pixels));
  };
  std::vector<Residual> out;
  for (std::size_t t = 0; t < trials.size(); ++t)
    out.push_back(
        {trialId(trials[t]), trialText(trials[t]), left(outlineCounts(group, t)), t == 0, t == group.trial});
  if (!group.trial) out.push_back({"found", say<"what its middle moves by">(), left(best), false, true});
  return sortedResiduals(std::move(out));
}

/// Of an explanation, over all objects of a group.
MiddleCounts middleCounts(const FaultGroup& group, std::size_t trial) {
  MiddleCounts sum;
  for (const JudgedRegion* region : group.regions) sum.add(region->evidence->middle.trials[trial]);
  return sum;
}

/// Where the best one leads elsewhere than the motion given: how far each is from the way of the centroids,
/// px.
std::vector<Residual> middleResiduals(const FaultGroup& group, const std::vector<MotionTrial>& trials) {
  const MiddleCounts best = middleCounts(group, *group.trial);
  std::vector<Residual> out;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    const MiddleCounts counts = middleCounts(group, t);
    const double left = std::max(0.0, best.given - (counts.given - counts.tried));
    out.push_back({trialId(trials[t]), trialText(trials[t]), left / static_cast<double>(best.samples), t == 0,
                   t == group.trial});
  }
  return sortedResiduals(std::move(out));
}

/// How far each explanation is from the camera's motion, of all regions of a group.
std::vector<DistanceCounts> distancesOf(const FaultGroup& group, std::size_t trialCount) {
  std::vector<DistanceCounts> out(trialCount);
  for (const JudgedRegion* region : group.regions)
    for (std::size_t t = 0; t < region->evidence->consistency.trials.size(); ++t)
      out[t].add(region->evidence->consistency.trials[t]);
  return out;
}

std::vector<Residual> consistencyResiduals(const FaultGroup& group, const std::vector<MotionTrial>& trials) {
  const std::vector<DistanceCounts> distances = distancesOf(group, trials.size());
  std::vector<Residual> out;
  for (std::size_t t = 0; t < trials.size(); ++t)
    if (distances[t].count() > 0)
      out.push_back(
          {trialId(trials[t]), trialText(trials[t]), distances[t].medianPx(), t == 0, t == group.trial});
  return sortedResiduals(std::move(out));
}

double percentOf(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string explanationNames(const std::vector<std::size_t>& explanations,
                             const std::vector<MotionTrial>& trials) {
  std::string names;
  for (const std::size_t trial : explanations)
    names += (names.empty() ? "" : "; ") + trialText(trials[trial]);
  return names;
}

std::string consistencyReason(const FaultGroup& group, const std::vector<MotionTrial>& trials) {
  const std::vector<DistanceCounts> distances = distancesOf(group, trials.size());
  std::string text =
      say<"At %1 pixels depth and matrices make the motion given if it is taken like this, to %2 px: %3. As "
          "given it is %4 px away.">(distances[*group.trial].count(),
                                     shortNumber(distances[*group.trial].medianPx()),
                                     trialText(trials[*group.trial]), shortNumber(distances[0].medianPx()));
  text += " " + (group.regions.front()->pixelsSay == PixelsSay::Yes
                     ? say<"The pictures confirm it.">()
                     : say<"The pictures have too little detail, or move too little, to confirm it.">());
  if (const std::vector<std::size_t> alikes = alikesOf(group); !alikes.empty())
    text += " " + say<"Here it leads to the same places as: %1.">(explanationNames(alikes, trials));
  return text;
}

std::string outlineReason(const FaultGroup& group, const std::vector<MotionTrial>& trials) {
  const OutlineCounts counts = outlineCounts(group, group.trial);
  std::string text = say<"There is too little detail to follow, but an outline moves: of %1 pixels inside it "
                         "%2 came from outside "
                         "of it by the motion given, and %3 by this: %4.">(
      counts.pixels, counts.given, counts.tried,
      group.trial ? trialText(trials[*group.trial]) : say<"what its middle moves by">());
  if (const std::vector<std::size_t> alikes = alikesOf(group); !alikes.empty())
    text += " " + say<"Here it leads to the same places as: %1.">(explanationNames(alikes, trials));
  return text;
}

std::string middleReason(const FaultGroup& group, const std::vector<MotionTrial>& trials) {
  const MiddleCounts counts = middleCounts(group, *group.trial);
  const auto mean = [&](double sum) { return shortNumber(sum / static_cast<double>(counts.samples)); };
  std::string text =
      say<"There is too little detail to follow, but the middle is seen to go %1 px away, in the "
          "mean over %2 objects and frames; the motions given, added up, miss it by %3 px, and "
          "taken like this by %4 px: %5.">(mean(counts.moved), counts.samples, mean(counts.given),
                                           mean(counts.tried), trialText(trials[*group.trial]));
  if (const std::vector<std::size_t> alikes = alikesOf(group); !alikes.empty())
    text += " " + say<"Here it leads to the same places as: %1.">(explanationNames(alikes, trials));
  return text;
}

std::string reasonOf(const FaultGroup& group, const std::vector<MotionTrial>& trials) {
  TrialEvidence sum;
  std::vector<std::size_t> rivals;
  for (const JudgedRegion* region : group.regions) {
    const TrialEvidence& trial =
        group.trial ? region->evidence->trials[*group.trial] : region->evidence->found;
    sum.given += trial.given;
    sum.tried += trial.tried;
    sum.cells += trial.cells;
    sum.cellsWon += trial.cellsWon;
    for (const std::size_t rival : rivalsOf(*region))
      if (std::ranges::count(rivals, rival) == 0) rivals.push_back(rival);
  }
  const std::string what =
      group.trial ? trialText(trials[*group.trial]) : say<"what a search finds in the frame before">();
  std::string text =
      say<"The motion given leaves %1 times as much of the pixels as this: %2; more in %3 % of %4 squares.">(
          shortNumber(sum.given / std::max(sum.tried, 1e-9)), what,
          std::lround(percentOf(sum.cellsWon, sum.cells)), sum.cells);
  if (const std::vector<std::size_t> alikes = alikesOf(group); !alikes.empty())
    text += " " + say<"Here it leads to the same places as: %1.">(explanationNames(alikes, trials));
  if (isTold(group)) return text;
  return text + " " + say<"These frames do not tell it from: %1.">(explanationNames(rivals, trials));
}

} // namespace

void tellEvidence(const FaultGroup& group, const std::vector<MotionTrial>& trials, Finding& out) {
  if (isChecked(group)) {
    out.reason = consistencyReason(group, trials);
    out.measure = say<"median distance from the camera's motion, px">();
    out.residuals = consistencyResiduals(group, trials);
  } else if (isOutlined(group)) {
    out.reason = outlineReason(group, trials);
    out.measure = say<"share of pixels inside an outline that came from outside of it, %">();
    out.residuals = outlineResiduals(group, trials);
  } else if (isOfCentroids(group)) {
    out.reason = middleReason(group, trials);
    out.measure = say<"mean distance from the way of the middle, px">();
    out.residuals = middleResiduals(group, trials);
  } else {
    out.reason = reasonOf(group, trials);
    out.measure = say<"mean difference of luma, × 1000">();
    out.residuals = residualsOf(group, trials);
  }
}

} // namespace taa::doctor
