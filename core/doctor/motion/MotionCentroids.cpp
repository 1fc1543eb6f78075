#include "core/doctor/motion/MotionCentroids.h"

#include "core/doctor/frames/RegionCentroids.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <utility>

namespace taa::doctor {

namespace {

/// px: explanations that have led an object to places nearer to each other say the same of it; its middle is
/// known to a part of a pixel.
constexpr double kMiddleApartPx = 0.6;
/// Pixels well inside an object, and their share of it: of a thing as thin as a pixel rows come and go.
constexpr double kLeastInside = 4.0, kInsideShare = 0.2;
constexpr double kLeastObject = 12.0; ///< pixels
/// Of its pixels: one that loses or gains more from frame to frame is another one, or comes out of something.
constexpr double kAsLargeObject = 0.1;
/// Pixels that come and go with where a silhouette lies between them. What else came or went at one side
/// moves the middle by its half, as a share of the object's width; explanations differ by so many times that.
constexpr double kSilhouettePixels = 2.0, kOverOff = 4.0;
/// What turns, or is turned around, moves in front by another motion than its outline does: explanations
/// differ by so many times what the motions of its pixels differ by.
constexpr double kOverSpread = 4.0;
constexpr int kSampledPerObject = 48;
/// Of a distance: what is so much nearer beside an object may hide a part of it.
constexpr float kNearer = 0.95f;
// What fits, and what does not.
constexpr std::size_t kEnoughCentroids = 10;
constexpr double kMiddleFactor = 2.0, kCentroidsWon = 0.8, kSameMiddleGain = 0.95;
/// The way is so many times what an explanation misses it by: one that holds things in place explains none.
constexpr double kExplainedWay = 2.0;

/// Whether the motion given by it would be another one for the middle as well, whatever turns: by a factor, a
/// sign, an axis or a unit, or as what rests in the world.
bool isOfMiddle(MotionKind kind) {
  const MotionMadeOf made = madeOf(kind);
  return made == MotionMadeOf::Factors || made == MotionMadeOf::Curve || kind == MotionKind::OfCamera ||
         kind == MotionKind::TwoFramesOld;
}

bool areAsLarge(double a, double b) {
  const double less = std::min(a, b);
  return less >= kLeastObject && std::abs(a - b) <= kAsLargeObject * less + kSilhouettePixels;
}

/// px that the middle of an object may be off by for pixels that came or went at one side.
double offBySize(double size, double sizeAtStart) {
  return 0.5 * std::max(0.0, std::abs(size - sizeAtStart) - kSilhouettePixels) / std::sqrt(sizeAtStart);
}

/// Regions with something nearer beside them.
std::set<RegionIndex> regionsHidden(const DoctorFrame& frame, const std::vector<RegionIndex>& labels) {
  std::set<RegionIndex> out;
  const glm::ivec2 size = frame.sizePx();
  const auto compare = [&](std::size_t a, std::size_t b) {
    if (labels[a] == labels[b]) return;
    const float ofA = frame.depthView.pixels[a], ofB = frame.depthView.pixels[b];
    if (ofA > 0.0f && (ofB <= 0.0f || ofA < kNearer * ofB)) out.insert(labels[b]);
    if (ofB > 0.0f && (ofA <= 0.0f || ofB < kNearer * ofA)) out.insert(labels[a]);
  };
  for (int y = 0; y + 1 < size.y; ++y)
    for (int x = 0; x + 1 < size.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * size.x + x;
      compare(i, i + 1);
      compare(i, i + static_cast<std::size_t>(size.x));
    }
  return out;
}

/// Of an object: the mean motion of its pixels by each explanation.
struct MeanMotions {
  int count = 0;
  glm::ivec2 pixel{-1};                        ///< one of them
  std::vector<std::optional<glm::dvec2>> sums; ///< none: the explanation says nothing of a pixel
  double squares = 0.0;                        ///< sum of those of the motions given

  void add(const FrameNeighbors& frames, const std::vector<MotionTrial>& trials, const glm::ivec2& at) {
    if (count++ == 0) {
      sums.assign(trials.size(), glm::dvec2(0.0));
      pixel = at;
    }
    for (std::size_t t = 0; t < trials.size(); ++t) {
      if (!sums[t]) continue;
      const auto motion = trueMotion(trials[t], frames, at);
      if (motion && isMotion(*motion))
        *sums[t] += glm::dvec2(*motion);
      else
        sums[t].reset();
      if (t == 0 && sums[0]) squares += glm::dot(glm::dvec2(*motion), glm::dvec2(*motion));
    }
  }
  /// Of the motions given, px: root of their mean squared distance from their mean. Expects that all are.
  double spreadPx() const {
    const glm::dvec2 middle = *mean(0);
    return std::sqrt(std::max(0.0, squares / static_cast<double>(count) - glm::dot(middle, middle)));
  }
  std::optional<glm::dvec2> mean(std::size_t trial) const {
    if (!sums[trial]) return {};
    return *sums[trial] / static_cast<double>(count);
  }
};

/// By region: whether so much of it is well inside.
std::vector<bool> areSolid(const std::vector<RegionIndex>& labels, const glm::ivec2& sizePx,
                           const std::vector<RegionMiddle>& centroids) {
  const std::vector<RegionMiddle> inside = centroidsOf(insideOf(labels, sizePx), sizePx);
  std::vector<bool> out(centroids.size());
  for (std::size_t region = 0; region < inside.size(); ++region)
    out[region] = inside[region].count >= std::max(kLeastInside, kInsideShare * centroids[region].count);
  return out;
}

/// Regions of a pair of frames, by where they lie in both.
class PairCentroids {
 public:
  PairCentroids(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels,
                const std::vector<RegionIndex>& labelsBefore)
      : frames_(frames), labels_(labels), sizePx_(frames.now.sizePx()), now_(centroidsOf(labels, sizePx_)),
        before_(centroidsOf(labelsBefore, sizePx_)), solid_(areSolid(labels, sizePx_, now_)),
        hidden_(regionsHidden(frames.now, labels)) {
    hidden_.merge(regionsHidden(frames.before, labelsBefore));
  }

  /// Of objects that are seen whole.
  std::map<RegionIndex, MeanMotions> meanMotions(const std::vector<MotionTrial>& trials) const {
    std::vector<bool> whole(now_.size());
    for (std::size_t region = 0; region < now_.size(); ++region) whole[region] = isWhole(region);
    std::map<RegionIndex, MeanMotions> out;
    std::vector<int> seen(now_.size());
    for (std::size_t i = 0; i < labels_.size(); ++i) {
      if (labels_[i] == kNoRegion || frames_.now.objectId[i] == 0) continue;
      const auto region = static_cast<std::size_t>(labels_[i]);
      if (!whole[region]) continue;
      const int every = std::max(1, static_cast<int>(now_[region].count) / kSampledPerObject);
      if (seen[region]++ % every == 0)
        out[labels_[i]].add(frames_, trials,
                            {static_cast<int>(i) % sizePx_.x, static_cast<int>(i) / sizePx_.x});
    }
    return out;
  }
  /// Pixels, now and in the frame before.
  double sizeOf(RegionIndex region) const { return now_[static_cast<std::size_t>(region)].count; }
  double sizeBefore(RegionIndex region) const { return before_[static_cast<std::size_t>(region)].count; }
  /// px.
  glm::dvec2 wayOf(RegionIndex region) const {
    const auto index = static_cast<std::size_t>(region);
    return now_[index].place() - before_[index].place() +
           glm::dvec2(frames_.before.depthJitterPx - frames_.now.depthJitterPx);
  }

 private:
  bool isWhole(std::size_t region) const {
    return region < before_.size() && solid_[region] && !now_[region].isCut && !before_[region].isCut &&
           areAsLarge(now_[region].count, before_[region].count) &&
           !hidden_.contains(static_cast<RegionIndex>(region));
  }

  const FrameNeighbors& frames_;
  const std::vector<RegionIndex>& labels_;
  glm::ivec2 sizePx_;
  std::vector<RegionMiddle> now_, before_;
  std::vector<bool> solid_;
  std::set<RegionIndex> hidden_;
};

/// `leastPx`: explanations that differ by no more say the same.
void compareWay(const glm::dvec2& way, double leastPx, const glm::dvec2& given, const glm::dvec2& tried,
                MiddleCounts& out) {
  if (glm::distance(given, tried) <= leastPx) return;
  const double ofGiven = glm::distance(given, way), ofTried = glm::distance(tried, way);
  ++out.samples;
  if (ofTried < ofGiven) ++out.won;
  out.given += ofGiven;
  out.tried += ofTried;
  out.moved += glm::length(way);
}

bool fitsCentroids(const MiddleCounts& counts) {
  return counts.samples >= kEnoughCentroids && counts.given >= kMiddleFactor * counts.tried &&
         counts.moved >= kExplainedWay * counts.tried &&
         static_cast<double>(counts.won) >= kCentroidsWon * static_cast<double>(counts.samples);
}

} // namespace

void MiddleCounts::add(const MiddleCounts& other) {
  samples += other.samples;
  won += other.won;
  given += other.given;
  tried += other.tried;
  moved += other.moved;
}

void MiddleEvidence::add(const MiddleEvidence& other) {
  trials.resize(std::max(trials.size(), other.trials.size()));
  for (std::size_t t = 0; t < other.trials.size(); ++t) trials[t].add(other.trials[t]);
  pixel = other.pixel;
}

std::map<RegionIndex, MiddleEvidence> MotionCentroids::add(const FrameNeighbors& frames,
                                                           const std::vector<MotionTrial>& trials,
                                                           const std::vector<RegionIndex>& labels,
                                                           const std::vector<RegionIndex>& labelsBefore) {
  std::map<RegionIndex, Way> earlier = std::exchange(ways_, {});
  if (frame_ != frames.before.frame) earlier.clear();
  frame_ = frames.now.frame;
  const bool isKnown = !frames.now.objectId.empty() && !frames.before.objectId.empty() &&
                       !frames.now.depthView.empty() && !frames.before.depthView.empty();
  if (!isKnown) return {};
  const PairCentroids pair(frames, labels, labelsBefore);
  std::map<RegionIndex, MiddleEvidence> out;
  for (const auto& [region, motions] : pair.meanMotions(trials)) {
    Way way = std::move(earlier[region]);
    if (way.sizeAtStart == 0.0) way.sizeAtStart = pair.sizeBefore(region);
    way.offPx = std::max(way.offPx, offBySize(pair.sizeOf(region), way.sizeAtStart));
    way.px += pair.wayOf(region);
    way.motions.resize(trials.size(), glm::dvec2(0.0));
    for (std::size_t t = 0; t < trials.size(); ++t)
      if (const auto mean = motions.mean(t); mean && way.motions[t])
        *way.motions[t] += *mean;
      else
        way.motions[t].reset();
    if (way.motions[0]) way.spreadPx += motions.spreadPx();
    ways_[region] = way;
    if (!way.motions[0]) continue;
    const double leastPx = std::max({kMiddleApartPx, kOverOff * way.offPx, kOverSpread * way.spreadPx});
    MiddleEvidence& evidence = out[region];
    evidence.pixel = motions.pixel;
    evidence.trials.resize(trials.size());
    for (std::size_t t = 1; t < trials.size(); ++t)
      if (way.motions[t] && isOfMiddle(trials[t].kind))
        compareWay(way.px, leastPx, *way.motions[0], *way.motions[t], evidence.trials[t]);
  }
  return out;
}

std::vector<std::size_t> middleWinners(const MiddleEvidence& evidence) {
  std::vector<std::size_t> out;
  double most = 0.0;
  const auto gain = [&](std::size_t t) { return evidence.trials[t].given - evidence.trials[t].tried; };
  for (std::size_t t = 0; t < evidence.trials.size(); ++t) {
    if (evidence.trials[t].samples >= kEnoughCentroids) most = std::max(most, gain(t));
    if (fitsCentroids(evidence.trials[t])) out.push_back(t);
  }
  std::erase_if(out, [&](std::size_t t) { return gain(t) < kSameMiddleGain * most; });
  return out;
}

} // namespace taa::doctor
