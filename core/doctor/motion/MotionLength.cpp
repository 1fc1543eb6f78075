#include "core/doctor/motion/MotionLength.h"

#include "core/base/Median.h"
#include "core/capture/import/FrameSamples.h"
#include "core/doctor/frames/Detail.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace taa::doctor {

namespace {

constexpr double kSamplesPerPair = 4000.0;
constexpr std::size_t kEnoughFitted = 3, kMaxPairs = 12;
constexpr std::size_t kLeastPixels = 40; ///< of a pair
/// Of known motion: so little may be longer, as that of what has just come into view.
constexpr double kFewLonger = 1e-3;
/// Factors that are tried before the best are fitted: from the first on, each so many times the one before.
constexpr double kShortestFactor = 3.0, kNextFactor = 1.08;
constexpr std::size_t kFittedStarts = 6;
constexpr std::size_t kRoughMotionPixels = 2000; ///< by which these are found
constexpr int kFitSteps = 20;
/// Of the squared slopes of luma by one factor over those by the other: an axis with less says nothing.
constexpr double kLeastAxis = 1e-4;
// What a length has to be to be told.
constexpr std::size_t kEnoughMoving = 300;
constexpr double kFittedMovesPx = 1.0;     ///< in the mean of what moves
constexpr double kClearlyBetter = 1.5;     ///< of what the motion given leaves
constexpr double kLeastFittedGain = 0.004; ///< of luma, in the mean
constexpr double kWonShare = 0.8;          ///< of squares of the picture
constexpr double kBetterThanOther = 1.15;  ///< of what any other length leaves
constexpr double kOtherFactor = 1.3;       ///< which is another by so much
constexpr double kMostError = 0.05;        ///< of the factor
constexpr int kSquarePx = 32;
/// Of the factor: reading between pixels, and surfaces that come into view, pull a fit by as much, in all
/// pairs alike.
constexpr double kReadingError = 0.004;
/// The numbers of the picture's size are those of a fit that is so many standard errors beside.
constexpr double kWithinErrors = 3.0;

/// Of one axis: another length, or the other sign.
bool isAnother(double a, double b) {
  const double ratio = a / b;
  return ratio <= 1.0 / kOtherFactor || ratio >= kOtherFactor;
}

} // namespace

void LengthEvidence::add(const FrameNeighbors& frames) {
  const DoctorFrame& now = frames.now;
  if (now.motionPx.empty()) return;
  const glm::ivec2 size = now.sizePx();
  const double pixels = static_cast<double>(size.x) * size.y;
  const int step = std::max(1, static_cast<int>(std::sqrt(pixels / kSamplesPerPair)));
  Pair pair;
  for (int y = step / 2; y < size.y; y += step)
    for (int x = step / 2; x < size.x; x += step) {
      const glm::vec2 motion = now.motionAt(x, y);
      if (!isMotion(motion)) continue;
      ++known_;
      if (std::abs(motion.x) >= 1.0f || std::abs(motion.y) >= 1.0f) ++longer_;
      if (motion == glm::vec2(0.0f) || now.isCovered({x, y}) || !hasDetail(now.luma, x, y)) continue;
      const glm::vec2 place = glm::vec2(x, y) + 0.5f + frames.jitterStep();
      pair.pixels.push_back({glm::dvec2(place), glm::dvec2(motion), static_cast<double>(*now.luma.at(x, y))});
    }
  if (pairs_.size() >= kMaxPairs || pair.pixels.size() < kLeastPixels) return;
  if (static_cast<double>(longer_) > kFewLonger * static_cast<double>(known_)) return;
  pair.previousLuma = frames.before.luma;
  pairs_.push_back(std::move(pair));
}

/// The length of the motion of some pairs.
class LengthEvidence::Fitting {
 public:
  explicit Fitting(const std::vector<Pair>& pairs) : pairs_(pairs) {
    std::size_t pixels = 0;
    for (const Pair& pair : pairs) pixels += pair.pixels.size();
    roughStep_ = std::max<std::size_t>(1, pixels / kRoughMotionPixels);
  }

  std::optional<FittedLength> fit() {
    Start best = fitted(starts());
    if (!std::isfinite(best.left)) return {};
    FittedLength out;
    tellErrors(best.factor, out);
    tellGain(best.factor, out);
    leaveOpenAxes(best, out);
    const bool isMeasured = out.factor[0] || out.factor[1];
    if (!isMeasured || !isBetter_) return {};
    return out;
  }

 private:
  struct Start {
    glm::dvec2 factor{1.0};
    double left = std::numeric_limits<double>::infinity();
  };

  /// Sums of weighted least squares for both factors.
  struct Equations {
    glm::dmat2 squares{0.0};
    glm::dvec2 products{0.0};

    void add(const Equations& other) {
      squares += other.squares;
      products += other.products;
    }
  };

  static bool isInPicture(const glm::dvec2& place, const Image& luma) {
    return place.x >= 0.5 && place.y >= 0.5 && place.x <= luma.width - 0.5 && place.y <= luma.height - 0.5;
  }
  /// Nothing beyond the picture.
  static std::optional<double> difference(const Pixel& pixel, const Image& luma, const glm::dvec2& factor) {
    const glm::dvec2 place = pixel.place - factor * pixel.motionPx;
    if (!isInPicture(place, luma)) return {};
    return pixel.luma - static_cast<double>(capture::betweenPixels(luma, glm::vec2(place)));
  }

  /// Mean |difference| of each n-th pixel; what leads out of the picture leaves what the motion given does.
  double left(const glm::dvec2& factor, std::size_t step) const {
    double sum = 0.0;
    std::size_t count = 0;
    for (const Pair& pair : pairs_)
      for (std::size_t i = 0; i < pair.pixels.size(); i += step) {
        const Pixel& pixel = pair.pixels[i];
        const auto as = difference(pixel, pair.previousLuma, factor);
        const auto given = as ? as : difference(pixel, pair.previousLuma, glm::dvec2(1.0));
        if (!given) continue;
        sum += std::abs(*given);
        ++count;
      }
    return count == 0 ? std::numeric_limits<double>::infinity() : sum / static_cast<double>(count);
  }

  /// The lengths that leave least, of both signs, with axes of one unit and of the picture's sides.
  std::vector<Start> starts() {
    const glm::dvec2 size(pairs_.front().previousLuma.width, pairs_.front().previousLuma.height);
    const double most = 2.0 * std::max(size.x, size.y);
    for (const double aspect : {1.0, size.y / size.x})
      for (double factor = kShortestFactor; factor <= most; factor *= kNextFactor)
        for (const glm::dvec2& sign :
             {glm::dvec2(1.0), glm::dvec2(1.0, -1.0), glm::dvec2(-1.0, 1.0), glm::dvec2(-1.0)}) {
          const glm::dvec2 tried = sign * glm::dvec2(factor, aspect * factor);
          tried_.push_back({tried, left(tried, roughStep_)});
        }
    std::ranges::stable_sort(tried_, {}, &Start::left);
    return {tried_.begin(), tried_.begin() + std::min<std::ptrdiff_t>(kFittedStarts, std::ssize(tried_))};
  }

  /// For a step of `factor`, of one pair.
  Equations equationsOf(const Pair& pair, const glm::dvec2& factor) const {
    std::vector<double> all;
    for (const Pixel& pixel : pair.pixels)
      if (const auto d = difference(pixel, pair.previousLuma, factor)) all.push_back(std::abs(*d));
    Equations out;
    if (all.empty()) return out;
    const double scale = std::max(1e-4, kTukeyMedians * median(std::move(all)));
    for (const Pixel& pixel : pair.pixels) {
      const auto d = difference(pixel, pair.previousLuma, factor);
      const double weight = d ? tukeyWeight(*d, scale) : 0.0;
      if (weight == 0.0) continue;
      const glm::vec2 place(pixel.place - factor * pixel.motionPx);
      const auto at = [&](float x, float y) {
        return static_cast<double>(capture::betweenPixels(pair.previousLuma, place + glm::vec2(x, y)));
      };
      const glm::dvec2 slope(at(0.5f, 0.0f) - at(-0.5f, 0.0f), at(0.0f, 0.5f) - at(0.0f, -0.5f));
      const glm::dvec2 byFactor = -slope * pixel.motionPx;
      out.squares += weight * glm::outerProduct(byFactor, byFactor);
      out.products += weight * *d * byFactor;
    }
    return out;
  }

  /// The inverse for the axes that say something; 0 for the others.
  static glm::dmat2 inverseOf(const glm::dmat2& squares, bool (&isMeasured)[2]) {
    const double x = squares[0][0], y = squares[1][1];
    isMeasured[0] = x > kLeastAxis * y && x > 0.0;
    isMeasured[1] = y > kLeastAxis * x && y > 0.0;
    if (isMeasured[0] && isMeasured[1]) return glm::inverse(squares);
    glm::dmat2 out(0.0);
    if (isMeasured[0]) out[0][0] = 1.0 / x;
    if (isMeasured[1]) out[1][1] = 1.0 / y;
    return out;
  }

  Equations equationsAt(const glm::dvec2& factor) const {
    Equations sum;
    for (const Pair& pair : pairs_) sum.add(equationsOf(pair, factor));
    return sum;
  }

  Start fitted(const std::vector<Start>& from) const {
    constexpr double kConverged = 1e-5, kLongestStep = 0.1;
    Start best;
    for (Start start : from) {
      for (int i = 0; i < kFitSteps; ++i) {
        const Equations sum = equationsAt(start.factor);
        bool isMeasured[2];
        glm::dvec2 step = inverseOf(sum.squares, isMeasured) * sum.products;
        const glm::dvec2 longest = kLongestStep * glm::abs(start.factor);
        step = glm::clamp(step, -longest, longest);
        start.factor += step;
        if (glm::length(step / start.factor) < kConverged) break;
      }
      start.left = left(start.factor, 1);
      if (start.left < best.left) best = start;
    }
    return best;
  }

  /// Of each factor, by the sum of each pair's own slope, as pixels of one pair go wrong together.
  void tellErrors(const glm::dvec2& factor, FittedLength& out) const {
    std::vector<Equations> ofPairs;
    Equations sum;
    for (const Pair& pair : pairs_) {
      ofPairs.push_back(equationsOf(pair, factor));
      sum.add(ofPairs.back());
    }
    bool isMeasured[2];
    const glm::dmat2 inverse = inverseOf(sum.squares, isMeasured);
    glm::dmat2 spread(0.0);
    for (const Equations& one : ofPairs) spread += glm::outerProduct(one.products, one.products);
    const auto count = static_cast<double>(ofPairs.size());
    const glm::dmat2 variance = inverse * spread * inverse * (count / (count - 1.0));
    for (int axis = 0; axis < 2; ++axis) {
      const double error =
          std::hypot(std::sqrt(std::max(0.0, variance[axis][axis])), kReadingError * factor[axis]);
      if (!isMeasured[axis] || !(error <= kMostError * std::abs(factor[axis]))) continue;
      out.factor[axis] = factor[axis];
      out.error[axis] = error;
    }
    out.pairs = pairs_.size();
  }

  /// What the fit leaves of the pixels that move by it, and in how many squares that is less.
  void tellGain(const glm::dvec2& factor, FittedLength& out) {
    std::size_t squares = 0, won = 0;
    for (const Pair& pair : pairs_) {
      std::map<int, std::pair<double, double>> sums;
      for (const Pixel& pixel : pair.pixels) {
        const double moves = glm::length(factor * pixel.motionPx);
        const auto given = difference(pixel, pair.previousLuma, glm::dvec2(1.0));
        const auto fitted = difference(pixel, pair.previousLuma, factor);
        if (moves < 0.5 * kFittedMovesPx || !given || !fitted) continue;
        ++out.pixels;
        out.movesPx += moves;
        out.given += std::abs(*given);
        out.fitted += std::abs(*fitted);
        const glm::ivec2 at = glm::ivec2(pixel.place) / kSquarePx;
        auto& [of, by] = sums[at.y * (pair.previousLuma.width / kSquarePx + 1) + at.x];
        of += std::abs(*given);
        by += std::abs(*fitted);
      }
      for (const auto& [square, sum] : sums) {
        ++squares;
        if (sum.second < sum.first) ++won;
      }
    }
    const auto count = static_cast<double>(std::max<std::size_t>(1, out.pixels));
    out.movesPx /= count;
    out.given /= count;
    out.fitted /= count;
    isBetter_ = out.pixels >= kEnoughMoving && out.movesPx >= kFittedMovesPx &&
                out.given >= kClearlyBetter * out.fitted && out.given - out.fitted >= kLeastFittedGain &&
                static_cast<double>(won) >= kWonShare * static_cast<double>(squares);
  }

  /// An axis along which another length leaves nearly as little is not measured: the sign of y where little
  /// moves up or down.
  void leaveOpenAxes(const Start& best, FittedLength& out) const {
    const double least = kBetterThanOther * left(best.factor, roughStep_);
    bool isOpen[2] = {false, false};
    for (const Start& other : tried_)
      for (int axis = 0; axis < 2 && other.left < least; ++axis)
        isOpen[axis] = isOpen[axis] || isAnother(other.factor[axis], best.factor[axis]);
    for (int axis = 0; axis < 2; ++axis)
      if (isOpen[axis]) out.factor[axis].reset();
  }

  const std::vector<Pair>& pairs_;
  std::size_t roughStep_ = 1;
  std::vector<Start> tried_;
  bool isBetter_ = false;
};

std::optional<FittedLength> LengthEvidence::fit() const {
  const bool isShort = known_ > 0 && static_cast<double>(longer_) <= kFewLonger * static_cast<double>(known_);
  if (!isShort || pairs_.size() < kEnoughFitted) return {};
  return Fitting(pairs_).fit();
}

MotionTrial trialOf(const FittedLength& length, const glm::ivec2& sizePx) {
  const auto isWithin = [&](const glm::dvec2& unit) {
    for (int axis = 0; axis < 2; ++axis) {
      const auto factor = length.factor[axis];
      if (factor && std::abs(std::abs(*factor) - unit[axis]) > kWithinErrors * length.error[axis])
        return false;
    }
    return true;
  };
  const auto signOf = [&](int axis) { return length.factor[axis].value_or(1.0) < 0.0 ? -1.0 : 1.0; };
  const glm::dvec2 signs(signOf(0), signOf(1)), size(sizePx);
  for (const bool isDevice : {false, true}) {
    const glm::dvec2 unit = isDevice ? 0.5 * size : size;
    if (isWithin(unit)) return {MotionKind::OtherUnit, glm::vec2(signs * unit), isDevice};
  }
  const double other = length.factor[0] ? std::abs(*length.factor[0]) : std::abs(*length.factor[1]);
  return {MotionKind::Scaled,
          {static_cast<float>(length.factor[0].value_or(other)),
           static_cast<float>(length.factor[1].value_or(other))}};
}

} // namespace taa::doctor
