#include "core/doctor/jitter/JitterFactors.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/doctor/flow/FlowFit.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace taa::doctor {

namespace {

constexpr double kFollowsPx = 0.15;     ///< to which a shift is measured: pictures alias
constexpr std::size_t kEnoughPairs = 6; ///< of frames: eight frames have seven
constexpr double kWithinErrors = 3.0;
/// Pictures alias: a factor is measured no better, whatever its standard error is.
constexpr double kLeastError = 0.01;
constexpr double kKnownTo = 0.05; ///< of a factor

JitterFactors factorsIn(const FlowFit& fit) {
  return {{fit.factors[0][0], fit.factors[1][1]}, {fit.factorErrors[0][0], fit.factorErrors[1][1]}};
}

bool areKnown(const JitterFactors& factors) {
  return glm::all(glm::lessThanEqual(factors.error, kKnownTo * glm::abs(factors.factor)));
}

/// Of an axis whose factor is not said: it is 1, to what is shown of it.
bool isOne(float factor) {
  constexpr float kShown = 0.03f;
  return std::abs(factor - 1.0f) <= kShown;
}

} // namespace

bool JitterFactors::areBeyond(const glm::dvec2& other) const {
  const glm::dvec2 most = glm::max(kWithinErrors * error, kLeastError * glm::abs(factor));
  return glm::any(glm::greaterThan(glm::abs(factor - other), most));
}

JitterTrial JitterFactors::trial() const {
  return {JitterKind::Scaled, glm::vec2(factor)};
}

std::optional<JitterFactors> measureFactors(const JitterEvidence& evidence) {
  std::vector<FlowSquare> shifts;
  for (const ShiftPair& pair : shiftPairs(evidence)) {
    FlowSquare& shift = shifts.emplace_back();
    shift.given = pair.before - pair.now;
    shift.px = pair.shift;
  }
  std::vector<const FlowSquare*> all;
  for (const FlowSquare& shift : shifts) all.push_back(&shift);
  const auto both = fitFlow(all, true, kFollowsPx, kEnoughPairs);
  if (both && both->isGood() && isAlongAxes(*both)) {
    const JitterFactors two = factorsIn(*both);
    const double apart = std::abs(two.factor.x - two.factor.y);
    if (apart > std::max(kWithinErrors * std::hypot(two.error.x, two.error.y), kKnownTo) && areKnown(two))
      return two;
  }
  const auto alike = fitFactor(all, kFollowsPx, kEnoughPairs);
  if (!alike || !alike->isGood() || !areKnown(factorsIn(*alike))) return {};
  return factorsIn(*alike);
}

bool explainShifts(const JitterFactors& factors, const JitterEvidence& evidence) {
  // Pictures that are read softly shift by a few hundredths less.
  constexpr double kNearerShare = 0.5, kOther = 0.1;
  const double missPx = shiftResidual(factors.trial(), evidence), statedPx = shiftResidual({}, evidence);
  const glm::dvec2 off = glm::abs(factors.factor - 1.0);
  return factors.areBeyond(glm::dvec2(1.0)) && std::max(off.x, off.y) >= kOther && missPx <= kFollowsPx &&
         missPx <= kNearerShare * statedPx;
}

std::string factorsName(const glm::vec2& factor) {
  const glm::dvec2 times = 1.0 / glm::dvec2(factor);
  if (factor.x == factor.y) return say<"Jitter reported %1 times as large as it is">(shortNumber(times.x));
  if (isOne(factor.x)) return say<"y of jitter reported %1 times as large as it is">(shortNumber(times.y));
  if (isOne(factor.y)) return say<"x of jitter reported %1 times as large as it is">(shortNumber(times.x));
  return say<"x of jitter reported %1 times as large as it is, y %2 times">(shortNumber(times.x),
                                                                            shortNumber(times.y));
}

std::string sidesText(const JitterFactors& factors, const glm::ivec2& sizePx) {
  const double wide = static_cast<double>(sizePx.x) / sizePx.y;
  for (const int axis : {0, 1}) {
    glm::dvec2 sides(1.0);
    for (const double ratio : {wide, 1.0 / wide}) {
      sides[axis] = ratio;
      if (ratio == 1.0 || factors.areBeyond(sides)) continue;
      return say<"That is the picture's %1 over its %2: %3 is divided by the wrong one of the two.">(
          ratio == wide ? say<"width">() : say<"height">(), ratio == wide ? say<"height">() : say<"width">(),
          axis == 0 ? std::string("x") : std::string("y"));
    }
  }
  return {};
}

} // namespace taa::doctor
