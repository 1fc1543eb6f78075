// Formulas as traced numbers write them: what changes nothing is left out, parentheses stand where they must,
// rows stand as numbers.
#include "core/explanation/FormulaText.h"
#include "core/taa/twin/Color.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <string>

using namespace taa;
using twin::Traced;
using Id = IntermediateId;

namespace {

Traced read(float value) {
  return Traced::made(twin::Operation::Read, value, value);
}

/// Of what `make` makes of numbers that were read.
std::string textOf(const std::function<Traced()>& make) {
  twin::Tracing tracing;
  twin::Trace trace;
  trace.rows[static_cast<std::size_t>(Id::alpha)][0] = make().operand();
  trace.nodes = tracing.take();
  return explanation::formulaText(trace, Id::alpha, 0, {});
}

} // namespace

TEST(FormulaText, LeavesOutWhatChangesNothing) {
  EXPECT_EQ(textOf([] { return read(0.3f) * 1.0f + 0.0f; }), "0.3");
  EXPECT_EQ(textOf([] { return (read(0.3f) + read(0.2f)) * read(1.0f) - read(0.0f); }), "0.3 + 0.2");
  EXPECT_EQ(textOf([] { return 1.0f - (1.0f - read(0.3f)) * (1.0f - read(0.0f)); }), "0.3");
  EXPECT_EQ(textOf([] { return twin::maximum(read(0.3f) + read(0.2f), 0.1f); }), "0.3 + 0.2")
      << "a literal that does not bind";
  EXPECT_EQ(textOf([] { return twin::saturated(read(0.3f) + read(0.2f)); }), "0.3 + 0.2");
  EXPECT_EQ(textOf([] { return twin::saturated(read(0.7f) + read(0.8f)); }), "clamp(0.7 + 0.8, 0, 1)");
  EXPECT_EQ(textOf([] { return twin::maximum(read(0.3f) + read(0.2f), read(0.1f)); }), "max(0.3 + 0.2, 0.1)")
      << "what was read may have bound";
  EXPECT_EQ(textOf([] { return twin::minimum(read(0.1f), read(0.1f)); }), "0.1")
      << "of two that are the same";
  EXPECT_EQ(
      textOf([] { return twin::maximum(read(0.1f), twin::minimum(read(0.1f), read(0.1f))) * read(2.0f); }),
      "0.1 × 2");
}

TEST(FormulaText, SetsParenthesesWhereTheyAreNeeded) {
  EXPECT_EQ(textOf([] { return (read(1.5f) + read(2.0f)) * read(3.0f); }), "(1.5 + 2) × 3");
  EXPECT_EQ(textOf([] { return read(1.5f) - (read(2.0f) - read(3.0f)); }), "1.5 − (2 − 3)");
  EXPECT_EQ(textOf([] { return read(1.5f) / (read(2.0f) * read(3.0f)); }), "1.5 / (2 × 3)");
  EXPECT_EQ(textOf([] { return read(1.5f) * read(2.0f) / read(3.0f); }), "1.5 × 2 / 3");
  EXPECT_EQ(textOf([] {
              const Traced difference = read(1.5f) - read(2.0f);
              return difference * difference;
            }),
            "(1.5 − 2)^2");
  EXPECT_EQ(textOf([] {
              const Traced below = read(-2.0f);
              return below * below + read(3.0f);
            }),
            "(−2)^2 + 3");
  EXPECT_EQ(textOf([] { return sqrt(read(1.5f) + read(2.0f)); }), "√(1.5 + 2)");
  EXPECT_EQ(textOf([] { return fabs(read(1.5f) - read(2.0f)) / read(3.0f); }), "|1.5 − 2| / 3");
  EXPECT_EQ(textOf([] { return twin::maximum(twin::maximum(read(1.5f), read(2.0f)), read(3.0f)); }),
            "max(1.5, 2, 3)");
  EXPECT_EQ(textOf([] { return exp(-(read(1.5f) + read(2.0f)) / read(3.0f)); }), "exp(−(1.5 + 2) / 3)");
  EXPECT_EQ(textOf([] { return twin::powerOf256ths(1.0f - read(0.25f), 384); }), "(1 − 0.25)^1.5");
}

TEST(FormulaText, StatesNamedValuesAndOpensOneThatIsAsked) {
  EXPECT_EQ(textOf([] { return twin::named(read(1.5f) + read(2.0f)) * read(3.0f); }), "3.5 × 3");
  EXPECT_EQ(textOf([] { return twin::named(read(1.5f) + read(2.0f)); }), "1.5 + 2");
}

TEST(FormulaText, WritesChannelsAsOneWhereTheyAreMadeAlike) {
  twin::Tracing tracing;
  const twin::Vec3<Traced> a(read(1.0f), read(2.0f), read(3.0f)), b(read(4.0f), read(5.0f), read(6.0f));
  const Traced share = read(0.5f);
  const twin::Vec3<Traced> even = a + share * (b - a);
  const twin::Vec3<Traced> uneven(a.x + b.x, a.y * b.y, a.z);
  twin::Trace trace;
  for (int i = 0; i < 3; ++i) {
    trace.rows[static_cast<std::size_t>(Id::resolved)][static_cast<std::size_t>(i)] = even[i].operand();
    trace.rows[static_cast<std::size_t>(Id::output)][static_cast<std::size_t>(i)] = uneven[i].operand();
  }
  trace.nodes = tracing.take();
  EXPECT_EQ(explanation::formulaText(trace, Id::resolved, {}), "(1, 2, 3) + 0.5 × ((4, 5, 6) − (1, 2, 3))");
  EXPECT_EQ(explanation::formulaText(trace, Id::resolved, 1, {}), "2 + 0.5 × (5 − 2)");
  EXPECT_FALSE(explanation::formulaText(trace, Id::output, {}));
}
