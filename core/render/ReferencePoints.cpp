// Terms … −3/2, −1/2, 1/2, 3/2 … of the sequence i·a mod 1: any run of it is as even as one from 0, and this
// one lies the same around 0.
#include "core/render/ReferencePoints.h"

#include <cmath>

namespace taa {

namespace {

// 1/φ and 1/φ² with φ³ = φ + 1.
constexpr double kStepX = 0.7548776662466927, kStepY = 0.5698402909980532;

float centered(double position) {
  return static_cast<float>(position + 0.5 - std::floor(position + 0.5) - 0.5);
}

} // namespace

glm::vec2 referencePointPx(int index) {
  const double term = index / 2 + 0.5;
  const glm::vec2 point(centered(term * kStepX), centered(term * kStepY));
  return index % 2 == 0 ? point : -point;
}

} // namespace taa
