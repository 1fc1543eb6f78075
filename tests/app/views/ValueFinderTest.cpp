// How visible values are spread: at once where they are few, else off the UI thread, always of all of them.
#include "app/views/legend/ValueFinder.h"
#include "tests/app/WindowFixture.h"

#include <memory>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

constexpr int kBins = 8;

/// A row of values 0, 1, 2 …
ValueFinder::Question wishOf(int count) {
  auto result = std::make_shared<ViewResult>();
  result->values = Image(count, 1, 1);
  for (int x = 0; x < count; ++x) *result->values.at(x, 0) = static_cast<float>(x);
  return {
      .result = result, .row = intermediate(IntermediateId::alpha), .style = {}, .range = {}, .bins = kBins};
}

constexpr int kMany = 8 * static_cast<int>(ValueFinder::kFew);

class ValueFinderTest : public testing::Test {
 protected:
  void SetUp() override {
    QObject::connect(&finder, &ValueFinder::found, [this](const auto& of, const Distribution& distribution) {
      answered.push_back(of.result->values.width);
      last = distribution;
    });
  }
  ValueFinder finder;
  std::vector<int> answered;
  Distribution last;
};

} // namespace

TEST_F(ValueFinderTest, AnswersAtOnceWhereThereAreFew) {
  finder.find(wishOf(1000));
  EXPECT_EQ(answered, std::vector<int>{1000});
  EXPECT_EQ(last.values, (ValueRange{9, 989})) << "the 10th and the 990th of a thousand";
}

TEST_F(ValueFinderTest, CountsAllOfManyWithoutHoldingWhoAsks) {
  const ValueFinder::Question wish = wishOf(kMany);
  finder.find(wish);
  EXPECT_TRUE(answered.empty());
  ASSERT_TRUE(taa::app::test::waitFor([&] { return !answered.empty(); }));
  const auto rankOf = [](int percent) { return static_cast<float>((kMany * percent + 99) / 100 - 1); };
  EXPECT_EQ(last.values, (ValueRange{rankOf(1), rankOf(99)})) << "of all of them";
  EXPECT_EQ(last.counts, countedOn(last.axis, shownValues(wish.result->values, wish.row, {}), kBins));
  int counted = 0;
  for (const int count : last.counts) counted += count;
  EXPECT_EQ(counted, kMany);
}

TEST_F(ValueFinderTest, LeavesOutWhatWasOvertaken) {
  finder.find(wishOf(kMany));
  finder.find(wishOf(kMany + 1));
  finder.find(wishOf(10));
  ASSERT_TRUE(taa::app::test::waitFor([&] { return answered.size() == 2; }));
  EXPECT_EQ(answered, (std::vector<int>{kMany, 10}));
  EXPECT_EQ(last.values, (ValueRange{0, 9}));
}

TEST_F(ValueFinderTest, MayGoWhileItCounts) {
  auto own = std::make_unique<ValueFinder>();
  own->find(wishOf(kMany));
  own.reset();
  finder.find(wishOf(kMany));
  EXPECT_TRUE(taa::app::test::waitFor([&] { return !answered.empty(); }));
}
