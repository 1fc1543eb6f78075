#include "core/capture/import/DepthJitter.h"

#include "core/base/Say.h"
#include "core/capture/import/Comparison.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace taa::capture {

namespace {

constexpr float kNotTold = std::numeric_limits<float>::quiet_NaN();

/// Relative. Depths that are nearer to each other than this are the same in half floats.
constexpr float kTellable = 0.002f;
/// Of the slope: where the slope changes by more from pixel to pixel, an edge is near, and nothing between
/// pixels is a depth of anything.
constexpr float kFlat = 0.25f;
/// Share of the pixels that tell the answers apart at which one of them is right: else something else is
/// wrong.
constexpr double kFitsMost = 0.5;

/// Whether depth is that of a plane around a place, along a row or a column.
bool isFlatAlong(const Image& depth, int x, int y, int stepX, int stepY) {
  const float before = *depth.at(x - stepX, y - stepY), here = *depth.at(x, y);
  const float next = *depth.at(x + stepX, y + stepY), afterNext = *depth.at(x + 2 * stepX, y + 2 * stepY);
  const float slope = next - here;
  const float bend = std::max(std::abs(slope - (here - before)), std::abs(afterNext - next - slope));
  // A rest for planes that face the camera in this direction, whose slope is rounding.
  return before > 0.0f && here > 0.0f && next > 0.0f && afterNext > 0.0f &&
         bend <= std::max(kFlat * std::abs(slope), 0.25f * kTellable * here);
}

/// Whether depth between the pixels around a place lies on one surface.
bool isFlatAt(const Image& depth, const glm::vec2& place) {
  const int x = static_cast<int>(std::floor(place.x - 0.5f)),
            y = static_cast<int>(std::floor(place.y - 0.5f));
  if (x < 1 || y < 1 || x + 2 >= depth.width || y + 2 >= depth.height) return false;
  return isFlatAlong(depth, x, y, 1, 0) && isFlatAlong(depth, x, y + 1, 1, 0) &&
         isFlatAlong(depth, x, y, 0, 1) && isFlatAlong(depth, x + 1, y, 0, 1);
}

/// One answer for one pair: where its pixels' surfaces were, how far away, and what the frame before says.
struct DepthBefore {
  PairMotion motion;
  Image depth;
  glm::vec2 step{0.0f}; ///< what the places of depth move by besides motion

  bool isKnown() const { return !motion.previousDepth.empty() && !depth.empty(); }
  glm::vec2 place(const FramePair& pair, std::size_t i) const {
    return glm::vec2(pair.places[i]) + 0.5f - motion.camera[i] + step;
  }
};

std::optional<DepthBefore> depthBefore(FrameSamples& samples, const FramePair& pair, const TestState& state) {
  std::optional<PairMotion> motion = samples.motionOf(pair, state, true);
  std::optional<Image> depth = samples.previousDepthOf(pair, state);
  if (!motion || !depth) return {};
  DepthBefore out{std::move(*motion), std::move(*depth), {}};
  if (state.conventions.depth.jittered) out.step = out.motion.jitterStep;
  return out;
}

/// Both answers, of all pairs.
struct DepthAnswers {
  Outcome jittered, plain;
  std::size_t told = 0, fitting = 0; ///< pixels at which the answers differ, and of these: one is right
};

void addPixel(const FramePair& pair, std::size_t i, const DepthBefore& jittered, const DepthBefore& plain,
              DepthAnswers& out) {
  const glm::vec2 places[2] = {jittered.place(pair, i), plain.place(pair, i)};
  const float wanted[2] = {jittered.motion.previousDepth[i], plain.motion.previousDepth[i]};
  float errors[2] = {kNotTold, kNotTold};
  const bool isSurface = wanted[0] > 0.0f && wanted[1] > 0.0f;
  if (isSurface && isFlatAt(jittered.depth, places[0]) && isFlatAt(plain.depth, places[1])) {
    const float misses[2] = {betweenPixels(jittered.depth, places[0]) / wanted[0] - 1.0f,
                             betweenPixels(plain.depth, places[1]) / wanted[1] - 1.0f};
    const float apart = std::abs(misses[0] - misses[1]);
    const bool isTold = apart >= kTellable;
    const bool fits = isTold && std::min(std::abs(misses[0]), std::abs(misses[1])) <= 0.5f * apart;
    if (isTold) ++out.told;
    if (fits) ++out.fitting;
    for (int answer = 0; answer < 2 && fits; ++answer) errors[answer] = std::abs(misses[answer]);
  }
  out.jittered.add(places[0], errors[0]);
  out.plain.add(places[1], errors[1]);
}

/// Nothing where conventions contradict the capture.
std::optional<DepthAnswers> depthAnswers(FrameSamples& samples, const TestState& jittered,
                                         const TestState& plain) {
  DepthAnswers out;
  for (const FramePair& pair : samples.pairs()) {
    const std::optional<DepthBefore> with = depthBefore(samples, pair, jittered);
    const std::optional<DepthBefore> without = depthBefore(samples, pair, plain);
    if (!with || !without) return {};
    const bool isKnown = with->isKnown() && without->isKnown();
    for (std::size_t i = 0; i < pair.places.size(); ++i) {
      if (isKnown) {
        addPixel(pair, i, *with, *without, out);
        continue;
      }
      out.jittered.add(glm::vec2(0.0f), kNotTold);
      out.plain.add(glm::vec2(0.0f), kNotTold);
    }
  }
  return out;
}

std::string depthReason(const DepthAnswers& answers, bool fits, const TrialComparison& comparison) {
  if (answers.told > 0 && !fits)
    return say<"at %1 of %2 pixels the depth of the frame before is neither answer's: much moves by itself, "
               "or depth or matrices are other than stated">(answers.told - answers.fitting, answers.told);
  if (!comparison.hasRegions())
    return say<"too little is steep enough to tell: the answers differ at %1 pixels">(answers.told);
  return reasonOf(comparison);
}

} // namespace

std::optional<Finding> askDepthJitter(FrameSamples& samples, TestState& state, bool isFixed) {
  if (!samples.asksDepthJitter() || samples.pairs().empty()) return {};
  TestState with = state, without = state;
  with.isJittered = without.isJittered = true;
  with.conventions.depth.jittered = true;
  without.conventions.depth.jittered = false;
  const std::optional<DepthAnswers> answers = depthAnswers(samples, with, without);
  if (!answers) return {};
  const TrialComparison comparison =
      compare(samples, std::vector<Outcome>{answers->jittered, answers->plain});
  const bool fits = static_cast<double>(answers->fitting) >=
                    kFitsMost * static_cast<double>(std::max<std::size_t>(1, answers->told));
  Finding finding;
  finding.question = say<"Jitter in depth">();
  finding.path = "depth.jittered";
  finding.measure = say<"mean relative difference from the depth of the frame before, × 1000">();
  finding.isSure = fits && comparison.isClear();
  finding.reason = depthReason(*answers, fits, comparison);
  if (finding.isSure && !isFixed) state.conventions.depth.jittered = comparison.best == 0;
  const bool isJittered = state.conventions.depth.jittered;
  finding.hypotheses = {
      {say<"Drawn with jitter">(), {"depth.jittered=on"}, comparison.residuals[0], isJittered},
      {say<"Drawn without">(), {"depth.jittered=off"}, comparison.residuals[1], !isJittered}};
  std::ranges::stable_sort(finding.hypotheses, {}, &Hypothesis::residual);
  return finding;
}

} // namespace taa::capture
