#include "core/doctor/jitter/JitterPauses.h"

#include "core/base/Median.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>

namespace taa::doctor {

namespace {

/// px: what a shift may be off at most, so that one that is measured wrong does not decide; what a change
/// from jitter to none, or back, has to gain.
constexpr double kMostOffPx = 0.3, kChangePx = 0.15;
/// px: jitter that is shorter says nothing of whether it is there.
constexpr double kLeastJitterPx = 0.1;
constexpr std::size_t kEnoughPausedPairs = 3, kEnoughHeldPairs = 3;
constexpr double kRefutedPx = 0.2, kFittingPausesPx = 0.1, kNearlyAll = 0.8;

/// px, of the measured shift, if pictures hold the stated jitters or none.
double offPx(const ShiftPair& pair, bool holdsBefore, bool holdsNow) {
  const glm::dvec2 made =
      (holdsBefore ? pair.before : glm::dvec2(0.0)) - (holdsNow ? pair.now : glm::dvec2(0.0));
  return glm::distance(pair.shift, made);
}

/// Whether each frame holds its jitter, by the cheapest path.
std::map<int, bool> cheapestPath(const std::vector<ShiftPair>& pairs) {
  struct Step {
    int frame = 0;
    std::array<double, 2> cost{0.0, 0.0}; ///< without jitter, with it
    std::array<std::size_t, 2> from{0, 1};
  };
  std::vector<Step> steps;
  for (const ShiftPair& pair : pairs) {
    if (steps.empty() || steps.back().frame != pair.frame - 1) {
      Step start{pair.frame - 1};
      if (!steps.empty()) start.cost = steps.back().cost; // a gap says nothing
      steps.push_back(start);
    }
    Step next{pair.frame};
    for (std::size_t to = 0; to < 2; ++to) {
      next.cost[to] = std::numeric_limits<double>::infinity();
      for (std::size_t from = 0; from < 2; ++from) {
        const double cost = steps.back().cost[from] + (from == to ? 0.0 : kChangePx) +
                            std::min(kMostOffPx, offPx(pair, from == 1, to == 1));
        if (cost >= next.cost[to]) continue;
        next.cost[to] = cost;
        next.from[to] = from;
      }
    }
    steps.push_back(next);
  }
  std::map<int, bool> holds;
  if (steps.empty()) return holds;
  std::size_t state = steps.back().cost[0] < steps.back().cost[1] ? 0 : 1;
  for (std::size_t i = steps.size(); i-- > 0;) {
    holds[steps[i].frame] = state == 1;
    state = steps[i].from[state];
  }
  return holds;
}

} // namespace

std::optional<JitterPauses> jitterPauses(const JitterEvidence& evidence) {
  const std::vector<ShiftPair> pairs = shiftPairs(evidence);
  const std::map<int, bool> holds = cheapestPath(pairs);
  std::vector<double> stated, paused, held;
  std::size_t nearer = 0;
  for (const ShiftPair& pair : pairs) {
    const bool before = holds.at(pair.frame - 1), now = holds.at(pair.frame);
    const double off = offPx(pair, before, now);
    if (before && now) {
      held.push_back(off);
      continue;
    }
    if (glm::length(pair.before) < kLeastJitterPx && glm::length(pair.now) < kLeastJitterPx) continue;
    stated.push_back(offPx(pair, true, true));
    paused.push_back(off);
    if (2.0 * off < stated.back()) ++nearer;
  }
  if (stated.size() < kEnoughPausedPairs || held.size() < kEnoughHeldPairs) return {};
  JitterPauses out{{}, {}, median(stated), median(paused)};
  if (out.statedPx < kRefutedPx || out.pausedPx > kFittingPausesPx || median(held) > kFittingPausesPx ||
      static_cast<double>(nearer) < kNearlyAll * static_cast<double>(stated.size()))
    return {};
  for (const auto& [frame, isHeld] : holds) {
    out.asked.push_back(frame);
    if (!isHeld) out.frames.push_back(frame);
  }
  return out;
}

} // namespace taa::doctor
