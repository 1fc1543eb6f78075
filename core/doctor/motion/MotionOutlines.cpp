#include "core/doctor/motion/MotionOutlines.h"

#include "core/doctor/frames/RegionCentroids.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace taa::doctor {

namespace {

/// px: explanations that lead to places nearer to each other say the same of an outline, which lies up to a
/// pixel beside where it is taken to be where depth has not the jitter that is stated.
constexpr float kApartPx = 1.5f;
constexpr double kOutlinePixelsPerPair = 130000.0; ///< looked at of larger pictures
/// Pixels from the silhouette: of the picture's width, at least and at most.
constexpr int kReachShare = 60, kLeastReach = 4, kMostReach = 32;
/// A region that is as large in both frames is seen whole.
constexpr double kAsLargeShare = 0.03;
constexpr double kEnoughOfWhole = 150.0;
// What fits, and what does not.
constexpr std::size_t kEnoughOutline = 150, kEnoughOutside = 40, kEnoughOutlinePairs = 3;
constexpr double kOfJitter = 0.5; ///< of what it is off by, squared: so much is a factor of the jitter
constexpr double kOutlineFactor = 4.0, kPairsShare = 0.8, kSameOutlineGain = 0.95;

class PairOutlines {
 public:
  PairOutlines(const FrameNeighbors& frames, const std::vector<MotionTrial>& trials,
               const std::vector<RegionIndex>& labels, const std::vector<RegionIndex>& labelsBefore)
      : frames_(frames), trials_(trials), labels_(labels), labelsBefore_(labelsBefore),
        sizePx_(frames.now.sizePx()), rasterStep_(frames.before.depthJitterPx - frames.now.depthJitterPx) {}

  std::map<RegionIndex, OutlineEvidence> counted() {
    if (frames_.now.objectId.empty()) return {};
    const double pixels = static_cast<double>(sizePx_.x) * sizePx_.y;
    const int step =
        std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kOutlinePixelsPerPair) - 0.05)));
    reach_ = std::clamp(sizePx_.x / kReachShare, kLeastReach, kMostReach);
    now_ = centroidsOf(labels_, sizePx_);
    before_ = centroidsOf(labelsBefore_, sizePx_);
    for (int y = 1; y + 1 < sizePx_.y; y += step)
      for (int x = 1; x + 1 < sizePx_.x; x += step)
        if (isNearSilhouette({x, y}) && isWide(labels_, sizePx_, x, y)) add({x, y});
    for (auto& [region, outline] : out_) {
      for (OutlineCounts& trial : outline.trials) endPair(trial);
      endPair(outline.found);
    }
    return std::move(out_);
  }

 private:
  RegionIndex labelAt(const glm::ivec2& pixel) const {
    return labels_[static_cast<std::size_t>(pixel.y) * sizePx_.x + pixel.x];
  }

  glm::ivec2 pixelAt(std::size_t index) const {
    return {static_cast<int>(index) % sizePx_.x, static_cast<int>(index) / sizePx_.x};
  }

  bool isNearSilhouette(const glm::ivec2& pixel) const {
    const RegionIndex label = labelAt(pixel);
    // A part that no number says ends where depth or motion does, which may be anywhere on a surface.
    if (frames_.now.objectId[static_cast<std::size_t>(pixel.y) * sizePx_.x + pixel.x] == 0) return false;
    for (const glm::ivec2 step :
         {glm::ivec2(reach_, 0), glm::ivec2(-reach_, 0), glm::ivec2(0, reach_), glm::ivec2(0, -reach_)}) {
      const glm::ivec2 at = glm::clamp(pixel + step, glm::ivec2(0), sizePx_ - 1);
      if (labelAt(at) != label) return true;
    }
    return false;
  }

  void add(const glm::ivec2& pixel) {
    const glm::vec2 given = frames_.now.motionAt(pixel.x, pixel.y);
    if (!isMotion(given)) return;
    const std::optional<bool> isGivenOutside = isOutside(pixel, given);
    if (!isGivenOutside) return;
    const RegionIndex region = labelAt(pixel);
    OutlineEvidence& outline = out_[region];
    outline.trials.resize(trials_.size());
    for (std::size_t t = 0; t < trials_.size(); ++t) {
      if (madeOf(trials_[t].kind) == MotionMadeOf::Jitter) continue;
      if (const auto motion = trueMotion(trials_[t], frames_, pixel))
        compare(pixel, given, *isGivenOutside, *motion, outline.trials[t]);
    }
    if (const auto motion = motionOfMiddle(region)) {
      compare(pixel, given, *isGivenOutside, *motion, outline.found);
      addOff(*motion - given, outline);
    }
  }

  void addOff(const glm::dvec2& off, OutlineEvidence& outline) const {
    const glm::dvec2 jitter(rasterStep_);
    outline.offSquares += glm::dot(off, off);
    outline.jitterSquares += glm::dot(jitter, jitter);
    outline.offByJitter += glm::dot(off, jitter);
  }

  void compare(const glm::ivec2& pixel, const glm::vec2& given, bool isGivenOutside, const glm::vec2& motion,
               OutlineCounts& out) const {
    if (!(glm::distance(motion, given) > kApartPx)) return;
    const std::optional<bool> isTriedOutside = isOutside(pixel, motion);
    if (!isTriedOutside) return;
    ++out.pixels;
    if (isGivenOutside) ++out.given;
    if (*isTriedOutside) ++out.tried;
  }

  /// Whether a pixel that moves like this lay outside of its region; nothing where that cannot be seen:
  /// beyond the picture, or behind something nearer.
  std::optional<bool> isOutside(const glm::ivec2& pixel, const glm::vec2& motionPx) const {
    const auto around = pixelsAround(glm::vec2(pixel) + 0.5f - motionPx + rasterStep_, sizePx_);
    if (!around) return {};
    for (const std::size_t i : *around)
      if (labelsBefore_[i] == labelAt(pixel)) return false;
    const auto isUnknown = [&](std::size_t i) {
      return labelsBefore_[i] == kNoRegion || wasHidden(frames_, pixel, pixelAt(i), kHiddenByOtherShare);
    };
    if (std::ranges::any_of(*around, isUnknown)) return {};
    return true;
  }

  std::optional<glm::vec2> motionOfMiddle(RegionIndex region) const {
    const auto index = static_cast<std::size_t>(region);
    if (index >= now_.size() || index >= before_.size()) return {};
    const RegionMiddle &a = now_[index], &b = before_[index];
    const bool isWhole = !a.isCut && !b.isCut && std::min(a.count, b.count) >= kEnoughOfWhole &&
                         std::abs(a.count - b.count) <= kAsLargeShare * b.count;
    if (!isWhole) return {};
    return glm::vec2(a.place() - b.place()) + rasterStep_;
  }

  static void endPair(OutlineCounts& counts) {
    counts.pairs = counts.given == counts.tried ? 0 : 1;
    counts.pairsWon = counts.given > counts.tried ? 1 : 0;
  }

  const FrameNeighbors& frames_;
  const std::vector<MotionTrial>& trials_;
  const std::vector<RegionIndex>&labels_, &labelsBefore_;
  glm::ivec2 sizePx_;
  glm::vec2 rasterStep_; ///< of what regions are drawn with
  int reach_ = kLeastReach;
  std::vector<RegionMiddle> now_, before_;
  std::map<RegionIndex, OutlineEvidence> out_;
};

/// Pixels that came from outside, of those that a square of as many pixels has along its sides: of a large
/// surface some always do, at corners and where something passes.
bool isOfWholeSilhouette(const OutlineCounts& counts) {
  constexpr double kLeastOfSilhouette = 0.1;
  const double pairs = static_cast<double>(counts.pairs);
  const double silhouette = 4.0 * std::sqrt(static_cast<double>(counts.pixels) / pairs) * pairs;
  return static_cast<double>(counts.given) >= kLeastOfSilhouette * silhouette;
}

bool fitsOutline(const OutlineCounts& counts) {
  return counts.pixels >= kEnoughOutline && counts.given >= kEnoughOutside &&
         counts.pairs >= kEnoughOutlinePairs && isOfWholeSilhouette(counts) &&
         static_cast<double>(counts.given) >= kOutlineFactor * static_cast<double>(counts.tried) &&
         static_cast<double>(counts.pairsWon) >= kPairsShare * static_cast<double>(counts.pairs);
}

} // namespace

void OutlineCounts::add(const OutlineCounts& other) {
  pixels += other.pixels;
  given += other.given;
  tried += other.tried;
  pairs += other.pairs;
  pairsWon += other.pairsWon;
}

void OutlineEvidence::add(const OutlineEvidence& other) {
  trials.resize(std::max(trials.size(), other.trials.size()));
  for (std::size_t t = 0; t < other.trials.size(); ++t) trials[t].add(other.trials[t]);
  found.add(other.found);
  offSquares += other.offSquares;
  jitterSquares += other.jitterSquares;
  offByJitter += other.offByJitter;
}

bool OutlineEvidence::isOffByJitter() const {
  return offByJitter * offByJitter > kOfJitter * offSquares * jitterSquares;
}

std::map<RegionIndex, OutlineEvidence> outlinesOf(const FrameNeighbors& frames,
                                                  const std::vector<MotionTrial>& trials,
                                                  const std::vector<RegionIndex>& labels,
                                                  const std::vector<RegionIndex>& labelsBefore) {
  return PairOutlines(frames, trials, labels, labelsBefore).counted();
}

std::vector<std::size_t> outlineWinners(const OutlineEvidence& evidence) {
  const auto gain = [&](std::size_t t) {
    return static_cast<double>(evidence.trials[t].given) - static_cast<double>(evidence.trials[t].tried);
  };
  std::vector<std::size_t> out;
  double most = 0.0;
  for (std::size_t t = 0; t < evidence.trials.size(); ++t)
    if (fitsOutline(evidence.trials[t])) {
      out.push_back(t);
      most = std::max(most, gain(t));
    }
  std::erase_if(out, [&](std::size_t t) { return gain(t) < kSameOutlineGain * most; });
  return out;
}

bool breaksOutline(std::size_t trial, const OutlineEvidence& evidence) {
  if (trial >= evidence.trials.size()) return false;
  const OutlineCounts& counts = evidence.trials[trial];
  return counts.tried >= kEnoughOutside &&
         static_cast<double>(counts.tried) >= kOutlineFactor * static_cast<double>(counts.given);
}

bool isOutlineFoundElsewhere(const OutlineEvidence& evidence) {
  return fitsOutline(evidence.found) && !evidence.isOffByJitter();
}

} // namespace taa::doctor
