#include "core/doctor/flow/FlowChange.h"

#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace taa::doctor {

namespace {

using Complex = std::complex<double>;

constexpr std::size_t kEnoughSquares = 12;
constexpr double kNearlyAllFrames = 0.8, kNearlyAllFollow = 0.8;
constexpr double kClearErrors = 5.0; ///< standard errors that a growth or a turn is larger than

Complex asComplex(const glm::dvec2& v) {
  return {v.x, v.y};
}

/// A square's place from the middle of the picture, and what is lacking there.
struct Lacking {
  Complex place, px;
  double errorPx = 0.0;
};

std::vector<Lacking> lackingOf(const std::vector<const FlowSquare*>& squares, const glm::ivec2& sizePx) {
  std::vector<Lacking> out;
  for (const FlowSquare* square : squares)
    out.push_back({asComplex(glm::dvec2(square->pixel) - 0.5 * glm::dvec2(sizePx)),
                   asComplex(square->px - square->given), square->errorPx});
  return out;
}

/// px = slope · place + middle, by weighted least squares; `spread`: the weighted sum of squared distances of
/// places from their mean.
struct ComplexLine {
  Complex slope, middle;
  double spread = 0.0, weight = 0.0;

  double off(const Lacking& one) const { return std::abs(one.px - slope * one.place - middle); }
};

ComplexLine lineThrough(const std::vector<Lacking>& all, const std::vector<double>& weights) {
  ComplexLine out;
  Complex place, px, product;
  for (std::size_t i = 0; i < all.size(); ++i) {
    out.weight += weights[i];
    place += weights[i] * all[i].place;
    px += weights[i] * all[i].px;
  }
  if (!(out.weight > 0.0)) return out;
  place /= out.weight;
  px /= out.weight;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Complex from = all[i].place - place;
    product += weights[i] * (all[i].px - px) * std::conj(from);
    out.spread += weights[i] * std::norm(from);
  }
  if (out.spread > 0.0) out.slope = product / out.spread;
  out.middle = px - out.slope * place;
  return out;
}

bool areNearlyAll(std::size_t some, std::size_t all) {
  return some > 0 && static_cast<double>(some) >= kNearlyAllFrames * static_cast<double>(all);
}

std::string percent(double share) {
  return shortNumber(100.0 * share);
}

} // namespace

bool PictureChange::isGood() const {
  return static_cast<double>(followed) >= kNearlyAllFollow * static_cast<double>(squares) &&
         std::hypot(growth, turn) >= kClearErrors * error;
}

bool PictureChange::isZoom(const glm::ivec2& sizePx) const {
  constexpr double kHardlyTurns = 0.1, kHardlyShifts = 0.1, kShiftPx = 0.5;
  const double atCornerPx = 0.5 * std::abs(growth) * glm::length(glm::dvec2(sizePx));
  return isGood() && std::abs(turn) <= std::max(3.0 * error, kHardlyTurns * std::abs(growth)) &&
         glm::length(shiftPx) <= std::max(kShiftPx, kHardlyShifts * atCornerPx);
}

std::optional<PictureChange> changeOf(const std::vector<const FlowSquare*>& squares, const glm::ivec2& sizePx,
                                      double tolerancePx) {
  constexpr int kRounds = 10;
  constexpr double kLeastScalePx = 0.05;
  // A square that grows is measured by less than it moves; and what moves by itself grows as well.
  constexpr double kShareOfLacking = 0.1;
  if (squares.size() < kEnoughSquares) return {};
  const std::vector<Lacking> all = lackingOf(squares, sizePx);
  std::vector<double> weights(all.size(), 1.0), off(all.size());
  ComplexLine line;
  for (int round = 0; round < kRounds; ++round) {
    line = lineThrough(all, weights);
    if (!(line.spread > 0.0)) return {};
    for (std::size_t i = 0; i < all.size(); ++i) off[i] = line.off(all[i]);
    const double scalePx = std::max(kLeastScalePx, median(off));
    for (std::size_t i = 0; i < all.size(); ++i) weights[i] = tukeyWeight(off[i], kTukeyMedians * scalePx);
  }
  PictureChange out;
  double left = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    left += 0.5 * weights[i] * off[i] * off[i];
    const double tolerated =
        std::max({tolerancePx, kChanceErrors * all[i].errorPx, kShareOfLacking * std::abs(all[i].px)});
    if (off[i] <= tolerated) ++out.followed;
  }
  out.squares = all.size();
  // Where a place is now, and moved by m, it was at place − m: of a picture that is 1 + g times as large m is
  // g ⁄ (1 + g) times the place.
  const Complex before = 1.0 - line.slope;
  out.growth = 1.0 / std::abs(before) - 1.0;
  out.turn = -std::arg(before);
  out.error = std::sqrt(left / std::max(1.0, line.weight - 2.0) / line.spread);
  out.shiftPx = {line.middle.real(), line.middle.imag()};
  return out;
}

PictureChanges changesOf(const std::vector<Refuted>& refuted, const FlowSeen& seen, const glm::ivec2& sizePx,
                         double tolerancePx) {
  std::map<int, std::vector<const FlowSquare*>> byFrame;
  for (const FlowSquare* square : squaresOf(refuted)) byFrame[frameOf(*square, seen)].push_back(square);
  PictureChanges out;
  for (const auto& [frame, squares] : byFrame)
    if (squares.size() >= kEnoughSquares) out[frame] = changeOf(squares, sizePx, tolerancePx);
  return out;
}

bool areZooms(const PictureChanges& changes, const glm::ivec2& sizePx) {
  const auto zooms = std::ranges::count_if(
      changes, [&](const auto& entry) { return entry.second && entry.second->isZoom(sizePx); });
  return areNearlyAll(static_cast<std::size_t>(zooms), changes.size());
}

std::string zoomText(const PictureChanges& changes) {
  const PictureChange *least = nullptr, *most = nullptr;
  for (const auto& [frame, change] : changes) {
    if (!change || !change->isGood()) continue;
    if (!least || change->growth < least->growth) least = &*change;
    if (!most || change->growth > most->growth) most = &*change;
  }
  if (!least) return {};
  return say<
      "By least squares what is lacking is that of a picture that grows about its middle by %1 ± %2 % to %3 "
      "± %4 % a frame: the field of view changes, or all that is seen is as far and comes nearer.">(
      percent(least->growth), percent(least->error), percent(most->growth), percent(most->error));
}

std::string changeText(const PictureChanges& changes, const FrameNames& names) {
  std::size_t good = 0;
  const PictureChange* most = nullptr;
  int where = 0;
  for (const auto& [frame, change] : changes) {
    if (!change || !change->isGood()) continue;
    ++good;
    if (most && std::hypot(most->growth, most->turn) >= std::hypot(change->growth, change->turn)) continue;
    most = &*change;
    where = frame;
  }
  if (!areNearlyAll(good, changes.size())) return {};
  return say<
      "By least squares what is lacking is that of a picture that changes as a whole: in frame %1 it grows by "
      "%2 %, turns by %3° and its middle shifts by %4 px.">(
      names.of(where), percent(most->growth), shortNumber(most->turn * 180.0 / std::numbers::pi),
      shortVector(most->shiftPx));
}

} // namespace taa::doctor
