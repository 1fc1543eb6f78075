#include "core/doctor/flow/FlowWords.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/decode/Motion.h"
#include "core/capture/import/FrameSamples.h"
#include "core/doctor/Correction.h"
#include "core/doctor/motion/MotionCorrection.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

std::string withError(double value, double error) {
  return say<"%1 ± %2">(shortNumber(value), shortNumber(error));
}

/// What was fitted, in a sentence.
std::string fitText(const FlowFit& fit, const glm::ivec2& sizePx) {
  const glm::dmat2& f = fit.factors;
  const glm::dmat2& e = fit.factorErrors;
  std::string text;
  if (isAlongAxes(fit)) {
    text = say<"x of the motion in pictures is %1 times what is given, y %2 times">(
        withError(f[0][0], e[0][0]), withError(f[1][1], e[1][1]));
  } else {
    text = say<"motion in pictures is (%1 x + %2 y, %3 x + %4 y) of what is given">(
        shortNumber(f[0][0]), shortNumber(f[1][0]), shortNumber(f[0][1]), shortNumber(f[1][1]));
    if (const auto degrees = turnedBy(fit))
      text += say<", which turns it by %1° clockwise and keeps its length">(shortNumber(*degrees));
  }
  if (hasOffset(fit))
    text += say<", and (%1, %2) px more, which is (%3, %4) of the picture">(
        withError(fit.offsetPx.x, fit.offsetErrorsPx.x), withError(fit.offsetPx.y, fit.offsetErrorsPx.y),
        shortNumber(fit.offsetPx.x / sizePx.x), shortNumber(fit.offsetPx.y / sizePx.y));
  return text;
}

FaultWords fitWords(const FlowFit& fit) {
  if (hasOffset(fit))
    return {
        "motionOffset", say<"Motion with an offset">(), say<"Everything smears, at rest too.">(),
        say<"What is stored is encoded otherwise than is stated: state that offset and that factor, or decode "
            "motion before it is used.">()};
  if (!isAlongAxes(fit)) return turnedWords(say<"Make motion along the axes of the picture.">());
  return lengthWords(say<"Multiply the motion that you write by %1.">(
      shortVector(glm::dvec2(fit.factors[0][0], fit.factors[1][1]))));
}

/// Of a length that was fitted, or of axes besides.
FaultWords lengthFault(const MotionTrial& trial) {
  if (trial.kind != MotionKind::Scaled) return motionFault(&trial, Region(), RegionEvidence());
  return lengthWords(say<"Multiply the motion that you write by %1, or state the unit that it has.">(
      shortVector(glm::dvec2(trial.factor))));
}

/// Sentences: what was fitted, and what unit of a picture of that size it is.
std::string lengthReason(const FittedLength& length, const MotionTrial& trial, const glm::ivec2& sizePx) {
  const auto along = [&](int axis) {
    const std::string name = axis == 0 ? "x" : "y";
    if (!length.factor[axis]) return say<"along %1 too little moves to tell">(name);
    return say<"%1 ± %2 along %3">(measuredNumber(*length.factor[axis], length.error[axis]),
                                   errorNumber(length.error[axis]), name);
  };
  std::string text =
      say<"All motion is shorter than a pixel, and the pictures move by %1 px in the mean. By least squares "
          "over %2 squares of %3 pairs of frames they move by so many times the motion given (and its "
          "standard error): %4, %5.">(shortNumber(length.movesPx), length.squares, length.pairs, along(0),
                                      along(1));
  if (trial.kind != MotionKind::OtherUnit)
    return text + " " + say<"No unit of a picture of %1 × %2 px lies within that.">(sizePx.x, sizePx.y);
  const glm::dvec2 unit = glm::abs(glm::dvec2(trial.factor));
  return text + " " +
         (trial.isDevice
              ? say<"Half the size of the picture lies within that, %1 and %2: device coordinates.">(
                    shortNumber(unit.x), shortNumber(unit.y))
              : say<"The size of the picture lies within that, %1 and %2: texture coordinates.">(
                    shortNumber(unit.x), shortNumber(unit.y)));
}

} // namespace

void nameMeasured(const FaultWords& fault, Finding& finding) {
  const std::string example = std::move(finding.change);
  nameBy(fault, finding);
  finding.change += " " + example;
}

void nameByFit(const FlowFit& fit, const CaptureInfo& captureInfo, Finding& finding) {
  const auto trial = knownTrial(fit, captureInfo.sizePx);
  nameMeasured(trial ? motionFault(&*trial, Region(), RegionEvidence()) : fitWords(fit), finding);
  finding.reason += " " + say<"By least squares %1: that explains %2 of %3 squares.">(
                              fitText(fit, captureInfo.sizePx), fit.followed, fit.squares);
  if (trial)
    correctBy(motionCorrection(*trial), finding);
  else if (isAlongAxes(fit) && !hasOffset(fit))
    correctBy(motionCorrection({MotionKind::Scaled, glm::vec2(fit.factors[0][0], fit.factors[1][1])}),
              finding);
}

void nameWithoutRoot(const FlowFit& fit, Finding& finding) {
  constexpr double kWithinErrors = 3.0;
  const double factor = fit.factors[0][0], error = fit.factorErrors[0][0];
  const bool isAsEncoded =
      std::abs(factor - 1.0) <= kWithinErrors * std::hypot(error, capture::kReadingError);
  nameMeasured(
      {"motionWithoutRoot", say<"Motion that is linear decoded as a root">(),
       say<"Small motion is lost, and fast things have far too little.">(),
       say<"State that motion is stored with an offset, %1, times %2 in device coordinates: the root that Unreal's "
           "encoding takes is not in what is stored. Or take it before you store.">(
           shortestText(static_cast<float>(capture::kUnrealRest)),
           isAsEncoded ? significantText(1.0 / capture::kUnrealSlope, 5)
                       : withError(factor / capture::kUnrealSlope, error / capture::kUnrealSlope))},
      finding);
  finding.reason +=
      " " + say<"By least squares the pictures move by %1 times what is read if its root is not undone: "
                "that explains %2 of %3 squares.">(withError(factor, error), fit.followed, fit.squares);
}

void nameMissing(const std::string& frame, const FlowFit& fit, Finding& finding) {
  nameMeasured(
      {std::string(kFrameMissingId), say<"A frame missing before frame %1">(frame),
       say<"Things jump, and history is looked for where they would have been.">(),
       say<"Write all frames one after the other, or start history anew in that one: \"cut\": true in the manifest.">()},
      finding);
  finding.reason +=
      " " + say<"There alone the pictures go %1 times as far as is given.">(shortNumber(fit.factors[0][0]));
}

void nameUnknown(Finding& finding) {
  nameMeasured(unknownMotion(), finding);
  finding.reason +=
      " " + say<"None of the mistakes that are known here makes what is given of what pictures show.">();
}

std::vector<Finding> lengthFindings(const FittedLength& length, const MotionTrial& trial,
                                    const CaptureInfo& captureInfo) {
  const auto axes = axesBesideUnit(trial, captureInfo);
  std::vector<MotionTrial> told{axes ? unitAlone(trial, *axes) : trial};
  if (axes) told.push_back(*axes);
  std::vector<Finding> out;
  for (const MotionTrial& one : told) {
    Finding finding;
    nameBy(lengthFault(one), finding);
    finding.confidence = trial.kind == MotionKind::OtherUnit ? Confidence::Sure : Confidence::Likely;
    finding.isWholePicture = true;
    finding.reason = lengthReason(length, trial, captureInfo.sizePx);
    finding.measure = say<"mean difference of luma, × 1000">();
    finding.residuals = {{trialId(trial), trialText(trial), 1000.0 * length.fitted, false, true},
                         {"asGiven", say<"as given">(), 1000.0 * length.given, true, false}};
    correctEverywhereBy(motionCorrection(one), finding);
    out.push_back(std::move(finding));
  }
  return out;
}

} // namespace taa::doctor
