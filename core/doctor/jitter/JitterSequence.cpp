#include "core/doctor/jitter/JitterSequence.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/settings/Faults.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace taa::doctor {

namespace {

constexpr float kSameJitterPx = 1e-4f;
constexpr double kHalfPixel = 0.505; ///< with room for rounding
/// Frames after which a mean is one, also where nothing repeats.
constexpr int kEnoughForMean = 16;
constexpr int kEnoughForRange = 8; ///< frames after which the extremes are near those of the sequence
// px: of a mean that is clearly not 0, and of one that few frames do not have by chance.
constexpr double kOffMeanPx = 0.12, kFarMeanPx = 0.2;
constexpr double kMeanErrors = 3.0; ///< standard errors of a mean that are no chance
/// Frames that are the same again to 10⁻⁴ px are a period's, also where it is not there twice.
constexpr std::size_t kEnoughRepeated = 4;
/// A normal distribution that suits a wide filter goes beyond half a pixel in half of all frames.
constexpr double kBeyondShare = 0.65;
constexpr int kTooShort = 2, kShort = 4; ///< frames of a period

bool repeatsAfter(const std::vector<glm::vec2>& jitters, std::size_t period) {
  for (std::size_t i = period; i < jitters.size(); ++i)
    if (glm::distance(jitters[i], jitters[i - period]) > kSameJitterPx) return false;
  return true;
}

Finding sequenceFinding(Fault fault, std::string reason, std::string change) {
  Finding out = faultFinding(fault);
  out.isWholePicture = true;
  out.reason = std::move(reason);
  out.change = std::move(change);
  return out;
}

/// Whether the middle between the extremes lies where the mean does: a few frames of an even sequence may
/// have their mean beside 0, but not their range too.
bool isRangeAround(const SequenceFacts& facts) {
  return facts.frames >= kEnoughForRange && glm::length(facts.meanPx) >= kFarMeanPx &&
         glm::length(facts.middlePx - facts.meanPx) <= 0.5 * glm::length(facts.meanPx);
}

/// px: a mean that is shorter may be one of these frames alone.
double chanceMeanPx(const SequenceFacts& facts) {
  return kMeanErrors * facts.spreadPx / std::sqrt(static_cast<double>(facts.frames));
}

void tellMean(const SequenceFacts& facts, Diagnosis& out) {
  const double off = glm::length(facts.meanPx);
  const bool isNoChance = off < kOffMeanPx || off >= chanceMeanPx(facts);
  const bool isKnown = facts.period || (facts.frames >= kEnoughForMean && isNoChance);
  if (!isKnown && !isRangeAround(facts)) {
    out.parts.leaveOpen(
        {say<"Jitter's mean">(),
         say<"the jitter of %1 frames does not repeat: the whole sequence may have another mean "
             "than theirs, %2 px">(facts.frames, shortVector(facts.meanPx)),
         say<"Capture a whole period, or twice as many frames.">(),
         {Fault::JitterMean}});
    return;
  }
  // A mean that a sequence of two has is that of its two places, which is what is wrong with it.
  const bool isOfShort = facts.period && *facts.period <= kTooShort;
  if (off < (isOfShort ? kFarMeanPx : kOffMeanPx)) return;
  out.findings.push_back(sequenceFinding(
      Fault::JitterMean,
      say<"The mean of the jitter of %1 frames is %2 px, and 0 leaves the picture where it is.">(
          facts.frames, shortVector(facts.meanPx)),
      say<"Take the mean off each value: draw with jitter − %1 px (x right, y down), and pass that.">(
          shortVector(facts.meanPx))));
  if (!isKnown) out.findings.back().confidence = Confidence::Likely;
}

void tellRange(const SequenceFacts& facts, Diagnosis& out) {
  if (facts.beyondShare >= kBeyondShare)
    out.findings.push_back(sequenceFinding(
        Fault::JitterOutside,
        say<"Jitter is more than half a pixel in %1 % of the frames, and reaches %2 px.">(
            std::lround(100.0 * facts.beyondShare), shortNumber(facts.longestPx)),
        say<"Multiply the jitter that you draw with, and pass, by %1.">(shortNumber(0.5 / facts.longestPx))));
  else if (facts.longestPx > kHalfPixel)
    out.parts.leaveOpen(
        {say<"Jitter's range">(),
         say<"it reaches %1 px: beyond half a pixel it blurs, unless a wide filter is meant, which frames do "
             "not say">(shortNumber(facts.longestPx)),
         say<"Compare with the range that is meant.">(),
         {Fault::JitterOutside}});
}

bool isTooShort(const SequenceFacts& facts) {
  return facts.period && *facts.period > 1 && *facts.period <= kTooShort;
}

Finding shortSequence(const SequenceFacts& facts) {
  return sequenceFinding(
      Fault::JitterShort, say<"The jitter repeats after %1 frames.">(*facts.period),
      say<"Take a longer sequence: 8 places or more, times the share of pixels that is drawn; Halton's of "
          "the bases 2 and 3 is one.">());
}

void tellPeriod(const SequenceFacts& facts, Diagnosis& out) {
  if (isTooShort(facts))
    out.findings.push_back(shortSequence(facts));
  else if (facts.period && *facts.period <= kShort)
    out.notes.push_back(
        say<"The jitter repeats after %1 frames: edges have no more steps than that.">(*facts.period));
}

} // namespace

SequenceFacts sequenceFacts(const std::map<int, glm::vec2>& jitterPx) {
  SequenceFacts out;
  std::vector<glm::vec2> jitters;
  for (const auto& [frame, jitter] : jitterPx) jitters.push_back(jitter);
  out.frames = static_cast<int>(jitters.size());
  for (std::size_t period = 1; !out.period && period + std::min(period, kEnoughRepeated) <= jitters.size();
       ++period)
    if (repeatsAfter(jitters, period)) out.period = static_cast<int>(period);
  const std::size_t whole = out.period ? static_cast<std::size_t>(*out.period) : 1;
  const std::size_t counted = jitters.size() / whole * whole;
  std::size_t beyond = 0;
  glm::dvec2 least(0.0), most(0.0);
  for (std::size_t i = 0; i < jitters.size(); ++i) {
    least = i == 0 ? glm::dvec2(jitters[i]) : glm::min(least, glm::dvec2(jitters[i]));
    most = i == 0 ? glm::dvec2(jitters[i]) : glm::max(most, glm::dvec2(jitters[i]));
    const double longest = static_cast<double>(std::max(std::abs(jitters[i].x), std::abs(jitters[i].y)));
    if (i < counted) out.meanPx += glm::dvec2(jitters[i]) / static_cast<double>(counted);
    if (longest > kHalfPixel) ++beyond;
    out.longestPx = std::max(out.longestPx, longest);
  }
  out.middlePx = 0.5 * (least + most);
  for (const glm::vec2& jitter : jitters) {
    const glm::dvec2 off = glm::dvec2(jitter) - out.meanPx;
    out.spreadPx += glm::dot(off, off) / (2.0 * static_cast<double>(jitters.size()));
  }
  out.spreadPx = std::sqrt(out.spreadPx);
  if (!jitters.empty()) out.beyondShare = static_cast<double>(beyond) / static_cast<double>(jitters.size());
  return out;
}

void tellShort(const std::map<int, glm::vec2>& jitterPx, Diagnosis& out) {
  const SequenceFacts facts = sequenceFacts(jitterPx);
  if (isTooShort(facts)) out.findings.push_back(shortSequence(facts));
}

void tellSequence(const std::map<int, glm::vec2>& jitterPx, Diagnosis& out) {
  const SequenceFacts facts = sequenceFacts(jitterPx);
  if (facts.period == 1) return;
  tellRange(facts, out);
  tellPeriod(facts, out);
  tellMean(facts, out);
}

} // namespace taa::doctor
