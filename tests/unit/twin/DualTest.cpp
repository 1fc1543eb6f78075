// Numbers that know how fast they change: their functions, and corners.
#include "core/taa/twin/Dual.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace taa;
using twin::Dual;

TEST(Dual, KnowsItsFunctions) {
  const auto slopeOf = [](auto function, double x) {
    return function(Dual(static_cast<float>(x), 1.0)).slope;
  };
  EXPECT_NEAR(slopeOf([](Dual x) { return x * x; }, 3.0), 6.0, 1e-12);
  EXPECT_NEAR(slopeOf([](Dual x) { return 1.0f / x; }, 2.0), -0.25, 1e-12);
  EXPECT_NEAR(slopeOf([](Dual x) { return sqrt(x); }, 4.0), 0.25, 1e-12);
  EXPECT_NEAR(slopeOf([](Dual x) { return fabs(x); }, -4.0), -1.0, 1e-12);
  EXPECT_NEAR(slopeOf([](Dual x) { return twin::power(x, 2.4f); }, 0.5), 2.4 * std::pow(0.5, 1.4), 1e-6);
  EXPECT_NEAR(slopeOf([](Dual x) { return twin::power(0.5f, x); }, 2.0), 0.25 * std::log(0.5), 1e-6);
  EXPECT_NEAR(slopeOf([](Dual x) { return twin::log2Of(x); }, 8.0), 1.0 / (8.0 * std::log(2.0)), 1e-12);
  EXPECT_NEAR(slopeOf([](Dual x) { return twin::log2OfOnePlus(x); }, 3.0), 1.0 / (4.0 * std::log(2.0)),
              1e-12);
  EXPECT_NEAR(slopeOf([](Dual x) { return twin::log2OfRatio(x); }, 0.1), 2.0 / (0.99 * std::log(2.0)), 1e-7);
  EXPECT_NEAR(slopeOf([](Dual x) { return twin::exp2Of(x); }, 3.0), 8.0 * std::log(2.0), 1e-6);
  EXPECT_NEAR(slopeOf([](Dual x) { return twin::exp2LessOne(x); }, 3.0), 8.0 * std::log(2.0), 1e-6);
}

TEST(Dual, SaysWhereTheOtherSideHasAnotherSlope) {
  const auto cornerOf = [](auto function) {
    const twin::Seeding seeding({});
    function();
    return seeding.isCorner();
  };
  EXPECT_TRUE(cornerOf([] { return Dual(2.0f, 1.0) < Dual(2.0f); }));
  EXPECT_FALSE(cornerOf([] { return Dual(2.0f, 1.0) < Dual(2.0f, 1.0); }));
  EXPECT_FALSE(cornerOf([] { return Dual(2.0f, 1.0) < Dual(3.0f); }));
  EXPECT_TRUE(cornerOf([] { return fabs(Dual(0.0f, 1.0)); }));
}
