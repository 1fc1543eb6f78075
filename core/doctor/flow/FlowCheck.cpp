#include "core/doctor/flow/FlowCheck.h"

#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/doctor/Correction.h"
#include "core/doctor/flow/FlowFindings.h"
#include "core/doctor/flow/FlowFit.h"
#include "core/doctor/flow/FlowLength.h"
#include "core/doctor/flow/FlowReadings.h"
#include "core/doctor/flow/FlowWords.h"
#include "core/doctor/flow/OtherObjects.h"
#include "core/doctor/motion/MotionCorrection.h"
#include "core/doctor/motion/MotionFindings.h"
#include "core/doctor/motion/MotionWords.h"
#include "core/settings/Faults.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

/// px: with jitter that is not known, what pictures alias by adds up.
constexpr double kOffPxWithOpenJitter = 1.5;
/// Of all squares: as many, refuted, refute an explanation of the whole picture; or make it doubtful.
constexpr double kRefutesAll = 0.5, kDoubtsAll = 0.25;

/// Adds one of motion, of which nothing is right then.
void addMotion(Finding finding, Diagnosis& out) {
  out.findings.push_back(std::move(finding));
  out.parts.takeBack(say<"Motion">());
}

/// Takes back what explanations were told of regions: something else explains all of them.
void takeBackRegions(Diagnosis& out) {
  std::erase_if(out.findings, [](const Finding& finding) {
    return isOfMotion(finding) && !finding.isWholePicture && !finding.residuals.empty();
  });
}

/// What was told of the whole picture, in words: it is refuted.
std::string takeBackOfAll(Diagnosis& out) {
  std::string names;
  std::erase_if(out.findings, [&](const Finding& finding) {
    if (!finding.isWholePicture || !isOfMotion(finding)) return false;
    names += (names.empty() ? "" : ", ") + finding.name;
    return true;
  });
  return names;
}

/// Motion of which no root was taken, and what is said of it as if one had been: all of it, as an encoding is
/// that of all that is stored. False: it is not so.
bool tellWithoutRoot(const FlowSeen& seen, const CaptureInfo& captureInfo, double tolerancePx,
                     Diagnosis& out) {
  std::vector<const FlowSquare*> written; // what was not is the camera's by what is stated
  for (const FlowPair& pair : seen.pairs)
    for (const FlowSquare& square : pair.squares)
      if (!square.isOfCamera()) written.push_back(&square);
  const auto withoutRoot = explainingWithoutRoot(written, captureInfo, tolerancePx);
  if (!withoutRoot) return false;
  // Of motion that hardly changes a line makes nearly what a curve does.
  const auto line = explaining(written, tolerancePx);
  if (line && isAlongAxes(*line) && line->followed >= withoutRoot->followed) return false;
  const std::vector<Refuted> refuted = refutedRegions(seen, tolerancePx);
  if (refuted.empty()) return false;
  takeBackOfAll(out);
  takeBackRegions(out);
  Finding finding = measuredFinding(refuted, seen, captureInfo, out);
  finding.confidence = Confidence::Likely;
  nameWithoutRoot(*withoutRoot, finding);
  addMotion(std::move(finding), out);
  return true;
}

/// Whether something that is sure explains motion of the whole picture, and with it that of each region.
bool isAllExplained(const Diagnosis& out) {
  return std::ranges::any_of(out.findings, [](const Finding& finding) {
    return finding.isWholePicture && isOfMotion(finding) && finding.confidence == Confidence::Sure;
  });
}

/// Whether the motion given is longer or shorter than what pictures move by, by a factor that hardly shows in
/// any square: over all of them it is known much better.
bool isOfOtherLength(const FlowSeen& seen, const FlowCaptureInfo& captureInfo, double tolerancePx,
                     const Diagnosis& out) {
  constexpr double kMovingPx = 1.0, kShare = 0.04, kFitErrors = 5.0;
  constexpr std::size_t kEnoughMoving = 60;
  std::vector<bool> isTold;
  for (const Region& region : seen.regions)
    isTold.push_back(isRegionTold(placeOf(region, captureInfo.captureInfo, 1.0).name, out));
  std::vector<const FlowSquare*> moving;
  for (const FlowPair& pair : seen.pairs)
    for (const FlowSquare& square : pair.squares)
      if (glm::length(square.given) >= kMovingPx && !isTold[static_cast<std::size_t>(square.region)])
        moving.push_back(&square);
  if (moving.size() < kEnoughMoving) return false;
  const auto fit = fitFlow(moving, true, tolerancePx);
  if (!fit || !fit->isGood() || !isAlongAxes(*fit)) return false;
  // Jitter that is not known is one error of all squares of a pair.
  const double alike = captureInfo.isJitterOpen
                           ? static_cast<double>(moving.size()) / static_cast<double>(seen.pairs.size())
                           : 1.0;
  const auto isOther = [&](int axis) {
    return std::abs(fit->factors[axis][axis] - 1.0) >
           std::max(kShare, kFitErrors * std::sqrt(alike) * fit->factorErrors[axis][axis]);
  };
  return isOther(0) && isOther(1) && fit->factors[0][0] > 0.0 && fit->factors[1][1] > 0.0;
}

/// Whether the motion given is what pictures move by, and an explanation would make something else of it.
bool isRightAsGiven(const std::vector<const FlowSquare*>& squares, std::size_t trial) {
  constexpr double kNearlyAll = 0.8, kOtherPx = 1.0;
  if (squares.size() < kEnoughRefutingSquares) return false;
  const auto right = std::ranges::count_if(squares, [&](const FlowSquare* square) {
    return square->offPx() <= kOffPx && isMotion(square->byTrial[trial]) &&
           glm::distance(glm::dvec2(square->byTrial[trial]), square->given) >= kOtherPx;
  });
  return static_cast<double>(right) >= kNearlyAll * static_cast<double>(squares.size());
}

/// All that was measured where a finding is.
std::vector<const FlowSquare*> squaresIn(const Finding& finding, const FlowSeen& seen,
                                         const CaptureInfo& captureInfo) {
  std::set<RegionIndex> regions;
  for (std::size_t i = 0; i < seen.regions.size(); ++i)
    if (std::ranges::count(finding.regions, placeOf(seen.regions[i], captureInfo, 1.0).name,
                           &RegionPlace::name) > 0)
      regions.insert(static_cast<RegionIndex>(i));
  std::vector<const FlowSquare*> out;
  for (const FlowPair& pair : seen.pairs)
    for (const FlowSquare& square : pair.squares)
      if (regions.contains(square.region)) out.push_back(&square);
  return out;
}

/// Whether an explanation by motion of the frame after makes next to nothing better over all of a region:
/// what a few pixels beside something say.
bool isHardlyBetter(const MotionTrial& trial, const Finding& finding) {
  constexpr double kHardly = 1.05;
  if (trial.kind != MotionKind::FrameEarly && trial.kind != MotionKind::Forward) return false;
  const auto given = std::ranges::find(finding.residuals, true, &Residual::isGiven);
  return given != finding.residuals.end() && given->value < kHardly * finding.residuals.front().value;
}

/// Of a factor that explains a region the number that squares say, where it is not the one told.
void measureFactor(const MotionTrial& trial, const std::vector<const FlowSquare*>& squares,
                   const FlowSeen& seen, const CaptureInfo& captureInfo, Finding& finding) {
  if (trial.kind != MotionKind::Scaled || squares.size() < kEnoughRefutingSquares) return;
  const auto fit = fitFlow(squares, true, kOffPx);
  if (!fit || !fit->isGood() || !isAlongAxes(*fit)) return;
  const auto known = knownTrial(*fit, captureInfo.sizePx);
  if (known && trialId(*known) == trialId(trial)) return;
  finding.change = exampleOf(squares, seen, captureInfo);
  finding.correction.clear();
  nameByFit(*fit, captureInfo, finding);
}

/// Takes back findings of regions whose explanation does not make what is measured there, or where nothing is
/// wrong; what makes only a part of it is not sure, and a factor that stays is measured.
void takeBackRefuted(const FlowSeen& seen, const CaptureInfo& captureInfo, Diagnosis& out) {
  const std::vector<MotionTrial> trials = motionTrials(captureInfo.sizePx);
  std::erase_if(out.findings, [&](Finding& finding) {
    if (!isOfMotion(finding) || finding.isWholePicture || finding.residuals.empty()) return false;
    const auto trial = std::ranges::find(trials, finding.residuals.front().id, &trialId);
    if (trial == trials.end()) return false;
    const std::vector<const FlowSquare*> squares = squaresIn(finding, seen, captureInfo);
    const auto index = static_cast<std::size_t>(trial - trials.begin());
    const BorneOut says = borneOut(squares, index);
    if (says == BorneOut::Partly) finding.confidence = Confidence::Likely;
    const bool isRefuted =
        isRightAsGiven(squares, index) || says == BorneOut::No || isHardlyBetter(*trial, finding);
    if (!isRefuted) measureFactor(*trial, squares, seen, captureInfo, finding);
    return isRefuted;
  });
}

/// How much of what was measured is refuted.
double refutedShare(const FlowSeen& seen, double tolerancePx) {
  std::size_t all = 0, refuting = 0;
  for (const FlowPair& pair : seen.pairs)
    for (const FlowSquare& square : pair.squares) {
      ++all;
      if (square.refutesGiven(tolerancePx)) ++refuting;
    }
  return all == 0 ? 0.0 : static_cast<double>(refuting) / static_cast<double>(all);
}

/// Says of findings of regions in which frames pictures refute them, where that is not in all.
void tellFrames(const std::vector<Refuted>& refuted, const CaptureInfo& captureInfo, Diagnosis& out) {
  constexpr double kNearlyAll = 0.8;
  for (Finding& finding : out.findings) {
    if (!isOfMotion(finding) || finding.isWholePicture) continue;
    for (const Refuted& one : refuted) {
      const bool isOfFinding =
          std::ranges::count(finding.regions, placeOf(*one.region, captureInfo, 1.0).name,
                             &RegionPlace::name) > 0;
      const bool isSometimes =
          static_cast<double>(one.frames.size()) < kNearlyAll * static_cast<double>(one.asked.size());
      if (!isOfFinding || !isSometimes) continue;
      finding.reason += " " + say<"By what squares move by it is so in %1.">(
                                  captureInfo.frameNames.of(one.frames, one.asked));
      break;
    }
  }
}

/// Whether a finding says no more than that what rests does not move as the camera, whatever it moves by.
bool saysNotCamerasAlone(const Finding& finding) {
  const bool isOfCamera = !finding.residuals.empty() && finding.residuals.front().id == "ofCamera";
  return finding.id == "motionNotCameras" ||
         (isOfCamera && (finding.id == faultInfo(Fault::CameraTurned).id ||
                         finding.id == faultInfo(Fault::CameraOfSecondView).id));
}

/// Where one line makes all that is given what pictures move by, that says more than that it is not the
/// camera's.
void nameNotCameras(const FlowSeen& seen, const CaptureInfo& captureInfo, double tolerancePx,
                    Diagnosis& out) {
  if (std::ranges::none_of(out.findings, saysNotCamerasAlone)) return;
  const std::vector<Refuted> all{wholePicture(seen)};
  const auto fit = explaining(all.front().squares, tolerancePx);
  const bool isAnyTurned = std::ranges::any_of(out.findings, [](const Finding& finding) {
    return saysNotCamerasAlone(finding) && finding.id != "motionNotCameras";
  });
  // What turns with a camera follows no line closely.
  constexpr double kClosePx = 0.2, kNearlyAll = 0.9;
  if (!fit || (isAnyTurned && followedShare(*fit, all.front().squares, kClosePx) < kNearlyAll)) return;
  std::erase_if(out.findings, saysNotCamerasAlone);
  takeBackRegions(out); // a part of it
  Finding finding = measuredFinding(all, seen, captureInfo, out);
  finding.confidence = Confidence::Likely;
  finding.isWholePicture = true;
  nameByFit(*fit, captureInfo, finding);
  addMotion(std::move(finding), out);
}

FaultWords otherObjectWords() {
  return {
      "motionOfAnotherObject", say<"Motion of another object">(),
      say<"A ghost where the other one is, or went.">(),
      say<"Each object has to find its own previous transform: look at the key or the index that it is kept "
          "by, and at what is drawn in between.">()};
}

bool isUnsure(const Finding& finding) {
  return finding.confidence != Confidence::Sure;
}

/// What is taken from another object, and whose it is; takes these regions out of `refuted`.
void tellOtherObjects(std::vector<Refuted>& refuted, const FlowSeen& seen, const CaptureInfo& captureInfo,
                      Diagnosis& out) {
  const std::vector<OfOtherObject> found = ofOtherObjects(refuted, seen);
  if (found.empty()) return;
  std::vector<Refuted> of;
  std::erase_if(refuted, [&](const Refuted& one) {
    const bool isFound = std::ranges::count(found, one.region, &OfOtherObject::region) > 0;
    if (isFound) of.push_back(one);
    return isFound;
  });
  Finding finding = measuredFinding(of, seen, captureInfo, out);
  finding.confidence = Confidence::Likely;
  finding.regions.clear();
  nameMeasured(otherObjectWords(), finding);
  for (const OfOtherObject& one : found) {
    const RegionPlace place = placeOf(*one.region, captureInfo, allPixels(captureInfo, out));
    const std::string other = placeOf(*one.other, captureInfo, 1.0).name;
    finding.reason +=
        " " + (one.kind == OtherObjectKind::Motion
                   ? say<"In %1 of %2 frames the motion given of %3 is what %4 moves by, to %5 px.">(
                         one.frames, one.asked, place.name, other, shortNumber(one.px))
                   : say<"In %1 of %2 frames the motion given of %3 leads to where %4 was, to %5 px.">(
                         one.frames, one.asked, place.name, other, shortNumber(one.px)));
    takeOutOfMotion({place.name}, out.findings, isUnsure);
    finding.regions.push_back(place);
  }
  std::ranges::stable_sort(finding.regions, std::greater(), &RegionPlace::share);
  addMotion(std::move(finding), out);
}

/// Frames in which a list of transforms slips.
void tellSlipped(const FlowSeen& seen, const CaptureInfo& captureInfo, Diagnosis& out) {
  Finding finding;
  nameBy(otherObjectWords(), finding);
  finding.confidence = Confidence::Likely;
  for (const SlippedFrame& slipped : slippedFrames(seen)) {
    for (const Region* region : slipped.regions) {
      const RegionPlace place = placeOf(*region, captureInfo, allPixels(captureInfo, out));
      takeOutOfMotion({place.name}, out.findings, isUnsure);
      if (std::ranges::count(finding.regions, place.name, &RegionPlace::name) == 0)
        finding.regions.push_back(place);
    }
    finding.reason += (finding.reason.empty() ? "" : " ") +
                      say<"In frame %1 the motion given of %2 of %3 objects that do not move so leads to "
                          "where other ones were, to %4 px: of %5 to where %6 was.">(
                          captureInfo.frameNames.of(slipped.frame), slipped.told, slipped.regions.size(),
                          shortNumber(slipped.px), placeOf(*slipped.example, captureInfo, 1.0).name,
                          placeOf(*slipped.other, captureInfo, 1.0).name);
  }
  if (!finding.regions.empty()) addMotion(std::move(finding), out);
}

/// What explanations that are no line make of the motion given; takes these regions out of `refuted`.
void tellReadings(std::vector<Refuted>& refuted, const FlowSeen& seen, const CaptureInfo& captureInfo,
                  Diagnosis& out) {
  const std::vector<MotionTrial> trials = motionTrials(captureInfo.sizePx);
  const double healthy = healthyPx(seen);
  std::map<std::size_t, std::vector<Refuted>> byTrial;
  std::map<std::size_t, std::set<std::size_t>> rivals;
  std::erase_if(refuted, [&](const Refuted& one) {
    if (areAllZero(one.squares)) return false;
    const std::vector<std::size_t> best = bestReadings(one.squares, trials, healthy);
    if (best.empty()) return false;
    // What is right in the frames before and after a wrong one is no motion of theirs that came late.
    if (madeOf(trials[best.front()].kind) == MotionMadeOf::OtherFrame &&
        borneOut(one.ofAll, best.front()) != BorneOut::Yes)
      return false;
    byTrial[best.front()].push_back(one);
    rivals[best.front()].insert(best.begin() + 1, best.end());
    return true;
  });
  for (const auto& [trial, of] : byTrial) {
    const std::vector<const FlowSquare*> squares = squaresOf(of);
    Finding finding = measuredFinding(of, seen, captureInfo, out);
    finding.confidence = Confidence::Likely;
    nameMeasured(motionFault(&trials[trial], *of.front().region, RegionEvidence()), finding);
    finding.reason += " " + say<"Taken like this it is off by %1 px: %2.">(
                                shortNumber(leftPx(squares, trial)), trialText(trials[trial]));
    for (const std::size_t rival : rivals[trial]) {
      std::string id = motionFault(&trials[rival], *of.front().region, RegionEvidence()).id;
      if (id != finding.id && std::ranges::count(finding.alike, id) == 0)
        finding.alike.push_back(std::move(id));
    }
    correctBy(motionCorrection(trials[trial]), finding);
    out.findings.push_back(std::move(finding));
  }
}

/// Motion that ends at a length, and what was said of regions where it does.
void tellLimited(const FlowSeen& seen, const CaptureInfo& captureInfo, double tolerancePx, Diagnosis& out) {
  const auto limit = limitPx(seen.pairs, tolerancePx);
  if (!limit) return;
  std::vector<Refuted> refuted = refutedRegions(seen, tolerancePx);
  if (refuted.empty()) return;
  takeBackRegions(out);
  Finding finding = measuredFinding(refuted, seen, captureInfo, out);
  nameMeasured({"motionLimited", say<"Motion cut off at a length">(),
                say<"Fast things ghost; slow ones are right.">(),
                say<"Store motion for TAA without the limit that motion blur, or a format, puts on it.">()},
               finding);
  finding.reason +=
      " " + say<"No motion that is given is longer than %1 px, where the pictures move farther, "
                "and now more and now less; shorter motion is right.">(shortNumber(*limit));
  addMotion(std::move(finding), out);
}

/// A frame of which everything moves otherwise than is given.
void tellWholeFrames(const FlowSeen& seen, const CaptureInfo& captureInfo, double tolerancePx,
                     Diagnosis& out) {
  const std::vector<Refuted> refuted{wholeFrames(seen, tolerancePx)};
  if (refuted.front().frames.empty() || std::ranges::any_of(out.findings, isOfMotion)) return;
  Finding finding = measuredFinding(refuted, seen, captureInfo, out);
  finding.confidence = Confidence::Likely;
  finding.isWholePicture = true;
  nameBest({}, refuted, seen, captureInfo, tolerancePx, finding);
  addMotion(std::move(finding), out);
}

/// What goes one way has lost that part of its motion: numbers without a sign.
void tellClipped(const FlowSeen& seen, const CaptureInfo& captureInfo, Diagnosis& out) {
  const std::vector<Refuted> all{wholePicture(seen)};
  const bool x = isClipped(all.front().squares, 0), y = isClipped(all.front().squares, 1);
  if (!x && !y) return;
  takeBackRegions(out);
  Finding finding = measuredFinding(all, seen, captureInfo, out);
  nameMeasured({"motionClipped", say<"Motion without its negative part">(),
                say<"What goes one way ghosts; what goes the other is right.">(),
                say<"Store motion in a format with a sign, or with an offset that is stated.">()},
               finding);
  finding.isWholePicture = true;
  finding.reason = say<
      "Along %1 motion of one sign is given and none of the other: where pictures move that way it is 0.">(
      x && y ? say<"x and y">()
      : x    ? std::string("x")
             : std::string("y"));
  addMotion(std::move(finding), out);
}

/// Of squares of which depth and matrices say something else than the motion given: whether there are enough,
/// and most move as one of them has it. `offPx`: how far off that is.
bool areMost(const FlowSeen& seen, const std::function<double(const FlowSquare&)>& offPx) {
  constexpr std::size_t kEnough = 24;
  constexpr double kMost = 0.6;
  std::size_t apart = 0, moving = 0;
  for (const FlowPair& pair : seen.pairs)
    for (const FlowSquare& square : pair.squares) {
      const double tolerancePx = std::max(kOffPx, 3.0 * square.errorPx);
      if (!square.camera || glm::distance(*square.camera, square.given) <= 2.0 * tolerancePx) continue;
      ++apart;
      if (offPx(square) <= tolerancePx) ++moving;
    }
  return moving >= kEnough && static_cast<double>(moving) >= kMost * static_cast<double>(apart);
}

/// What is told of motion of the whole picture does not make what pictures move by.
void leaveUnsure(Diagnosis& out) {
  for (Finding& finding : out.findings)
    if (finding.isWholePicture && isOfMotion(finding)) finding.confidence = Confidence::Likely;
}

} // namespace

bool isDepthConfirmed(const FlowSeen& seen) {
  return areMost(seen, [](const FlowSquare& square) { return glm::distance(*square.camera, square.px); });
}

bool isMotionConfirmed(const FlowSeen& seen) {
  return areMost(seen, [](const FlowSquare& square) { return square.offPx(); });
}

void tellFlow(const FlowSeen& asGiven, const FlowSeen& corrected, const FlowCaptureInfo& captureInfo,
              Diagnosis& out) {
  const double tolerancePx = captureInfo.isJitterOpen ? kOffPxWithOpenJitter : kOffPx;
  // A curve can pass for what a mistake that is told makes of motion of nearly one length.
  const bool isExplained = captureInfo.isMotionCorrected && refutedShare(corrected, tolerancePx) < kDoubtsAll;
  if (!isExplained && tellWithoutRoot(asGiven, captureInfo.captureInfo, tolerancePx, out)) return;
  const bool isAnyTold = std::ranges::any_of(out.findings, isOfMotion);
  const bool isOtherLength = isOfOtherLength(corrected, captureInfo, tolerancePx, out) ||
                             (!isAnyTold && isRestRefuted(corrected.pairs));
  if (isOtherLength ||
      (captureInfo.isMotionCorrected && refutedShare(corrected, tolerancePx) >= kRefutesAll)) {
    // What is wrong everywhere shows in the sum of squares in none of which it is clear.
    std::vector<Refuted> refuted{wholePicture(asGiven)};
    if (!isOtherLength && !explaining(refuted.front().squares, tolerancePx))
      refuted = refutedRegions(asGiven, tolerancePx);
    if (refuted.empty()) {
      leaveUnsure(out);
      return;
    }
    const std::string told = takeBackOfAll(out);
    Finding finding = bestFinding(refuted, asGiven, captureInfo.captureInfo, tolerancePx, out);
    finding.isWholePicture = true;
    if (finding.id == kUnknownMotionId && !told.empty())
      finding.reason += " " + say<"What comes nearest does not explain it either: %1.">(told);
    addMotion(std::move(finding), out);
    return;
  }
  if (captureInfo.isMotionCorrected && !isExplained) leaveUnsure(out);
  std::vector<Refuted> refuted = refutedRegions(corrected, tolerancePx);
  takeBackRefuted(corrected, captureInfo.captureInfo, out);
  tellClipped(corrected, captureInfo.captureInfo, out);
  tellLimited(corrected, captureInfo.captureInfo, tolerancePx, out);
  nameNotCameras(corrected, captureInfo.captureInfo, tolerancePx, out);
  tellFrames(refuted, captureInfo.captureInfo, out);
  if (!isAllExplained(out)) {
    tellOtherObjects(refuted, corrected, captureInfo.captureInfo, out);
    tellSlipped(corrected, captureInfo.captureInfo, out);
  }
  std::erase_if(refuted, [&](const Refuted& one) {
    return isMotionTold(placeOf(*one.region, captureInfo.captureInfo, 1.0).name, out);
  });
  if (refuted.empty()) {
    if (!captureInfo.isJitterOpen) tellWholeFrames(corrected, captureInfo.captureInfo, tolerancePx, out);
    return;
  }
  tellReadings(refuted, corrected, captureInfo.captureInfo, out);
  if (!refuted.empty())
    out.findings.push_back(bestFinding(refuted, corrected, captureInfo.captureInfo, tolerancePx, out));
  out.parts.takeBack(say<"Motion">());
}

} // namespace taa::doctor
