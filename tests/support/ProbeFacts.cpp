#include "tests/support/ProbeFacts.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace taa::test {

namespace {

/// In the frame before, around where the followed surface was.
Before surroundings(const SurfaceOracle& oracle, const glm::dvec2& center, const SeenPoint& followed,
                    const glm::ivec2& sizePx) {
  if (center.x < 0.0 || center.y < 0.0 || center.x > sizePx.x || center.y > sizePx.y) return Before::Outside;
  bool isAnySame = false, isAnyOther = false;
  for (double y = -2.5; y <= 2.5; y += 0.5)
    for (double x = -2.5; x <= 2.5; x += 0.5) {
      const SeenPoint seen = oracle.at(center + glm::dvec2(x, y), true);
      const bool isSky = seen.object == 0, wasSky = followed.object == 0;
      const double difference = isSky && wasSky   ? 0.0
                                : isSky || wasSky ? 1.0
                                                  : std::abs(seen.depth / followed.depthBefore - 1.0);
      if (difference < 0.02)
        isAnySame = true; // within the least tolerance of the presets
      else if (difference > 0.1)
        isAnyOther = true;
      else
        return Before::Mixed;
    }
  return isAnySame && isAnyOther ? Before::Mixed : isAnySame ? Before::Same : Before::Other;
}

} // namespace

ProbeFacts factsOf(const SurfaceOracle& oracle, const glm::ivec2& pixel, const glm::ivec2& sizePx) {
  ProbeFacts facts;
  facts.own = facts.followed = oracle.sampleOf(pixel);
  for (int k = 0; k < 9; ++k) {
    const SeenPoint neighbor = oracle.sampleOf(pixel + glm::ivec2(k % 3 - 1, k / 3 - 1));
    const bool isNearer =
        neighbor.object != 0 && (facts.followed.object == 0 || neighbor.depth < facts.followed.depth);
    if (isNearer) facts.followed = neighbor;
  }
  facts.followsOther = glm::distance(facts.own.motionPx, facts.followed.motionPx) > 0.1;
  facts.before =
      surroundings(oracle, glm::dvec2(pixel) + 0.5 - facts.followed.motionPx, facts.followed, sizePx);
  return facts;
}

} // namespace taa::test
