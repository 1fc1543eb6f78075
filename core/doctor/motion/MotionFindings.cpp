#include "core/doctor/motion/MotionFindings.h"

#include "core/base/Say.h"
#include "core/doctor/NumberText.h"
#include "core/doctor/mending/Mending.h"
#include "core/doctor/mending/MotionMending.h"
#include "core/doctor/motion/MotionJudgement.h"
#include "core/doctor/motion/MotionJumps.h"
#include "core/doctor/motion/MotionMarks.h"
#include "core/doctor/motion/MotionOpen.h"
#include "core/doctor/motion/MotionWords.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

/// Of the pixels of regions that are decided: a fault of so many is one of the whole picture.
constexpr double kWholeShare = 0.95;
constexpr std::size_t kShownResiduals = 12;
// The sky's motion by depth and cameras alone, where it has no detail: px, and the share of all other
// surfaces whose motion has to be that of the camera, so that cameras are known to be right.
constexpr double kSkyMovesPx = 0.1;
constexpr double kTrustedShare = 0.3;

/// One fault and the regions that it shows in.
struct FaultGroup {
  MotionFault fault;
  std::optional<std::size_t> trial;
  std::vector<const JudgedRegion*> regions;
  double pixels = 0.0;
};

/// Whether nothing that rests has motion, though depth and matrices move it.
bool isNothingOfCamera(const std::vector<JudgedRegion>& judged) {
  return std::ranges::none_of(judged, [](const JudgedRegion& region) {
    return region.witness.verdict == WitnessVerdict::OfCamera && region.evidence->givenPx > 0.0;
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
    const bool isApart = isNothing && other.witness.verdict == WitnessVerdict::Apart;
    if ((other.trial == region.trial || isApart) && !isUnwritten(*other.evidence)) return other;
    if (other.trial == region.trial && !other.region->isSky) surface = &other;
  }
  return *surface;
}

std::vector<FaultGroup> groupsOf(const std::vector<JudgedRegion>& judged,
                                 const std::vector<MotionTrial>& trials) {
  std::vector<FaultGroup> groups;
  for (const JudgedRegion& region : judged) {
    if (region.decision.verdict != MotionVerdict::Wrong) continue;
    const MotionTrial* trial = region.trial ? &trials[*region.trial] : nullptr;
    const JudgedRegion& named = namedBy(region, judged);
    MotionFault fault = motionFault(trial, *named.region, *named.evidence);
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

bool isWitnessed(const FaultGroup& group) {
  return group.regions.front()->isWitnessed;
}

/// How far each explanation is from the camera's motion, of all regions of a group.
std::vector<DistanceCounts> distancesOf(const FaultGroup& group, std::size_t trialCount) {
  std::vector<DistanceCounts> out(trialCount);
  for (const JudgedRegion* region : group.regions)
    for (std::size_t t = 0; t < region->evidence->witness.trials.size(); ++t)
      out[t].add(region->evidence->witness.trials[t]);
  return out;
}

std::vector<Residual> witnessResiduals(const FaultGroup& group, const std::vector<MotionTrial>& trials) {
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

/// Whether one region leaves no other explanation: it decides for all that the fault shows in.
bool isTold(const FaultGroup& group) {
  return std::ranges::any_of(group.regions,
                             [](const JudgedRegion* region) { return rivalsOf(*region).empty(); });
}

/// Explanations that depth and matrices fit as well.
std::vector<std::size_t> witnessAlikes(const FaultGroup& group) {
  std::vector<std::size_t> out;
  for (const std::size_t other : group.regions.front()->decision.explanations)
    if (other != *group.trial) out.push_back(other);
  std::erase_if(out, [&](std::size_t other) {
    return !std::ranges::all_of(group.regions, [other](const JudgedRegion* region) {
      return !region->isWitnessed || std::ranges::count(region->decision.explanations, other) > 0;
    });
  });
  return out;
}

/// Explanations that fit all regions as well and lead to the same places: x negated, where nothing moves
/// along y, is both negated.
std::vector<std::size_t> alikesOf(const FaultGroup& group) {
  std::vector<std::size_t> out;
  if (!group.trial) return out;
  if (isWitnessed(group)) return witnessAlikes(group);
  for (const std::size_t other : group.regions.front()->decision.explanations) {
    const auto isSame = [other](const JudgedRegion* region) {
      return std::ranges::count(region->decision.explanations, other) > 0 && isAlike(*region, other);
    };
    if (other != *group.trial && std::ranges::all_of(group.regions, isSame)) out.push_back(other);
  }
  return out;
}

std::string namesOf(const std::vector<std::size_t>& explanations, const std::vector<MotionTrial>& trials) {
  std::string names;
  for (const std::size_t trial : explanations)
    names += (names.empty() ? "" : "; ") + trialText(trials[trial]);
  return names;
}

std::string witnessReason(const FaultGroup& group, const std::vector<MotionTrial>& trials) {
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
    text += " " + say<"Here it leads to the same places as: %1.">(namesOf(alikes, trials));
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
    text += " " + say<"Here it leads to the same places as: %1.">(namesOf(alikes, trials));
  if (isTold(group)) return text;
  return text + " " + say<"These frames do not tell it from: %1.">(namesOf(rivals, trials));
}

/// Pixels of regions that are right or wrong.
double decidedPixels(const std::vector<JudgedRegion>& judged) {
  double pixels = 0.0;
  for (const JudgedRegion& region : judged)
    if (region.decision.verdict == MotionVerdict::Right || region.decision.verdict == MotionVerdict::Wrong)
      pixels += region.region->pixels;
  return pixels;
}

bool isSure(const FaultGroup& group) {
  if (!alikesOf(group).empty()) return false;
  return isWitnessed(group) ? group.regions.front()->pixelsSay == PixelsSay::Yes : isTold(group);
}

/// Of the faults that a group's other explanations would be.
std::vector<std::string> alikeIds(const FaultGroup& group, const std::vector<MotionTrial>& trials) {
  std::vector<std::string> out;
  std::vector<std::size_t> others = alikesOf(group);
  if (!isWitnessed(group) && !isTold(group))
    for (const JudgedRegion* region : group.regions)
      for (const std::size_t rival : rivalsOf(*region)) others.push_back(rival);
  for (const std::size_t other : others) {
    const JudgedRegion& region = *group.regions.front();
    std::string id = motionFault(&trials[other], *region.region, *region.evidence).id;
    if (id != group.fault.id && std::ranges::count(out, id) == 0) out.push_back(std::move(id));
  }
  return out;
}

/// Whether an explanation leads elsewhere in no region whose motion is right, by its pixels or by depth and
/// matrices: then it may be that of all.
bool breaksNothing(std::size_t trial, const std::vector<JudgedRegion>& judged) {
  constexpr std::size_t kEnoughToBreak = 50;
  constexpr double kBreaks = 1.05;
  return std::ranges::none_of(judged, [&](const JudgedRegion& region) {
    const TrialEvidence& evidence = region.evidence->trials[trial];
    if (region.trial || evidence.pixels < kEnoughToBreak) return false;
    if (isConfirmed(*region.evidence)) return true;
    return region.decision.verdict == MotionVerdict::Right && evidence.tried >= kBreaks * evidence.given;
  });
}

Finding findingOf(const FaultGroup& group, const std::vector<JudgedRegion>& judged,
                  const MotionEvidence& evidence, const Patient& patient, double allPixels) {
  Finding out;
  out.id = group.fault.id;
  out.name = group.fault.name;
  out.sureness = isSure(group) ? Sureness::Sure : Sureness::Likely;
  out.isWholePicture = group.pixels >= kWholeShare * decidedPixels(judged);
  for (const JudgedRegion* region : group.regions)
    out.regions.push_back(placeOf(*region->region, patient, allPixels));
  std::ranges::stable_sort(out.regions, std::greater(), &RegionPlace::share);
  const bool isOfMatrices = isWitnessed(group);
  out.reason = isOfMatrices ? witnessReason(group, evidence.trials()) : reasonOf(group, evidence.trials());
  out.measure = isOfMatrices ? say<"median distance from the camera's motion, px">()
                             : say<"mean difference of luma, × 1000">();
  out.residuals =
      isOfMatrices ? witnessResiduals(group, evidence.trials()) : residualsOf(group, evidence.trials());
  out.alike = alikeIds(group, evidence.trials());
  out.symptom = group.fault.symptom;
  out.change = group.fault.change;
  if (!group.trial) return out;
  const std::vector<std::string> mending = motionMending(evidence.trials()[*group.trial]);
  if (breaksNothing(*group.trial, judged))
    mendEverywhereBy(mending, out);
  else
    mendBy(mending, out);
  const auto largest = std::ranges::max_element(
      group.regions, {}, [](const JudgedRegion* region) { return region->evidence->example.lengthPx; });
  const std::string example = motionExample(patient, *(*largest)->evidence, *group.trial);
  if (!example.empty()) out.change += " " + example;
  return out;
}

/// Whether the motion of surfaces is that of the cameras at so many pixels that these are right.
bool areCamerasTrusted(const std::vector<JudgedRegion>& judged) {
  std::size_t known = 0, ofCamera = 0;
  for (const JudgedRegion& region : judged) {
    if (region.region->isSky || region.evidence->cameraPx == 0.0) continue;
    known += region.evidence->cameraKnown;
    ofCamera += region.evidence->ofCamera;
  }
  return known > 0 && static_cast<double>(ofCamera) >= kTrustedShare * static_cast<double>(known);
}

/// The sky cannot move by itself: where the cameras are right, they decide, whatever its detail.
bool isSkyUnwritten(const JudgedRegion& sky, const std::vector<JudgedRegion>& judged, bool isTrusted) {
  const RegionEvidence& evidence = *sky.evidence;
  const auto pixels = static_cast<double>(evidence.pixels);
  const bool isAlone = !sky.trial || std::ranges::none_of(judged, [&](const JudgedRegion& other) {
    return &other != &sky && other.trial == sky.trial;
  });
  return sky.region->isSky && isAlone && isTrusted && isUnwritten(evidence) &&
         evidence.cameraPx >= kSkyMovesPx * pixels;
}

Finding skyFinding(const JudgedRegion& sky, const Patient& patient, double allPixels) {
  const MotionFault fault = motionFault(nullptr, *sky.region, *sky.evidence);
  const double meanPx = sky.evidence->cameraPx / static_cast<double>(sky.evidence->pixels);
  Finding out;
  out.id = fault.id;
  out.name = fault.name;
  out.regions = {placeOf(*sky.region, patient, allPixels)};
  out.reason =
      say<"Motion is 0 wherever nothing is drawn, though depth and matrices, which make the motion of other "
          "surfaces, move the sky by %1 px a frame in the mean.">(shortNumber(meanPx));
  out.measure = say<"mean distance from the camera's motion, px">();
  out.residuals = {{"ofCamera", say<"that of the camera">(), 0.0, false, true},
                   {"asGiven", say<"as given">(), meanPx, true, false}};
  out.symptom = fault.symptom;
  out.change = fault.change;
  mendBy(motionMending({MotionKind::OfCamera}), out);
  const std::vector<MotionTrial> trials = motionTrials(patient.sizePx);
  for (std::size_t t = 0; t < trials.size(); ++t)
    if (trials[t].kind == MotionKind::OfCamera) out.change += " " + motionExample(patient, *sky.evidence, t);
  return out;
}

/// Tells of a sky without motion, and takes it out of what is judged.
void tellUnwrittenSky(std::vector<JudgedRegion>& judged, const Patient& patient, double allPixels,
                      Diagnosis& out) {
  const bool isTrusted = areCamerasTrusted(judged);
  const auto sky = std::ranges::find_if(
      judged, [&](const JudgedRegion& region) { return isSkyUnwritten(region, judged, isTrusted); });
  if (sky == judged.end()) return;
  out.findings.push_back(skyFinding(*sky, patient, allPixels));
  std::erase_if(judged, [](const JudgedRegion& other) { return other.region->isSky; });
}

/// Sentences of what is right and of what is not known.
void tellOthers(const Judged& all, const std::vector<MotionTrial>& trials, const Patient& patient,
                double allPixels, Diagnosis& out) {
  // A hundred small things are not worth a hundred sentences.
  constexpr double kWorthNaming = 0.002;
  std::size_t small = all.unseen, right = 0;
  std::vector<Fault> ofSmall;
  if (all.unseen > 0) ofSmall = openFaultsOfUnseen();
  for (const JudgedRegion& region : all.regions) {
    const MotionVerdict verdict = region.decision.verdict;
    const RegionPlace place = placeOf(*region.region, patient, allPixels);
    if (verdict == MotionVerdict::Wrong) continue;
    if (verdict == MotionVerdict::Right)
      ++right;
    else if (place.share < kWorthNaming || verdict == MotionVerdict::TooSmall) {
      ++small;
      addFaults(openFaults(region, trials), ofSmall);
    } else {
      out.undecided.push_back(undecidedMotion(verdict, place, *region.evidence));
      out.undecided.back().faults = openFaults(region, trials);
    }
  }
  if (right > 0)
    out.healthy.push_back(
        right == 1
            ? say<"Motion of one region fits its own pixels, and other explanations do not.">()
            : say<"Motion of %1 regions fits their own pixels, and other explanations do not.">(right));
  if (small > 0)
    out.undecided.push_back(
        {small == 1 ? say<"Motion of a small region">() : say<"Motion of %1 small regions">(small),
         say<"they have too few pixels that can be followed, or move and change too little">(),
         say<"Bring the camera nearer to them, or capture more and larger frames.">(), ofSmall});
}

} // namespace

RegionPlace placeOf(const Region& region, const Patient& patient, double allPixels) {
  RegionPlace out;
  const auto named = patient.objectNames.find(region.objectId);
  if (region.isSky)
    out.name = say<"the sky">();
  else if (region.objectId != 0 && named != patient.objectNames.end())
    out.name = say<"object %1 (%2)">(region.objectId, named->second);
  else if (region.objectId != 0)
    out.name = say<"object %1">(region.objectId);
  else
    out.name = say<"the part around pixel %1, %2 of frame %3">(region.pixel.x, region.pixel.y, region.frame);
  out.frame = region.frame;
  out.box = region.box;
  out.pixel = region.pixel;
  out.share = region.pixels / std::max(1.0, allPixels);
  out.isSky = region.isSky;
  out.objectId = region.objectId;
  out.pixels = region.runs;
  return out;
}

std::optional<MotionTrial> tellMotion(const MotionEvidence& evidence, const std::vector<Region>& regions,
                                      const Patient& patient, Diagnosis& out) {
  const double allPixels = static_cast<double>(out.frames) * patient.sizePx.x * patient.sizePx.y;
  tellMarks(evidence, regions, patient, allPixels, out);
  Judged judged = judgeMotion(evidence, regions);
  tellUnwrittenSky(judged.regions, patient, allPixels, out);
  std::optional<MotionTrial> most;
  for (const FaultGroup& group : groupsOf(judged.regions, evidence.trials())) {
    out.findings.push_back(findingOf(group, judged.regions, evidence, patient, allPixels));
    if (!most && group.trial && breaksNothing(*group.trial, judged.regions))
      most = evidence.trials()[*group.trial];
  }
  const Finding late = lateFinding();
  if (judged.isLate && std::ranges::count(out.findings, late.id, &Finding::id) == 0)
    out.findings.push_back(late);
  tellJumps(evidence, regions, patient, allPixels, out);
  if (judged.contradicted)
    out.undecided.push_back(contradictedMatrices(evidence.trials()[*judged.contradicted]));
  tellOthers(judged, evidence.trials(), patient, allPixels, out);
  return most;
}

} // namespace taa::doctor
