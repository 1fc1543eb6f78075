#include "core/doctor/motion/MotionPairs.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/doctor/motion/MotionFindings.h"
#include "core/doctor/motion/MotionWords.h"

#include <glm/common.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

/// Pixels of a pair, and their share of the region's: twelve healthy captures of strangers have at most 140
/// such in a pair, beside what uncovers and where cameras stop.
constexpr std::size_t kEnoughOfPair = 150;
constexpr double kLeastOfRegion = 0.05;
/// Of the sum of two pairs, or of one alone: one thing may happen to a light in one frame.
constexpr std::size_t kSeveralPairs = 2, kEnoughPixelsOfOne = 400;
constexpr double kClearlyLessOfOne = 2.5;
/// What motion given leaves, over what the explanation does; and by how much of luma more, in the mean.
constexpr double kClearlyLess = 1.7, kClearGain = 0.01;
constexpr double kNamedLess = 2.0;      ///< where it leaves more than half, it is not what is so
constexpr double kNearlyAllAsked = 0.8; ///< of the pairs that were asked

/// Explanations that tell frames apart: what is made of factors and jitter is so in all of them.
bool isOfPairs(const MotionTrial& trial) {
  const MotionMadeOf made = madeOf(trial.kind);
  return made == MotionMadeOf::Screen || made == MotionMadeOf::OtherFrame ||
         trial.kind == MotionKind::OfCamera;
}

bool isAsked(const TrialOfPair& trial, const PairTrace& pair) {
  return trial.pixels >= kEnoughOfPair &&
         static_cast<double>(trial.pixels) >= kLeastOfRegion * static_cast<double>(pair.pixels);
}

bool isWon(const TrialOfPair& trial) {
  return trial.given >= kClearlyLess * trial.tried &&
         trial.given - trial.tried >= kClearGain * static_cast<double>(trial.pixels);
}

WonPairs wonBy(std::size_t trial, const RegionEvidence& evidence) {
  WonPairs out;
  out.trial = trial;
  double most = 0.0;
  for (const PairTrace& pair : evidence.traces) {
    if (trial >= pair.trials.size() || !isAsked(pair.trials[trial], pair)) continue;
    const TrialOfPair& one = pair.trials[trial];
    out.asked.push_back(pair.frame);
    if (!isWon(one)) continue;
    out.frames.push_back(pair.frame);
    out.pixels += one.pixels;
    out.given += one.given;
    out.tried += one.tried;
    if (one.given - one.tried <= most) continue;
    most = one.given - one.tried;
    out.frame = pair.frame;
    out.pixel = one.pixel;
  }
  return out;
}

bool isEnough(const WonPairs& won) {
  return won.frames.size() >= kSeveralPairs ||
         (won.pixels >= kEnoughPixelsOfOne && won.given >= kClearlyLessOfOne * won.tried);
}

FaultWords wordsOf(const MotionTrial& trial, const WonPairs& won, const Region& region,
                   const RegionEvidence& evidence) {
  // What rests elsewhere is shown where something else has written its motion.
  const bool isOfCamera = 2 * evidence.ofCamera > evidence.pixels;
  if (won.given < kNamedLess * won.tried) return unknownMotion();
  if (madeOf(trial.kind) == MotionMadeOf::OtherFrame)
    return {
        "motionJumps", say<"Motion that jumps in some frames">(),
        say<"A ghost, or a smear, that flashes up in these frames.">(),
        say<"Look at what its previous transform is looked up by: an index that another thing has moved into "
            "is one way to such a motion, a transform that was not kept is another.">()};
  if (won.areNearlyAll() || isOfCamera) return motionFault(&trial, region, evidence, {}, isOfCamera);
  return {
      "motionOfStill", say<"Motion of what stands still in some frames">(),
      say<"It ghosts, or trembles, while it stands still.">(),
      say<"Its transform or its pose stays the same in these frames, and motion is written as if it went on: "
          "let the previous one be this one, too, where it is not brought up to date.">()};
}

/// Where most is gained: what is known of the region's own place is that of another frame.
void pointAt(const WonPairs& won, const glm::ivec2& sizePx, RegionPlace& place) {
  constexpr int kHalfPx = 8;
  const glm::ivec2 first = glm::max(won.pixel - kHalfPx, glm::ivec2(0)),
                   end = glm::min(won.pixel + kHalfPx + 1, sizePx);
  place.frame = won.frame;
  place.pixel = won.pixel;
  place.box = {first, end};
  place.pixels.clear();
  for (int y = first.y; y < end.y; ++y) place.pixels.push_back({y, first.x, end.x});
}

/// Adds a region, and what is said of it, to the finding of its id.
void addTo(std::vector<Finding>& findings, const WonPairs& won, const MotionTrial& trial,
           const Region& region, const RegionEvidence& evidence, const CaptureInfo& captureInfo,
           double allPixels) {
  const auto perPixel = [&](double sum) { return 1000.0 * sum / static_cast<double>(won.pixels); };
  RegionPlace place = placeOf(region, captureInfo, allPixels);
  pointAt(won, captureInfo.sizePx, place);
  const std::string reason = say<
      "In %1, at %2 of its pixels in the mean, the motion given of %3 leaves %4 thousandths of the pixels' "
      "luma, and what comes nearest leaves %5: %6.">(
      captureInfo.frameNames.of(won.frames, won.asked), won.pixels / won.frames.size(), place.name,
      shortNumber(perPixel(won.given)), shortNumber(perPixel(won.tried)), trialText(trial));
  const FaultWords words = wordsOf(trial, won, region, evidence);
  const auto known = std::ranges::find(findings, words.id, &Finding::id);
  if (known != findings.end()) {
    known->reason += " " + reason;
    known->regions.push_back(std::move(place));
    return;
  }
  Finding out;
  nameBy(words, out);
  out.confidence = Confidence::Likely;
  out.reason = reason;
  out.measure = say<"mean difference of luma, × 1000">();
  out.residuals = {
      {trialId(trial), trialText(trial), perPixel(won.tried), false, words.id != kUnknownMotionId},
      {"asGiven", say<"as given">(), perPixel(won.given), true, false}};
  out.regions = {std::move(place)};
  findings.push_back(std::move(out));
}

} // namespace

bool WonPairs::areNearlyAll() const {
  return static_cast<double>(frames.size()) >= kNearlyAllAsked * static_cast<double>(asked.size());
}

std::optional<WonPairs> wonPairs(const RegionEvidence& evidence, const std::vector<MotionTrial>& trials) {
  std::optional<WonPairs> best;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    if (!isOfPairs(trials[t])) continue;
    WonPairs won = wonBy(t, evidence);
    if (isEnough(won) && (!best || won.gain() > best->gain())) best = std::move(won);
  }
  return best;
}

void tellPairs(const MotionEvidence& evidence, const std::vector<Region>& regions,
               const CaptureInfo& captureInfo, Diagnosis& out) {
  for (std::size_t i = 0; i < regions.size() && i < evidence.regions().size(); ++i) {
    const RegionEvidence& region = evidence.regions()[i];
    if (isMotionTold(placeOf(regions[i], captureInfo, 1.0).name, out)) continue;
    const auto won = wonPairs(region, evidence.trials());
    if (!won) continue;
    addTo(out.findings, *won, evidence.trials()[won->trial], regions[i], region, captureInfo,
          allPixels(captureInfo, out));
    out.parts.takeBack(say<"Motion">());
  }
}

} // namespace taa::doctor
