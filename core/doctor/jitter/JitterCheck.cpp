#include "core/doctor/jitter/JitterCheck.h"

#include "core/base/Say.h"
#include "core/capture/decode/ScreenUnits.h"
#include "core/doctor/NumberText.h"
#include "core/doctor/jitter/JitterSequence.h"
#include "core/settings/Faults.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

constexpr std::size_t kEnoughShifts = 4;
// px, in the middle of all pairs: shifts that fit, that do not, and that are there at all.
constexpr double kFittingPx = 0.12, kMissingPx = 0.2, kShiftingPx = 0.15;
/// Where pictures alias, shifts are measured worse: what is stated fits to so much where all else misses
/// by so many times as much.
constexpr double kAliasedPx = 0.3, kAllElse = 1.5;
constexpr double kNoJitterPx = 1e-3;
constexpr double kClearlyBetter = 2.5; ///< what is stated misses by so many times as much as what fits
/// As good as the best: px more.
constexpr double kAsGoodPx = 0.05;

struct TriedJitter {
  JitterTrial trial;
  double residual = 0.0; ///< px
};

std::vector<TriedJitter> triedJitters(const JitterEvidence& evidence, const glm::ivec2& sizePx) {
  std::vector<TriedJitter> out;
  for (const JitterTrial& trial : jitterTrials(sizePx))
    out.push_back({trial, shiftResidual(trial, evidence)});
  return out;
}

struct JitterWords {
  Fault fault;
  std::string change;
};

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
    return {trial.factor.x < 1.0f ? Fault::JitterDoubled : Fault::JitterHalved,
            say<"Multiply the jitter that you pass by %1, or state the unit that it has.">(
                shortVector(glm::dvec2(trial.factor)))};
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
glm::dvec2 passedJitter(const Patient& patient, const glm::vec2& jitterPx) {
  if (!patient.conventions) return glm::dvec2(jitterPx);
  const capture::JitterConventions& jitter = patient.conventions->jitter;
  const glm::dvec2 perValue = capture::pxPerUnit(jitter.unit, jitter.yAxis, patient.sizePx);
  return (jitter.meaning == capture::JitterMeaning::Sample ? -1.0 : 1.0) * glm::dvec2(jitterPx) / perValue;
}

/// The frame whose stated jitter is farthest from what pictures show, in a sentence.
std::string exampleOf(const JitterTrial& trial, const JitterEvidence& evidence, const Patient& patient) {
  float farthest = -1.0f;
  std::string text;
  for (const auto& [frame, stated] : evidence.stated) {
    const auto shown = trueJitter(trial, evidence.stated, frame);
    if (!shown || glm::distance(*shown, stated) <= farthest) continue;
    farthest = glm::distance(*shown, stated);
    text = say<"For example at frame %1 you pass %2; the pictures show %3.">(
        frame, shortVector(passedJitter(patient, stated)), shortVector(passedJitter(patient, *shown)));
  }
  return text;
}

/// Of shifts that are measured, px, in the middle of all pairs.
double measuredPx(const JitterEvidence& evidence) {
  return shiftResidual({JitterKind::NotApplied}, evidence);
}

bool isConstant(const JitterEvidence& evidence) {
  return std::ranges::all_of(evidence.stated, [&](const auto& frame) {
    return glm::distance(frame.second, evidence.stated.begin()->second) < 1e-4f;
  });
}

std::vector<Residual> jitterResiduals(const std::vector<TriedJitter>& tried, const TriedJitter& best) {
  std::vector<Residual> out;
  for (const TriedJitter& one : tried)
    if (std::isfinite(one.residual))
      out.push_back({jitterTrialId(one.trial), jitterTrialText(one.trial), one.residual,
                     one.trial.kind == JitterKind::AsStated, &one == &best});
  std::ranges::stable_sort(out, {}, &Residual::value);
  return out;
}

Finding jitterFinding(const JitterWords& words) {
  Finding out = faultFinding(words.fault);
  out.change = words.change;
  out.isWholePicture = true;
  out.measure = say<"distance of measured shifts from those that jitter makes, px">();
  return out;
}

/// Pictures shift as something else than what is stated makes them.
Finding otherJitter(const std::vector<TriedJitter>& tried, const TriedJitter& best,
                    const JitterEvidence& evidence, bool isCameraKnown, const Patient& patient) {
  Finding out = jitterFinding(jitterWords(best.trial));
  out.change += " " + exampleOf(best.trial, evidence, patient);
  out.reason = say<"In %1 pairs of frames the shift of the pictures is that of jitter like this, to %2 px: "
                   "%3. From what is stated it is %4 px away.">(
      evidence.shifts.size(), shortNumber(best.residual), jitterTrialText(best.trial),
      shortNumber(tried.front().residual));
  out.residuals = jitterResiduals(tried, best);
  std::string rivals;
  for (const TriedJitter& other : tried)
    if (&other != &best && other.residual <= best.residual + kAsGoodPx)
      rivals += (rivals.empty() ? "" : "; ") + jitterTrialText(other.trial);
  if (!rivals.empty()) out.reason += " " + say<"These frames do not tell it from: %1.">(rivals);
  if (!isCameraKnown)
    out.reason += " " + say<"Without depth and matrices it may also be motion that holds jitter.">();
  out.sureness = rivals.empty() && isCameraKnown ? Sureness::Sure : Sureness::Likely;
  return out;
}

/// Always the same jitter is stated, and pictures do not shift.
Finding frozenJitter(const glm::vec2& statedPx, const Patient& patient) {
  Finding out = jitterFinding(
      {Fault::JitterFrozen,
       say<"Go on in the sequence with each frame that is drawn: its index is always the same.">()});
  out.reason = say<"All frames state the same jitter, %1, and pictures do not shift against each other.">(
      shortVector(passedJitter(patient, statedPx)));
  out.measure.clear();
  return out;
}

/// What pictures hold by their shifts alone, but for a constant that no difference shows: from the first
/// frame of each run of measured pairs on.
JitterMender measuredJitter(const JitterEvidence& evidence) {
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
JitterMender tellUnstated(const JitterEvidence& evidence, bool isCameraKnown, const Patient& patient,
                          Diagnosis& out) {
  const double shiftPx = measuredPx(evidence);
  const glm::vec2 stated = evidence.stated.begin()->second;
  const double statedPx = glm::length(glm::dvec2(stated));
  if (shiftPx < kShiftingPx && statedPx > kNoJitterPx) {
    out.findings.push_back(frozenJitter(stated, patient));
    return {};
  }
  if (shiftPx < kShiftingPx) {
    out.notes.push_back(say<"No jitter is stated, and the pictures show none.">());
    return {};
  }
  if (!isCameraKnown) {
    out.undecided.push_back(
        {say<"Jitter">(),
         say<"none is stated, and pictures shift by %1 px besides their motion">(shortNumber(shiftPx)),
         say<"Capture depth and matrices, too.">()});
    return {};
  }
  Finding finding = jitterFinding(jitterWords({}));
  finding.reason = say<"No jitter is stated, or always the same, and pictures shift by %1 px besides the "
                       "camera's motion.">(shortNumber(shiftPx));
  finding.residuals = {{"asStated", say<"as stated">(), shiftPx, true, false}};
  out.findings.push_back(std::move(finding));
  return measuredJitter(evidence);
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

/// Whether what is stated fits, as well as pictures that alias let it.
bool fitsAsStated(const std::vector<TriedJitter>& tried) {
  const TriedJitter& stated = tried.front();
  if (stated.residual <= kFittingPx) return true;
  return stated.residual <= kAliasedPx && std::ranges::all_of(tried, [&](const TriedJitter& other) {
           return &other == &stated || other.residual >= kAllElse * stated.residual;
         });
}

} // namespace

JitterOutcome tellJitter(const JitterEvidence& evidence, bool isCameraKnown, const Patient& patient,
                         Diagnosis& out) {
  if (evidence.stated.empty()) return {};
  if (evidence.shifts.size() < kEnoughShifts) {
    out.undecided.push_back({say<"Jitter">(),
                             say<"only %1 of %2 pairs of frames have detail enough to measure a shift">(
                                 evidence.shifts.size(), evidence.pairs),
                             say<"Capture 8 frames or more of a still, detailed scene.">()});
    return {};
  }
  if (isConstant(evidence)) {
    return {tellUnstated(evidence, isCameraKnown, patient, out)};
  }
  const std::vector<TriedJitter> tried = triedJitters(evidence, patient.sizePx);
  const TriedJitter& stated = tried.front();
  const TriedJitter& best = *std::ranges::min_element(tried, {}, &TriedJitter::residual);
  if (fitsAsStated(tried)) {
    out.healthy.push_back(
        say<"Jitter is in the pictures as it is stated, to %1 px.">(shortNumber(stated.residual)));
    tellSequenceOf(stated.trial, evidence, out);
    return {};
  }
  if (best.residual > kFittingPx || stated.residual < kMissingPx ||
      stated.residual < kClearlyBetter * best.residual) {
    out.undecided.push_back({say<"Jitter">(),
                             say<"measured shifts are %1 px from those that are stated, and no other "
                                 "explanation fits">(shortNumber(stated.residual)),
                             say<"Capture 8 frames or more with camera and objects still.">()});
    return {{}, stated.residual >= kMissingPx};
  }
  out.findings.push_back(otherJitter(tried, best, evidence, isCameraKnown, patient));
  tellSequenceOf(best.trial, evidence, out);
  return {[trial = best.trial, all = evidence.stated](int frame) { return trueJitter(trial, all, frame); }};
}

} // namespace taa::doctor
