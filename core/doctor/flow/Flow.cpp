#include "core/doctor/flow/Flow.h"

#include "core/base/Median.h"
#include "core/capture/import/FrameSamples.h"
#include "core/doctor/frames/RegionCentroids.h"
#include "core/doctor/motion/MotionEvidence.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace taa::doctor {

namespace {

constexpr int kSquarePx = 16, kHalfSquarePx = kSquarePx / 2;
/// Squares overlap, so that small things have some.
constexpr int kStepPx = 8, kRingPx = 2;
/// Pictures that are so much smaller say roughly where to look.
constexpr int kCoarse = 4, kCoarseHalf = 4;
constexpr int kLeastCoarseReach = 6, kCoarseReachShare = 64; ///< coarse pixels; of the picture's width
constexpr std::size_t kCoarseStarts = 4;
constexpr int kReachPx = 2; ///< around each place that is looked at
constexpr std::size_t kMaxOfRegion = 64;
/// Of luma per px, squared, in the mean along the axis with less detail: 1 % of noise is a tenth of a pixel.
constexpr double kLeastDetail = 2e-5;
/// Of a square's detail: what is left of it where the frame before shows the same.
constexpr double kSameShare = 0.35;
/// Neighbors are alike, for light that is compared is smoothed: so many pixels say as much as one.
constexpr double kPixelsAlike = 4.0;
/// Of the picture's width: motion that is longer is none that anything has.
constexpr double kNearShare = 1.0 / 16.0;
constexpr double kFarthestErrorPx = 0.2;
/// Of what is left elsewhere, and of the square's contrast: pictures read between pixels are softer.
constexpr double kAsGood = 1.5, kAsGoodContrast = 0.1;
/// As given against as measured: what aliases jumps from frame to frame as well, but not so clearly.
constexpr double kClearlyMore = 3.0;
constexpr double kLeastLuma = 0.004;
constexpr double kRepeatsShare = 0.7;

struct Pixel {
  glm::vec2 place{0.0f};  ///< its center
  glm::vec2 motion{0.0f}; ///< given there less that given in the middle of the square
  float luma = 0.0f;
};

struct Square {
  glm::ivec2 pixel{0};
  RegionIndex region = kNoRegion;
  double detail = 0.0;   ///< see kLeastDetail
  double contrast = 0.0; ///< mean |luma − its mean|
};

Image reduced(const Image& luma) {
  Image out(std::max(1, luma.width / kCoarse), std::max(1, luma.height / kCoarse), 1);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      float sum = 0.0f;
      for (int v = 0; v < kCoarse; ++v)
        for (int u = 0; u < kCoarse; ++u)
          sum +=
              *luma.at(std::min(x * kCoarse + u, luma.width - 1), std::min(y * kCoarse + v, luma.height - 1));
      *out.at(x, y) = sum / static_cast<float>(kCoarse * kCoarse);
    }
  return out;
}

/// Whether all of a square is of one region, with what light is smoothed from around it, and motion is known
/// in all of it: a silhouette beside it moves as something else does.
bool isOfOneRegion(const DoctorFrame& frame, const std::vector<RegionIndex>& labels,
                   const glm::ivec2& first) {
  const auto at = [&](int x, int y) { return labels[static_cast<std::size_t>(y) * frame.luma.width + x]; };
  const RegionIndex region = at(first.x, first.y);
  if (region == kNoRegion) return false;
  for (int y = first.y - kRingPx; y < first.y + kSquarePx + kRingPx; ++y)
    for (int x = first.x - kRingPx; x < first.x + kSquarePx + kRingPx; ++x)
      if (at(x, y) != region) return false;
  for (int y = first.y; y < first.y + kSquarePx; ++y)
    for (int x = first.x; x < first.x + kSquarePx; ++x)
      if (isMasked(frame, {x, y}) || !isMotion(frame.motionAt(x, y))) return false;
  return true;
}

Square measured(const Image& luma, const glm::ivec2& first, RegionIndex region) {
  double xx = 0.0, xy = 0.0, yy = 0.0, mean = 0.0;
  for (int y = first.y; y < first.y + kSquarePx; ++y)
    for (int x = first.x; x < first.x + kSquarePx; ++x) {
      const double dx = 0.5 * static_cast<double>(*luma.at(x + 1, y) - *luma.at(x - 1, y));
      const double dy = 0.5 * static_cast<double>(*luma.at(x, y + 1) - *luma.at(x, y - 1));
      xx += dx * dx;
      xy += dx * dy;
      yy += dy * dy;
      mean += static_cast<double>(*luma.at(x, y));
    }
  constexpr double kPixels = static_cast<double>(kSquarePx) * kSquarePx;
  mean /= kPixels;
  Square out{first + kHalfSquarePx, region};
  const double half = 0.5 * (xx + yy), root = std::sqrt(std::max(0.0, half * half - (xx * yy - xy * xy)));
  out.detail = (half - root) / kPixels;
  for (int y = first.y; y < first.y + kSquarePx; ++y)
    for (int x = first.x; x < first.x + kSquarePx; ++x)
      out.contrast += std::abs(static_cast<double>(*luma.at(x, y)) - mean) / kPixels;
  return out;
}

/// Of a region: squares with detail, evenly of all that it has, and what share of all squares that is.
struct RegionSquares {
  std::vector<Square> squares;
  std::size_t all = 0, detailed = 0;
};

std::map<RegionIndex, RegionSquares> squaresOf(const DoctorFrame& frame,
                                               const std::vector<RegionIndex>& labels) {
  std::map<RegionIndex, RegionSquares> out;
  for (int y = kRingPx; y + kSquarePx + kRingPx <= frame.luma.height; y += kStepPx)
    for (int x = kRingPx; x + kSquarePx + kRingPx <= frame.luma.width; x += kStepPx) {
      if (!isOfOneRegion(frame, labels, {x, y})) continue;
      const RegionIndex region = labels[static_cast<std::size_t>(y) * frame.luma.width + x];
      const Square square = measured(frame.luma, {x, y}, region);
      RegionSquares& of = out[region];
      ++of.all;
      if (square.detail >= kLeastDetail) of.squares.push_back(square);
    }
  const std::size_t most = std::max<std::size_t>(
      4, std::min(kMaxOfRegion, kMaxFlowSquares / std::max<std::size_t>(1, out.size())));
  for (auto& [region, of] : out) {
    of.detailed = of.squares.size();
    const std::size_t count = std::min(most, of.detailed);
    std::vector<Square> chosen;
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(of.squares[i * of.detailed / count]);
    of.squares = std::move(chosen);
  }
  return out;
}

std::vector<Pixel> pixelsOf(const DoctorFrame& frame, const glm::ivec2& middle) {
  const glm::vec2 given = frame.motionAt(middle.x, middle.y);
  std::vector<Pixel> out;
  for (int y = middle.y - kHalfSquarePx; y < middle.y + kHalfSquarePx; ++y)
    for (int x = middle.x - kHalfSquarePx; x < middle.x + kHalfSquarePx; ++x) {
      const glm::vec2 motion = frame.motionAt(x, y);
      out.push_back({glm::vec2(x, y) + 0.5f, isMotion(motion) ? motion - given : glm::vec2(0.0f),
                     *frame.luma.at(x, y)});
    }
  return out;
}

/// Whether something nearer lay where some of a square is said to have been: it cannot be found then.
bool wasPartlyHidden(const FrameNeighbors& frames, const glm::ivec2& middle) {
  constexpr int kEvery = 3;
  const glm::ivec2 size = frames.now.sizePx();
  for (int y = middle.y - kHalfSquarePx; y < middle.y + kHalfSquarePx; y += kEvery)
    for (int x = middle.x - kHalfSquarePx; x < middle.x + kHalfSquarePx; x += kEvery) {
      const glm::ivec2 before(
          glm::floor(glm::vec2(x, y) + 0.5f - frames.now.motionAt(x, y) + frames.jitterStep()));
      const bool isInside = before.x >= 0 && before.y >= 0 && before.x < size.x && before.y < size.y;
      if (isInside && wasHidden(frames, {x, y}, before)) return true;
    }
  return false;
}

/// Where the pixels of a square were, displaced by one vector: alike, or each by how its motion differs from
/// that in the middle.
struct Warp {
  const std::vector<Pixel>& pixels;
  const Image& before;
  bool isVarying = false;

  glm::vec2 placeOf(const Pixel& pixel, const glm::dvec2& px) const {
    return pixel.place - glm::vec2(px) - (isVarying ? pixel.motion : glm::vec2(0.0f));
  }
  /// Mean of |difference| over every n-th pixel; infinite where one leads out of the picture.
  double left(const glm::dvec2& px, std::size_t step = 1) const {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pixels.size(); i += step, ++count) {
      const glm::vec2 place = placeOf(pixels[i], px);
      if (!isInPicture(place, {before.width, before.height})) return std::numeric_limits<double>::infinity();
      sum += static_cast<double>(std::abs(pixels[i].luma - capture::betweenPixels(before, place)));
    }
    return sum / static_cast<double>(count);
  }
};

struct Found {
  glm::dvec2 px{0.0};
  double left = std::numeric_limits<double>::infinity();
  double errorPx = std::numeric_limits<double>::infinity();
};

/// Least squares from a place that is nearly right.
Found refined(const Warp& warp, glm::dvec2 px) {
  constexpr int kSteps = 8;
  constexpr double kConvergedPx = 1e-3, kFarthestPx = 1.5;
  const glm::dvec2 start = px;
  glm::dmat2 normal(0.0);
  double squares = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    normal = glm::dmat2(0.0);
    squares = 0.0;
    glm::dvec2 sum(0.0);
    for (const Pixel& pixel : warp.pixels) {
      const glm::vec2 place = warp.placeOf(pixel, px);
      const auto at = [&](float x, float y) {
        return static_cast<double>(capture::betweenPixels(warp.before, place + glm::vec2(x, y)));
      };
      const glm::dvec2 slope(at(0.5f, 0.0f) - at(-0.5f, 0.0f), at(0.0f, 0.5f) - at(0.0f, -0.5f));
      const double difference = static_cast<double>(pixel.luma) - at(0.0f, 0.0f);
      normal += glm::outerProduct(slope, slope);
      sum += slope * difference;
      squares += difference * difference;
    }
    const double determinant = glm::determinant(normal);
    if (!(determinant > 0.0)) return {};
    const glm::dvec2 further = glm::inverse(normal) * sum;
    px -= further;
    if (!(glm::distance(px, start) <= kFarthestPx)) return {};
    if (glm::length(further) < kConvergedPx) break;
  }
  const double half = 0.5 * (normal[0][0] + normal[1][1]);
  const double least = half - std::sqrt(std::max(0.0, half * half - glm::determinant(normal)));
  const double variance = squares / static_cast<double>(warp.pixels.size());
  return {px, warp.left(px), std::sqrt(variance * kPixelsAlike / std::max(least, 1e-12))};
}

/// Displacements, px, at which small pictures fit best around the square.
std::vector<glm::dvec2> roughly(const Image& now, const Image& before, const glm::ivec2& middle, int reach) {
  const glm::ivec2 center = middle / kCoarse;
  std::vector<std::pair<float, glm::ivec2>> all;
  for (int dy = -reach; dy <= reach; ++dy)
    for (int dx = -reach; dx <= reach; ++dx) {
      float sum = 0.0f;
      int count = 0;
      for (int y = std::max(0, center.y - kCoarseHalf); y < std::min(now.height, center.y + kCoarseHalf); ++y)
        for (int x = std::max(0, center.x - kCoarseHalf); x < std::min(now.width, center.x + kCoarseHalf);
             ++x) {
          if (x - dx < 0 || y - dy < 0 || x - dx >= before.width || y - dy >= before.height) continue;
          sum += std::abs(*now.at(x, y) - *before.at(x - dx, y - dy));
          ++count;
        }
      if (count >= 2 * kCoarseHalf * kCoarseHalf)
        all.emplace_back(sum / static_cast<float>(count), glm::ivec2(dx, dy));
    }
  std::ranges::sort(all, {}, [](const auto& one) { return one.first; });
  std::vector<glm::dvec2> out;
  for (const auto& [left, at] : all) {
    const glm::dvec2 px = glm::dvec2(at) * static_cast<double>(kCoarse);
    if (std::ranges::any_of(
            out, [&](const glm::dvec2& known) { return glm::distance(known, px) < 1.5 * kCoarse; }))
      continue;
    out.push_back(px);
    if (out.size() == kCoarseStarts) break;
  }
  return out;
}

/// Best of whole pixels around a place.
Found nearby(const Warp& warp, const glm::dvec2& around, int reach) {
  constexpr std::size_t kEvery = 3;
  Found best;
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x) {
      const glm::dvec2 px = around + glm::dvec2(x, y);
      if (const double left = warp.left(px, kEvery); left < best.left) best = {px, left};
    }
  return best;
}

void keepBetter(const Found& other, Found& best) {
  if (other.left < best.left) best = other;
}

/// A pair of frames, square by square.
class FlowMeter {
 public:
  explicit FlowMeter(const FrameNeighbors& frames)
      : frames_(frames), coarseNow_(reduced(frames.now.luma)), coarseBefore_(reduced(frames.before.luma)),
        reach_(std::max(kLeastCoarseReach, frames.now.luma.width / kCoarseReachShare)),
        step_(frames.jitterStep()) {}

  /// Whether a square that moves as given was in the frame before: it may have come from beyond the border,
  /// or from behind something, where nothing tells it from what looks alike.
  bool canBeThere(const Square& square) const {
    if (wasPartlyHidden(frames_, square.pixel)) return false;
    const std::vector<Pixel> pixels = pixelsOf(frames_.now, square.pixel);
    const glm::dvec2 given = givenAt(square);
    return std::isfinite(Warp{pixels, frames_.before.luma, true}.left(given - step_)) ||
           glm::length(given) > frames_.now.luma.width * kNearShare;
  }
  /// `last`: what the square of its region before it was displaced by. Nothing: pictures do not say.
  std::optional<FlowSquare> measure(const Square& square, const std::optional<glm::dvec2>& last) const {
    const std::vector<Pixel> pixels = pixelsOf(frames_.now, square.pixel);
    const Warp alike{pixels, frames_.before.luma, false}, varying{pixels, frames_.before.luma, true};
    const glm::dvec2 given = givenAt(square);
    const auto camera = cameraMotionPx(frames_.now, square.pixel);
    std::vector<glm::dvec2> starts = roughly(coarseNow_, coarseBefore_, square.pixel, reach_);
    starts.push_back(given - step_);
    starts.push_back(-step_);
    if (camera) starts.push_back(glm::dvec2(*camera) - step_);
    if (last) starts.push_back(*last);
    Found rough;
    for (const glm::dvec2& start : starts) keepBetter(nearby(alike, start, kReachPx), rough);
    Found best;
    if (std::isfinite(rough.left)) best = refined(alike, rough.px);
    // Motion that changes over the square, as that of what turns and of a floor does, is followed by what is
    // given where that is right but for one vector.
    const Found asGiven = refined(varying, given - step_);
    keepBetter(asGiven, best);
    // What repeats fits at many places: then the one that is stated is as good as any other.
    if (asGiven.left <= kAsGood * best.left + kAsGoodContrast * square.contrast) best = asGiven;
    if (!(best.left <= kSameShare * square.contrast) || !(best.errorPx <= kFarthestErrorPx)) return {};
    FlowSquare out;
    out.pixel = square.pixel;
    out.region = square.region;
    out.px = best.px + step_;
    out.errorPx = best.errorPx;
    out.given = given;
    out.left = best.left;
    out.leftAsGiven = varying.left(given - step_);
    const double apart = Warp{pixels, frames_.now.luma, false}.left(given - best.px - step_);
    out.apart = std::isfinite(apart) ? apart : out.leftAsGiven;
    if (camera) out.camera = glm::dvec2(*camera);
    return out;
  }
  glm::dvec2 step() const { return step_; }

 private:
  glm::dvec2 givenAt(const Square& square) const {
    return glm::dvec2(frames_.now.motionAt(square.pixel.x, square.pixel.y));
  }

  const FrameNeighbors& frames_;
  Image coarseNow_, coarseBefore_;
  int reach_;
  glm::dvec2 step_;
};

std::vector<glm::vec2> underTrials(const std::vector<MotionTrial>& trials, const FrameNeighbors& frames,
                                   const glm::ivec2& pixel) {
  std::vector<glm::vec2> out;
  for (const MotionTrial& trial : trials)
    out.push_back(
        trueMotion(trial, frames, pixel).value_or(glm::vec2(std::numeric_limits<float>::quiet_NaN())));
  return out;
}

std::map<RegionIndex, RegionMeans> meansOf(const DoctorFrame& frame, const std::vector<RegionIndex>& labels) {
  constexpr int kCameraStep = 3; // of pixels whose camera's motion is made
  struct Sum {
    glm::dvec2 given{0.0}, camera{0.0};
    double distance = 0.0, moving = 0.0, asked = 0.0, known = 0.0;
  };
  const glm::ivec2 size = frame.sizePx();
  const std::vector<RegionMiddle> centroids = centroidsOf(labels, size);
  std::vector<Sum> sums(centroids.size());
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const RegionIndex region = labels[static_cast<std::size_t>(y) * size.x + x];
      const glm::vec2 motion = frame.motionAt(x, y);
      if (region == kNoRegion || !isMotion(motion)) continue;
      Sum& sum = sums[static_cast<std::size_t>(region)];
      sum.given += glm::dvec2(motion);
      sum.moving += 1.0;
      if (!frame.depthView.empty()) sum.distance += static_cast<double>(*frame.depthView.at(x, y));
      if (x % kCameraStep != 0 || y % kCameraStep != 0) continue;
      sum.asked += 1.0;
      const auto camera = cameraMotionPx(frame, {x, y});
      if (!camera) continue;
      sum.camera += glm::dvec2(*camera);
      sum.known += 1.0;
    }
  std::map<RegionIndex, RegionMeans> out;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Sum& sum = sums[i];
    if (!(sum.moving > 0.0)) continue;
    RegionMeans& means = out[static_cast<RegionIndex>(i)];
    means.middle = centroids[i].place();
    means.isWhole = !centroids[i].isCut;
    means.given = sum.given / sum.moving;
    means.distance = sum.distance / sum.moving;
    if (sum.known > 0.0 && sum.known == sum.asked) means.camera = sum.camera / sum.known;
  }
  return out;
}

} // namespace

bool FlowSquare::isOfCamera() const {
  return camera && isSameMotion(glm::vec2(given), glm::vec2(*camera));
}

double FlowSquare::offPx() const {
  return glm::distance(px, given);
}

bool FlowSquare::refutesGiven(double tolerancePx) const {
  if (isOfCamera()) return false;
  // What repeats fits elsewhere as well.
  if (std::isfinite(leftAsGiven) && apart < kRepeatsShare * leftAsGiven) return false;
  return offPx() > std::max(tolerancePx, kChanceErrors * errorPx) && leftAsGiven >= kClearlyMore * left &&
         leftAsGiven - left >= kLeastLuma;
}

FlowPair measureFlow(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels,
                     const std::vector<MotionTrial>& trials) {
  FlowPair out{frames.now.frame, {}, {}, {}, 0};
  if (frames.now.motionPx.empty() || frames.before.luma.width != frames.now.luma.width) return out;
  out.means = meansOf(frames.now, labels);
  const FlowMeter meter(frames);
  for (const auto& [region, of] : squaresOf(frames.now, labels)) {
    std::optional<glm::dvec2> last;
    std::size_t asked = 0, said = 0;
    for (const Square& square : of.squares) {
      if (!meter.canBeThere(square)) continue;
      ++asked;
      const auto measured = meter.measure(square, last);
      if (!measured) continue;
      ++said;
      last = measured->px - meter.step();
      out.squares.push_back(*measured);
      out.squares.back().byTrial = underTrials(trials, frames, square.pixel);
    }
    out.asked += asked;
    if (asked > 0)
      out.said[region] = static_cast<double>(of.detailed) * static_cast<double>(said) /
                         (static_cast<double>(of.all) * static_cast<double>(asked));
  }
  return out;
}

} // namespace taa::doctor
