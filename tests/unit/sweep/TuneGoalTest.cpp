// Goals of tuning, of numbers given by hand.
#include "core/sweep/tune/TuneGoal.h"

#include "tests/support/ErrorOf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

using taa::Metric;
using taa::TuneGoal;
using taa::TuneNumbers;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TuneNumbers numbers(double rmse, double psnr, double cost = 1.0) {
  TuneNumbers made;
  made.means[static_cast<std::size_t>(Metric::Rmse)] = rmse;
  made.means[static_cast<std::size_t>(Metric::Psnr)] = psnr;
  made.cost = cost;
  return made;
}

void expectRefused(const std::string& text, const std::string& word) {
  const std::string why = taa::test::errorOf([&] { TuneGoal goal(text); });
  EXPECT_NE(why.find(word), std::string::npos) << text << ": " << why;
}

} // namespace

TEST(TuneGoal, IsTheSumOfItsWeightsAtTheStart) {
  const TuneNumbers start = numbers(0.04, 28);
  EXPECT_DOUBLE_EQ(TuneGoal("rmse=1,psnr=0.5,cost=0.25").value(start, start), 1.75);
}

TEST(TuneGoal, WeighsEachNumberAgainstWhatItWas) {
  const TuneNumbers start = numbers(0.04, 20);
  EXPECT_DOUBLE_EQ(TuneGoal("rmse=3").value(numbers(0.02, 20), start), 1.5);
  EXPECT_DOUBLE_EQ(TuneGoal("psnr=3").value(numbers(0.04, 30), start), 2.0) << "more is better";
  EXPECT_DOUBLE_EQ(TuneGoal("cost=2").value(numbers(0.04, 20, 1.5), start), 3.0);
  EXPECT_DOUBLE_EQ(TuneGoal("rmse=1,cost=2").value(numbers(0.08, 20, 0.5), start), 3.0);
}

TEST(TuneGoal, KeepsWhatIsNearlyPerfectFromBeingAllThatCounts) {
  // RMSE is plotted from 0 to 0.1: a thousandth is 1e-4.
  EXPECT_DOUBLE_EQ(TuneGoal("rmse=1").value(numbers(1e-3, 20), numbers(0, 20)), 10.0);
  EXPECT_EQ(TuneGoal("psnr=1").value(numbers(0, kInfinite), numbers(0, kInfinite)), 1.0);
  EXPECT_EQ(TuneGoal("psnr=1").value(numbers(0, kInfinite), numbers(0.1, 20)), 0.0);
}

TEST(TuneGoal, IsInfiniteWhereANumberIsNotKnown) {
  const TuneNumbers start = numbers(0.04, 20);
  EXPECT_EQ(TuneGoal("rmse=1").value({}, start), kInfinite);
  EXPECT_EQ(TuneGoal("rmse=1").value(numbers(std::nan(""), 20), start), kInfinite);
  EXPECT_EQ(TuneGoal("rmse=1,flicker=1").unknown(start), Metric::Flicker);
  EXPECT_FALSE(TuneGoal("rmse=1,cost=1").unknown(start));
}

TEST(TuneGoal, NamesEveryMetricOfTheTable) {
  for (const taa::MetricInfo& info : taa::kMetrics)
    EXPECT_EQ(TuneGoal(std::string(info.id) + "=1").metrics(), std::vector<Metric>{info.metric});
  EXPECT_TRUE(TuneGoal("rmse=1,cost=1").countsCost());
  EXPECT_FALSE(TuneGoal("rmse=1").countsCost());
}

TEST(TuneGoal, RefusesWhatItCannotRead) {
  expectRefused("", "empty");
  expectRefused("rsme=1", "rsme");
  expectRefused("rsme=1", "flicker");
  expectRefused("rmse", "METRIC=WEIGHT");
  expectRefused("rmse=", "METRIC=WEIGHT");
  expectRefused("rmse=0", "above 0");
  expectRefused("rmse=-1", "above 0");
  expectRefused("rmse=inf", "above 0");
  expectRefused("rmse=1x", "rmse=1x");
  expectRefused("rmse=1,rmse=2", "twice");
  expectRefused("cost=1,cost=2", "twice");
}

// By more than a hundredth; flicker is not known here.
TEST(TuneGoal, SaysWhichGuardedMetricsAreWorse) {
  const TuneNumbers start = numbers(0.04, 20);
  EXPECT_TRUE(worseMetrics(start, start).empty());
  EXPECT_TRUE(worseMetrics(numbers(0.0403, 10), start).empty()) << "PSNR is not guarded beside RMSE";
  const std::vector<taa::WorseMetric> worse = worseMetrics(numbers(0.05, 20), start);
  ASSERT_EQ(worse.size(), 1u);
  EXPECT_EQ(worse[0].metric, Metric::Rmse);
  EXPECT_DOUBLE_EQ(worse[0].rise, 0.25);
}

TEST(TuneGoal, IsRmseAndFlickerUnlessSaidOtherwise) {
  EXPECT_EQ(TuneGoal(taa::kDefaultGoal).metrics(), (std::vector<Metric>{Metric::Rmse, Metric::Flicker}));
}
