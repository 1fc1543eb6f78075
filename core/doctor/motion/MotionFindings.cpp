#include "core/doctor/motion/MotionFindings.h"

#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/doctor/Correction.h"
#include "core/doctor/motion/MotionCorrection.h"
#include "core/doctor/motion/MotionGroups.h"
#include "core/doctor/motion/MotionJudgement.h"
#include "core/doctor/motion/MotionJumps.h"
#include "core/doctor/motion/MotionMarks.h"
#include "core/doctor/motion/MotionOpen.h"
#include "core/doctor/motion/MotionReasons.h"
#include "core/doctor/motion/MotionWords.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

/// Of the pixels of regions that are decided: a fault of so many is one of the whole picture.
constexpr double kWholeShare = 0.95;
/// px: the sky's motion by depth and cameras alone, where it has no detail.
constexpr double kSkyMovesPx = 0.1;

/// Pixels of regions that are right or wrong.
double decidedPixels(const std::vector<JudgedRegion>& judged) {
  double pixels = 0.0;
  for (const JudgedRegion& region : judged)
    if (region.decision.verdict == MotionVerdict::Right || region.decision.verdict == MotionVerdict::Wrong)
      pixels += region.region->pixels;
  return pixels;
}

/// Whether an explanation leads elsewhere in no region whose motion is right, by its pixels or by depth and
/// matrices: then it may be that of all.
bool breaksNothing(std::size_t trial, const std::vector<JudgedRegion>& judged) {
  constexpr std::size_t kEnoughToBreak = 50;
  constexpr double kBreaks = 1.05;
  return std::ranges::none_of(judged, [&](const JudgedRegion& region) {
    if (region.trial) return false;
    if (region.decision.verdict != MotionVerdict::Wrong && breaksOutline(trial, region.evidence->outline))
      return true;
    const TrialEvidence& evidence = region.evidence->trials[trial];
    if (evidence.pixels < kEnoughToBreak) return false;
    if (isConfirmed(*region.evidence)) return true;
    return region.decision.verdict == MotionVerdict::Right && evidence.tried >= kBreaks * evidence.given;
  });
}

/// Mean of |luma − luma of the frame before| × 1000 where motion is right, the median of its regions; nothing
/// where there are too few.
std::optional<double> leftWhereRight(const std::vector<JudgedRegion>& judged) {
  constexpr std::size_t kEnoughRight = 2;
  std::vector<double> left;
  for (const JudgedRegion& region : judged)
    if (region.decision.verdict == MotionVerdict::Right && region.evidence->textured > 0)
      left.push_back(1000.0 * region.evidence->texturedError /
                     static_cast<double>(region.evidence->textured));
  return left.size() < kEnoughRight ? std::nullopt : std::optional(median(std::move(left)));
}

/// An explanation by pixels that leaves far more of them than is left where motion is right, and much of what
/// the motion given leaves, is none: the finding is unknown then, and says so. False: it explains them.
bool leaveUnknown(const FaultGroup& group, const std::vector<JudgedRegion>& judged, Finding& out) {
  constexpr double kPoorFit = 4.0, kMuchOfGiven = 0.4;
  const auto best = std::ranges::find(out.residuals, true, &Residual::isBest);
  const auto given = std::ranges::find(out.residuals, true, &Residual::isGiven);
  const auto right = leftWhereRight(judged);
  if (isChecked(group) || isOutlined(group) || isOfCentroids(group) || !right ||
      best == out.residuals.end() || given == out.residuals.end() || best->value <= kPoorFit * *right ||
      best->value <= kMuchOfGiven * given->value)
    return false;
  nameBy(unknownMotion(), out);
  out.confidence = Confidence::Likely;
  out.reason = say<"The motion given leaves %1 thousandths of the pixels' luma, and what comes nearest, %2, "
                   "leaves %3, where %4 are left in regions whose motion is right.">(
      shortNumber(given->value), best->text, shortNumber(best->value), shortNumber(*right));
  out.alike.clear();
  best->isBest = false;
  return true;
}

Finding findingOf(const FaultGroup& group, const std::vector<JudgedRegion>& judged,
                  const MotionEvidence& evidence, const CaptureInfo& captureInfo, double allPixels) {
  Finding out;
  nameBy(group.fault, out);
  out.confidence = isSure(group) && out.id != kUnknownMotionId ? Confidence::Sure : Confidence::Likely;
  out.isWholePicture = group.pixels >= kWholeShare * decidedPixels(judged);
  for (const JudgedRegion* region : group.regions)
    out.regions.push_back(placeOf(*region->region, captureInfo, allPixels));
  std::ranges::stable_sort(out.regions, std::greater(), &RegionPlace::share);
  tellEvidence(group, evidence.trials(), out);
  out.alike = alikeIds(group, evidence.trials());
  if (!group.trial || leaveUnknown(group, judged, out)) return out;
  const std::vector<std::string> correction = motionCorrection(evidence.trials()[*group.trial]);
  if (breaksNothing(*group.trial, judged))
    correctEverywhereBy(correction, out);
  else
    correctBy(correction, out);
  const auto largest = std::ranges::max_element(
      group.regions, {}, [](const JudgedRegion* region) { return region->evidence->example.lengthPx; });
  const std::string example = motionExample(captureInfo, *(*largest)->evidence, *group.trial);
  if (!example.empty()) out.change += " " + example;
  return out;
}

/// One for each thing that is wrong: another unit may be told with other axes.
std::vector<Finding> findingsOf(FaultGroup group, const std::vector<JudgedRegion>& judged,
                                const MotionEvidence& evidence, const CaptureInfo& captureInfo,
                                double allPixels) {
  const MotionTrial* trial = group.trial ? &evidence.trials()[*group.trial] : nullptr;
  const auto axes = trial ? axesBesideUnit(*trial, captureInfo) : std::nullopt;
  if (!axes) return {findingOf(group, judged, evidence, captureInfo, allPixels)};
  std::vector<Finding> out;
  const JudgedRegion& first = *group.regions.front();
  for (const MotionTrial& one : {unitAlone(*trial, *axes), *axes}) {
    group.fault = motionFault(&one, *first.region, *first.evidence);
    out.push_back(findingOf(group, judged, evidence, captureInfo, allPixels));
  }
  return out;
}

/// By a factor what rests is told as well as by the camera's motion, which a capture may state that it lacks:
/// that it has it is told then.
void preferStated(std::vector<JudgedRegion>& judged, const std::vector<MotionTrial>& trials,
                  const CaptureInfo& captureInfo) {
  if (!captureInfo.conventions || captureInfo.conventions->motion.includesCamera) return;
  const auto found = std::ranges::find(trials, MotionKind::CameraTwice, &MotionTrial::kind);
  const auto twice = static_cast<std::size_t>(found - trials.begin());
  for (JudgedRegion& region : judged)
    if (region.trial && trials[*region.trial].kind == MotionKind::Scaled && isAlike(region, twice))
      region.trial = twice;
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

Finding skyFinding(const JudgedRegion& sky, const CaptureInfo& captureInfo, double allPixels) {
  const FaultWords fault = motionFault(nullptr, *sky.region, *sky.evidence);
  const double meanPx = sky.evidence->cameraPx / static_cast<double>(sky.evidence->pixels);
  Finding out;
  nameBy(fault, out);
  out.regions = {placeOf(*sky.region, captureInfo, allPixels)};
  out.reason =
      say<"Motion is 0 wherever nothing is drawn, though depth and matrices, which make the motion of other "
          "surfaces, move the sky by %1 px a frame in the mean.">(shortNumber(meanPx));
  out.measure = say<"mean distance from the camera's motion, px">();
  out.residuals = {{"ofCamera", say<"that of the camera">(), 0.0, false, true},
                   {"asGiven", say<"as given">(), meanPx, true, false}};
  correctBy(motionCorrection({MotionKind::OfCamera}), out);
  const std::vector<MotionTrial> trials = motionTrials(captureInfo.sizePx);
  for (std::size_t t = 0; t < trials.size(); ++t)
    if (trials[t].kind == MotionKind::OfCamera)
      out.change += " " + motionExample(captureInfo, *sky.evidence, t);
  return out;
}

/// Tells of a sky without motion, and takes it out of what is judged.
void tellUnwrittenSky(std::vector<JudgedRegion>& judged, const CaptureInfo& captureInfo, double allPixels,
                      Diagnosis& out) {
  const bool isTrusted = areCamerasRight(judged);
  const auto sky = std::ranges::find_if(
      judged, [&](const JudgedRegion& region) { return isSkyUnwritten(region, judged, isTrusted); });
  if (sky == judged.end()) return;
  out.findings.push_back(skyFinding(*sky, captureInfo, allPixels));
  std::erase_if(judged, [](const JudgedRegion& other) { return other.region->isSky; });
}

/// The first of them, and how many there are besides.
std::string namesOf(const std::vector<const Region*>& regions, const CaptureInfo& captureInfo,
                    double allPixels) {
  constexpr std::size_t kShown = 3;
  std::string out;
  for (std::size_t i = 0; i < std::min(kShown, regions.size()); ++i)
    out += (i == 0 ? "" : ", ") + placeOf(*regions[i], captureInfo, allPixels).name;
  return regions.size() <= kShown ? out : say<"%1 and %2 more">(out, regions.size() - kShown);
}

/// Sentences of what is right and of what is not known.
void tellOthers(const Judged& all, const std::vector<MotionTrial>& trials, const CaptureInfo& captureInfo,
                double allPixels, Diagnosis& out) {
  // A hundred small things are not worth a hundred sentences.
  constexpr double kWorthNaming = 0.002;
  std::size_t small = all.unseen, right = 0;
  std::vector<Fault> ofSmall;
  if (all.unseen > 0) ofSmall = openFaultsOfUnseen();
  for (const JudgedRegion& region : all.regions) {
    const MotionVerdict verdict = region.decision.verdict;
    const RegionPlace place = placeOf(*region.region, captureInfo, allPixels);
    if (verdict == MotionVerdict::Wrong) continue;
    if (verdict == MotionVerdict::Right)
      ++right;
    else if (place.share < kWorthNaming || verdict == MotionVerdict::TooSmall) {
      ++small;
      addFaults(openFaults(region, trials), ofSmall);
    } else {
      Undecided open = undecidedMotion(verdict, place, *region.evidence);
      open.faults = openFaults(region, trials);
      out.parts.leaveOpen(std::move(open));
    }
  }
  if (right > 0)
    out.parts.addRight(
        say<"Motion">(),
        right == 1
            ? say<"Motion of one region fits its own pixels, and other explanations do not.">()
            : say<"Motion of %1 regions fits their own pixels, and other explanations do not.">(right));
  if (small > 0)
    out.parts.leaveOpen(
        {small == 1 ? say<"Motion of a small region">() : say<"Motion of %1 small regions">(small),
         say<"they have too few pixels that can be followed, or move and change too little">(),
         say<"Bring the camera nearer to them, or capture more and larger frames.">(), ofSmall});
}

/// A camera beside this one that always stands on its way is none: the way is another one.
void tellWay(const WayShare& way, Diagnosis& out) {
  const std::string_view beside = faultInfo(Fault::CameraOfSecondView).id;
  const std::string share = shortNumber(way.share);
  for (Finding& finding : out.findings) {
    if (finding.id != beside) continue;
    if (!way.isClear) {
      finding.confidence = Confidence::Likely;
      finding.reason +=
          " " + say<"It may also be the camera's way, taken %1 times: the camera moves evenly here, and both "
                    "make the same.">(share);
      continue;
    }
    finding.id = "motionOtherWay";
    finding.name = say<"The camera's way %1 times in motion">(share);
    finding.symptom = say<"Near things smear while the camera moves; where it turns all is right.">();
    finding.change =
        say<"Motion is made as if the camera had come %1 times its way, as distances make it that are %2 "
            "times as far: make it with the depth, the near plane and the unit of the frames' own "
            "projection.">(share, shortNumber(1.0 / way.share));
    finding.correction.clear();
    finding.alike.clear();
  }
}

} // namespace

double allPixels(const CaptureInfo& captureInfo, const Diagnosis& out) {
  return static_cast<double>(out.frames) * captureInfo.sizePx.x * captureInfo.sizePx.y;
}

RegionPlace placeOf(const Region& region, const CaptureInfo& captureInfo, double allPixels) {
  RegionPlace out;
  const auto named = captureInfo.objectNames.find(region.objectId);
  if (region.isSky)
    out.name = say<"the sky">();
  else if (region.objectId != 0 && named != captureInfo.objectNames.end())
    out.name = say<"object %1 (%2)">(region.objectId, named->second);
  else if (region.objectId != 0)
    out.name = say<"object %1">(region.objectId);
  else
    out.name = say<"the part around pixel %1, %2 of frame %3">(region.pixel.x, region.pixel.y,
                                                               captureInfo.frameNames.of(region.frame));
  out.frame = region.frame;
  out.box = region.box;
  out.pixel = region.pixel;
  out.share = region.pixels / std::max(1.0, allPixels);
  out.isSky = region.isSky;
  out.objectId = region.objectId;
  out.pixels = region.runs;
  return out;
}

bool isBeyondPicture(const MotionEvidence& evidence) {
  constexpr double kMostLonger = 0.5;
  std::size_t known = 0, longer = 0;
  for (const RegionEvidence& region : evidence.regions()) {
    // One value that most have stands for none.
    const std::size_t marks = 2 * region.marks > region.outside ? region.marks : 0;
    known += region.seen - region.marked - marks;
    longer += region.outside - marks;
  }
  return known > 0 && static_cast<double>(longer) >= kMostLonger * static_cast<double>(known);
}

Finding unitFinding(const MotionTrial& unit) {
  Finding out;
  nameBy(motionFault(&unit, Region(), RegionEvidence()), out);
  out.confidence = Confidence::Likely;
  out.isWholePicture = true;
  out.reason = say<"At most of the pixels motion is longer than the picture.">();
  correctEverywhereBy(motionCorrection(unit), out);
  return out;
}

MotionTold tellMotion(const MotionEvidence& evidence, const std::vector<Region>& regions,
                      const CaptureInfo& captureInfo, const SilhouettesSeen& silhouettes, Diagnosis& out) {
  const double all = allPixels(captureInfo, out);
  tellMarks(evidence, regions, captureInfo, all, out);
  Judged judged = judgeMotion(evidence, regions, silhouettes);
  tellUnwrittenSky(judged.regions, captureInfo, all, out);
  preferStated(judged.regions, evidence.trials(), captureInfo);
  MotionTold told;
  const bool isOfOneFrame = identityFrame(evidence.pairs()).has_value();
  for (const FaultGroup& group : groupsOf(judged.regions, evidence.trials(), captureInfo.frameNames)) {
    if (isOfOneFrame && isOfCentroids(group)) continue; // its way over all frames holds that of the one
    const std::vector<Finding> findings = findingsOf(group, judged.regions, evidence, captureInfo, all);
    std::ranges::copy(findings, std::back_inserter(out.findings));
    if (!told.all && group.trial && breaksNothing(*group.trial, judged.regions))
      told.all = {evidence.trials()[*group.trial], findings};
  }
  const Finding late = lateFinding();
  if (judged.isLate && std::ranges::count(out.findings, late.id, &Finding::id) == 0)
    out.findings.push_back(late);
  tellJumps(evidence, regions, captureInfo, all, out);
  if (judged.contradicted)
    out.parts.leaveOpen(contradictedMatrices(evidence.trials()[*judged.contradicted],
                                             namesOf(judged.contradictedIn, captureInfo, all),
                                             !judged.areMatricesTrusted));
  tellOthers(judged, evidence.trials(), captureInfo, all, out);
  constexpr double kLeastShare = 0.05;
  if (const auto way = evidence.wayShare(); way && way->share > kLeastShare) tellWay(*way, out);
  told.isOfCameraOrDepth =
      judged.unconfirmed && evidence.trials()[*judged.unconfirmed].kind == MotionKind::CameraBeside;
  return told;
}

} // namespace taa::doctor
