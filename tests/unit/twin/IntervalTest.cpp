// Numbers that know what a driver may make of them: their ranges, and both ways of a comparison.
#include "core/taa/twin/Interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace taa;
using twin::Interval;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

double unitOf(double exact) {
  const auto near = static_cast<float>(std::fabs(exact));
  return static_cast<double>(near) - static_cast<double>(std::nextafter(near, 0.0f));
}

/// What the rows of a pixel were found to be, none of which is compared.
twin::Observation observing(std::vector<bool> script) {
  static const twin::PixelRecord kFound{};
  static const std::bitset<kIntermediateCount> kRows;
  return {kFound, kRows, std::move(script)};
}

} // namespace

TEST(Interval, OfExactNumbersIsExactButForQuotientsAndRoots) {
  const Interval a = 0.1f, b = 0.7f;
  for (const Interval& each : {a + b, a - b, a * b, -a, fabs(-a), floor(b), twin::minimum(a, b)}) {
    EXPECT_TRUE(each.isPoint());
  }
  EXPECT_EQ((a + b).low, 0.1f + 0.7f);
  EXPECT_EQ((a * b).high, 0.1f * 0.7f);
  EXPECT_FALSE((a / b).isPoint());
  EXPECT_FALSE(sqrt(b).isPoint());
  EXPECT_TRUE((Interval(0.0f) / b).isPoint()) << "nothing has no error";
}

// The floats within 2.5 ulp of the exact quotient are in it, and those farther are not.
TEST(Interval, OfQuotientsIsWhatGlslAllows) {
  std::mt19937 random(1); // NOLINT: the same numbers each time
  std::uniform_real_distribution<float> numbers(0.001f, 1000.0f);
  for (int i = 0; i < 2000; ++i) {
    const float a = numbers(random), b = numbers(random);
    const Interval range = Interval(a) / Interval(b);
    const double exact = static_cast<double>(a) / static_cast<double>(b), unit = unitOf(exact);
    for (float x = a / b, down = x; std::fabs(static_cast<double>(x) - exact) <= 8.0 * unit;
         x = std::nextafter(x, 1e9f), down = std::nextafter(down, -1e9f))
      for (const float each : {x, down}) {
        const double distance = std::fabs(static_cast<double>(each) - exact);
        if (std::fabs(distance - 2.5 * unit) < 0.51 * unit)
          continue; // the unit of the other side of a power of 2
        EXPECT_EQ(range.contains(each), distance < 2.5 * unit) << a << " / " << b;
      }
  }
}

TEST(Interval, HoldsWhatItsNumbersGive) {
  std::mt19937 random(2); // NOLINT: the same numbers each time
  std::uniform_real_distribution<float> numbers(-3.0f, 3.0f), shares(0.0f, 1.0f);
  const auto drawn = [&] {
    const float low = numbers(random);
    return Interval(low, low, low + 0.5f * shares(random));
  };
  const auto within = [&](const Interval& x) {
    return std::min(x.high, x.low + shares(random) * (x.high - x.low));
  };
  for (int i = 0; i < 5000; ++i) {
    const Interval a = drawn(), b = drawn(), c = drawn();
    const float x = within(a), y = within(b), z = within(c);
    EXPECT_TRUE((a + b).contains(x + y));
    EXPECT_TRUE((a - b).contains(x - y));
    EXPECT_TRUE((a * b).contains(x * y));
    EXPECT_TRUE((a / b).contains(x / y));
    EXPECT_TRUE((-a).contains(-x));
    EXPECT_TRUE(fabs(a).contains(std::fabs(x)));
    EXPECT_TRUE(sqrt(a).contains(std::sqrt(std::fabs(x))) || x < 0.0f);
    EXPECT_TRUE(twin::minimum(a, b).contains(twin::minimum(x, y)));
    EXPECT_TRUE(twin::maximum(a, b).contains(twin::maximum(x, y)));
    EXPECT_TRUE(twin::bounded(a, b, c).contains(twin::bounded(x, y, z)));
    EXPECT_TRUE(twin::saturated(a).contains(twin::saturated(x)));
    EXPECT_TRUE(twin::exp2Of(Interval(x)).contains(twin::exp2Of(x)));
    EXPECT_TRUE(twin::log2OfOnePlus(Interval(x + 4.0f)).contains(twin::log2OfOnePlus(x + 4.0f)));
  }
}

// What is copied, or bounded by what does not bind, is the same number on every driver.
TEST(Interval, KnowsItselfAgain) {
  const Interval x = Interval(1.0f) / Interval(3.0f), other = Interval(1.0f) / Interval(3.0f);
  const twin::Observation observation = observing({});
  const Interval same = twin::bounded(twin::maximum(x, 0.0f), 0.0f, 1.0f);
  EXPECT_TRUE(same == x);
  EXPECT_TRUE(same <= x);
  EXPECT_FALSE(same < x);
  EXPECT_TRUE((same - x).isPoint());
  EXPECT_TRUE(observation.decisions().empty());
  EXPECT_FALSE((other - x).isPoint()) << "may be another quotient";
  const Interval around(0.1f, -0.2f, 0.3f);
  EXPECT_EQ((around * around).low, 0.0f);
  EXPECT_LT((around * Interval(0.1f, -0.2f, 0.3f)).low, 0.0f);
}

TEST(Interval, OfNoNumberIsNotItself) {
  const Interval nan = kNan, stored = Interval::made(kNan, kNan, kNan), copy = stored;
  EXPECT_FALSE(nan == nan);
  EXPECT_FALSE(stored == copy);
  EXPECT_FALSE(stored <= copy);
  EXPECT_TRUE((stored - copy).isNan());
  const Interval huge = Interval(3e38f, 3e38f, Interval::kInfinity);
  EXPECT_TRUE((huge - huge).isAnything()) << "infinity less infinity";
}

// Of 8 bits: the count is exact, its quotient by 255 is not; 0 is.
TEST(Interval, OfStoredStepsMayErrInTheirQuotient) {
  const Interval white = twin::quantized(Interval(1.0f), 255.0f, 0.5f);
  EXPECT_TRUE(white.contains(std::nextafter(1.0f, 0.0f)));
  EXPECT_TRUE(twin::quantized(Interval(0.0f), 255.0f, 0.5f).isPoint());
  const Interval between(0.5f, 0.499f, 0.501f);
  EXPECT_TRUE(twin::quantized(between, 255.0f, 0.5f).contains(127.0f / 255.0f));
  EXPECT_TRUE(twin::quantized(between, 255.0f, 0.5f).contains(128.0f / 255.0f));
}

TEST(Interval, GoesBothWaysWhereBothMayBe) {
  const Interval wide(1.0f, 0.9f, 1.1f);
  EXPECT_TRUE(wide > Interval(0.5f)) << "nothing to choose";
  const twin::Observation likely = observing({});
  EXPECT_FALSE(wide < Interval(0.95f)) << "as the twin has it";
  EXPECT_EQ(floor(wide).low, 1.0f);
  EXPECT_EQ(likely.decisions().size(), 2u);
  const twin::Observation other = observing({true, true});
  EXPECT_TRUE(wide < Interval(0.95f));
  EXPECT_EQ(floor(wide).low, 0.0f);
  EXPECT_EQ(other.decisions().size(), 2u);
}

TEST(Interval, PromisesNothingOfWhatGlslLeavesOpen) {
  const Interval zero = 0.0f, around(0.1f, -0.1f, 0.1f);
  EXPECT_TRUE((Interval(1.0f) / zero).isAnything());
  EXPECT_TRUE((Interval(1.0f) / around).isAnything());
  EXPECT_TRUE((Interval(1.0f) / zero).contains(kNan));
  EXPECT_TRUE(sqrt(Interval(-1.0f)).isAnything());
  EXPECT_TRUE((Interval(1.0f) / zero + Interval(1.0f)).isAnything());
  EXPECT_FALSE(around.contains(kNan));
  EXPECT_TRUE(Interval(kNan).contains(kNan));
  EXPECT_FALSE(Interval(kNan).contains(0.0f));
  const twin::Observation observation = observing({});
  EXPECT_FALSE(Interval(kNan) < zero);
  EXPECT_FALSE(Interval(kNan) >= zero);
  EXPECT_TRUE(observation.decisions().empty()) << "a comparison with NaN is false";
}

// A driver may flush them.
TEST(Interval, MayLoseWhatIsBelowNormalNumbers) {
  const Interval small = Interval(0x1p-100f) * Interval(0x1p-40f);
  EXPECT_TRUE(small.contains(0x1p-140f));
  EXPECT_TRUE(small.contains(0.0f));
  EXPECT_FALSE(small.contains(0x1p-126f));
}

TEST(Interval, TakesWhatTheDriverMadeOfARow) {
  twin::PixelRecord found{};
  found[static_cast<std::size_t>(IntermediateId::alpha)] = glm::vec4(0.25f);
  std::bitset<kIntermediateCount> rows;
  rows.set(static_cast<std::size_t>(IntermediateId::alpha));
  const twin::Observation observation(found, rows, {});
  Interval alpha(0.2f, 0.1f, 0.3f), speed = 2.0f;
  observe(IntermediateId::alpha, alpha);
  observe(IntermediateId::speed, speed);
  EXPECT_TRUE(alpha.isPoint());
  EXPECT_EQ(alpha.value, 0.25f);
  EXPECT_EQ(speed.value, 2.0f) << "is not compared";
  ASSERT_EQ(observation.compared().size(), 1u);
  EXPECT_TRUE(observation.compared()[0].isInside());
}
