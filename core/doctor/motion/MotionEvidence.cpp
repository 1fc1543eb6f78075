#include "core/doctor/motion/MotionEvidence.h"

#include "core/base/Median.h"
#include "core/capture/import/FrameSamples.h"
#include "core/doctor/frames/Detail.h"
#include "core/doctor/motion/MotionSearch.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace taa::doctor {

namespace {

/// px: explanations that lead to places nearer to each other say the same of a pixel.
constexpr float kSameTrialPx = 0.25f;
/// Of luma: a square that differs by less fits.
constexpr double kFittingError = 0.008;
constexpr double kPixelsPerPair = 130000.0; ///< looked at of larger pictures
constexpr int kCellSamples = 16;            ///< a side of a square
constexpr std::size_t kLeastInCell = 12;
constexpr int kLeastReachPx = 12;

struct CellPixel {
  glm::ivec2 pixel{0};
  float luma = 0.0f;
  glm::vec2 given{0.0f};
  float error = 0.0f; ///< as given
};
/// Pixels with detail, by region and square.
using CellPixels = std::map<std::pair<RegionIndex, int>, std::vector<CellPixel>>;

bool isLongerThanPicture(const glm::vec2& motionPx, const glm::ivec2& sizePx) {
  return std::abs(motionPx.x) >= static_cast<float>(sizePx.x) ||
         std::abs(motionPx.y) >= static_cast<float>(sizePx.y);
}

/// What a trial leaves of a square's pixels.
struct CellSums {
  std::size_t pixels = 0, asked = 0, said = 0; ///< see TrialEvidence
  double given = 0.0, tried = 0.0;

  /// Returns what the trial leaves of a pixel.
  float add(const CellPixel& pixel, const Image& previousLuma, const glm::vec2& place) {
    const float left = std::abs(pixel.luma - capture::betweenPixels(previousLuma, place));
    ++pixels;
    given += static_cast<double>(pixel.error);
    tried += static_cast<double>(left);
    return left;
  }
};

void addCell(TrialEvidence& out, CellSums& pair, const CellSums& cell) {
  out.asked += cell.asked;
  out.said += cell.said;
  out.pixels += cell.pixels;
  out.given += cell.given;
  out.tried += cell.tried;
  pair.given += cell.given;
  pair.tried += cell.tried;
  pair.pixels += cell.pixels;
  if (cell.pixels < kLeastInCell) return;
  ++out.cells;
  if (cell.tried < cell.given) ++out.cellsWon;
}

void addPair(TrialEvidence& out, const CellSums& pair) {
  if (pair.pixels < kLeastInCell) return;
  ++out.pairs;
  if (pair.tried < pair.given) ++out.pairsWon;
}

MotionExample exampleAt(const FrameNeighbors& frames, const std::vector<MotionTrial>& trials,
                        const glm::ivec2& pixel, float lengthPx) {
  MotionExample out{frames.now.frame, pixel, lengthPx, frames.now.motionAt(pixel.x, pixel.y), {}};
  for (const MotionTrial& trial : trials) out.byTrial.push_back(trueMotion(trial, frames, pixel));
  return out;
}

/// A pair of frames, worked through square by square.
class PairEvidence {
 public:
  PairEvidence(const FrameNeighbors& frames, const std::vector<MotionTrial>& trials,
               const std::vector<RegionIndex>& labels, const std::vector<RegionIndex>& labelsBefore,
               std::vector<RegionEvidence>& regions)
      : frames_(frames), trials_(trials), labels_(labels), labelsBefore_(labelsBefore), regions_(regions),
        jitterStep_(frames.jitterStep()), inside_(insideOf(labels, frames.now.sizePx())) {}

  void add() {
    const glm::ivec2 size = frames_.now.sizePx();
    const double pixels = static_cast<double>(size.x) * size.y;
    const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kPixelsPerPair) - 0.05)));
    const int cell = step * kCellSamples, columns = size.x / cell + 1;
    for (int y = 1; y + 1 < size.y; y += step)
      for (int x = 1; x + 1 < size.x; x += step) {
        const std::size_t i = static_cast<std::size_t>(y) * size.x + x;
        const int square = y / cell * columns + x / cell;
        addPixel({x, y}, inside_[i], square);
        consistency({x, y}, labels_[i], inside_[i] != kNoRegion);
        if (inside_[i] == kNoRegion && labels_[i] != kNoRegion)
          silhouettes_[{labels_[i], square}].push_back({x, y});
      }
    for (const auto& [key, cellPixels] : cells_) compareCell(key, cellPixels);
    for (const auto& [region, sums] : pairs_) finish(region, sums);
    for (const RegionIndex region : markedIn_) ++regions_[static_cast<std::size_t>(region)].markedPairs;
    finishSilhouettes();
  }
  const PairConsistency& consistency() const { return consistency_; }

 private:
  struct PairSums {
    std::vector<CellSums> trials;
    std::vector<TrialOfPair> ofPair; ///< as trials
    CellSums found;
    std::size_t pixels = 0;
    double lengthPx = 0.0;
  };

  void addPixel(const glm::ivec2& pixel, RegionIndex region, int cell) {
    if (region == kNoRegion) return;
    if (isMasked(frames_.now, pixel)) return;
    const glm::vec2 given = frames_.now.motionAt(pixel.x, pixel.y);
    ++regions_[static_cast<std::size_t>(region)].seen;
    if (!isMotion(given)) {
      addMarked(pixel, region);
      return;
    }
    if (isLongerThanPicture(given, frames_.now.sizePx()))
      addOutside(given, regions_[static_cast<std::size_t>(region)]);
    const glm::vec2 place = placeOf(pixel, given);
    if (!isInPicture(place, frames_.now.sizePx()) || wasHidden(frames_, pixel, glm::ivec2(place))) return;
    if (frames_.before.isCovered(glm::ivec2(place))) return;
    RegionEvidence& out = regions_[static_cast<std::size_t>(region)];
    CellPixel seen{pixel, *frames_.now.luma.at(pixel.x, pixel.y), given, 0.0f};
    seen.error = std::abs(seen.luma - capture::betweenPixels(frames_.before.luma, place));
    ++out.pixels;
    out.givenPx += static_cast<double>(glm::length(given));
    if (given == glm::vec2(0.0f)) ++out.zero;
    float longest = glm::length(given);
    if (const auto camera = cameraMotionPx(frames_.now, pixel)) {
      ++out.cameraKnown;
      out.cameraPx += static_cast<double>(glm::length(*camera));
      if (isSameMotion(given, *camera)) ++out.ofCamera;
      addOffCamera(out, pixel, glm::dvec2(given - *camera));
      longest = std::max(longest, glm::length(*camera));
    }
    if (longest > out.example.lengthPx) out.example = exampleAt(frames_, trials_, pixel, longest);
    PairSums& pair = pairs_[region];
    ++pair.pixels;
    pair.lengthPx += static_cast<double>(glm::length(given));
    if (!hasDetail(frames_.now.luma, inside_, pixel.x, pixel.y)) return;
    ++out.textured;
    out.texturedError += static_cast<double>(seen.error);
    cells_[{region, cell}].push_back(seen);
  }

  void consistency(const glm::ivec2& pixel, RegionIndex region, bool isInside) {
    if (region == kNoRegion || isMasked(frames_.now, pixel)) return;
    if (isInside) addConsistency(consistency_, frames_, pixel);
    if (!isMotion(frames_.now.motionAt(pixel.x, pixel.y))) return;
    const std::size_t i = static_cast<std::size_t>(pixel.y) * frames_.now.sizePx().x + pixel.x;
    addSilhouetteConsistency(silhouetteConsistency_[region], frames_, pixel, labelsBefore_[i] != labels_[i]);
    if (isInside)
      addConsistency(regions_[static_cast<std::size_t>(region)].consistency, trials_, frames_, pixel);
  }

  /// Silhouettes say when motion was made only where it is not wrong everywhere.
  void finishSilhouettes() {
    if (2 * consistency_.off > consistency_.known) return;
    for (const auto& [region, silhouettes] : silhouetteConsistency_)
      addSilhouettes(silhouettes, regions_[static_cast<std::size_t>(region)].consistency);
  }

  static void addOutside(const glm::vec2& given, RegionEvidence& out) {
    if (out.outside++ == 0) out.mark = given;
    if (given == out.mark) ++out.marks;
  }

  void addOffCamera(RegionEvidence& out, const glm::ivec2& pixel, const glm::dvec2& offPx) const {
    const float distance = *frames_.now.depthView.at(pixel.x, pixel.y);
    out.offCamera.add(offPx);
    if (distance > 0.0f) out.offCameraByDistance.add(offPx * static_cast<double>(distance));
  }

  /// A pixel that is said to have no previous position: compared with that of what rests in the world.
  void addMarked(const glm::ivec2& pixel, RegionIndex region) {
    RegionEvidence& out = regions_[static_cast<std::size_t>(region)];
    ++out.marked;
    markedIn_.insert(region);
    const auto camera = cameraMotionPx(frames_.now, pixel);
    const glm::vec2 place = placeOf(pixel, camera.value_or(glm::vec2(0.0f)));
    if (!isInPicture(place, frames_.now.sizePx()) || !hasDetail(frames_.now.luma, inside_, pixel.x, pixel.y))
      return;
    ++out.markedTextured;
    out.markedPx += static_cast<double>(glm::length(camera.value_or(glm::vec2(0.0f))));
    out.markedError += static_cast<double>(std::abs(*frames_.now.luma.at(pixel.x, pixel.y) -
                                                    capture::betweenPixels(frames_.before.luma, place)));
  }

  glm::vec2 placeOf(const glm::ivec2& pixel, const glm::vec2& motionPx) const {
    return glm::vec2(pixel) + 0.5f - motionPx + jitterStep_;
  }

  void compareCell(const std::pair<RegionIndex, int>& key, const std::vector<CellPixel>& pixels) {
    const RegionIndex region = key.first;
    RegionEvidence& out = regions_[static_cast<std::size_t>(region)];
    PairSums& pair = pairs_[region];
    out.trials.resize(trials_.size());
    pair.trials.resize(trials_.size());
    pair.ofPair.resize(trials_.size());
    for (std::size_t t = 0; t < trials_.size(); ++t) {
      CellSums sums;
      for (const CellPixel& pixel : pixels) {
        const auto motionPx = trueMotion(trials_[t], frames_, pixel.pixel);
        ++sums.asked;
        if (motionPx) ++sums.said;
        if (!motionPx || glm::distance(*motionPx, pixel.given) <= kSameTrialPx) continue;
        const glm::vec2 place = placeOf(pixel.pixel, *motionPx);
        if (!isInPicture(place, frames_.now.sizePx())) continue;
        const bool isSeen = wasSeen(pixel.pixel, pixel.given) && wasSeen(pixel.pixel, *motionPx);
        // What a frame beside holds there is another motion where something uncovers what is behind it.
        if (!isSeen && madeOf(trials_[t].kind) == MotionMadeOf::OtherFrame) continue;
        const float left = sums.add(pixel, frames_.before.luma, place);
        if (isSeen) pair.ofPair[t].add(pixel.pixel, pixel.error, left);
      }
      addCell(out.trials[t], pair.trials[t], sums);
    }
    search(out, pair.found, pixels, silhouettes_[key]);
  }

  void search(RegionEvidence& out, CellSums& pair, const std::vector<CellPixel>& pixels,
              const std::vector<glm::ivec2>& silhouette) {
    double error = 0.0;
    bool isZero = true, isOfCamera = true;
    std::vector<SearchedPixel> searched;
    for (const CellPixel& pixel : pixels) {
      error += static_cast<double>(pixel.error);
      isZero = isZero && pixel.given == glm::vec2(0.0f);
      const auto camera = cameraMotionPx(frames_.now, pixel.pixel);
      isOfCamera = isOfCamera && camera && isSameMotion(pixel.given, *camera);
      searched.push_back({placeOf(pixel.pixel, glm::vec2(0.0f)), pixel.luma});
    }
    // What fits needs no search: nothing could be gained.
    if ((!isZero && !isOfCamera) || error < kFittingError * static_cast<double>(pixels.size())) return;
    const int reach = std::max(kLeastReachPx, frames_.now.sizePx().x / 60);
    const auto found = searchMotion(searched, frames_.before.luma, pixels.front().given, reach);
    if (!found || glm::distance(*found, pixels.front().given) <= 2.0f * kSameTrialPx) return;
    CellSums sums;
    for (const CellPixel& pixel : pixels) sums.add(pixel, frames_.before.luma, placeOf(pixel.pixel, *found));
    addCell(out.found, pair, sums);
    out.foundPx += static_cast<double>(sums.pixels) * glm::dvec2(*found);
    for (const glm::ivec2& pixel : silhouette) {
      if (!wasOfRegion(pixel, frames_.now.motionAt(pixel.x, pixel.y))) ++out.silhouetteGiven;
      if (!wasOfRegion(pixel, *found)) ++out.silhouetteFound;
    }
  }

  /// Whether a pixel that moves like this was of the same region in the frame before.
  bool wasOfRegion(const glm::ivec2& pixel, const glm::vec2& motionPx) const {
    const glm::ivec2 size = frames_.now.sizePx();
    const glm::vec2 place = placeOf(pixel, motionPx);
    if (!isInPicture(place, size)) return true; // nobody knows
    const glm::ivec2 before(place);
    return labelsBefore_[static_cast<std::size_t>(before.y) * size.x + before.x] ==
           labels_[static_cast<std::size_t>(pixel.y) * size.x + pixel.x];
  }

  /// Where no depth says what hid a pixel (see wasHidden()), what was of another region may have.
  bool wasSeen(const glm::ivec2& pixel, const glm::vec2& motionPx) const {
    const bool isDepthKnown = !frames_.now.depth.empty() && !frames_.before.depth.empty();
    return isDepthKnown || wasOfRegion(pixel, motionPx);
  }

  void finish(RegionIndex region, const PairSums& sums) {
    RegionEvidence& out = regions_[static_cast<std::size_t>(region)];
    ++out.pairs;
    for (std::size_t t = 0; t < sums.trials.size(); ++t) addPair(out.trials[t], sums.trials[t]);
    addPair(out.found, sums.found);
    out.traces.push_back(traceOf(sums));
  }

  PairTrace traceOf(const PairSums& sums) const {
    PairTrace out{frames_.now.frame, sums.pixels, sums.lengthPx};
    out.trials = sums.ofPair;
    for (std::size_t t = 0; t < sums.trials.size(); ++t) {
      const CellSums& trial = sums.trials[t];
      const bool isOfOther =
          trials_[t].kind == MotionKind::FrameLate || trials_[t].kind == MotionKind::FrameEarly;
      if (!isOfOther || trial.given - trial.tried <= out.given - out.tried) continue;
      out.compared = trial.pixels;
      out.given = trial.given;
      out.tried = trial.tried;
    }
    return out;
  }

  const FrameNeighbors& frames_;
  const std::vector<MotionTrial>& trials_;
  const std::vector<RegionIndex>&labels_, &labelsBefore_;
  std::vector<RegionEvidence>& regions_;
  glm::vec2 jitterStep_;
  std::vector<RegionIndex> inside_; ///< regions of the pixels well inside one
  CellPixels cells_;
  std::map<std::pair<RegionIndex, int>, std::vector<glm::ivec2>> silhouettes_; ///< pixels that are not
  std::map<RegionIndex, PairSums> pairs_;
  PairConsistency consistency_{frames_.now.frame};
  std::map<RegionIndex, ConsistencyEvidence> silhouetteConsistency_;
  std::set<RegionIndex> markedIn_; ///< regions with marks of no previous position
};

} // namespace

double EvenVectors::spread() const {
  const double length = count == 0 ? 0.0 : glm::length(sum) / static_cast<double>(count);
  if (!(length > 0.0)) return std::numeric_limits<double>::infinity();
  return std::sqrt(std::max(0.0, squares / static_cast<double>(count) - length * length)) / length;
}

bool isSameMotion(const glm::vec2& a, const glm::vec2& b) {
  return glm::distance(a, b) <= std::max(kSameMotionPx, 1e-3f * glm::length(b));
}

MotionEvidence::MotionEvidence(const glm::ivec2& sizePx) : trials_(motionTrials(sizePx)) {}

std::optional<WayShare> MotionEvidence::wayShare() const {
  constexpr std::size_t kEnoughPairs = 3;
  constexpr double kNearlyAll = 0.8, kSame = 0.03, kUneven = 0.1;
  if (wayShares_.size() < kEnoughPairs ||
      static_cast<double>(wayShares_.size()) < kNearlyAll * static_cast<double>(moved_))
    return {};
  const double middle = median(wayShares_);
  const auto spread = [](const std::vector<double>& values, double around) {
    std::vector<double> off;
    for (const double value : values) off.push_back(std::abs(value - around));
    return median(std::move(off));
  };
  if (spread(wayShares_, middle) > kSame) return {};
  const double moved = median(movedBy_);
  const bool isAside = 2 * aside_ > wayShares_.size();
  return WayShare{middle, !isAside || spread(movedBy_, moved) >= kUneven * moved};
}

void MotionEvidence::add(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels,
                         const std::vector<RegionIndex>& labelsBefore) {
  const auto highest = std::ranges::max_element(labels);
  const std::size_t count = highest == labels.end() ? 0 : static_cast<std::size_t>(*highest + 1);
  if (regions_.size() < count) regions_.resize(count);
  for (RegionEvidence& region : regions_) region.trials.resize(trials_.size());
  if (frames.others.beside) ++moved_;
  if (frames.others.wayShare) {
    wayShares_.push_back(*frames.others.wayShare);
    movedBy_.push_back(frames.others.movedByM);
    if (frames.others.isMovedAside) ++aside_;
  }
  PairEvidence pair(frames, trials_, labels, labelsBefore, regions_);
  pair.add();
  pairs_.push_back(pair.consistency());
  for (const auto& [region, outline] : outlinesOf(frames, trials_, labels, labelsBefore))
    regions_[static_cast<std::size_t>(region)].outline.add(outline);
  for (const auto& [region, middle] : centroids_.add(frames, trials_, labels, labelsBefore)) {
    RegionEvidence& evidence = regions_[static_cast<std::size_t>(region)];
    evidence.middle.add(middle);
    if (evidence.example.byTrial.empty()) evidence.example = exampleAt(frames, trials_, middle.pixel, 0.0f);
  }
}

} // namespace taa::doctor
