#include "core/doctor/motion/MotionJudgement.h"

#include "core/doctor/motion/MotionMarks.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace taa::doctor {

namespace {

// What pixels say of an explanation of depth and matrices, over all regions that it explains: they contradict
// or confirm it where it leaves so many times as much or as little as the motion given.
constexpr std::size_t kEnoughToContradict = 300, kEnoughToConfirm = 150;
constexpr double kContradicts = 1.15, kConfirms = 1.1, kConfirmingShare = 0.6;
/// Of all pixels whose motion could be the camera's: an explanation of so many needs no pixels to confirm it;
/// and none of fewer does where so many others have the camera's motion, by which that is known to be right.
constexpr double kMostOfAll = 0.5, kTrustedOfAll = 0.3;

std::vector<JudgedRegion> judgedRegions(const MotionEvidence& evidence, const std::vector<Region>& regions) {
  std::vector<JudgedRegion> out;
  for (std::size_t i = 0; i < regions.size() && i < evidence.regions().size(); ++i) {
    const RegionEvidence& measured = evidence.regions()[i];
    const bool isSeen = measured.pixels > 0 || !measured.middle.trials.empty();
    if (!isSeen || isUnwrittenMark(measured) || isKeptAsMissing(measured)) continue;
    JudgedRegion region;
    region.region = &regions[i];
    region.evidence = &measured;
    region.decision = decideMotion(measured, evidence.trials());
    region.consistency = decideConsistency(measured.consistency, evidence.trials());
    // Clouds may drift; nobody writes motion for them.
    const bool isDrifting = regions[i].isSky && region.decision.verdict == MotionVerdict::Wrong &&
                            region.decision.explanations.empty();
    if (isDrifting) region.decision.verdict = MotionVerdict::Contradicted;
    out.push_back(std::move(region));
  }
  return out;
}

/// Regions that one explanation makes the camera's motion of.
struct CheckedRegions {
  std::size_t trial = 0;
  std::vector<JudgedRegion*> regions;

  PixelsSay pixelsSay() const {
    TrialEvidence sum;
    for (const JudgedRegion* region : regions) {
      const TrialEvidence& one = region->evidence->trials[trial];
      sum.pixels += one.pixels;
      sum.given += one.given;
      sum.tried += one.tried;
      sum.cells += one.cells;
      sum.cellsWon += one.cellsWon;
    }
    if (sum.pixels >= kEnoughToContradict && sum.tried >= kContradicts * sum.given) return PixelsSay::No;
    const bool isConfirmed =
        sum.pixels >= kEnoughToConfirm && sum.given >= kConfirms * sum.tried &&
        static_cast<double>(sum.cellsWon) >= kConfirmingShare * static_cast<double>(sum.cells);
    return isConfirmed ? PixelsSay::Yes : PixelsSay::Nothing;
  }
  double pixels() const {
    double out = 0.0;
    for (const JudgedRegion* region : regions) out += region->region->pixels;
    return out;
  }
};

double pixelsWith(const std::vector<JudgedRegion>& judged, ConsistencyVerdict verdict) {
  double pixels = 0.0;
  for (const JudgedRegion& region : judged)
    if (region.consistency.verdict == verdict) pixels += region.region->pixels;
  return pixels;
}

/// The explanation that the most pixels of regions that are still open are told by, and these regions; of
/// those that depth and matrices do not tell apart the one that fits the pixels of what moves by itself, too.
CheckedRegions broadestConsistency(const std::vector<JudgedRegion*>& open,
                                   const std::vector<JudgedRegion>& all, std::size_t trialCount) {
  std::vector<double> pixels(trialCount, 0.0);
  for (const JudgedRegion* region : open)
    for (const std::size_t trial : region->consistency.explanations) pixels[trial] += region->region->pixels;
  const double most = *std::ranges::max_element(pixels);
  for (const JudgedRegion& region : all)
    if (region.consistency.verdict == ConsistencyVerdict::Apart)
      for (const std::size_t trial : region.decision.explanations)
        if (pixels[trial] >= most) pixels[trial] += region.region->pixels;
  CheckedRegions out;
  out.trial = static_cast<std::size_t>(std::ranges::max_element(pixels) - pixels.begin());
  for (JudgedRegion* region : open)
    if (std::ranges::count(region->consistency.explanations, out.trial) > 0) out.regions.push_back(region);
  return out;
}

bool isBelieved(const CheckedRegions& told, const MotionTrial& trial, PixelsSay pixelsSay,
                const std::vector<JudgedRegion>& judged) {
  // What was fitted fits wrong depth as well: pixels have to confirm it.
  if (pixelsSay != PixelsSay::Nothing || isFitted(trial)) return pixelsSay == PixelsSay::Yes;
  const double ofCamera = pixelsWith(judged, ConsistencyVerdict::OfCamera);
  const double known = ofCamera + pixelsWith(judged, ConsistencyVerdict::Explained) +
                       pixelsWith(judged, ConsistencyVerdict::Apart);
  if (told.pixels() >= kMostOfAll * known) return true;
  return isParticular(trial) && ofCamera >= kTrustedOfAll * known;
}

/// What moves by itself has nothing to be checked with: what all that rests is told by is its fault, too,
/// where pixels do not contradict that.
void spreadTold(std::size_t trial, std::vector<JudgedRegion>& judged) {
  for (JudgedRegion& region : judged) {
    if (region.trial || region.decision.verdict != MotionVerdict::Wrong) continue;
    const TrialEvidence& evidence = region.evidence->trials[trial];
    if (evidence.gain() <= 0.0) continue;
    region.trial = trial;
    region.decision.explanations = {trial};
  }
}

/// A region that depth and matrices tell by something else, as a hub that turns and looks the same: where its
/// pixels fit what nearly all is told by nearly as well, that is its fault, too. Takes it out of `open`.
void tellAlike(std::size_t trial, std::vector<JudgedRegion*>& open) {
  constexpr double kNearlyAsWell = 0.8;
  std::erase_if(open, [trial](JudgedRegion* region) {
    const double gain = region->evidence->trials[trial].gain();
    double own = 0.0;
    for (const std::size_t other : region->consistency.explanations)
      own = std::max(own, region->evidence->trials[other].gain());
    if (gain <= 0.0 || gain < kNearlyAsWell * own) return false;
    region->decision = {MotionVerdict::Wrong, {trial}};
    region->trial = trial;
    return true;
  });
}

void judgeByConsistency(Judged& out, const MotionEvidence& evidence) {
  std::vector<JudgedRegion*> open;
  for (JudgedRegion& region : out.regions)
    if (region.consistency.verdict == ConsistencyVerdict::Explained) open.push_back(&region);
  const double explained = pixelsWith(out.regions, ConsistencyVerdict::Explained);
  const double ofCamera = pixelsWith(out.regions, ConsistencyVerdict::OfCamera), known = ofCamera + explained;
  const double all = known + pixelsWith(out.regions, ConsistencyVerdict::Apart);
  out.areMatricesTrusted = ofCamera > 0.0 && ofCamera >= kTrustedOfAll * all;
  while (!open.empty()) {
    const CheckedRegions told = broadestConsistency(open, out.regions, evidence.trials().size());
    std::erase_if(open, [&](JudgedRegion* region) { return std::ranges::count(told.regions, region) > 0; });
    const PixelsSay pixelsSay = told.pixelsSay();
    if (!isBelieved(told, evidence.trials()[told.trial], pixelsSay, out.regions)) {
      if (pixelsSay == PixelsSay::No && !out.contradicted) {
        out.contradicted = told.trial;
        for (const JudgedRegion* region : told.regions) out.contradictedIn.push_back(region->region);
      }
      if (pixelsSay == PixelsSay::Nothing && isFitted(evidence.trials()[told.trial]) && !out.unconfirmed)
        out.unconfirmed = told.trial;
      continue;
    }
    for (JudgedRegion* region : told.regions) {
      region->decision = {MotionVerdict::Wrong, region->consistency.explanations};
      region->trial = told.trial;
      region->isChecked = true;
      region->pixelsSay = pixelsSay;
    }
    if (told.pixels() >= kMostOfAll * explained) tellAlike(told.trial, open);
    if (told.pixels() >= kMostOfAll * known) spreadTold(told.trial, out.regions);
  }
}

bool isLate(const std::vector<JudgedRegion>& judged) {
  ConsistencyEvidence silhouettes;
  for (const JudgedRegion& region : judged) {
    if (region.consistency.verdict != ConsistencyVerdict::OfCamera) continue;
    addSilhouettes(region.evidence->consistency, silhouettes);
  }
  return isLateAtSilhouettes(silhouettes);
}

/// Where the camera rests, what rests in the world rests on the screen, and anything that shrinks fits it:
/// such a region is told by which camera made its motion, where that shows, and is no interface.
void preferWorld(JudgedRegion& region, const std::vector<MotionTrial>& trials) {
  std::vector<std::size_t>& fitting = region.decision.explanations;
  const auto ofCamera =
      std::ranges::find(fitting, MotionKind::OfCamera, [&](std::size_t t) { return trials[t].kind; });
  if (ofCamera == fitting.end() || !isAtRestInWorld(*region.evidence)) return;
  if (wrongCamera(*region.evidence))
    fitting = {*ofCamera};
  else
    std::erase_if(fitting, [&](std::size_t t) { return trials[t].kind == MotionKind::Resting; });
}

std::vector<FittingTrial> fittingTrials(const std::vector<JudgedRegion*>& open) {
  std::vector<FittingTrial> fitting;
  for (const JudgedRegion* region : open)
    for (const std::size_t trial : region->decision.explanations)
      fitting.push_back(
          {trial, static_cast<double>(region->region->pixels), region->evidence->trials[trial].gain()});
  return fitting;
}

/// Tells the most with the fewest: the explanation that fits the most pixels is that of all regions that it
/// fits, then the next one.
void explainByFewest(std::vector<JudgedRegion>& judged, const std::vector<MotionTrial>& trials) {
  std::vector<JudgedRegion*> open;
  for (JudgedRegion& region : judged) {
    if (region.decision.verdict != MotionVerdict::Wrong || region.decision.explanations.empty() ||
        region.trial)
      continue;
    preferWorld(region, trials);
    open.push_back(&region);
  }
  while (!open.empty()) {
    const std::size_t best = broadestTrial(fittingTrials(open));
    std::erase_if(open, [&](JudgedRegion* region) {
      if (std::ranges::count(region->decision.explanations, best) == 0) return false;
      region->trial = best;
      return true;
    });
  }
}

/// Whether an object's motion is open, and its middle may tell it.
bool isOpenToCentroids(const JudgedRegion& region) {
  const MotionVerdict verdict = region.decision.verdict;
  return verdict != MotionVerdict::Right && verdict != MotionVerdict::Wrong &&
         region.consistency.verdict != ConsistencyVerdict::OfCamera && !isConfirmed(*region.evidence) &&
         !region.evidence->middle.trials.empty();
}

/// Whether the pixels of objects speak against an explanation of how their centroids move: what turns has
/// another motion than its middle.
bool contradictCentroids(const std::vector<const JudgedRegion*>& objects, std::size_t trial) {
  double given = 0.0, tried = 0.0;
  for (const JudgedRegion* object : objects) {
    given += object->evidence->trials[trial].given;
    tried += object->evidence->trials[trial].tried;
  }
  return tried > given;
}

/// Whether more than one or two objects go by an explanation: the middle of a ring that spins stays where it
/// is, though all of it that is seen moves.
bool areSeveral(const std::vector<const JudgedRegion*>& objects, std::size_t trial) {
  constexpr std::ptrdiff_t kSeveral = 3;
  return std::ranges::count_if(objects, [&](const JudgedRegion* object) {
           const MiddleCounts& own = object->evidence->middle.trials[trial];
           return own.samples > 0 && own.tried < own.given;
         }) >= kSeveral;
}

/// Objects that are too small to tell anything by themselves tell it together, and the same as depth and
/// matrices where it fits. That what rests in the world has another motion than the camera's is no news then.
void judgeByCentroids(std::vector<JudgedRegion>& judged, const std::vector<MotionTrial>& trials) {
  MiddleEvidence all;
  std::vector<const JudgedRegion*> objects;
  for (const JudgedRegion& region : judged)
    if (isOpenToCentroids(region)) {
      all.add(region.evidence->middle);
      objects.push_back(&region);
    }
  std::vector<std::size_t> winners = middleWinners(all);
  std::erase_if(winners, [&](std::size_t trial) { return contradictCentroids(objects, trial); });
  std::erase_if(winners, [&](std::size_t trial) {
    return trials[trial].kind == MotionKind::OfCamera && !areSeveral(objects, trial);
  });
  if (winners.empty()) return;
  const auto told = std::ranges::find(judged, true, &JudgedRegion::isChecked);
  if (told != judged.end() && std::ranges::count(winners, *told->trial) > 0)
    winners.assign(1, *told->trial);
  else if (told != judged.end())
    std::erase_if(winners, [&](std::size_t trial) { return trials[trial].kind == MotionKind::OfCamera; });
  if (winners.empty()) return;
  for (JudgedRegion& region : judged) {
    if (!isOpenToCentroids(region)) continue;
    const MiddleCounts& own = region.evidence->middle.trials[winners.front()];
    if (own.given > own.tried) region.decision = {MotionVerdict::Wrong, winners, DecidedBy::Centroids};
  }
}

/// Where pixels say of what rests that its motion is not the camera's, and no more, the motion given is that
/// of nothing that is known: what outlines alone say of others beside that is no explanation.
void leaveOutlinesAlone(std::vector<JudgedRegion>& judged, const std::vector<MotionTrial>& trials) {
  const auto isOfCamera = [&](const JudgedRegion& region) {
    return region.trial && trials[*region.trial].kind == MotionKind::OfCamera;
  };
  const bool isKnown = std::ranges::any_of(judged, [&](const JudgedRegion& region) {
    return isOfCamera(region) && region.decision.by == DecidedBy::Pixels && !isUnwritten(*region.evidence);
  });
  if (!isKnown) return;
  for (JudgedRegion& region : judged) {
    if (!region.trial || region.decision.by != DecidedBy::Outline || isOfCamera(region)) continue;
    region.trial.reset();
    region.decision = {MotionVerdict::Doubtful, {}};
  }
}

/// Everything is a frame late, or nothing: of the sky alone it is what leaks into it from what moves before
/// it.
void leaveSkyAlone(std::vector<JudgedRegion>& judged, const std::vector<MotionTrial>& trials) {
  for (JudgedRegion& sky : judged) {
    if (!sky.region->isSky || !sky.trial) continue;
    const bool isAlone = std::ranges::none_of(
        judged, [&](const JudgedRegion& other) { return &other != &sky && other.trial == sky.trial; });
    if (madeOf(trials[*sky.trial].kind) != MotionMadeOf::OtherFrame || !isAlone) continue;
    sky.trial.reset();
    sky.decision = {MotionVerdict::Contradicted, {}};
  }
}

/// Jitter is left in the motion of all that one pass draws. Of a few squares of one thing alone, where other
/// things say no, it is something as thin as a pixel that stays on its pixels, or repeats.
void leaveJitterAlone(std::vector<JudgedRegion>& judged, const std::vector<MotionTrial>& trials) {
  constexpr std::size_t kEnoughSquaresAlone = 60, kEnoughPixelsApart = 150;
  constexpr double kRefutes = 1.2;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (madeOf(trials[t].kind) != MotionMadeOf::Jitter) continue;
    std::size_t squares = 0, refuting = 0;
    for (const JudgedRegion& region : judged) {
      const TrialEvidence& evidence = region.evidence->trials[t];
      if (region.trial == t)
        squares += evidence.cells;
      else if (evidence.pixels >= kEnoughPixelsApart && evidence.tried >= kRefutes * evidence.given)
        refuting += evidence.cells;
    }
    if (squares >= kEnoughSquaresAlone || refuting < squares) continue;
    for (JudgedRegion& region : judged) {
      if (region.trial != t) continue;
      region.trial.reset();
      region.decision = {MotionVerdict::Doubtful, {}};
    }
  }
}

} // namespace

std::size_t broadestTrial(const std::vector<FittingTrial>& fitting) {
  assert(!fitting.empty());
  constexpr double kAsMuch = 0.99;
  struct Sum {
    double pixels = 0.0, gain = 0.0;
  };
  std::map<std::size_t, Sum> sums; // by trial
  for (const FittingTrial& each : fitting) {
    sums[each.trial].pixels += each.pixels;
    sums[each.trial].gain += each.gain;
  }
  double most = 0.0, gain = std::numeric_limits<double>::lowest();
  for (const auto& [trial, sum] : sums) most = std::max(most, sum.pixels);
  for (const auto& [trial, sum] : sums)
    if (sum.pixels == most) gain = std::max(gain, sum.gain);
  const double least = gain - (1.0 - kAsMuch) * std::abs(gain);
  return std::ranges::find_if(
             sums,
             [&](const auto& entry) { return entry.second.pixels == most && entry.second.gain >= least; })
      ->first;
}

bool isAlike(const JudgedRegion& region, std::size_t other) {
  constexpr float kSamePx = 0.25f;
  const auto& moved = region.evidence->example.byTrial;
  const auto &told = moved[*region.trial], &rival = moved[other];
  return told && rival && glm::distance(*told, *rival) <= kSamePx;
}

std::vector<std::size_t> rivalsOf(const JudgedRegion& region) {
  std::vector<std::size_t> out;
  if (!region.trial) return out;
  for (const std::size_t other : region.decision.explanations)
    if (other != *region.trial && !isAlike(region, other)) out.push_back(other);
  return out;
}

Judged judgeMotion(const MotionEvidence& evidence, const std::vector<Region>& regions,
                   const SilhouettesSeen& silhouettes) {
  Judged out;
  out.regions = judgedRegions(evidence, regions);
  out.unseen =
      static_cast<std::size_t>(std::ranges::count_if(evidence.regions(), [](const RegionEvidence& region) {
        return region.seen == 0 && region.middle.trials.empty();
      }));
  out.isLate = silhouettes.ofTime && isLate(out.regions);
  if (out.isLate || !silhouettes.ofPlace)
    for (JudgedRegion& region : out.regions)
      if (region.decision.by == DecidedBy::Outline)
        region.decision = decideByPixels(*region.evidence, evidence.trials());
  judgeByConsistency(out, evidence);
  judgeByCentroids(out.regions, evidence.trials());
  explainByFewest(out.regions, evidence.trials());
  leaveSkyAlone(out.regions, evidence.trials());
  leaveOutlinesAlone(out.regions, evidence.trials());
  leaveJitterAlone(out.regions, evidence.trials());
  return out;
}

} // namespace taa::doctor
