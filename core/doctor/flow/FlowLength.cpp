#include "core/doctor/flow/FlowLength.h"

#include "core/base/Median.h"
#include "core/capture/import/FrameSamples.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace taa::doctor {

namespace {

/// Of squares: so few may be longer, as the motion of what has just come into view.
constexpr double kFewLonger = 1e-3;
constexpr double kShortestFactor = 3.0; ///< less is no other unit
constexpr double kMostError = 0.05;     ///< of the factor: what is known worse is not told

/// One factor for each axis, by least squares over the squares that follow it.
class LengthFit {
 public:
  explicit LengthFit(const std::vector<FlowPair>& pairs) : pairs_(pairs) {
    constexpr int kRounds = 12;
    constexpr double kLeastScalePx = 0.05;
    for (const FlowPair& pair : pairs)
      for (const FlowSquare& square : pair.squares) all_.push_back(&square);
    for (int round = 0; round < kRounds; ++round) {
      solve();
      std::vector<double> off;
      for (const FlowSquare* square : all_) off.push_back(offPx(*square));
      scalePx_ = kTukeyMedians * std::max(kLeastScalePx, median(std::move(off)));
    }
  }

  std::optional<FittedLength> told() const {
    constexpr std::size_t kEnoughPairs = 3;
    FittedLength out;
    for (int axis = 0; axis < 2; ++axis) {
      out.error[axis] = errorOf(axis);
      if (saysOf_[axis] && out.error[axis] <= kMostError * std::abs(factor_[axis]))
        out.factor[axis] = factor_[axis];
    }
    const auto isLonger = [](const std::optional<double>& factor) {
      return factor && std::abs(*factor) >= kShortestFactor;
    };
    for (const FlowPair& pair : pairs_)
      if (!pair.squares.empty()) ++out.pairs;
    const bool isAny = isLonger(out.factor[0]) || isLonger(out.factor[1]);
    return isAny && out.pairs >= kEnoughPairs && isBetter(out) ? std::optional(out) : std::nullopt;
  }

 private:
  double offPx(const FlowSquare& square) const { return glm::distance(square.px, factor_ * square.given); }
  double weightOf(const FlowSquare& square) const {
    return scalePx_ > 0.0 ? tukeyWeight(offPx(square), scalePx_) : 1.0;
  }

  void solve() {
    glm::dvec2 squares(0.0), products(0.0);
    for (const FlowSquare* square : all_) {
      const double weight = weightOf(*square);
      squares += weight * square->given * square->given;
      products += weight * square->given * square->px;
    }
    // Of the squared lengths along the other axis: with less, an axis says nothing.
    constexpr double kLeastAxis = 1e-4;
    for (int axis = 0; axis < 2; ++axis) {
      saysOf_[axis] = squares[axis] > kLeastAxis * squares[1 - axis];
      factor_[axis] = saysOf_[axis] ? products[axis] / squares[axis] : 0.0;
    }
  }

  /// By the sum of each pair's own slope, as squares of one pair go wrong together.
  double errorOf(int axis) const {
    double squares = 0.0, spread = 0.0, count = 0.0;
    for (const FlowPair& pair : pairs_) {
      double slope = 0.0;
      for (const FlowSquare& square : pair.squares) {
        const double weight = weightOf(square), given = square.given[axis];
        squares += weight * given * given;
        slope += weight * given * (square.px[axis] - factor_[axis] * given);
      }
      spread += slope * slope;
      count += 1.0;
    }
    if (!(squares > 0.0) || count < 2.0) return std::numeric_limits<double>::infinity();
    return std::hypot(std::sqrt(spread * count / (count - 1.0)) / squares,
                      capture::kReadingError * factor_[axis]);
  }

  /// Adds what is left where squares move, and returns whether nearly all of them follow, and clearly.
  bool isBetter(FittedLength& out) const {
    constexpr double kMovesPx = 1.0, kFollowsPx = 0.5, kFollowsShare = 0.05, kNearlyAll = 0.8;
    constexpr double kClearlyBetter = 1.5, kLeastGain = 0.004; // of luma, in the mean
    constexpr std::size_t kEnough = 24;
    std::size_t followed = 0;
    for (const FlowSquare* square : all_) {
      const double moves = std::max(glm::length(factor_ * square->given), glm::length(square->px));
      if (moves < 0.5 * kMovesPx) continue;
      ++out.squares;
      out.movesPx += moves;
      out.given += std::isfinite(square->leftAsGiven) ? square->leftAsGiven : square->left;
      out.fitted += square->left;
      const double tolerancePx =
          std::max({kFollowsPx, kFollowsShare * moves, kChanceErrors * square->errorPx});
      if (offPx(*square) <= tolerancePx) ++followed;
    }
    if (out.squares < kEnough) return false;
    const auto count = static_cast<double>(out.squares);
    out.movesPx /= count;
    out.given /= count;
    out.fitted /= count;
    return out.movesPx >= kMovesPx && static_cast<double>(followed) >= kNearlyAll * count &&
           out.given >= kClearlyBetter * out.fitted && out.given - out.fitted >= kLeastGain;
  }

  const std::vector<FlowPair>& pairs_;
  std::vector<const FlowSquare*> all_;
  glm::dvec2 factor_{0.0};
  bool saysOf_[2] = {false, false}; ///< by axis
  double scalePx_ = 0.0;            ///< 0: all count alike
};

} // namespace

std::optional<FittedLength> fittedLength(const std::vector<FlowPair>& pairs) {
  std::size_t known = 0, longer = 0;
  for (const FlowPair& pair : pairs)
    for (const FlowSquare& square : pair.squares) {
      ++known;
      if (std::abs(square.given.x) >= 1.0 || std::abs(square.given.y) >= 1.0) ++longer;
    }
  if (known == 0 || static_cast<double>(longer) > kFewLonger * static_cast<double>(known)) return {};
  return LengthFit(pairs).told();
}

bool isRestRefuted(const std::vector<FlowPair>& pairs) {
  constexpr std::size_t kEnoughPairs = 5, kEnoughOfPair = 8;
  constexpr double kMovesPx = 0.1, kErrors = 4.0;
  std::vector<glm::dvec2> centroids;
  glm::dvec2 mean(0.0);
  for (const FlowPair& pair : pairs) {
    std::vector<double> x, y;
    for (const FlowSquare& square : pair.squares) {
      if (square.given != glm::dvec2(0.0)) return false;
      x.push_back(square.px.x);
      y.push_back(square.px.y);
    }
    if (x.size() < kEnoughOfPair) continue;
    centroids.emplace_back(median(std::move(x)), median(std::move(y)));
    mean += centroids.back();
  }
  if (centroids.size() < kEnoughPairs) return false;
  const auto count = static_cast<double>(centroids.size());
  mean /= count;
  double squares = 0.0;
  for (const glm::dvec2& middle : centroids) squares += glm::dot(middle - mean, middle - mean);
  const double error = std::sqrt(squares / (count * (count - 1.0)));
  return glm::length(mean) >= std::max(kMovesPx, kErrors * error);
}

std::optional<double> limitPx(const std::vector<FlowPair>& pairs, double tolerancePx) {
  constexpr double kAtLimit = 0.995, kBelow = 0.9, kLongerPx = 0.5, kAlong = 0.98, kVaries = 1.1;
  constexpr std::size_t kEnoughAt = 12, kEnoughBelow = 8;
  constexpr double kNearlyAll = 0.8, kMostLonger = 0.6; // some may be hardly longer
  double limit = 0.0;
  for (const FlowPair& pair : pairs)
    for (const FlowSquare& square : pair.squares) limit = std::max(limit, glm::length(square.given));
  std::size_t at = 0, longer = 0, below = 0, right = 0;
  std::vector<double> lengths;
  for (const FlowPair& pair : pairs)
    for (const FlowSquare& square : pair.squares) {
      const double given = glm::length(square.given), moved = glm::length(square.px);
      if (given >= kAtLimit * limit) {
        ++at;
        const bool isAlong = glm::dot(square.given, square.px) >= kAlong * given * moved;
        if (isAlong && moved >= given + kLongerPx) ++longer;
        lengths.push_back(moved);
      } else if (given <= kBelow * limit) {
        ++below;
        if (square.offPx() <= std::max(tolerancePx, kChanceErrors * square.errorPx)) ++right;
      }
    }
  const auto isShare = [](std::size_t part, std::size_t whole, double share) {
    return static_cast<double>(part) >= share * static_cast<double>(whole);
  };
  if (at < kEnoughAt || below < kEnoughBelow || !isShare(longer, at, kMostLonger) ||
      !isShare(right, below, kNearlyAll))
    return {};
  // What is as long everywhere may as well be a factor.
  const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
  return *most >= kVaries * *least ? std::optional(limit) : std::nullopt;
}

MotionTrial trialOf(const FittedLength& length, const glm::ivec2& sizePx) {
  constexpr double kWithinErrors = 3.0;
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
