// Numbers that know how fast they change: their functions, and corners.
#include "core/taa/twin/Dual.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

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

TEST(Dual, HasTheSlopeToTheSideThatTheSeedGoes) {
  const Dual rising(2.0f, 1.0), falling(2.0f, -1.0), still(2.0f);
  EXPECT_EQ(maximum(rising, still).slope, 1.0);
  EXPECT_EQ(maximum(still, falling).slope, 0.0);
  EXPECT_EQ(minimum(rising, still).slope, 0.0);
  EXPECT_EQ(minimum(still, falling).slope, -1.0);
  EXPECT_EQ(maximum(still, minimum(still, rising)).slope, 0.0)
      << "no more than itself, whatever the other does";
  EXPECT_EQ(twin::saturated(Dual(1.0f, 1.0)).slope, 0.0);
  EXPECT_EQ(twin::saturated(Dual(1.0f, -1.0)).slope, -1.0);
  EXPECT_EQ(fabs(Dual(0.0f, -1.0)).slope, 1.0);
}

TEST(Dual, SaysWhereTwoPart) {
  const auto tiesOf = [](auto function) {
    const twin::Seeding seeding({});
    function();
    return std::pair(seeding.hasTie(), seeding.hasOpenTie());
  };
  const std::pair none(false, false), decided(true, false), open(true, true);
  EXPECT_EQ(tiesOf([] { return Dual(2.0f, 1.0) < Dual(2.0f); }), open);
  EXPECT_EQ(tiesOf([] { return maximum(Dual(2.0f, 1.0), Dual(2.0f)).slope; }), decided);
  EXPECT_EQ(tiesOf([] { return fabs(Dual(0.0f, 1.0)).slope; }), decided);
  EXPECT_EQ(tiesOf([] { return Dual(2.0f, 1.0) < Dual(2.0f, 1.0); }), none);
  EXPECT_EQ(tiesOf([] { return Dual(2.0f, 1.0) < Dual(3.0f); }), none);
}
