#include "core/doctor/jitter/JitterTrials.h"

#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

namespace taa::doctor {

namespace {

struct JitterTrialWords {
  std::string_view id;
  std::string_view text;
};

/// In the order of the enumerators; those with a factor say it.
constexpr std::array<JitterTrialWords, 10> kJitterWords = {{
    {"asStated", "as stated"},
    {"notApplied", "none in the pictures"},
    {"mirroredX", "x negated"},
    {"mirroredY", "y negated"},
    {"opposite", "both negated"},
    {"swappedAxes", "x and y exchanged"},
    {"scaled", ""},
    {"otherUnit", ""},
    {"frameLate", "that stated with the frame after"},
    {"frameEarly", "that stated with the frame before"},
}};

std::optional<glm::vec2> statedAt(const std::map<int, glm::vec2>& stated, int frame) {
  const auto found = stated.find(frame);
  if (found == stated.end()) return {};
  return found->second;
}

bool isOfManyPixels(const std::map<int, glm::vec2>& stated) {
  constexpr float kManyPx = 4.0f;
  return std::ranges::any_of(stated, [](const auto& frame) { return glm::length(frame.second) >= kManyPx; });
}

TrialLuma trialLuma(const std::vector<SearchedPixel>& samples, const FrameNeighbors& frames,
                    const std::map<int, glm::vec2>& stated) {
  TrialLuma out;
  for (const JitterTrial& trial : jitterTrials(frames.now.sizePx())) {
    const auto now = trueJitter(trial, stated, frames.now.frame);
    const auto before = trueJitter(trial, stated, frames.now.frame - 1);
    const bool isKnown = now && before && glm::distance(*now, *before) <= kFarthestShiftPx;
    out.push_back(isKnown ? lumaLeft(samples, frames.before.luma, *before - *now)
                          : std::numeric_limits<double>::quiet_NaN());
  }
  // What leads farther than pictures are compared leaves at least what the worst of the others leaves.
  if (std::isnan(out.front()))
    for (const double luma : out)
      if (std::isnan(out.front()) || luma > out.front()) out.front() = luma;
  return out;
}

/// Whether the sky fits clearly better without the jitter that is stated, and what little else there is says
/// enough by itself or fits better with it.
bool isSkyApart(const ShiftSamples& samples, const FrameNeighbors& frames) {
  constexpr std::size_t kLeastBesideSky = 40;
  constexpr double kClearly = 1.0 / 3.0;
  if (samples.world.size() < kLeastBesideSky) return false;
  const glm::vec2 step = frames.jitterStep();
  const auto left = [&](const std::vector<SearchedPixel>& of, const glm::vec2& shiftPx) {
    return lumaLeft(of, frames.before.luma, shiftPx);
  };
  return left(samples.sky, glm::vec2(0.0f)) < kClearly * left(samples.sky, step) &&
         (areEnough(samples.world) || left(samples.world, step) < left(samples.world, glm::vec2(0.0f)));
}

/// Adds the parts of a pair, see JitterEvidence::parts.
void addParts(const std::vector<SearchedPixel>& samples, const FrameNeighbors& frames, JitterEvidence& out) {
  constexpr int kPartsAcross = 4;
  constexpr std::size_t kLeastInPart = 24;
  constexpr double kClearly = 0.9;
  const glm::vec2 size(frames.now.sizePx());
  std::map<std::pair<int, int>, std::vector<SearchedPixel>> parts;
  for (const SearchedPixel& sample : samples) {
    const glm::ivec2 part(static_cast<float>(kPartsAcross) * sample.place / size);
    parts[{part.x, part.y}].push_back(sample);
  }
  for (const auto& [place, part] : parts) {
    if (part.size() < kLeastInPart) continue;
    ++out.parts;
    if (lumaLeft(part, frames.before.luma, frames.jitterStep()) <
        kClearly * lumaLeft(part, frames.before.luma, glm::vec2(0.0f)))
      ++out.shiftingParts;
  }
}

} // namespace

void JitterEvidence::add(const FrameNeighbors& frames) {
  ++pairs;
  const DoctorFrame& now = frames.now;
  constexpr double kRestingPx = 0.05;
  ShiftSamples samples = shiftSamples(frames);
  const bool isResting = samples.longestPx <= kRestingPx;
  resting.add(frames.before, now, isResting);
  skyShare += samples.skyShare;
  std::map<int, glm::vec2> around = stated;
  if (frames.after) around[now.frame + 1] = frames.after->jitterPx;
  if (areEnough(samples.sky)) {
    sky.push_back(trialLuma(samples.sky, frames, around));
    if (const auto share = measureShare(samples.sky, frames)) skyShares.push_back(*share);
  }
  // A picture of little else is measured by its sky, but for one that rests while the rest shifts.
  const bool isMixed = samples.isSparse && !(areEnough(samples.sky) && isSkyApart(samples, frames));
  if (isMixed) samples.world.insert(samples.world.end(), samples.sky.begin(), samples.sky.end());
  if (!areEnough(samples.world)) return;
  if (isResting) addParts(samples.world, frames, *this);
  world.push_back(trialLuma(samples.world, frames, around));
  if (const auto shift = measureShift(samples.world, frames)) shifts.push_back({now.frame, *shift});
}

std::vector<ShiftPair> shiftPairs(const JitterEvidence& evidence) {
  std::vector<ShiftPair> out;
  for (const JitterEvidence::Shift& shift : evidence.shifts) {
    const auto before = evidence.stated.find(shift.frame - 1), now = evidence.stated.find(shift.frame);
    if (before != evidence.stated.end() && now != evidence.stated.end())
      out.push_back({shift.frame, glm::dvec2(before->second), glm::dvec2(now->second), glm::dvec2(shift.px)});
  }
  return out;
}

std::vector<JitterTrial> jitterTrials(const glm::ivec2& sizePx) {
  std::vector<JitterTrial> trials;
  for (const JitterKind kind :
       {JitterKind::AsStated, JitterKind::NotApplied, JitterKind::MirroredX, JitterKind::MirroredY,
        JitterKind::Opposite, JitterKind::SwappedAxes, JitterKind::FrameLate, JitterKind::FrameEarly})
    trials.push_back({kind});
  for (const float factor : {0.5f, 2.0f, 2.0f / 3.0f, 0.75f, 4.0f / 3.0f, 1.5f})
    trials.push_back({JitterKind::Scaled, glm::vec2(factor)});
  // Texture or device coordinates taken for pixels, and the other way; y of the latter may point up.
  const glm::vec2 uv(sizePx), ndc = 0.5f * uv, yUp(1.0f, -1.0f);
  for (const glm::vec2& unit : {uv, ndc, 1.0f / uv, 1.0f / ndc})
    for (const glm::vec2& factor : {unit, unit * yUp}) trials.push_back({JitterKind::OtherUnit, factor});
  for (const JitterKind late : {JitterKind::FrameLate, JitterKind::FrameEarly})
    for (const JitterKind kind :
         {JitterKind::MirroredX, JitterKind::MirroredY, JitterKind::Opposite, JitterKind::SwappedAxes})
      trials.push_back({kind, glm::vec2(1.0f), late});
  return trials;
}

std::string jitterTrialId(const JitterTrial& trial) {
  if (trial.isTwofold()) return jitterTrialId({trial.kind}) + "+" + jitterTrialId({trial.also});
  const std::string id(kJitterWords[static_cast<std::size_t>(trial.kind)].id);
  if (trial.kind != JitterKind::OtherUnit && trial.kind != JitterKind::Scaled) return id;
  if (trial.kind == JitterKind::Scaled && trial.factor.x == trial.factor.y)
    return id + ":" + shortNumber(static_cast<double>(trial.factor.x));
  return id + ":" + shortVector(glm::dvec2(trial.factor));
}

std::string jitterTrialText(const JitterTrial& trial) {
  if (trial.isTwofold())
    return say<"%1, and %2">(jitterTrialText({trial.kind}), jitterTrialText({trial.also}));
  if (trial.kind == JitterKind::Scaled)
    return say<"times %1">(trial.factor.x == trial.factor.y ? shortNumber(static_cast<double>(trial.factor.x))
                                                            : shortVector(glm::dvec2(trial.factor)));
  if (trial.kind == JitterKind::OtherUnit)
    return say<"times %1: another unit">(shortVector(glm::dvec2(trial.factor)));
  return std::string(kJitterWords[static_cast<std::size_t>(trial.kind)].text);
}

std::optional<glm::vec2> trueJitter(const JitterTrial& trial, const std::map<int, glm::vec2>& stated,
                                    int frame) {
  const auto is = [&](JitterKind kind) { return trial.kind == kind || trial.also == kind; };
  const int delay = is(JitterKind::FrameLate) ? 1 : is(JitterKind::FrameEarly) ? -1 : 0;
  const std::optional<glm::vec2> jitter = statedAt(stated, frame + delay);
  if (!jitter) return {};
  switch (trial.kind) {
  case JitterKind::AsStated:
  case JitterKind::FrameLate:
  case JitterKind::FrameEarly:
    break;
  case JitterKind::NotApplied:
    return glm::vec2(0.0f);
  case JitterKind::MirroredX:
    return *jitter * glm::vec2(-1.0f, 1.0f);
  case JitterKind::MirroredY:
    return *jitter * glm::vec2(1.0f, -1.0f);
  case JitterKind::Opposite:
    return -*jitter;
  case JitterKind::SwappedAxes:
    return glm::vec2(jitter->y, jitter->x);
  case JitterKind::OtherUnit:
    // What shrinks jitter of parts of a pixel leaves none, which is said otherwise.
    if (trial.factor.x < 1.0f && !isOfManyPixels(stated)) return {};
    return *jitter * trial.factor;
  case JitterKind::Scaled:
    return *jitter * trial.factor;
  }
  return jitter;
}

double shiftResidual(const JitterTrial& trial, const JitterEvidence& evidence) {
  std::vector<double> misses;
  for (const JitterEvidence::Shift& shift : evidence.shifts) {
    const auto now = trueJitter(trial, evidence.stated, shift.frame);
    const auto before = trueJitter(trial, evidence.stated, shift.frame - 1);
    if (!now || !before) continue;
    misses.push_back(static_cast<double>(glm::distance(shift.px, *before - *now)));
  }
  return misses.empty() ? std::numeric_limits<double>::infinity() : median(std::move(misses));
}

} // namespace taa::doctor
