#include "core/verdict/pixel/ReferenceDoubt.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace taa {

namespace {

/// Share of the error by which the part that is most of it leads the next one.
double leadOfPart(const PixelError& origin) {
  const glm::dvec3 error = origin.error();
  const double square = glm::dot(error, error);
  if (square == 0.0) return 1.0;
  std::array<double, kErrorParts> shares{};
  for (std::size_t part = 0; part < kErrorParts; ++part)
    shares[part] = glm::dot(origin.sum[part], error) / square;
  std::ranges::sort(shares, std::greater<double>());
  return shares[0] - shares[1];
}

} // namespace

bool isInDoubt(const ReferenceDoubt& doubt, const PixelVerdict& verdict, const PixelError& origin) {
  const double range = 2.0 * doubt.error;
  if (range == 0.0) return false;
  if (std::abs(verdict.error - kVisibleError) < range) return true;
  if (doubt.isMoving && std::abs(verdict.flicker - kVisibleFlicker) < range) return true;
  // References of this frame and of one before are in both parts, with opposite signs.
  const double rangeOfLead = std::sqrt(2.0) * range;
  return verdict.kind != VerdictKind::None && leadOfPart(origin) * verdict.error < rangeOfLead;
}

} // namespace taa
