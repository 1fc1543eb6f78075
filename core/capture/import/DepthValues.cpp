#include "core/capture/import/DepthValues.h"

#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/format/ConventionText.h"
#include "core/capture/import/Comparison.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace taa::capture {

namespace {

constexpr double kSharedByMany = 0.0005; ///< of the pixels
constexpr double kFarBeyond = 4.0; ///< a value for nothing lies so much farther than the farthest surface
/// px, in the median: what stands still fits its own motion so well, and another kind of depth does not.
constexpr double kFits = 0.25;
constexpr double kClearDepthFactor = 2.0;
/// px: below it nothing is told, as half floats and sums of rounded matrices differ by as much.
constexpr double kRoundingPx = 0.005;
constexpr double kMovesEnough = 0.1;
constexpr std::size_t kEnoughPixels = 500;

std::vector<float> sortedFinite(const Image& plane) {
  std::vector<float> values;
  for (const float value : plane.pixels)
    if (std::isfinite(value)) values.push_back(value);
  std::ranges::sort(values);
  return values;
}

/// How many at the end of a sorted range are equal.
std::size_t sharedAtEnd(const std::vector<float>& values) {
  return values.size() -
         static_cast<std::size_t>(std::ranges::lower_bound(values, values.back()) - values.begin());
}

std::size_t sharedAtStart(const std::vector<float>& values) {
  return static_cast<std::size_t>(std::ranges::upper_bound(values, values.front()) - values.begin());
}

float mostCommon(std::vector<float> values) {
  std::ranges::sort(values);
  float best = 0.0f;
  std::size_t most = 0;
  for (auto at = values.begin(); at != values.end();) {
    const auto end = std::upper_bound(at, values.end(), *at);
    if (static_cast<std::size_t>(end - at) > most) {
      most = static_cast<std::size_t>(end - at);
      best = *at;
    }
    at = end;
  }
  return best;
}

struct DepthTrial {
  Trial trial;
  std::vector<double> misses; ///< px
  double median = std::numeric_limits<double>::infinity();
};

bool areWindow(const DepthValues& values) {
  return values.lowest >= -1.0 && values.highest <= 1.0;
}

/// The value for nothing where depth is of that kind; nothing: the farthest that it can have.
std::optional<double> nothingOf(const DepthConventions& depth, const DepthValues& values) {
  if (depth.kind != DepthKind::Window) return values.nothing;
  if (!depth.reversed && values.highest == 1.0) return 1.0;
  return {};
}

std::vector<Trial> depthTrials(const TestState& state, const DepthValues& values) {
  std::vector<Trial> trials;
  const auto add = [&](std::string text, std::vector<std::string> assignments) {
    Trial trial{std::move(text), std::move(assignments), state};
    DepthConventions& depth = trial.state.conventions.depth;
    const DepthConventions before = depth;
    for (const std::string& assignment : trial.assignments)
      applyAssignment(trial.state.conventions, assignment);
    // What stands for nothing in one kind is a surface in another.
    if (depth.kind != before.kind || depth.reversed != before.reversed) {
      depth.nothing = nothingOf(depth, values);
      if (depth.nothing != before.nothing)
        trial.assignments.push_back("depth.nothing=" +
                                    (depth.nothing ? decimalText(*depth.nothing) : std::string("none")));
    }
    trials.push_back(std::move(trial));
  };
  if (areWindow(values)) {
    const std::string range = values.lowest < 0.0 ? "depth.range=minusOneToOne" : "depth.range=zeroToOne";
    add(say<"Depth buffer">(), {"depth.kind=window", "depth.reversed=off", range});
    add(say<"Depth buffer, reversed">(), {"depth.kind=window", "depth.reversed=on", range});
  }
  const std::string scale = values.highest <= 0.0 ? "-1" : "1";
  add(say<"Distance along the axis">(), {"depth.kind=planar", "depth.scale=" + scale});
  add(say<"Distance from the eye">(), {"depth.kind=radial", "depth.scale=" + scale});
  return trials;
}

/// Fills in how far the camera's motion by depth is from the motion stored. Returns how long that is.
std::vector<double> measure(FrameSamples& samples, std::vector<DepthTrial>& trials) {
  std::vector<double> lengths;
  for (const FramePair& pair : samples.pairs()) {
    if (pair.motion.empty()) continue; // nothing is stored to compare with
    std::vector<PairMotion> motions;
    for (DepthTrial& trial : trials) {
      std::optional<PairMotion> motion = samples.motionOf(pair, trial.trial.state, true);
      motions.push_back(motion && !motion->camera.empty() ? std::move(*motion) : PairMotion{});
    }
    for (std::size_t i = 0; i < pair.places.size(); ++i) {
      std::optional<double> length;
      for (std::size_t t = 0; t < trials.size(); ++t) {
        if (motions[t].camera.empty() || motions[t].depth[i] <= 0.0f) continue;
        const auto miss = static_cast<double>(glm::distance(motions[t].camera[i], motions[t].stored[i]));
        if (!std::isfinite(miss)) continue;
        trials[t].misses.push_back(miss);
        length = static_cast<double>(glm::length(motions[t].stored[i]));
      }
      if (length) lengths.push_back(*length);
    }
  }
  for (DepthTrial& trial : trials)
    if (trial.misses.size() >= kEnoughPixels) trial.median = upperMedian(trial.misses);
  return lengths;
}

} // namespace

DepthValues depthValuesOf(const Image& depth) {
  DepthValues out;
  std::vector<float> values = sortedFinite(depth);
  if (values.size() < 2 || values.front() == values.back()) return out;
  out.isKnown = true;
  const auto many = static_cast<std::size_t>(kSharedByMany * static_cast<double>(values.size())) + 1;
  const std::size_t last = sharedAtEnd(values), first = sharedAtStart(values);
  const bool isWindow = values.front() >= -1.0f && values.back() <= 1.0f;
  const auto beforeLast = static_cast<double>(values[values.size() - last - 1]);
  const auto high = static_cast<double>(values.back());
  if (!isWindow && values.front() >= 0.0f && high > kFarBeyond * beforeLast && last >= many) {
    out.nothing = high;
    values.resize(values.size() - last);
  } else if (!isWindow && values.back() == 0.0f && last >= many && values[values.size() - last - 1] < 0.0f) {
    out.nothing = 0.0;
    values.resize(values.size() - last);
  } else if (!isWindow && values.front() == 0.0f && first >= many) {
    out.nothing = 0.0;
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
  }
  out.lowest = static_cast<double>(values.front());
  out.highest = static_cast<double>(values.back());
  out.median = static_cast<double>(values[values.size() / 2]);
  return out;
}

DepthConventions depthFrom(const DepthValues& values) {
  DepthConventions out;
  if (!values.isKnown) return out;
  if (areWindow(values)) {
    if (values.lowest < 0.0) out.range = ClipRange::MinusOneToOne;
    // Perspective crowds what is far away: near 1 where that is 1, near 0 where depth is reversed.
    out.reversed = values.median < 0.5;
  } else {
    out.kind = DepthKind::Planar;
    if (values.highest <= 0.0) out.scale = -1.0;
  }
  out.nothing = nothingOf(out, values);
  return out;
}

bool canHold(const DepthConventions& depth, const DepthValues& values) {
  if (!values.isKnown) return true;
  if (depth.kind == DepthKind::Window) return areWindow(values);
  return depth.scale * values.lowest >= 0.0 && depth.scale * values.highest >= 0.0 &&
         (!values.nothing || depth.nothing == values.nothing);
}

std::string depthGuess(const DepthValues& values) {
  const DepthConventions guessed = depthFrom(values);
  std::string name = say<"Distance along the axis">();
  if (guessed.kind == DepthKind::Window)
    name = guessed.reversed ? say<"Depth buffer, reversed">() : say<"Depth buffer">();
  return say<"Kind of depth: %1 (by its values alone: they are from %2 to %3, half of them below %4)">(
      name, significantText(values.lowest, 4), significantText(values.highest, 4),
      significantText(values.median, 4));
}

namespace {

/// Of x where y is the same.
std::optional<double> markOf(const std::vector<float>& x, const std::vector<float>& y) {
  constexpr double kLeastMarked = 0.1, kMostMarked = 0.98;
  std::vector<float> same;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i] == y[i] && x[i] != 0.0f) same.push_back(x[i]);
  if (same.empty()) return {};
  const float mark = mostCommon(same);
  const auto share = static_cast<double>(std::ranges::count(same, mark)) / static_cast<double>(x.size());
  if (share < kLeastMarked || share > kMostMarked) return {};
  return static_cast<double>(mark);
}

/// Of values without sign that nothing but 0 comes near the ends of: motion is short against its range.
bool areAroundHalf(const std::vector<float>& x, const std::vector<float>& y) {
  constexpr float kFromEnds = 0.02f, kMiddle = 0.15f;
  std::vector<double> written;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] == 0.0f && y[i] == 0.0f) continue;
    for (const float value : {x[i], y[i]}) {
      if (!(value >= kFromEnds && value <= 1.0f - kFromEnds)) return false;
      written.push_back(static_cast<double>(value));
    }
  }
  return !written.empty() && std::abs(median(std::move(written)) - 0.5) <= static_cast<double>(kMiddle);
}

} // namespace

MotionValues motionValuesOf(const Image& motion) {
  MotionValues out;
  std::vector<float> x, y;
  std::size_t zeros = 0;
  for (std::size_t i = 0; i + 1 < motion.pixels.size(); i += static_cast<std::size_t>(motion.channels)) {
    if (!std::isfinite(motion.pixels[i]) || !std::isfinite(motion.pixels[i + 1])) continue;
    x.push_back(motion.pixels[i]);
    y.push_back(motion.pixels[i + 1]);
    if (x.back() == 0.0f && y.back() == 0.0f) ++zeros;
    const float longer = std::max(std::abs(x.back()), std::abs(y.back()));
    out.largest = std::max(out.largest, static_cast<double>(longer));
  }
  if (!x.empty()) out.zeroShare = static_cast<double>(zeros) / static_cast<double>(x.size());
  out.mark = markOf(x, y);
  out.isAroundHalf = areAroundHalf(x, y);
  out.restX = static_cast<double>(mostCommon(std::move(x)));
  out.restY = static_cast<double>(mostCommon(std::move(y)));
  return out;
}

std::optional<Finding> askDepth(FrameSamples& samples, TestState& state, const DepthValues& values,
                                const QuestionRules& rules) {
  if (!samples.hasMotion() || !samples.hasDepth() || !samples.hasMatrices() || samples.pairs().empty())
    return {};
  std::vector<DepthTrial> trials;
  for (Trial& trial : depthTrials(state, values)) trials.push_back({std::move(trial), {}});
  std::vector<double> lengths = measure(samples, trials);
  const auto isStated = [&](const DepthTrial& trial) {
    return trial.trial.state.conventions == state.conventions;
  };
  Finding finding;
  finding.question = say<"Kind of depth">();
  finding.path = "depth.kind";
  finding.measure = say<"median distance of the camera's motion from the stored one, px">();
  const auto best = std::ranges::min_element(trials, {}, &DepthTrial::median);
  double second = std::numeric_limits<double>::infinity();
  for (auto at = trials.begin(); at != trials.end(); ++at)
    if (at != best) second = std::min(second, at->median);
  const bool isMoving = lengths.size() >= kEnoughPixels && upperMedian(lengths) >= kMovesEnough;
  const bool fits = best->median <= kFits;
  finding.isSure = isMoving && fits && second >= kClearDepthFactor * std::max(best->median, kRoundingPx);
  if (!std::isfinite(best->median))
    finding.reason = say<"the matrices are not such that depth and they make a motion">();
  else if (!isMoving)
    finding.reason = say<"the camera moves too little to tell; the values themselves say which is likely">();
  else if (finding.isSure)
    finding.reason =
        say<"with it, the camera's motion is the one stored, to %1 px">(roundedText(best->median, 4));
  else
    finding.reason = fits ? say<"another one fits as well">()
                          : say<"none makes the camera's motion that is stored: much moves by itself, or "
                                "matrices or motion are other than guessed">();
  const bool isFixed = std::ranges::any_of(
      differences(best->trial.state.conventions, state.conventions), [&](const std::string& change) {
        return rules.fixedPaths.contains(change.substr(0, change.find('=')));
      });
  const bool isAdopted = finding.isSure && !isFixed && !isStated(*best);
  for (const DepthTrial& trial : trials)
    if (std::isfinite(trial.median))
      finding.hypotheses.push_back({trial.trial.text, trial.trial.assignments, trial.median,
                                    isAdopted ? &trial == &*best : isStated(trial)});
  std::ranges::stable_sort(finding.hypotheses, {}, &Hypothesis::residual);
  if (isAdopted) state = best->trial.state;
  return finding;
}

std::optional<Finding> askSky(FrameSamples& samples, TestState& state, bool isFixed) {
  constexpr std::size_t kEnoughSky = 64;
  constexpr double kNearlyAll = 0.98;
  if (!samples.hasMotion() || !samples.hasDepth() || !samples.hasMatrices()) return {};
  std::vector<double> lengths;
  std::size_t resting = 0;
  for (const FramePair& pair : samples.pairs()) {
    if (pair.motion.empty()) continue;
    const std::optional<PairMotion> motion = samples.motionOf(pair, state, true);
    if (!motion || motion->camera.empty()) return {};
    for (std::size_t i = 0; i < pair.places.size(); ++i) {
      if (motion->depth[i] != 0.0f) continue;
      lengths.push_back(static_cast<double>(glm::length(motion->camera[i])));
      if (pair.motion.pixels[2 * i] == 0.0f && pair.motion.pixels[2 * i + 1] == 0.0f) ++resting;
    }
  }
  if (lengths.size() < kEnoughSky ||
      static_cast<double>(resting) < kNearlyAll * static_cast<double>(lengths.size()))
    return {};
  const double median = upperMedian(lengths);
  if (median < kMovesEnough) return {};
  MotionConventions& stated = state.conventions.motion;
  if (!isFixed) stated.whereNothing = MotionFallback::Camera;
  Finding finding;
  finding.question = say<"Motion of the sky">();
  finding.path = "motion.whereNothing";
  finding.measure = say<"median distance from the camera's motion, px">();
  finding.isSure = true;
  finding.reason =
      say<"motion is 0 wherever nothing was drawn, though the camera moves: the engine did not write it">();
  finding.hypotheses = {{say<"Of the camera">(),
                         {"motion.whereNothing=camera"},
                         0.0,
                         stated.whereNothing == MotionFallback::Camera},
                        {say<"As stored">(), {"motion.whereNothing=none"}, median, !stated.whereNothing}};
  return finding;
}

} // namespace taa::capture
