// What is said to lie beyond the sides of a part is what its box is left out for.
#include "core/render/passes/ClipSides.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace taa {
namespace {

View viewOf(const gl::Rect& part) {
  View view;
  view.block.sizePx = {160.0f, 90.0f};
  view.part = part;
  return view;
}

} // namespace

TEST(ClipSides, ReachThreePixelsAroundThePart) {
  const ClipSides sides = clipSides(viewOf({83, 13, 2, 14}));
  EXPECT_EQ(sides.low.x, 0.0f); // 80 of 160
  EXPECT_FLOAT_EQ(sides.high.x, 2.0f * 88.0f / 160.0f - 1.0f);
  EXPECT_FLOAT_EQ(sides.high.y, 1.0f - 2.0f * 10.0f / 90.0f);
  EXPECT_FLOAT_EQ(sides.low.y, 1.0f - 2.0f * 30.0f / 90.0f);
}

TEST(ClipSides, HalfSpacesHoldThePointsWhoseBoxIsLeftOut) {
  const ClipSides sides = clipSides(viewOf({40, 30, 25, 20}));
  const glm::mat4 clipFromModel = perspectiveReversed(0.9f, 16.0f / 9.0f, 0.1f);
  for (const glm::vec4 jitter : {glm::vec4(0.0f), glm::vec4(0.02f, -0.01f, 0.1f, 0.2f)}) {
    const std::array<HalfSpace, 4> spaces = beyondSides(clipFromModel, sides, jitter);
    int inside = 0, outside = 0;
    for (float x = -3.03f; x < 3.0f; x += 0.25f)
      for (float y = -2.02f; y < 2.0f; y += 0.25f)
        for (const float z : {-0.3f, -2.0f, -9.0f}) {
          const glm::vec3 point(x, y, z);
          const bool isBeyond = std::ranges::any_of(spaces, [&](const HalfSpace& space) {
            return glm::dot(space.plane, glm::vec4(point, 1.0f)) > 0.0f;
          });
          EXPECT_EQ(!isBeyond, farthestPoint({point, point}, clipFromModel, sides, jitter).has_value());
          ++(isBeyond ? outside : inside);
        }
    EXPECT_GT(inside, 20);
    EXPECT_GT(outside, 200);
  }
}

// A plane may be off by roundings of the terms that it is a sum of.
TEST(ClipSides, TermsOfAHalfSpaceAreNoSmallerThanItsPlane) {
  const glm::mat4 clipFromModel = perspectiveReversed(0.9f, 16.0f / 9.0f, 0.1f);
  for (const HalfSpace& space :
       beyondSides(clipFromModel, clipSides(viewOf({40, 30, 25, 20})), {0.02f, -0.01f, 0.1f, 0.2f}))
    for (int term = 0; term < 4; ++term)
      EXPECT_GE(space.terms[term] * 1.000001f, std::abs(space.plane[term])) << term;
}

} // namespace taa
