#include "core/doctor/motion/MotionConsistency.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace taa::doctor {

namespace {

constexpr std::size_t kEnoughChecks = 200;
// px, in the middle of all pixels: motion that is the camera's, that is not, and that an explanation makes
// the camera's.
constexpr double kOwnPx = 0.02, kOffPx = 0.03, kExplainedPx = 0.05;
/// What is given is so many times as far from the camera's motion as what explains it.
constexpr double kClearlyNearer = 5.0;
/// Explanations fit as well where they are nearer than so many times the nearest, and than so many px.
constexpr double kAsNear = 2.0, kAsNearPx = 4e-4;
/// px: an explanation with a free number gives way to one without that is as near as this.
constexpr double kFreePx = 0.005;
/// Of the pixels: they follow what explains the region.
constexpr double kFollowing = 0.7;
constexpr double kLogRounding = -11.0; ///< of half floats
constexpr std::size_t kEnoughAtSilhouettes = 60;
constexpr double kLateShare = 0.8, kSilhouetteOffPx = 0.1;
constexpr std::size_t kEnoughLateFrames = 3; ///< in one what moves may stop, or start

/// px: what does not move shrinks to nothing by any factor.
constexpr float kLeastScaledPx = 0.01f;

/// Whether a trial says something of what moves like this: that of the camera and rest on the screen fit
/// whatever is given.
bool isTelling(const MotionTrial& trial, const glm::vec2& camera) {
  switch (trial.kind) {
  case MotionKind::OfCamera:
  case MotionKind::Resting:
    return false;
  case MotionKind::Scaled:
  case MotionKind::OtherUnit:
  case MotionKind::Root:
    return glm::length(camera) >= kLeastScaledPx;
  default:
    return true;
  }
}

/// By how much a trial enlarges what is given.
float enlargement(const MotionTrial& trial, const glm::vec2& given, const glm::ivec2& sizePx) {
  if (trial.kind == MotionKind::Encoded) return 2.0f;
  if (trial.kind == MotionKind::Root) return 2.0f * glm::length(given / glm::vec2(sizePx));
  return std::max(1.0f, std::max(std::abs(trial.factor.x), std::abs(trial.factor.y)));
}

} // namespace

double DistanceCounts::endPx(std::size_t bin) {
  return std::exp2(0.5 * static_cast<double>(bin) - 12.0);
}

void DistanceCounts::add(float distancePx) {
  const double bin = 2.0 * (std::log2(std::max(static_cast<double>(distancePx), 1e-6)) + 12.0);
  const double last = static_cast<double>(kHalfOctaves - 1);
  // NaN counts as the farthest.
  ++counts_[static_cast<std::size_t>(bin < last ? std::ceil(std::max(0.0, bin)) : last)];
  ++count_;
}

void DistanceCounts::add(const DistanceCounts& other) {
  for (std::size_t bin = 0; bin < kHalfOctaves; ++bin) counts_[bin] += other.counts_[bin];
  count_ += other.count_;
}

double DistanceCounts::medianPx() const {
  std::size_t sum = 0;
  for (std::size_t bin = 0; bin < kHalfOctaves; ++bin) {
    sum += counts_[bin];
    if (2 * sum > count_) return endPx(bin);
  }
  return std::numeric_limits<double>::infinity();
}

std::size_t DistanceCounts::upTo(double distancePx) const {
  std::size_t sum = 0;
  for (std::size_t bin = 0; bin < kHalfOctaves && endPx(bin) <= distancePx; ++bin) sum += counts_[bin];
  return sum;
}

void addSilhouetteConsistency(ConsistencyEvidence& out, const FrameNeighbors& frames, const glm::ivec2& pixel,
                              bool wasOther) {
  const auto camera = cameraMotionPx(frames.now, pixel);
  if (!camera || !frames.after || frames.after->startsHistory || frames.after->motionPx.empty()) return;
  const glm::vec2 given = frames.now.motionAt(pixel.x, pixel.y),
                  after = frames.after->motionAt(pixel.x, pixel.y);
  if (!isMotion(after) || !(static_cast<double>(glm::distance(given, *camera)) > kSilhouetteOffPx)) return;
  ++out.off;
  if (!wasOther || static_cast<double>(glm::distance(after, *camera)) > kExplainedPx) return;
  ++out.offLate;
  out.lateFrames.insert(frames.now.frame);
}

void addSilhouettes(const ConsistencyEvidence& of, ConsistencyEvidence& out) {
  out.off += of.off;
  out.offLate += of.offLate;
  out.lateFrames.insert(of.lateFrames.begin(), of.lateFrames.end());
}

void addConsistency(ConsistencyEvidence& out, const std::vector<MotionTrial>& trials,
                    const FrameNeighbors& frames, const glm::ivec2& pixel) {
  const auto camera = cameraMotionPx(frames.now, pixel);
  if (!camera) return;
  const glm::vec2 given = frames.now.motionAt(pixel.x, pixel.y);
  const float rounding = std::exp2(static_cast<float>(kLogRounding)) * glm::length(given);
  out.trials.resize(trials.size());
  out.trials[0].add(std::max(0.0f, glm::distance(given, *camera) - rounding));
  if (static_cast<double>(glm::distance(given, *camera) - rounding) <= kOwnPx) return;
  ++out.apart;
  const glm::mat4 flipped = flippedMatrix(*frames.now.previousClipFromClip);
  const auto upsideDown = motionUnder(flipped, frames.now, pixel, *frames.now.depth.at(pixel.x, pixel.y));
  out.flipped.add(upsideDown ? std::max(0.0f, glm::distance(given, *upsideDown) - rounding)
                             : std::numeric_limits<float>::infinity());
  for (std::size_t t = 1; t < trials.size(); ++t) {
    if (!isTelling(trials[t], *camera)) continue;
    const auto motionPx = trueMotion(trials[t], frames, pixel);
    if (!motionPx) continue;
    const float rounded = rounding * enlargement(trials[t], given, frames.now.sizePx());
    out.trials[t].add(std::max(0.0f, glm::distance(*motionPx, *camera) - rounded));
  }
}

void addConsistency(PairConsistency& out, const FrameNeighbors& frames, const glm::ivec2& pixel) {
  const auto camera = cameraMotionPx(frames.now, pixel);
  if (!camera) return;
  ++out.known;
  const glm::vec2 given = frames.now.motionAt(pixel.x, pixel.y);
  const bool isMarked = !isMotion(given);
  if (!isMarked && !(static_cast<double>(glm::distance(given, *camera)) > kSilhouetteOffPx)) return;
  ++out.off;
  const auto set = trueMotion({MotionKind::CameraIdentity}, frames, pixel);
  const float rounding = std::exp2(static_cast<float>(kLogRounding)) * glm::length(given);
  if (isMarked || (set && static_cast<double>(glm::distance(*set, *camera) - rounding) <= kExplainedPx))
    ++out.ofIdentity;
}

std::optional<int> identityFrame(const std::vector<PairConsistency>& pairs) {
  constexpr double kNearlyAllOff = 0.8, kHalfOff = 0.5;
  std::optional<int> frame;
  for (const PairConsistency& pair : pairs) {
    const auto known = static_cast<double>(pair.known), off = static_cast<double>(pair.off);
    if (pair.known < kEnoughChecks || off < kHalfOff * known) continue;
    const bool isOfIdentity =
        off >= kNearlyAllOff * known && static_cast<double>(pair.ofIdentity) >= kNearlyAllOff * off;
    if (frame || !isOfIdentity) return {};
    frame = pair.frame;
  }
  return frame;
}

bool areMatricesFlipped(const std::vector<const ConsistencyEvidence*>& regions,
                        const std::vector<MotionTrial>& trials) {
  ConsistencyEvidence all;
  all.trials.resize(trials.size());
  for (const ConsistencyEvidence* region : regions) {
    if (region->trials.empty()) continue;
    for (std::size_t t = 0; t < trials.size(); ++t) all.trials[t].add(region->trials[t]);
    all.apart += region->apart;
    all.flipped.add(region->flipped);
  }
  const auto follows = [&](const DistanceCounts& counts) {
    return static_cast<double>(counts.upTo(kExplainedPx)) >= kFollowing * static_cast<double>(all.apart);
  };
  if (all.apart < kEnoughChecks || 2 * all.apart < all.trials[0].count() || !follows(all.flipped))
    return false;
  for (std::size_t t = 1; t < trials.size(); ++t)
    if (!isFitted(trials[t]) && follows(all.trials[t])) return false;
  return true;
}

bool isFitted(const MotionTrial& trial) {
  return trial.kind == MotionKind::CameraTurned || trial.kind == MotionKind::CameraBeside;
}

bool isParticular(const MotionTrial& trial) {
  switch (madeOf(trial.kind)) {
  case MotionMadeOf::Jitter:
  case MotionMadeOf::Curve:
    return true;
  case MotionMadeOf::OtherCamera:
    return trial.kind != MotionKind::CameraBeside;
  default:
    return false;
  }
}

ConsistencyDecision decideConsistency(const ConsistencyEvidence& evidence,
                                      const std::vector<MotionTrial>& trials) {
  if (evidence.trials.empty() || evidence.trials[0].count() < kEnoughChecks) return {};
  const double given = evidence.trials[0].medianPx();
  if (given <= kOwnPx) return {ConsistencyVerdict::OfCamera, {}};
  if (given < kOffPx) return {};
  const double farthest = std::min(kExplainedPx, given / kClearlyNearer);
  const auto fits = [&](std::size_t t) {
    const DistanceCounts& trial = evidence.trials[t];
    return static_cast<double>(trial.upTo(2.0 * farthest)) >=
               kFollowing * static_cast<double>(evidence.apart) &&
           trial.medianPx() <= farthest;
  };
  double nearest = std::numeric_limits<double>::infinity(), nearestFixed = nearest;
  for (std::size_t t = 1; t < trials.size(); ++t) {
    if (!fits(t)) continue;
    nearest = std::min(nearest, evidence.trials[t].medianPx());
    if (!isFitted(trials[t])) nearestFixed = std::min(nearestFixed, evidence.trials[t].medianPx());
  }
  const bool isFixed = nearestFixed <= std::max(kAsNear * nearest, kFreePx);
  const double asNear = std::max(kAsNear * (isFixed ? nearestFixed : nearest), kAsNearPx);
  ConsistencyDecision out{ConsistencyVerdict::Apart, {}};
  for (std::size_t t = 1; t < trials.size(); ++t)
    if (fits(t) && evidence.trials[t].medianPx() <= asNear && !(isFixed && isFitted(trials[t])))
      out.explanations.push_back(t);
  if (!out.explanations.empty()) out.verdict = ConsistencyVerdict::Explained;
  return out;
}

bool isLateAtSilhouettes(const ConsistencyEvidence& evidence) {
  return evidence.off >= kEnoughAtSilhouettes && evidence.lateFrames.size() >= kEnoughLateFrames &&
         static_cast<double>(evidence.offLate) >= kLateShare * static_cast<double>(evidence.off);
}

} // namespace taa::doctor
