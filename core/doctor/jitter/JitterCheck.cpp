#include "core/doctor/jitter/JitterCheck.h"

#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/decode/ScreenUnits.h"
#include "core/doctor/Correction.h"
#include "core/doctor/jitter/JitterFactors.h"
#include "core/doctor/jitter/JitterFit.h"
#include "core/doctor/jitter/JitterPauses.h"
#include "core/doctor/jitter/JitterSequence.h"
#include "core/doctor/jitter/JitterSky.h"
#include "core/settings/Faults.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

constexpr std::size_t kEnoughShifts = 4;
// px, in the middle of all pairs: shifts that are not those of a jitter, however pictures alias, and shifts
// that are there at all.
constexpr double kMissingPx = 0.3, kShiftingPx = 0.15;
constexpr double kNoJitterPx = 1e-3;

struct JitterWords {
  Fault fault;
  std::string change;
};

/// What no fault of the table is.
constexpr std::string_view kOtherUnitId = "jitterUnit", kOfAxisId = "jitterOfAxis";

JitterWords jitterWords(const JitterTrial& trial) {
  switch (trial.kind) {
  case JitterKind::AsStated:
    break;
  case JitterKind::NotApplied:
    return {Fault::JitterNotApplied,
            say<"Apply the jitter to the projection that color is drawn with, or report none.">()};
  case JitterKind::MirroredX:
    return {Fault::JitterNegatedX, say<"Negate x of the jitter that you pass.">()};
  case JitterKind::MirroredY:
    return {Fault::JitterNegatedY, say<"Negate y of the jitter that you pass.">()};
  case JitterKind::Opposite:
    return {Fault::JitterNegated,
            say<"Negate the jitter that you pass, or state its other meaning: content against sample.">()};
  case JitterKind::SwappedAxes:
    return {Fault::JitterSwapped, say<"Exchange x and y of the jitter that you pass.">()};
  case JitterKind::Scaled:
  case JitterKind::OtherUnit:
    return {
        trial.factor.x * std::abs(trial.factor.y) < 1.0f ? Fault::JitterDoubled : Fault::JitterHalved,
        say<"Multiply the jitter that you pass by %1, or state the unit that it has; or draw with what you "
            "pass.">(shortVector(glm::dvec2(trial.factor)))};
  case JitterKind::FrameLate:
    return {Fault::JitterLate, say<"Pass the jitter of the frame itself: what you pass is that of the frame "
                                   "before.">()};
  case JitterKind::FrameEarly:
    return {Fault::JitterEarly, say<"Pass the jitter of the frame itself: what you pass is that of the frame "
                                    "after.">()};
  }
  return {Fault::JitterNotReported, say<"Pass the jitter that pictures are drawn with.">()};
}

/// A displacement of content, px, as the engine states jitter.
glm::dvec2 passedJitter(const CaptureInfo& captureInfo, const glm::vec2& jitterPx) {
  if (!captureInfo.conventions) return glm::dvec2(jitterPx);
  const capture::JitterConventions& jitter = captureInfo.conventions->jitter;
  const glm::dvec2 perValue = capture::pxPerUnit(jitter.unit, jitter.yAxis, captureInfo.sizePx);
  return (jitter.meaning == capture::JitterMeaning::Sample ? -1.0 : 1.0) * glm::dvec2(jitterPx) / perValue;
}

/// The frame whose stated jitter is farthest from what pictures show, in a sentence.
std::string exampleOf(const JitterTrial& trial, const JitterEvidence& evidence,
                      const CaptureInfo& captureInfo) {
  float farthest = -1.0f;
  std::string text;
  for (const auto& [frame, stated] : evidence.stated) {
    const auto shown = trueJitter(trial, evidence.stated, frame);
    if (!shown || glm::distance(*shown, stated) <= farthest) continue;
    farthest = glm::distance(*shown, stated);
    text = say<"For example at frame %1 you pass %2; the pictures show %3.">(
        captureInfo.frameNames.of(frame), shortVector(passedJitter(captureInfo, stated)),
        shortVector(passedJitter(captureInfo, *shown)));
  }
  return text;
}

/// Of shifts that are measured, px, in the middle of all pairs.
double measuredPx(const JitterEvidence& evidence) {
  return shiftResidual({JitterKind::NotApplied}, evidence);
}

bool isNone(const glm::vec2& jitterPx) {
  return !(static_cast<double>(glm::length(jitterPx)) > kNoJitterPx);
}

bool isConstant(const JitterEvidence& evidence) {
  return std::ranges::all_of(evidence.stated, [&](const auto& frame) {
    return glm::distance(frame.second, evidence.stated.begin()->second) < 1e-4f;
  });
}

/// What makes what is reported that which pictures hold; no setting changes a unit of jitter.
std::vector<std::string> jitterCorrection(const JitterTrial& trial) {
  switch (trial.kind) {
  case JitterKind::AsStated:
  case JitterKind::OtherUnit:
    break;
  case JitterKind::NotApplied:
    return {"fault.jitter=unreported"};
  case JitterKind::MirroredX:
    return {"fault.jitter=negatedX"};
  case JitterKind::MirroredY:
    return {"fault.jitter=negatedY"};
  case JitterKind::Opposite:
    return {"fault.jitter=negated"};
  case JitterKind::SwappedAxes:
    return {"fault.jitter=swapped"};
  case JitterKind::Scaled:
    if (trial.factor.x != trial.factor.y) break;
    return {"fault.jitterReported=" + shortNumber(static_cast<double>(trial.factor.x))};
  case JitterKind::FrameLate:
    return {"fault.jitter=early"};
  case JitterKind::FrameEarly:
    return {"fault.jitter=late"};
  }
  return {};
}

Finding wordedFinding(const JitterWords& words) {
  Finding out = faultFinding(words.fault);
  out.change = words.change;
  out.isWholePicture = true;
  return out;
}

std::vector<Residual> jitterResiduals(const JitterFit& fit, const std::vector<JitterTrial>& trials) {
  std::vector<Residual> out;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (trials[i].isTwofold() && !trials[fit.best].isTwofold()) continue;
    const bool isStated = trials[i].kind == JitterKind::AsStated;
    const double share = isStated ? 1.0 : fit.trials[i].share();
    if (std::isfinite(share))
      out.push_back({jitterTrialId(trials[i]), jitterTrialText(trials[i]), 1000.0 * share * fit.statedLuma,
                     isStated, i == fit.best});
  }
  std::ranges::stable_sort(out, {}, &Residual::value);
  return out;
}

/// Other explanations that fit as well, in the finding's sentences.
void tellRivals(const JitterFit& fit, const std::vector<JitterTrial>& trials, Finding& out) {
  std::string texts;
  for (const std::size_t rival : fit.rivals()) {
    texts += (texts.empty() ? "" : "; ") + jitterTrialText(trials[rival]);
    const std::string id(faultInfo(jitterWords(trials[rival]).fault).id);
    if (id != out.id && std::ranges::find(out.alike, id) == out.alike.end()) out.alike.push_back(id);
  }
  if (texts.empty()) return;
  out.reason += " " + say<"These frames do not tell it from: %1.">(texts);
  out.confidence = Confidence::Likely;
}

/// One thing that a trial says is wrong; a twofold one says two.
Finding otherJitterFinding(const JitterTrial& one, const JitterTrial& best, const JitterEvidence& evidence,
                           const CaptureInfo& captureInfo) {
  Finding out = jitterFinding(one);
  out.change += " " + exampleOf(best, evidence, captureInfo);
  // No setting undoes two things that are wrong with jitter.
  if (!best.isTwofold()) correctBy(jitterCorrection(one), out);
  return out;
}

/// By which the best trial of a fit is told.
enum class JitterConsistency : std::uint8_t { Pairs, Rest };

std::string consistencyText(JitterConsistency consistency, const JitterFit& fit, const JitterTrial& best) {
  const TrialFit& won = fit.trials[fit.best];
  const std::string text = jitterTrialText(best);
  if (consistency == JitterConsistency::Rest)
    return say<
        "The camera rests: by the slopes of the mean of all pictures each of them is displaced as jitter "
        "like this makes it, and as nothing else that was tried: %1.">(text);
  return say<"In %1 of %2 pairs of frames pictures fit the one before better if jitter is like this: %3. "
             "What is left then is %4 % of what is left as stated.">(won.won, won.pairs, text,
                                                                     std::lround(100.0 * won.share()));
}

std::string withoutCameraText() {
  return say<"Without depth and matrices it may also be motion that holds jitter.">();
}

/// Pictures shift as something else than what is stated makes them: a finding for each thing that is wrong.
std::vector<Finding> otherJitter(JitterConsistency consistency, const JitterFit& fit,
                                 const std::vector<JitterTrial>& trials, const JitterEvidence& evidence,
                                 bool isCameraKnown, const CaptureInfo& captureInfo) {
  const JitterTrial& best = trials[fit.best];
  std::vector<Finding> findings{otherJitterFinding({best.kind, best.factor}, best, evidence, captureInfo)};
  if (best.isTwofold()) findings.push_back(otherJitterFinding({best.also}, best, evidence, captureInfo));
  for (Finding& out : findings) {
    out.reason = consistencyText(consistency, fit, best) + " " +
                 say<"Shifts that are measured from frame to frame are %1 px from it, and %2 px from what is "
                     "stated.">(shortNumber(fit.missPx[fit.best]), shortNumber(fit.missPx.front()));
    out.measure = say<"median difference of luma where pictures are shifted so, × 1000">();
    out.residuals = jitterResiduals(fit, trials);
    if (consistency == JitterConsistency::Pairs) tellRivals(fit, trials, out);
    if (isCameraKnown) continue;
    out.reason += " " + withoutCameraText();
    out.confidence = Confidence::Likely;
  }
  return findings;
}

/// Always the same jitter is stated, and pictures do not shift.
Finding frozenJitter(const glm::vec2& statedPx, const CaptureInfo& captureInfo) {
  Finding out = wordedFinding(
      {Fault::JitterFrozen,
       say<"Go on in the sequence with each frame that is drawn: its index is always the same.">()});
  out.reason = say<"All frames state the same jitter, %1, and pictures do not shift against each other.">(
      shortVector(passedJitter(captureInfo, statedPx)));
  return out;
}

/// The same where pictures do not say whether they shift: what is stated is wrong whatever they do.
Finding frozenStatement(const glm::vec2& statedPx, const CaptureInfo& captureInfo) {
  Finding out = frozenJitter(statedPx, captureInfo);
  out.confidence = Confidence::Likely;
  out.reason = say<"All frames state the same jitter, %1. Whether pictures shift nevertheless they have too "
                   "little detail to tell.">(shortVector(passedJitter(captureInfo, statedPx)));
  return out;
}

/// What pictures hold by their shifts alone, but for a constant that no difference shows: from the first
/// frame of each run of measured pairs on.
JitterCorrector measuredJitter(const JitterEvidence& evidence) {
  std::map<int, glm::vec2> jitters;
  for (const JitterEvidence::Shift& shift : evidence.shifts) {
    const glm::vec2 before = jitters.try_emplace(shift.frame - 1, 0.0f).first->second;
    jitters[shift.frame] = before - shift.px;
  }
  return [jitters](int frame) -> std::optional<glm::vec2> {
    const auto found = jitters.find(frame);
    if (found == jitters.end()) return {};
    return found->second;
  };
}

/// Pictures shift though no jitter is stated, or always the same.
JitterCorrector tellUnstated(const JitterEvidence& evidence, bool isCameraKnown,
                             const CaptureInfo& captureInfo, Diagnosis& out) {
  const double shiftPx = measuredPx(evidence);
  const glm::vec2 stated = evidence.stated.begin()->second;
  if (shiftPx < kShiftingPx && !isNone(stated)) {
    out.findings.push_back(frozenJitter(stated, captureInfo));
    return {};
  }
  if (shiftPx < kShiftingPx) {
    out.notes.push_back(say<"No jitter is stated, and the pictures show none.">());
    return {};
  }
  if (!isCameraKnown) {
    out.parts.leaveOpen(
        {say<"Jitter">(),
         say<"none is stated, and pictures shift by %1 px besides their motion">(shortNumber(shiftPx)),
         say<"Capture depth and matrices, too.">(),
         {},
         true});
    return {};
  }
  Finding finding = wordedFinding(jitterWords({}));
  finding.reason = say<"No jitter is stated, or always the same, and pictures shift by %1 px besides the "
                       "camera's motion.">(shortNumber(shiftPx));
  finding.measure = say<"distance of measured shifts from those that jitter makes, px">();
  finding.residuals = {{"asStated", say<"as stated">(), shiftPx, true, false}};
  out.findings.push_back(std::move(finding));
  return measuredJitter(evidence);
}

/// Some frames are drawn without the jitter that is stated for them.
JitterCorrector tellPauses(const JitterPauses& pauses, const JitterEvidence& evidence, Diagnosis& out) {
  const std::string frames = out.frameNames.of(pauses.frames, pauses.asked);
  Finding finding = wordedFinding(jitterWords({JitterKind::NotApplied}));
  finding.name = say<"Jitter reported, not applied in %1">(frames);
  finding.change =
      say<"Apply the jitter to the projection that color is drawn with in %1, too, or report none for "
          "them.">(frames);
  finding.reason =
      say<"Shifts that are measured from frame to frame are those of the stated jitter, to %1 px, if "
          "the pictures of %2 hold none; with it they would be %3 px off. The others hold it.">(
          shortNumber(pauses.pausedPx), frames, shortNumber(pauses.statedPx));
  finding.measure = say<"distance of measured shifts from those that jitter makes, px">();
  finding.residuals = {{"paused", say<"without jitter in %1">(frames), pauses.pausedPx, false, true},
                       {"asStated", say<"as stated">(), pauses.statedPx, true, false}};
  out.findings.push_back(std::move(finding));
  return [pauses, stated = evidence.stated](int frame) -> std::optional<glm::vec2> {
    const auto found = stated.find(frame);
    if (found == stated.end()) return {};
    return std::ranges::count(pauses.frames, frame) > 0 ? glm::vec2(0.0f) : found->second;
  };
}

/// Those that pictures would show.
std::vector<Fault> jitterFaults() {
  return {Fault::JitterNegatedX, Fault::JitterNegatedY,   Fault::JitterNegated, Fault::JitterSwapped,
          Fault::JitterDoubled,  Fault::JitterHalved,     Fault::JitterLate,    Fault::JitterEarly,
          Fault::JitterOutside,  Fault::JitterNotApplied, Fault::JitterMean,    Fault::JitterShort,
          Fault::SkyNotJittered};
}

/// What is wrong with, and worth knowing of, the sequence that pictures hold if a trial is right.
void tellSequenceOf(const JitterTrial& trial, const JitterEvidence& evidence, Diagnosis& out) {
  std::map<int, glm::vec2> jitters;
  for (const auto& [frame, stated] : evidence.stated)
    if (const auto jitter = trueJitter(trial, evidence.stated, frame)) jitters[frame] = *jitter;
  const bool startsWithNone = !jitters.empty() && jitters.begin()->second == glm::vec2(0.0f);
  if (startsWithNone && trial.kind == JitterKind::AsStated)
    out.notes.push_back(say<"The first frame is not jittered; others are.">());
  if (startsWithNone) jitters.erase(jitters.begin());
  tellSequence(jitters, out);
}

/// What the doctor says of the sequence, and of the sky, where pictures shift as a trial has it.
void tellTrial(const std::vector<JitterTrial>& trials, std::size_t trial, const JitterEvidence& evidence,
               const std::optional<RegionPlace>& sky, Diagnosis& out) {
  tellSequenceOf(trials[trial], evidence, out);
  if (sky) tellSky(evidence, trials, trial, *sky, out);
}

Finding factorsFinding(const JitterFactors& factors, const JitterEvidence& evidence,
                       const JitterCaptureInfo& captureInfo, double statedMissPx) {
  const JitterTrial trial = factors.trial();
  const double missPx = shiftResidual(trial, evidence);
  Finding out = otherJitterFinding(trial, trial, evidence, captureInfo.captureInfo);
  out.confidence = Confidence::Likely;
  out.reason =
      say<"By least squares over %1 pairs of frames pictures shift by %2 ± %3 times the stated jitter "
          "along x, and %4 ± %5 times along y. Shifts that are measured are %6 px from that in the "
          "middle, and %7 px from what is stated.">(
          shiftPairs(evidence).size(), measuredNumber(factors.factor.x, factors.error.x),
          errorNumber(factors.error.x), measuredNumber(factors.factor.y, factors.error.y),
          errorNumber(factors.error.y), shortNumber(missPx), shortNumber(statedMissPx));
  if (const std::string sides = sidesText(factors, captureInfo.captureInfo.sizePx); !sides.empty())
    out.reason += " " + sides;
  if (!captureInfo.isCameraKnown) out.reason += " " + withoutCameraText();
  out.measure = say<"distance of measured shifts from those that jitter makes, px">();
  out.residuals = {{jitterTrialId(trial), jitterTrialText(trial), missPx, false, true},
                   {"asStated", say<"as stated">(), statedMissPx, true, false}};
  return out;
}

void tellNoFit(double missPx, Diagnosis& out) {
  out.parts.leaveOpen({say<"Jitter">(),
                       say<"measured shifts are %1 px from those that are stated, and no other "
                           "explanation fits clearly">(shortNumber(missPx)),
                       say<"Capture 8 frames or more with camera and objects still.">(), jitterFaults(),
                       missPx > kMissingPx});
}

/// Whether parts of the pictures shift as is stated, whatever most of the detail does: an interface that is
/// drawn without the jitter rests beside them.
bool areSomeShifting(const JitterEvidence& evidence) {
  constexpr std::size_t kEnoughShifting = 4;
  constexpr double kSome = 0.1;
  return evidence.shiftingParts >= kEnoughShifting &&
         static_cast<double>(evidence.shiftingParts) >= kSome * static_cast<double>(evidence.parts);
}

void tellSomeShifting(const JitterEvidence& evidence, Diagnosis& out) {
  out.parts.leaveOpen(
      {say<"Jitter">(),
       say<"most of the detail rests, as without jitter, but %1 of %2 parts of the pictures shift as is "
           "stated: an interface without jitter may lie over what has it">(evidence.shiftingParts,
                                                                           evidence.parts),
       say<"Capture without the interface, or let the camera turn by some pixels a frame.">(),
       {Fault::JitterNotApplied, Fault::InterfaceBefore},
       true});
}

/// Pictures fit no better, and yet shifts that are measured are nearer to jitter of another length; or they
/// are measured so coarsely that a somewhat other length would look the same.
void tellLength(const JitterFit& fit, const std::vector<JitterTrial>& trials, Diagnosis& out) {
  constexpr double kFitsAsWellShare = 1.02, kNearerLengthShare = 0.8, kCoarsePx = 0.1;
  const double missPx = fit.missPx.front();
  const auto leaveOpen = [&](const std::string& reason, const std::vector<Fault>& faults, bool isMisfit) {
    out.parts.leaveOpen({say<"Jitter's length">(), reason, say<"Capture a still scene with fine detail.">(),
                         faults, isMisfit});
  };
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (trials[t].kind != JitterKind::Scaled || fit.trials[t].share() > kFitsAsWellShare ||
        fit.missPx[t] > kNearerLengthShare * missPx)
      continue;
    const Fault fault = trials[t].factor.x < 1.0f ? Fault::JitterDoubled : Fault::JitterHalved;
    leaveOpen(say<"measured shifts are %1 px from those that are stated, and %2 px from those of "
                  "jitter like this: %3; but pictures fit it no better">(
                  shortNumber(missPx), shortNumber(fit.missPx[t]), jitterTrialText(trials[t])),
              {fault}, true);
    return;
  }
  if (missPx > kCoarsePx)
    leaveOpen(say<"measured shifts are %1 px from those that are stated: jitter that is a little longer or "
                  "shorter would look the same">(shortNumber(missPx)),
              {Fault::JitterDoubled, Fault::JitterHalved}, false);
}

} // namespace

Finding jitterFinding(const JitterTrial& trial) {
  Finding out = wordedFinding(jitterWords(trial));
  if (trial.kind == JitterKind::OtherUnit) {
    out.id = kOtherUnitId;
    out.name = say<"Jitter of another unit">();
  }
  if (trial.kind != JitterKind::Scaled) return out;
  if (trial.factor.x != trial.factor.y) out.id = kOfAxisId;
  // Names of the table say twice and half; factors between are told by their number.
  if (trial.factor != glm::vec2(0.5f) && trial.factor != glm::vec2(2.0f))
    out.name = factorsName(trial.factor);
  return out;
}

bool areSurfacesJittered(const JitterEvidence& evidence) {
  constexpr int kEnoughDepthPairs = 4;
  constexpr double kFewPairs = 0.2, kClearlyMore = 1.15;
  const TrialFit without = fitOf(evidence.world, kNotAppliedTrial, 0);
  return without.pairs >= kEnoughDepthPairs && without.won <= kFewPairs * without.pairs &&
         without.stated > 0.0 && without.tried >= kClearlyMore * without.stated;
}

Image asDepthPicture(const DoctorFrame& frame) {
  std::vector<double> drawn;
  for (const float depth : frame.depth.pixels)
    if (depth > 0.0f && depth < 1.0f) drawn.push_back(static_cast<double>(depth));
  const auto middle = static_cast<float>(drawn.empty() ? 1.0 : median(std::move(drawn)));
  Image out(frame.depth.width, frame.depth.height, 1);
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    const float depth = frame.depth.pixels[i];
    out.pixels[i] = depth > 0.0f ? depth / (depth + middle) : 0.0f;
  }
  return out;
}

JitterOutcome tellJitter(const JitterEvidence& evidence, const JitterCaptureInfo& captureInfo,
                         Diagnosis& out) {
  if (evidence.stated.empty()) return {};
  if (evidence.shifts.size() < kEnoughShifts) {
    const glm::vec2 first = evidence.stated.begin()->second;
    if (isConstant(evidence) && !isNone(first))
      out.findings.push_back(frozenStatement(first, captureInfo.captureInfo));
    out.parts.leaveOpen({say<"Jitter">(),
                         say<"only %1 of %2 pairs of frames have detail enough to measure a shift">(
                             evidence.shifts.size(), evidence.pairs),
                         say<"Capture 8 frames or more of a still, detailed scene.">(), jitterFaults()});
    return {};
  }
  if (isConstant(evidence))
    return {tellUnstated(evidence, captureInfo.isCameraKnown, captureInfo.captureInfo, out)};
  if (const auto pauses = jitterPauses(evidence)) return {tellPauses(*pauses, evidence, out)};
  std::vector<JitterTrial> trials = jitterTrials(captureInfo.captureInfo.sizePx);
  JitterFit fit = jitterFit(evidence, trials);
  const double missPx = fit.missPx.front();
  const bool isContradicted = fit.isContradicted();
  const std::optional<std::size_t> atRest = trialAtRest(evidence, trials);
  const auto factors = measureFactors(evidence);
  const bool isOfFactors = !isContradicted && factors && explainShifts(*factors, evidence);
  const bool isConfirmed = fit.isConfirmed() || fit.isMeasured() || (atRest == 0u && !isContradicted);
  if (isConfirmed && !isOfFactors && missPx <= kMissingPx) {
    out.parts.addRight(say<"Jitter">(),
                       say<"Jitter is in the pictures as it is stated, to %1 px.">(shortNumber(missPx)));
    tellLength(fit, trials, out);
    tellTrial(trials, 0, evidence, captureInfo.sky, out);
    return {};
  }
  const auto correctorOf = [&](const JitterTrial& trial) -> JitterCorrector {
    return [trial, all = evidence.stated](int frame) { return trueJitter(trial, all, frame); };
  };
  JitterConsistency consistency = JitterConsistency::Pairs;
  if (!isContradicted && atRest && fit.missPx[*atRest] < missPx) {
    consistency = JitterConsistency::Rest;
    fit.best = *atRest;
  } else if (isOfFactors) {
    out.findings.push_back(factorsFinding(*factors, evidence, captureInfo, missPx));
    tellSequenceOf(trials.front(), evidence, out);
    return {correctorOf(factors->trial())};
  } else if (!isContradicted) {
    tellNoFit(missPx, out);
    tellShort(evidence.stated, out);
    return {{}, missPx > kMissingPx, true};
  }
  if (trials[fit.best].kind == JitterKind::NotApplied && captureInfo.areSurfacesJittered &&
      captureInfo.areSurfacesJittered()) {
    out.notes.push_back(
        say<"Surfaces are drawn with the jitter, and what is seen on them is not shifted by it: textures are "
            "read as if there were none.">());
    tellTrial(trials, 0, evidence, captureInfo.sky, out);
    return {correctorOf(trials[fit.best])}; // what pictures are compared by
  }
  if (trials[fit.best].kind == JitterKind::NotApplied && areSomeShifting(evidence)) {
    tellSomeShifting(evidence, out);
    return {{}, false, true};
  }
  if (trials[fit.best].kind == JitterKind::Scaled && factors &&
      factors->areBeyond(glm::dvec2(trials[fit.best].factor)))
    trials[fit.best] = factors->trial();
  for (Finding& finding :
       otherJitter(consistency, fit, trials, evidence, captureInfo.isCameraKnown, captureInfo.captureInfo))
    out.findings.push_back(std::move(finding));
  tellTrial(trials, fit.best, evidence, captureInfo.sky, out);
  return {correctorOf(trials[fit.best])};
}

} // namespace taa::doctor
