#include "core/doctor/flow/FlowFindings.h"

#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/doctor/Correction.h"
#include "core/doctor/flow/FlowChange.h"
#include "core/doctor/flow/FlowWords.h"
#include "core/doctor/motion/MotionFindings.h"
#include "core/doctor/motion/MotionWords.h"
#include "core/settings/Faults.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

namespace taa::doctor {

namespace {

double medianOff(const std::vector<const FlowSquare*>& squares) {
  std::vector<double> off;
  for (const FlowSquare* square : squares) off.push_back(square->offPx());
  return median(std::move(off));
}

double medianError(const std::vector<const FlowSquare*>& squares) {
  std::vector<double> errors;
  for (const FlowSquare* square : squares) errors.push_back(square->errorPx);
  return median(std::move(errors));
}

double medianLeft(const std::vector<const FlowSquare*>& squares, double FlowSquare::*left) {
  std::vector<double> all;
  for (const FlowSquare* square : squares)
    if (std::isfinite(square->*left)) all.push_back(1000.0 * square->*left);
  return median(std::move(all));
}

std::vector<Residual> residualsOf(const std::vector<const FlowSquare*>& squares) {
  return {{"measured", say<"as the pictures move">(), medianLeft(squares, &FlowSquare::left), false, true},
          {"asGiven", say<"as given">(), medianLeft(squares, &FlowSquare::leftAsGiven), true, false}};
}

/// Whether motion is right elsewhere: the pass that writes it does so for what moves by itself.
bool isRightElsewhere(const FlowSeen& seen, const std::vector<Refuted>& refuted) {
  constexpr std::size_t kEnough = 8;
  std::size_t right = 0;
  for (const FlowPair& pair : seen.pairs)
    for (const FlowSquare& square : pair.squares) {
      const Region* region = &seen.regions[static_cast<std::size_t>(square.region)];
      if (std::ranges::count(refuted, region, &Refuted::region) > 0) continue;
      if (glm::length(square.given) > kOffPx && square.offPx() <= kOffPx) ++right;
    }
  return right >= kEnough;
}

/// How many times as far as is given pictures go where they do so in one frame alone: pictures between are
/// missing.
std::optional<FlowFit> fitOfMissing(const std::vector<Refuted>& refuted) {
  constexpr std::size_t kEnoughAsked = 5;
  constexpr double kLeast = 1.6, kMost = 3.4, kRoughlyPx = 1.5; // motion changes from frame to frame
  const auto [frames, asked] = framesOf(refuted);
  if (frames.size() != 1 || asked.size() < kEnoughAsked) return {};
  const auto fit = fitFactor(squaresOf(refuted), kRoughlyPx);
  const bool isFarther = fit && fit->factors[0][0] >= kLeast && fit->factors[0][0] <= kMost;
  return isFarther && fit->isGood() ? fit : std::nullopt;
}

} // namespace

bool isOfMotion(const Finding& finding) {
  return partOf(finding) == FaultPart::Motion;
}

bool areAllZero(const std::vector<const FlowSquare*>& squares) {
  constexpr double kNearlyAll = 0.98;
  const auto zero = std::ranges::count_if(
      squares, [](const FlowSquare* square) { return square->given == glm::dvec2(0.0); });
  return static_cast<double>(zero) >= kNearlyAll * static_cast<double>(squares.size());
}

std::string exampleOf(const std::vector<const FlowSquare*>& squares, const FlowSeen& seen,
                      const CaptureInfo& captureInfo) {
  const FlowSquare* farthest = *std::ranges::max_element(
      squares, {}, [](const FlowSquare* square) { return square->offPx() / (1.0 + 10.0 * square->errorPx); });
  return say<"For example around pixel %1, %2 of frame %3 you write %4; the pictures show %5.">(
      farthest->pixel.x, farthest->pixel.y, captureInfo.frameNames.of(frameOf(*farthest, seen)),
      shortVector(storedMotion(captureInfo, farthest->given)),
      shortVector(storedMotion(captureInfo, farthest->px)));
}

Finding measuredFinding(const std::vector<Refuted>& refuted, const FlowSeen& seen,
                        const CaptureInfo& captureInfo, const Diagnosis& out) {
  const std::vector<const FlowSquare*> squares = squaresOf(refuted);
  Finding finding;
  for (const Refuted& one : refuted)
    if (one.region) finding.regions.push_back(placeOf(*one.region, captureInfo, allPixels(captureInfo, out)));
  std::ranges::stable_sort(finding.regions, std::greater(), &RegionPlace::share);
  finding.measure = say<"median difference of luma in squares that can be followed, × 1000">();
  finding.residuals = residualsOf(squares);
  const auto [frames, asked] = framesOf(refuted);
  finding.reason =
      say<"In %1 the pictures move otherwise there than is given, by %2 px in the middle of %3 squares "
          "that can be followed to %4 px.">(captureInfo.frameNames.of(frames, asked),
                                            shortNumber(medianOff(squares)), squares.size(),
                                            shortNumber(medianError(squares)));
  finding.change = exampleOf(squares, seen, captureInfo);
  return finding;
}

void nameBest(const std::optional<FlowFit>& fit, const std::vector<Refuted>& refuted, const FlowSeen& seen,
              const CaptureInfo& captureInfo, double tolerancePx, Finding& finding) {
  if (const auto missing = fitOfMissing(refuted)) {
    nameMissing(captureInfo.frameNames.of(framesOf(refuted).first.front()), *missing, finding);
    return;
  }
  if (fit) {
    nameByFit(*fit, captureInfo, finding);
    return;
  }
  const PictureChanges changes = changesOf(refuted, seen, captureInfo.sizePx, tolerancePx);
  if (!areZooms(changes, captureInfo.sizePx)) {
    nameUnknown(finding);
    if (const std::string text = changeText(changes, captureInfo.frameNames); !text.empty())
      finding.reason += " " + text;
    return;
  }
  const MotionTrial unzoomed{MotionKind::CameraUnzoomed};
  nameMeasured(motionFault(&unzoomed, Region(), RegionEvidence()), finding);
  finding.reason += " " + zoomText(changes);
}

Finding bestFinding(const std::vector<Refuted>& refuted, const FlowSeen& seen, const CaptureInfo& captureInfo,
                    double tolerancePx, const Diagnosis& out) {
  const std::vector<const FlowSquare*> squares = squaresOf(refuted);
  Finding finding = measuredFinding(refuted, seen, captureInfo, out);
  finding.confidence = Confidence::Likely;
  if (areAllZero(squares)) {
    const bool isOfCamera = isRightElsewhere(seen, refuted);
    const FaultInfo& row = faultInfo(isOfCamera ? Fault::MotionWithoutCamera : Fault::MotionZero);
    nameMeasured({std::string(row.id), std::string(row.label), std::string(row.symptom),
                  isOfCamera ? say<"Write the motion of what rests in the world, too: that of the camera.">()
                             : say<"Write motion for it: draw it in the pass that writes motion, with the "
                                   "transforms of this frame and of the one before.">()},
                 finding);
    finding.reason +=
        " " + (isOfCamera ? say<"What is given there is 0, and where something moves by itself it is "
                                "right: the camera's motion is missing.">()
                          : say<"What is given there is 0.">());
    return finding;
  }
  // A line that all frames follow says more than one of those in which it shows.
  std::vector<const FlowSquare*> ofAll;
  for (const Refuted& one : refuted) ofAll.insert(ofAll.end(), one.ofAll.begin(), one.ofAll.end());
  auto fit = explaining(ofAll, tolerancePx);
  if (fit && followedShare(*fit, squares, tolerancePx) < kMostSquares)
    fit.reset(); // what is right everywhere else
  if (!fit) fit = explaining(squares, tolerancePx);
  nameBest(fit, refuted, seen, captureInfo, tolerancePx, finding);
  return finding;
}

} // namespace taa::doctor
