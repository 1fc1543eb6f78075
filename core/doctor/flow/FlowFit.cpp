#include "core/doctor/flow/FlowFit.h"

#include "core/base/Median.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace taa::doctor {

namespace {

/// How many numbers say what is made of the motion given.
enum class FlowModel : std::uint8_t { Factor, Factors, FactorsAndOffset };

/// x and y of what is made of a motion are these, by (x, y, 1).
struct FlowLine {
  glm::dvec3 x{0.0}, y{0.0};
  glm::dvec3 errorShares{0.0}; ///< of the root of the variance: standard errors

  glm::dvec2 at(const glm::dvec2& given) const {
    const glm::dvec3 row(given, 1.0);
    return {glm::dot(x, row), glm::dot(y, row)};
  }
};

/// Whether the motions given lie along no line, through zero or not: along one, two factors make anything of
/// them.
bool areSpread(const std::vector<const FlowSquare*>& squares) {
  constexpr double kLeastSpread = 0.05; // 1 less the squared correlation of x and y
  glm::dvec2 mean(0.0);
  for (const FlowSquare* square : squares) mean += square->given / static_cast<double>(squares.size());
  glm::dmat2 spread(0.0);
  for (const FlowSquare* square : squares)
    spread += glm::outerProduct(square->given - mean, square->given - mean);
  return glm::determinant(spread) > kLeastSpread * spread[0][0] * spread[1][1];
}

/// Weighted least squares. Nothing where what is given does not tell all of the numbers.
std::optional<FlowLine> solve(const std::vector<const FlowSquare*>& squares,
                              const std::vector<double>& weights, FlowModel model) {
  constexpr double kTellsApart = 1e-6;
  glm::dmat3 normal(0.0);
  glm::dvec3 x(0.0), y(0.0);
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const glm::dvec3 row(squares[i]->given, model == FlowModel::FactorsAndOffset ? 1.0 : 0.0);
    normal += weights[i] * glm::outerProduct(row, row);
    x += weights[i] * squares[i]->px.x * row;
    y += weights[i] * squares[i]->px.y * row;
  }
  if (model == FlowModel::Factor) {
    const double length = normal[0][0] + normal[1][1];
    if (!(length > 0.0)) return {};
    const double factor = (x.x + y.y) / length;
    return FlowLine{{factor, 0.0, 0.0}, {0.0, factor, 0.0}, glm::dvec3(1.0 / std::sqrt(length))};
  }
  if (model == FlowModel::Factors) normal[2][2] = 1.0;
  if (!(glm::determinant(normal) > kTellsApart * normal[0][0] * normal[1][1] * normal[2][2])) return {};
  const glm::dmat3 inverse = glm::inverse(normal);
  return FlowLine{inverse * x,
                  inverse * y,
                  {std::sqrt(inverse[0][0]), std::sqrt(inverse[1][1]), std::sqrt(inverse[2][2])}};
}

std::optional<FlowFit> fitBy(const std::vector<const FlowSquare*>& squares, FlowModel model,
                             double tolerancePx) {
  constexpr int kRounds = 12;
  constexpr double kLeastScalePx = 0.05;
  std::vector<double> weights(squares.size(), 1.0), off(squares.size());
  std::optional<FlowLine> found;
  for (int round = 0; round < kRounds; ++round) {
    found = solve(squares, weights, model);
    if (!found) return {};
    for (std::size_t i = 0; i < squares.size(); ++i)
      off[i] = glm::distance(squares[i]->px, found->at(squares[i]->given));
    const double scalePx = std::max(kLeastScalePx, median(off));
    for (std::size_t i = 0; i < squares.size(); ++i)
      weights[i] = tukeyWeight(off[i], kTukeyMedians * scalePx);
  }
  FlowFit out;
  out.factors = glm::dmat2(glm::dvec2(found->x.x, found->y.x), glm::dvec2(found->x.y, found->y.y));
  double squared = 0.0, weight = 0.0, varied = 0.0;
  glm::dvec2 mean(0.0);
  for (std::size_t i = 0; i < squares.size(); ++i) {
    mean += weights[i] * squares[i]->px;
    weight += weights[i];
  }
  mean /= std::max(1.0, weight);
  for (std::size_t i = 0; i < squares.size(); ++i) {
    squared += 0.5 * weights[i] * off[i] * off[i];
    varied += 0.5 * weights[i] * glm::dot(squares[i]->px - mean, squares[i]->px - mean);
    if (off[i] <= std::max(tolerancePx, kChanceErrors * squares[i]->errorPx)) ++out.followed;
  }
  out.squares = squares.size();
  out.explainedShare = varied > 0.0 ? 1.0 - squared / varied : 0.0;
  const glm::dvec3 errors = std::sqrt(squared / std::max(1.0, weight - 3.0)) * found->errorShares;
  out.factorErrors = glm::dmat2(glm::dvec2(errors.x), glm::dvec2(errors.y));
  if (model != FlowModel::FactorsAndOffset) return out;
  out.offsetPx = {found->x.z, found->y.z};
  out.offsetErrorsPx = glm::dvec2(errors.z);
  return out;
}

bool isNear(double value, double expected, double error) {
  constexpr double kFitErrors = 3.0, kShare = 0.02;
  return std::abs(value - expected) <=
         std::max(kFitErrors * error, kShare * std::max(1.0, std::abs(expected)));
}

/// Whether the numbers of a fit are those, within its errors.
bool areNear(const FlowFit& fit, const glm::dmat2& factors) {
  for (int column = 0; column < 2; ++column)
    for (int row = 0; row < 2; ++row)
      if (!isNear(fit.factors[column][row], factors[column][row], fit.factorErrors[column][row]))
        return false;
  return true;
}

} // namespace

bool FlowFit::isGood() const {
  constexpr double kNearlyAll = 0.8, kKnownTo = 0.05;
  double largest = 0.0, error = 0.0;
  for (int column = 0; column < 2; ++column)
    for (int row = 0; row < 2; ++row) {
      largest = std::max(largest, std::abs(factors[column][row]));
      error = std::max(error, factorErrors[column][row]);
    }
  return error <= kKnownTo * largest &&
         static_cast<double>(followed) >= kNearlyAll * static_cast<double>(squares);
}

std::optional<FlowFit> fitFactor(const std::vector<const FlowSquare*>& squares, double tolerancePx,
                                 std::size_t enough) {
  if (squares.size() < enough) return {};
  return fitBy(squares, FlowModel::Factor, tolerancePx);
}

std::optional<FlowFit> fitFlow(const std::vector<const FlowSquare*>& squares, bool isThroughZero,
                               double tolerancePx, std::size_t enough) {
  if (squares.size() < enough) return {};
  if (!areSpread(squares)) return isThroughZero ? fitFactor(squares, tolerancePx, enough) : std::nullopt;
  return fitBy(squares, isThroughZero ? FlowModel::Factors : FlowModel::FactorsAndOffset, tolerancePx);
}

bool isAlongAxes(const FlowFit& fit) {
  const double scale = std::max(std::abs(fit.factors[0][0]), std::abs(fit.factors[1][1]));
  return std::abs(fit.factors[0][1]) <= std::max(3.0 * fit.factorErrors[0][1], 0.02 * scale) &&
         std::abs(fit.factors[1][0]) <= std::max(3.0 * fit.factorErrors[1][0], 0.02 * scale);
}

bool isTurned(const FlowFit& fit) {
  constexpr double kAcross = 0.2, kAsLong = 2.5; // pictures may be twice as wide as high, as units are
  const double x = glm::length(fit.factors[0]), y = glm::length(fit.factors[1]);
  return std::abs(glm::dot(fit.factors[0], fit.factors[1])) <= kAcross * x * y && x <= kAsLong * y &&
         y <= kAsLong * x;
}

bool hasOffset(const FlowFit& fit) {
  constexpr double kOffsetPx = 0.25;
  return std::abs(fit.offsetPx.x) > std::max(kOffsetPx, 3.0 * fit.offsetErrorsPx.x) ||
         std::abs(fit.offsetPx.y) > std::max(kOffsetPx, 3.0 * fit.offsetErrorsPx.y);
}

std::optional<double> turnedBy(const FlowFit& fit) {
  const glm::dmat2& f = fit.factors;
  const double angle = std::atan2(f[0][1] - f[1][0], f[0][0] + f[1][1]), c = std::cos(angle),
               s = std::sin(angle);
  if (!areNear(fit, glm::dmat2(glm::dvec2(c, s), glm::dvec2(-s, c)))) return {};
  return angle * 180.0 / std::numbers::pi;
}

std::optional<MotionTrial> knownTrial(const FlowFit& fit, const glm::ivec2& sizePx) {
  if (hasOffset(fit)) return {};
  for (const MotionTrial& trial : motionTrials(sizePx)) {
    const auto factors = factorsOf(trial);
    if (!factors) continue;
    if (areNear(fit, *factors)) return trial;
  }
  return {};
}

std::optional<FlowFit> explaining(const std::vector<const FlowSquare*>& squares, double tolerancePx) {
  // Where motion hardly varies, turned and scaled axes make anything of it.
  constexpr double kVaries = 0.8;
  const auto scaled = fitFlow(squares, true, tolerancePx);
  const glm::dmat2 asGiven(1.0);
  const auto saysMore = [&](const FlowFit& fit) { return hasOffset(fit) || !areNear(fit, asGiven); };
  const auto isOfAxes = [](const FlowFit& fit) {
    return isAlongAxes(fit) || (isTurned(fit) && fit.explainedShare >= kVaries);
  };
  if (scaled && scaled->isGood() && isOfAxes(*scaled)) return saysMore(*scaled) ? scaled : std::nullopt;
  const auto shifted = fitFlow(squares, false, tolerancePx);
  return shifted && shifted->isGood() && isAlongAxes(*shifted) && saysMore(*shifted) ? shifted : std::nullopt;
}

std::optional<FlowFit> explainingWithoutRoot(const std::vector<const FlowSquare*>& squares,
                                             const CaptureInfo& captureInfo, double tolerancePx) {
  const bool isUnreal =
      captureInfo.conventions && captureInfo.conventions->motion.encoding == capture::MotionEncoding::Unreal;
  if (!isUnreal) return {};
  const glm::dvec2 pxPerNdc = 0.5 * glm::dvec2(captureInfo.sizePx);
  std::vector<FlowSquare> linear;
  for (const FlowSquare* square : squares) {
    FlowSquare& one = linear.emplace_back(*square);
    one.given = glm::sign(square->given) * glm::sqrt(2.0 * glm::abs(square->given) * pxPerNdc);
  }
  std::vector<const FlowSquare*> all;
  for (const FlowSquare& square : linear) all.push_back(&square);
  const auto fit = fitFactor(all, tolerancePx);
  return fit && fit->isGood() ? fit : std::nullopt;
}

double followedShare(const FlowFit& fit, const std::vector<const FlowSquare*>& squares, double tolerancePx) {
  const auto followed = std::ranges::count_if(squares, [&](const FlowSquare* square) {
    return glm::distance(square->px, fit.factors * square->given + fit.offsetPx) <=
           std::max(tolerancePx, kChanceErrors * square->errorPx);
  });
  return squares.empty() ? 0.0 : static_cast<double>(followed) / static_cast<double>(squares.size());
}

bool isClipped(const std::vector<const FlowSquare*>& squares, int axis) {
  constexpr double kNearlyAll = 0.9, kMovesPx = 0.5;
  constexpr std::size_t kEnough = 16;
  for (const double sign : {1.0, -1.0}) {
    std::size_t zero = 0, lost = 0, given = 0, alone = 0; // alone: of one component, not of both
    bool isOneSigned = true;
    for (const FlowSquare* square : squares) {
      const double along = sign * square->given[axis];
      if (along < 0.0) isOneSigned = false;
      if (along > kMovesPx) ++given;
      if (along != 0.0 || std::abs(square->px[axis]) <= kMovesPx) continue;
      ++zero;
      if (sign * square->px[axis] < 0.0) ++lost;
      if (square->given[1 - axis] != 0.0) ++alone;
    }
    if (isOneSigned && given >= kEnough && alone >= kEnough &&
        static_cast<double>(lost) >= kNearlyAll * static_cast<double>(zero))
      return true;
  }
  return false;
}

} // namespace taa::doctor
