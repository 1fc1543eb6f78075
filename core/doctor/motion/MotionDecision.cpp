#include "core/doctor/motion/MotionDecision.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace taa::doctor {

namespace {

constexpr std::size_t kEnoughOfRegion = 150, kEnoughCells = 5, kEnoughPairs = 3;
constexpr double kNearlyAllPixels = 0.98;
constexpr double kDetailedShare = 0.02; ///< of a region's pixels: less is no texture
constexpr double kMovesPx = 0.25;       ///< in the mean
constexpr double kRestInWorldPx = 0.01; ///< likewise
/// Of luma, in the mean: less may be rounding and shading.
constexpr double kLeastLumaGain = 0.004;
/// A trial fits as well as the best one where it gains this share of it.
constexpr double kSameGain = 0.95;
/// Motion given is in doubt where an explanation leaves so many times less, in so many squares.
constexpr double kDoubtFactor = 1.1, kDoubtSquares = 0.6;
/// Motion given is right where another explanation leaves so much more.
constexpr double kRightFactor = 1.2;

/// How much better a trial has to be than the motion given.
struct WinningRule {
  double factor = 1.5; ///< of what it leaves
  double share = 0.8;  ///< of squares and of pairs of frames
};
constexpr WinningRule kAgainstConsistency{3.0, 0.9};
// What is searched for finds something better in noise, too; and a shadow or a light that moves is found
// where it is the only detail.
constexpr WinningRule kSearched{2.5, 0.85};
constexpr double kSearchedDetail = 0.3;
constexpr double kSearchedShare = 0.5; ///< of the pixels with detail, in which another motion is found
/// Of its silhouette, what was found leaves at most so much of what the motion given leaves outside of the
/// region.
constexpr double kSilhouetteShare = 0.75;
constexpr std::size_t kEnoughSilhouette = 24; ///< pixels outside of it

double shareIn(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

bool wins(const TrialEvidence& trial, const WinningRule& rule) {
  return trial.pixels >= kEnoughOfRegion && trial.cells >= kEnoughCells && trial.pairs >= kEnoughPairs &&
         trial.given >= rule.factor * trial.tried &&
         trial.gain() >= kLeastLumaGain * static_cast<double>(trial.pixels) &&
         shareIn(trial.cellsWon, trial.cells) >= rule.share &&
         shareIn(trial.pairsWon, trial.pairs) >= rule.share;
}

/// Where depth and cameras make the motion given, what would change it by a rule makes no sense: there, what
/// lies over the surface may rest on the screen.
bool isPossible(const MotionTrial& trial, bool isMotionConfirmed) {
  return !isMotionConfirmed || trial.kind == MotionKind::Resting;
}

std::vector<std::size_t> winners(const RegionEvidence& evidence, const std::vector<MotionTrial>& trials) {
  const bool isChecked = isConfirmed(evidence);
  const WinningRule rule = isChecked ? kAgainstConsistency : WinningRule{};
  std::vector<std::size_t> winning, best;
  double most = 0.0;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (!isPossible(trials[t], isChecked)) continue;
    // What gains more and is not clear makes what gains less no explanation.
    if (evidence.trials[t].pixels >= kEnoughOfRegion) most = std::max(most, evidence.trials[t].gain());
    if (wins(evidence.trials[t], rule)) winning.push_back(t);
  }
  std::ranges::copy_if(winning, std::back_inserter(best),
                       [&](std::size_t t) { return evidence.trials[t].gain() >= kSameGain * most; });
  return best;
}

/// Whether a search finds the region elsewhere, as a whole and with its silhouette: what moves over it is
/// found in a part, or without.
bool isFoundElsewhere(const RegionEvidence& evidence) {
  return shareIn(evidence.textured, evidence.pixels) >= kSearchedDetail &&
         shareIn(evidence.found.pixels, evidence.textured) >= kSearchedShare &&
         evidence.silhouetteGiven >= kEnoughSilhouette &&
         static_cast<double>(evidence.silhouetteFound) <=
             kSilhouetteShare * static_cast<double>(evidence.silhouetteGiven) &&
         wins(evidence.found, kSearched);
}

/// Whether some explanation leads elsewhere, and leaves more.
bool isBetterThanAnother(const RegionEvidence& evidence) {
  return std::ranges::any_of(evidence.trials, [](const TrialEvidence& trial) {
    return trial.pixels >= kEnoughOfRegion && trial.tried >= kRightFactor * trial.given;
  });
}

/// Whether some explanation leads elsewhere, and leaves less.
bool isWorseThanAnother(const RegionEvidence& evidence) {
  return std::ranges::any_of(evidence.trials, [](const TrialEvidence& trial) {
    return trial.pixels >= kEnoughOfRegion && trial.given >= kDoubtFactor * trial.tried &&
           shareIn(trial.cellsWon, trial.cells) >= kDoubtSquares;
  });
}

} // namespace

bool isUnwritten(const RegionEvidence& evidence) {
  return shareIn(evidence.zero, evidence.pixels) >= kNearlyAllPixels;
}

bool isConfirmed(const RegionEvidence& evidence) {
  const auto pixels = static_cast<double>(evidence.pixels);
  return shareIn(evidence.ofCamera, evidence.pixels) >= kNearlyAllPixels &&
         evidence.cameraPx >= kMovesPx * pixels;
}

bool isAtRestInWorld(const RegionEvidence& evidence) {
  return shareIn(evidence.cameraKnown, evidence.pixels) >= kNearlyAllPixels &&
         evidence.cameraPx <= kRestInWorldPx * static_cast<double>(evidence.pixels);
}

std::optional<Fault> wrongCamera(const RegionEvidence& evidence) {
  constexpr double kEven = 0.35, kLessEven = 2.0;
  const double turned = evidence.offCamera.spread(), beside = evidence.offCameraByDistance.spread();
  if (turned <= kEven && beside >= kLessEven * turned) return Fault::CameraTurned;
  if (beside <= kEven && turned >= kLessEven * beside) return Fault::CameraOfSecondView;
  return {};
}

MotionDecision decideByPixels(const RegionEvidence& evidence, const std::vector<MotionTrial>& trials) {
  if (evidence.pixels < kEnoughOfRegion || evidence.pairs < kEnoughPairs)
    return {MotionVerdict::TooSmall, {}};
  if (std::vector<std::size_t> best = winners(evidence, trials); !best.empty())
    return {MotionVerdict::Wrong, std::move(best)};
  if (isFoundElsewhere(evidence)) return {MotionVerdict::Wrong, {}};
  if (evidence.textured < kEnoughOfRegion || shareIn(evidence.textured, evidence.pixels) < kDetailedShare)
    return {MotionVerdict::NoTexture, {}};
  if (!isConfirmed(evidence) && isWorseThanAnother(evidence)) return {MotionVerdict::Doubtful, {}};
  if (isBetterThanAnother(evidence)) return {MotionVerdict::Right, {}};
  const bool differs = std::ranges::any_of(
      evidence.trials, [](const TrialEvidence& trial) { return trial.pixels >= kEnoughOfRegion; });
  return {differs ? MotionVerdict::Contradicted : MotionVerdict::Still, {}};
}

MotionDecision decideMotion(const RegionEvidence& evidence, const std::vector<MotionTrial>& trials) {
  MotionDecision byPixels = decideByPixels(evidence, trials);
  const bool isTold = byPixels.verdict == MotionVerdict::Right || byPixels.verdict == MotionVerdict::Wrong;
  if (isTold || byPixels.verdict == MotionVerdict::TooSmall) return byPixels;
  std::vector<std::size_t> best = outlineWinners(evidence.outline);
  std::erase_if(best, [&](std::size_t t) { return !isPossible(trials[t], isConfirmed(evidence)); });
  if (!best.empty()) return {MotionVerdict::Wrong, std::move(best), DecidedBy::Outline};
  if (isOutlineFoundElsewhere(evidence.outline)) return {MotionVerdict::Wrong, {}, DecidedBy::Outline};
  return byPixels;
}

} // namespace taa::doctor
