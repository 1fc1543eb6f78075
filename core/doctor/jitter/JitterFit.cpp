#include "core/doctor/jitter/JitterFit.h"

#include "core/base/Median.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

namespace taa::doctor {

namespace {

constexpr int kEnoughFits = 4;
// Shares of what is left: one that fits better, one that may, and of the sky that rests.
constexpr double kFittingShare = 0.85, kDoubtShare = 0.98, kRestingShare = 1.0 / 3.0;
// px from shifts that are measured, and the share of what is stated's distance: a second check.
// Where pictures alias, shifts are measured worse.
constexpr double kFittingPx = 0.15, kAliasedPx = 0.3, kNearerShare = 0.65;
// Likewise, where they are measured so well that they decide alone; others have to be so far away.
constexpr double kMeasuredPx = 0.02, kFromOthersPx = 0.1, kMeasuredFactor = 5.0;
constexpr double kNearlyAllPairs = 0.8, kMostPairs = 2.0 / 3.0; ///< of the pairs
/// Times the miss of an explanation: where all others miss by so much more, no other makes what is measured.
constexpr double kAloneFactor = 3.0;
constexpr double kAsGoodShare = 1.05;

/// How well a trial makes what is measured, both less their means.
struct AtRestFit {
  double factor = 0.0; ///< by which it is measured too long
  double left = 1.0;   ///< of the length of what is measured; 1: all of it
};

bool isWon(const TrialFit& fit, double share = kNearlyAllPairs) {
  return fit.pairs >= kEnoughFits && fit.won >= share * fit.pairs;
}

/// What a trial takes the stated jitter times, where it does no more.
std::optional<double> lengthOf(const JitterTrial& trial) {
  if (trial.isTwofold() || trial.factor.x != trial.factor.y) return {};
  if (trial.kind == JitterKind::NotApplied) return 0.0;
  if (trial.kind != JitterKind::AsStated && trial.kind != JitterKind::Scaled) return {};
  return static_cast<double>(trial.factor.x);
}

AtRestFit fitAtRest(const std::vector<glm::dvec2>& measured, const std::vector<glm::dvec2>& made) {
  glm::dvec2 measuredMean(0.0), madeMean(0.0);
  for (std::size_t i = 0; i < made.size(); ++i) {
    measuredMean += measured[i] / static_cast<double>(made.size());
    madeMean += made[i] / static_cast<double>(made.size());
  }
  double both = 0.0, ofMade = 0.0, ofMeasured = 0.0;
  for (std::size_t i = 0; i < made.size(); ++i) {
    const glm::dvec2 a = measured[i] - measuredMean, b = made[i] - madeMean;
    both += glm::dot(a, b);
    ofMade += glm::dot(b, b);
    ofMeasured += glm::dot(a, a);
  }
  if (!(ofMade > 0.0) || !(ofMeasured > 0.0)) return {};
  const double explained = both * both / (ofMade * ofMeasured);
  return {both / ofMade, std::sqrt(std::max(0.0, 1.0 - explained))};
}

} // namespace

double TrialFit::share() const {
  if (pairs < kEnoughFits || !(stated > 0.0)) return std::numeric_limits<double>::infinity();
  return tried / stated;
}

TrialFit fitOf(const std::vector<TrialLuma>& pairs, std::size_t tried, std::size_t stated) {
  TrialFit out;
  for (const TrialLuma& pair : pairs) {
    // Comparisons are written so that NaN fails them.
    if (!(pair[tried] < pair[stated]) && !(pair[tried] > pair[stated])) continue;
    ++out.pairs;
    out.won += pair[tried] < pair[stated] ? 1 : 0;
    out.stated += pair[stated];
    out.tried += pair[tried];
  }
  return out;
}

bool JitterFit::isConfirmed() const {
  for (std::size_t i = 0; i + twofold < trials.size(); ++i) {
    const bool isNearer = isWon(trials[i]) || missPx[i] <= kNearerShare * missPx.front();
    if (trials[i].share() < kDoubtShare && (!isOfLength[i] || isNearer)) return false;
  }
  return true;
}

bool JitterFit::isMeasured() const {
  const double stated = missPx.front();
  const auto end = missPx.end() - static_cast<std::ptrdiff_t>(twofold);
  return stated <= kMeasuredPx && std::all_of(missPx.begin() + 1, end, [&](double other) {
           return other >= std::max(kFromOthersPx, kMeasuredFactor * stated);
         });
}

bool JitterFit::isContradicted() const {
  const TrialFit& fit = trials[best];
  const double miss = missPx[best], statedMiss = missPx.front();
  const bool isClear = fit.share() <= kFittingShare && isWon(fit) && miss <= kAliasedPx && miss < statedMiss;
  const bool isNearer = miss <= kFittingPx && miss <= kNearerShare * statedMiss;
  return isClear || (fit.share() < kDoubtShare && isNearer);
}

bool JitterFit::isContradictedTwice() const {
  const TrialFit& fit = trials[best];
  const double miss = missPx[best];
  // In some pairs it may move the picture as what is stated does: then either fits better by chance.
  const bool isAlone =
      std::ranges::count_if(missPx, [&](double other) { return other < kAloneFactor * miss; }) == 1;
  return fit.share() <= kFittingShare && isWon(fit, isAlone ? kMostPairs : kNearlyAllPairs) &&
         miss <= kFittingPx && miss <= kNearerShare * missPx.front();
}

std::vector<std::size_t> JitterFit::rivals() const {
  std::vector<std::size_t> out;
  const std::size_t singles = trials.size() - twofold, tried = best < singles ? singles : trials.size();
  for (std::size_t i = 0; i < tried; ++i)
    if (i != best && trials[i].share() <= kAsGoodShare * trials[best].share()) out.push_back(i);
  return out;
}

JitterFit jitterFit(const JitterEvidence& evidence, const std::vector<JitterTrial>& trials) {
  JitterFit out;
  for (std::size_t trial = 0; trial < trials.size(); ++trial) {
    out.trials.push_back(fitOf(evidence.world, trial, 0));
    out.missPx.push_back(shiftResidual(trials[trial], evidence));
    out.isOfLength.push_back(trials[trial].kind == JitterKind::Scaled);
  }
  out.twofold = static_cast<std::size_t>(std::ranges::count(trials, true, &JitterTrial::isTwofold));
  const std::size_t singles = trials.size() - out.twofold;
  const auto leastOf = [&](std::size_t first, std::size_t end) {
    const auto begin = out.trials.begin() + static_cast<std::ptrdiff_t>(first);
    const auto least = std::ranges::min_element(begin, out.trials.begin() + static_cast<std::ptrdiff_t>(end),
                                                {}, &TrialFit::share);
    return static_cast<std::size_t>(least - out.trials.begin());
  };
  out.best = leastOf(0, singles);
  for (const TrialLuma& pair : evidence.world)
    out.statedLuma += pair.front() / static_cast<double>(evidence.world.size());
  if (out.isContradicted() || out.twofold == 0) return out;
  JitterFit twice = out;
  twice.best = leastOf(singles, trials.size());
  return twice.isContradictedTwice() ? twice : out;
}

std::optional<std::size_t> trialAtRest(const JitterEvidence& evidence,
                                       const std::vector<JitterTrial>& trials) {
  constexpr double kFits = 0.4, kFitsNot = 0.65, kLeastFactor = 0.6, kMostFactor = 2.5, kLeastPx = 0.1;
  const std::map<int, glm::vec2> shown = evidence.resting.displacementsPx();
  double lengths = 0.0;
  for (const auto& [frame, px] : shown) lengths += static_cast<double>(glm::dot(px, px));
  if (!(lengths > kLeastPx * kLeastPx * static_cast<double>(shown.size()))) return {};
  std::optional<std::size_t> fitting;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    const JitterKind kind = trials[t].kind;
    if (kind == JitterKind::NotApplied || kind == JitterKind::Scaled || kind == JitterKind::OtherUnit)
      continue;
    std::vector<glm::dvec2> measured, made;
    for (const auto& [frame, px] : shown)
      if (const auto jitter = trueJitter(trials[t], evidence.stated, frame)) {
        measured.emplace_back(px);
        made.emplace_back(*jitter);
      }
    const AtRestFit fit = fitAtRest(measured, made);
    // The sign of a factor is that of a trial of its own.
    const bool fits = fit.factor >= kLeastFactor && fit.factor <= kMostFactor && fit.left <= kFits;
    if (!fits && (fit.factor <= 0.0 || fit.left >= kFitsNot)) continue;
    if (!fits || fitting) return {};
    fitting = t;
  }
  return fitting;
}

std::optional<bool> isSkyResting(const JitterEvidence& evidence, std::size_t trial) {
  const TrialFit fit = fitOf(evidence.sky, kNotAppliedTrial, trial);
  if (fit.pairs < kEnoughFits) return {};
  return fit.share() <= kRestingShare && isWon(fit);
}

std::optional<double> skyFactor(const JitterEvidence& evidence, const std::vector<JitterTrial>& trials) {
  constexpr double kSame = 0.12;
  if (static_cast<int>(evidence.skyShares.size()) < kEnoughFits) return {};
  const double factor = median(evidence.skyShares);
  std::vector<double> apart;
  for (const double share : evidence.skyShares) apart.push_back(std::abs(share - factor));
  if (median(std::move(apart)) > kSame) return {};
  std::size_t nearest = 0;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    const std::optional<double> length = lengthOf(trials[t]), best = lengthOf(trials[nearest]);
    if (length && std::abs(*length - factor) < std::abs(*best - factor)) nearest = t;
  }
  const TrialFit fit = fitOf(evidence.sky, nearest, 0);
  if (nearest != 0 && (!isWon(fit) || fit.share() > kFittingShare)) return {};
  return factor;
}

} // namespace taa::doctor
