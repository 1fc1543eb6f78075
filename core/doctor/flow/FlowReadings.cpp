#include "core/doctor/flow/FlowReadings.h"

#include "core/base/Median.h"
#include "core/doctor/flow/FlowFit.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace taa::doctor {

namespace {

/// px: squares are measured no better, and where everything is wrong nothing says what is healthy.
constexpr double kLeastHealthyPx = 0.02, kMostHealthyPx = 0.1;

std::optional<double> distanceUnder(const FlowSquare& square, std::size_t trial) {
  if (trial >= square.byTrial.size() || !isMotion(square.byTrial[trial])) return {};
  return glm::distance(square.px, glm::dvec2(square.byTrial[trial]));
}

bool isNearUnder(const FlowSquare& square, std::size_t trial) {
  constexpr double kNearPx = 0.35, kShareOfMotion = 0.15;
  const auto distance = distanceUnder(square, trial);
  return distance && *distance <= std::max({kNearPx, kShareOfMotion * glm::length(square.px),
                                            kChanceErrors * square.errorPx});
}

/// Whether it leads clearly elsewhere than the motion given.
bool isApartUnder(const FlowSquare& square, std::size_t trial) {
  constexpr double kApartPx = 1.0;
  return trial < square.byTrial.size() && isMotion(square.byTrial[trial]) &&
         glm::distance(square.given, glm::dvec2(square.byTrial[trial])) >= kApartPx;
}

} // namespace

double leftPx(const std::vector<const FlowSquare*>& squares, std::size_t trial) {
  std::vector<double> left;
  for (const FlowSquare* square : squares)
    if (const auto distance = distanceUnder(*square, trial)) left.push_back(*distance);
  return 2 * left.size() <= squares.size() ? std::numeric_limits<double>::infinity()
                                           : median(std::move(left));
}

double healthyPx(const FlowSeen& seen) {
  std::vector<double> off;
  for (const FlowPair& pair : seen.pairs)
    for (const FlowSquare& square : pair.squares) off.push_back(square.offPx());
  if (off.empty()) return kMostHealthyPx;
  const auto quarter = off.begin() + std::ssize(off) / 4;
  std::ranges::nth_element(off, quarter);
  return std::clamp(*quarter, kLeastHealthyPx, kMostHealthyPx);
}

BorneOut borneOut(const std::vector<const FlowSquare*>& squares, std::size_t trial) {
  constexpr double kMost = 0.7, kSome = 0.4;
  std::size_t asked = 0, near = 0;
  for (const FlowSquare* square : squares) {
    if (!isApartUnder(*square, trial)) continue;
    ++asked;
    if (isNearUnder(*square, trial)) ++near;
  }
  if (asked < kEnoughRefutingSquares) return BorneOut::Open;
  const double share = static_cast<double>(near) / static_cast<double>(asked);
  return share >= kMost ? BorneOut::Yes : share >= kSome ? BorneOut::Partly : BorneOut::No;
}

std::vector<std::size_t> bestReadings(const std::vector<const FlowSquare*>& squares,
                                      const std::vector<MotionTrial>& trials, double healthyPx) {
  constexpr double kMuchMore = 3.0, kHealthyTimes = 2.5, kAsLittle = 1.5;
  const double given = leftPx(squares, 0);
  std::vector<std::pair<double, std::size_t>> all;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t t = 1; t < trials.size(); ++t) {
    const MotionMadeOf made = madeOf(trials[t].kind);
    if (made == MotionMadeOf::Factors || made == MotionMadeOf::Jitter) continue;
    all.emplace_back(leftPx(squares, t), t);
    best = std::min(best, all.back().first);
  }
  if (!(best <= kHealthyTimes * healthyPx) || !(given >= kMuchMore * best)) return {};
  std::vector<std::size_t> out;
  for (const auto& [left, trial] : all)
    if (left <= std::max(kAsLittle * best, best + healthyPx)) out.push_back(trial);
  return out;
}

} // namespace taa::doctor
